//! How pictures reach a display.

use crate::support::{BusFault, Memory, camera, is_a_row, memory, panel, panel_of, pixels, scene};
use draw_faults::{Call, Once, Strict};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use scanray::{
    Adaptive, AtEdges, Exact, Jittered, Progress, Quality, RasterRenderer, RasterWorkspace, RenderError,
    Renderer, RowError, Settings, Uniform, Workspace,
};

const SIZE: Size = Size::new(40, 30);

fn settings() -> Settings {
    Settings::new().with_depth(2)
}

#[test]
fn a_picture_is_one_fill_a_row_from_top_to_bottom() {
    let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
    let mut display = panel(SIZE).only(is_a_row);
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    renderer.draw(&mut display).unwrap();
    assert!(display.inner().inner().is_full());
    let row = |y| Rectangle::new(Point::new(0, y), Size::new(40, 1));
    let rows: Vec<_> = (0..30).map(|y| Call::Contiguous(row(y))).collect();
    assert_eq!(*display.inner().calls(), rows);
}

#[test]
fn every_way_of_drawing_writes_every_pixel_exactly_once() {
    fn check(size: Size, quality: impl Quality) {
        let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
        let settings = settings().with_quality(quality);
        let mut renderer = Renderer::new(&scene(), &camera(), size, settings, &mut workspace).unwrap();
        once(size, |display| renderer.draw(display));
    }
    fn once(size: Size, draw: impl FnOnce(&mut Watched) -> Result<(), BusFault>) {
        let canvas = memory(Rectangle::new(Point::new(-7, 11), size));
        let mut display = Strict::new(Once::new(canvas, vec![false; (size.width * size.height) as usize]));
        draw(&mut display).unwrap();
        display.inner().assert_complete();
    }
    type Watched = Strict<Once<Memory<Rgb565>, Vec<bool>>>;
    for size in [SIZE, Size::new(1, 1), Size::new(37, 3), Size::new(8, 21)] {
        check(size, Exact);
        check(size, Adaptive);
        check(size, Jittered(2));
        check(size, AtEdges(Uniform(2)));
        let mut workspace = RasterWorkspace::<f32, 40>::new();
        let mut raster = RasterRenderer::new(&scene(), &camera(), size, settings(), &mut workspace).unwrap();
        once(size, |display| raster.draw(display));
        let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
        let mut renderer = Renderer::new(&scene(), &camera(), size, settings(), &mut workspace).unwrap();
        let mut progress = Progress::new(1);
        once(size, |display| {
            while renderer.refine(&mut progress, display)? {}
            Ok(())
        });
    }
}

#[test]
fn the_embedded_graphics_mock_display_accepts_the_picture() {
    let mut workspace = Workspace::<f32, BinaryColor, 64, 1>::new();
    let mut display = MockDisplay::new();
    let size = display.bounding_box().size;
    Renderer::new(&scene(), &camera(), size, Settings::new(), &mut workspace)
        .unwrap()
        .draw(&mut display)
        .unwrap();
    assert_eq!(display.affected_area().size, size);
}

#[test]
fn a_picture_in_the_middle_of_a_display_has_the_same_pixels() {
    let mut workspace = Workspace::<f32, Gray4, 40, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    let mut alone = panel(SIZE).only(is_a_row);
    renderer.draw(&mut alone).unwrap();
    let mut larger = panel(Size::new(100, 50)).only(is_a_row);
    renderer.draw_at(Point::new(17, 9), &mut larger).unwrap();
    for (i, pixel) in pixels(&alone).iter().enumerate() {
        assert_eq!(pixels(&larger)[(i / 40 + 9) * 100 + i % 40 + 17], *pixel);
    }
    assert_eq!(pixels(&larger).iter().flatten().count(), 40 * 30);
}

#[test]
fn parts_put_together_are_the_whole_picture() {
    let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    let mut whole = panel(SIZE).only(is_a_row);
    renderer.draw(&mut whole).unwrap();
    let mut tiled = panel(SIZE).only(is_a_row);
    // The last tiles reach over the edges of the picture.
    for (x, y) in (0..30).step_by(7).flat_map(|y| (0..40).step_by(11).map(move |x| (x, y))) {
        let part = Rectangle::new(Point::new(x, y), Size::new(11, 7));
        renderer.draw_part(&part, Point::zero(), &mut tiled).unwrap();
    }
    assert_eq!(pixels(&tiled), pixels(&whole));
}

#[test]
fn a_part_outside_the_picture_draws_nothing() {
    let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    let mut display = panel::<Rgb565>(SIZE).only(is_a_row);
    let part = Rectangle::new(Point::new(60, 5), Size::new(4, 4));
    renderer.draw_part(&part, Point::zero(), &mut display).unwrap();
    let nothing = Rectangle::new(Point::new(3, 5), Size::new(0, 100));
    renderer.draw_part(&nothing, Point::zero(), &mut display).unwrap();
    assert!(display.inner().calls().is_empty());
}

#[test]
fn a_display_that_does_not_begin_at_zero_is_drawn_from_its_own_corner() {
    let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    let mut display = panel_of(Rectangle::new(Point::new(-8, 5), SIZE)).only(is_a_row);
    renderer.draw(&mut display).unwrap();
    assert!(display.inner().inner().is_full());
}

#[test]
fn rows_and_their_bus_bytes_are_those_of_the_picture_in_any_order() {
    let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    let mut display = panel(SIZE).only(is_a_row);
    renderer.draw(&mut display).unwrap();
    for y in [29, 0, 14, 15, 3] {
        let (mut colors, mut bytes) = ([Rgb565::BLACK; 40], [[0_u8; 2]; 40]);
        renderer.render_row(y, &mut colors).unwrap();
        renderer.render_row(y, &mut bytes).unwrap();
        for x in 0..40 {
            let pixel = pixels(&display)[y as usize * 40 + x].unwrap();
            assert_eq!(colors[x], pixel);
            assert_eq!(bytes[x].as_slice(), pixel.to_be_bytes().as_ref());
        }
    }
}

#[test]
fn a_row_that_is_not_there_or_a_buffer_of_another_length_is_refused() {
    let mut workspace = Workspace::<f32, Rgb565, 0, 2>::new();
    let mut renderer = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace).unwrap();
    let mut row = [Rgb565::BLACK; 40];
    assert_eq!(renderer.render_row(30, &mut row), Err(RowError::NoSuchRow(30)));
    let short = RowError::BufferLength { width: 40, length: 39 };
    assert_eq!(renderer.render_row(0, &mut row[..39]), Err(short));
    assert_eq!(renderer.render_row(0, &mut row), Ok(()));
}

#[test]
fn what_does_not_fit_the_workspace_is_refused_with_its_measure() {
    let mut workspace = Workspace::<f32, Rgb565, 39, 2>::new();
    let wide = Renderer::new(&scene(), &camera(), SIZE, settings(), &mut workspace);
    assert_eq!(wide.err(), Some(RenderError::RowTooWide { width: 40, room: 39 }));
    let mut workspace = Workspace::<f32, Rgb565, 40, 2>::new();
    let deep = Renderer::new(&scene(), &camera(), SIZE, settings().with_depth(3), &mut workspace);
    assert_eq!(deep.err(), Some(RenderError::TooDeep { depth: 3, room: 2 }));
    let dark = settings().with_exposure(f32::NAN);
    let dark = Renderer::new(&scene(), &camera(), SIZE, dark, &mut workspace);
    assert_eq!(dark.err(), Some(RenderError::Exposure));
}
