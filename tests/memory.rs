//! What rendering takes of RAM.

use embedded_graphics::pixelcolor::{Gray4, Rgb565, Rgb888};
use scanray::{Fixed, Progress, Workspace};

/// Is the formula of the documentation.
const fn formula(width: usize, color: usize) -> usize {
    width * color + 1280
}

#[test]
fn a_workspace_takes_what_its_formula_says_and_hardly_less() {
    let sizes = [
        (size_of::<Workspace<f32, Rgb565, 320, 5>>(), formula(320, 2)),
        (size_of::<Workspace<Fixed, Rgb565, 320, 5>>(), formula(320, 2)),
        (size_of::<Workspace<Fixed, Gray4, 128, 1>>(), formula(128, 1)),
        (size_of::<Workspace<f32, Rgb888, 240, 8>>(), formula(240, size_of::<Rgb888>())),
        (size_of::<Workspace<f32, Rgb565, 0, 2>>(), formula(0, 2)),
    ];
    for (size, formula) in sizes {
        assert!(size <= formula && size + 64 >= formula, "{size} bytes, formula {formula}");
    }
}

#[test]
fn a_row_of_320_pixels_takes_less_than_two_kilobytes() {
    assert!(size_of::<Workspace<f32, Rgb565, 320, 5>>() < 2048);
    assert!(size_of::<Workspace<Fixed, Rgb565, 320, 5>>() < 2048);
}

#[test]
fn a_picture_that_becomes_finer_keeps_eight_bytes() {
    assert!(size_of::<Progress>() <= 8);
}
