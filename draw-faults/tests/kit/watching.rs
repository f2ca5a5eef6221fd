//! Displays that count and complain.

use super::{ALL, BROKEN, area, drawn, grays, memory};
use draw_faults::{At, Call, Canvas, Counting, Counts, Failing, Logging, Once, Stalling, Strict};
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb666};
use embedded_graphics::prelude::*;

#[test]
fn calls_pixels_and_bytes_are_counted() {
    let mut display = Counting::new(memory());
    display.fill_contiguous(&area(0, 0, 6, 1), grays(6)).unwrap();
    display.fill_contiguous(&area(0, 1, 6, 1), grays(4)).unwrap();
    display.draw_iter([Pixel(Point::zero(), Gray8::WHITE); 2]).unwrap();
    display.clear(Gray8::BLACK).unwrap();
    let counts = Counts { draw_iter: 1, fill_contiguous: 2, fill_solid: 1, pixels: 36, bytes: 36 };
    assert_eq!(display.counts(), counts);
    assert_eq!(counts.calls(), 4);
    assert_eq!(display.restart(), counts);
    assert_eq!(display.counts(), Counts::default());
}

#[test]
fn bytes_are_those_of_the_colour() {
    fn bytes<C: PixelColor>(color: C) -> u64 {
        let mut display = Counting::new(Canvas::<C, _>::new(ALL, vec![None; 24]));
        let Ok(()) = display.fill_solid(&area(0, 0, 6, 2), color);
        let Ok(()) = display.fill_solid(&area(0, 0, 3, 3), color);
        display.counts().bytes
    }
    assert_eq!(bytes(Rgb565::RED), 42);
    assert_eq!(bytes(Rgb666::RED), 63);
    // 12 bits are 2 bytes, 9 are 2 again.
    assert_eq!(bytes(BinaryColor::On), 4);
}

#[test]
fn up_to_the_pixel_that_a_bus_breaks_at_pixels_are_counted() {
    let mut display = Counting::new(Failing::once(memory(), At::Pixel(4), BROKEN));
    assert_eq!(display.fill_contiguous(&area(0, 0, 6, 1), grays(6)), Err(BROKEN));
    // The fifth was offered and lost.
    assert_eq!(display.counts().pixels, 5);
    assert_eq!(drawn(display.inner().inner()), 4);
}

#[test]
fn the_list_of_calls_is_the_calls() {
    let mut display = Logging::new(Stalling::new(memory(), 1, BROKEN), Vec::new());
    assert_eq!(display.fill_contiguous(&area(1, 1, 2, 1), grays(2)), Err(BROKEN));
    display.draw_iter([Pixel(Point::zero(), Gray8::WHITE)]).unwrap();
    display.clear(Gray8::BLACK).unwrap();
    assert_eq!(*display.calls(), [Call::Contiguous(area(1, 1, 2, 1)), Call::Pixels, Call::Solid(ALL)]);
    assert_eq!(display.calls().iter().filter_map(Call::area).count(), 2);
}

#[test]
fn strictness_lets_pass_what_is_right() {
    let mut display = Strict::new(memory()).only(|call| *call != Call::Pixels);
    display.fill_contiguous(&ALL, grays(24)).unwrap();
    display.fill_contiguous(&area(5, 3, 1, 1), grays(1)).unwrap();
    display.clear(Gray8::WHITE).unwrap();
    let mut display = Strict::new(memory());
    display.draw_iter([Pixel(Point::new(5, 3), Gray8::WHITE)]).unwrap();
}

#[test]
#[should_panic(expected = "23 colours for the 24 pixels")]
fn too_few_colours_are_found() {
    Strict::new(memory()).fill_contiguous(&ALL, grays(23)).unwrap();
}

#[test]
#[should_panic(expected = "more colours than the 24 pixels")]
fn a_colour_too_many_is_found() {
    Strict::new(memory()).fill_contiguous(&ALL, grays(25)).unwrap();
}

#[test]
#[should_panic(expected = "more colours than the 24 pixels")]
fn colours_without_end_are_found() {
    Strict::new(memory()).fill_contiguous(&ALL, core::iter::repeat(Gray8::WHITE)).unwrap();
}

#[test]
#[should_panic(expected = "reaches beyond")]
fn an_area_that_reaches_beyond_the_display_is_found() {
    Strict::new(memory()).fill_solid(&area(4, 3, 3, 1), Gray8::WHITE).unwrap();
}

#[test]
#[should_panic(expected = "reaches beyond")]
fn an_area_at_the_end_of_all_coordinates_is_found() {
    Strict::new(memory()).fill_solid(&area(i32::MAX, i32::MAX, 9, 9), Gray8::WHITE).unwrap();
}

#[test]
#[should_panic(expected = "an area without pixels")]
fn an_empty_area_is_found() {
    Strict::new(memory()).fill_contiguous(&area(1, 1, 0, 3), grays(0)).unwrap();
}

#[test]
#[should_panic(expected = "pixel (6, 0) is outside of")]
fn a_pixel_outside_is_found() {
    Strict::new(memory()).draw_iter([Pixel(Point::new(6, 0), Gray8::WHITE)]).unwrap();
}

#[test]
#[should_panic(expected = "not one of the calls allowed: Solid")]
fn a_call_that_is_not_allowed_is_found() {
    Strict::new(memory()).only(|call| matches!(call, Call::Contiguous(_))).clear(Gray8::WHITE).unwrap();
}

#[test]
fn the_pixels_that_are_missing_are_named_until_each_is_drawn_once() {
    let mut display = Once::new(memory(), [true; 24]);
    assert_eq!(display.missing().count(), 24);
    display.fill_contiguous(&area(0, 0, 6, 3), grays(18)).unwrap();
    display.fill_solid(&area(0, 3, 4, 1), Gray8::WHITE).unwrap();
    display.draw_iter([Pixel(Point::new(5, 3), Gray8::WHITE)]).unwrap();
    assert!(display.missing().eq([Point::new(4, 3)]));
    display.draw_iter([Pixel(Point::new(4, 3), Gray8::WHITE)]).unwrap();
    display.assert_complete();
    display.restart();
    display.clear(Gray8::WHITE).unwrap();
    display.assert_complete();
}

#[test]
#[should_panic(expected = "6 pixels are not drawn, the first at (0, 3)")]
fn a_picture_that_is_not_whole_is_found() {
    let mut display = Once::new(memory(), [false; 24]);
    display.fill_solid(&area(0, 0, 6, 3), Gray8::WHITE).unwrap();
    display.assert_complete();
}

#[test]
#[should_panic(expected = "pixel (2, 1) is drawn a second time")]
fn a_pixel_of_two_fills_is_found() {
    let mut display = Once::new(memory(), [false; 24]);
    display.fill_contiguous(&area(0, 0, 3, 2), grays(6)).unwrap();
    display.fill_solid(&area(2, 1, 2, 2), Gray8::WHITE).unwrap();
}

#[test]
#[should_panic(expected = "pixel (1, 1) is drawn a second time")]
fn a_pixel_that_is_drawn_twice_is_found() {
    let mut display = Once::new(memory(), [false; 24]);
    display.draw_iter([Pixel(Point::new(1, 1), Gray8::WHITE); 2]).unwrap();
}
