//! What rendering takes of RAM.

use embedded_graphics::pixelcolor::{Gray4, Rgb565, Rgb888};
use scanray::{Fixed, Progress, RasterWorkspace, Workspace};

/// Is the formula of the documentation.
const fn formula(width: usize, color: usize, depth: usize) -> usize {
    width * color + depth * 44 + 1288
}

#[test]
fn a_workspace_takes_what_its_formula_says_and_hardly_less() {
    let sizes = [
        (size_of::<Workspace<f32, Rgb565, 320, 5>>(), formula(320, 2, 5)),
        (size_of::<Workspace<Fixed, Rgb565, 320, 5>>(), formula(320, 2, 5)),
        (size_of::<Workspace<Fixed, Gray4, 128, 1>>(), formula(128, 1, 1)),
        (size_of::<Workspace<f32, Rgb888, 240, 8>>(), formula(240, size_of::<Rgb888>(), 8)),
        (size_of::<Workspace<f32, Rgb565, 0, 2>>(), formula(0, 2, 2)),
    ];
    for (size, formula) in sizes {
        assert!(size <= formula && size + 64 >= formula, "{size} bytes, formula {formula}");
    }
}

#[test]
fn tracing_takes_less_than_two_kilobytes_beside_the_row() {
    assert!(size_of::<Workspace<f32, Rgb565, 320, 5>>() < 2048 + 640);
    assert!(size_of::<Workspace<Fixed, Rgb565, 320, 5>>() < 2048 + 640);
}

#[test]
fn a_row_of_depths_takes_eight_bytes_a_pixel_and_nothing_else() {
    assert_eq!(size_of::<RasterWorkspace<f32, 320>>(), 320 * 8);
    assert_eq!(size_of::<RasterWorkspace<Fixed, 320>>(), 320 * 8);
}

#[test]
fn a_picture_that_becomes_finer_keeps_eight_bytes() {
    assert!(size_of::<Progress>() <= 8);
}
