//! Each display does what it says, alone and around another.

use draw_faults::{At, Call, Canvas, Counting, Counts, Failing, Fallible, Logging, Once, Stalling, Strict};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb666};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle};

/// Is an error that says too much to be made up by anybody else.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Broken {
    line: u8,
    says: &'static str,
}

const BROKEN: Broken = Broken { line: 3, says: "no acknowledge" };

type Memory = Canvas<Gray8, Vec<Option<Gray8>>, Broken>;

const fn area(x: i32, y: i32, width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

const ALL: Rectangle = area(0, 0, 6, 4);

fn memory() -> Memory {
    Canvas::new(ALL, vec![None; 24])
}

fn grays(count: usize) -> impl Iterator<Item = Gray8> {
    (1..=count).map(|gray| Gray8::new(gray as u8))
}

/// Answers how many pixels of a canvas are drawn.
fn drawn(canvas: &Memory) -> usize {
    canvas.pixels().iter().flatten().count()
}

#[test]
fn a_canvas_keeps_what_lies_within_and_leaves_out_the_rest() {
    let mut canvas = Canvas::<Gray8, _, Broken>::new(area(-2, 5, 3, 2), [None; 6]);
    canvas.fill_contiguous(&area(-3, 4, 3, 3), grays(9)).unwrap();
    canvas.draw_iter([Pixel(Point::new(1, 5), Gray8::WHITE), Pixel(Point::new(0, 7), Gray8::WHITE)]).unwrap();
    let levels: Vec<_> = canvas.pixels().iter().map(|pixel| pixel.map(|gray| gray.luma())).collect();
    assert_eq!(levels, [Some(5), Some(6), None, Some(8), Some(9), None]);
    assert_eq!(canvas.pixel(Point::new(-2, 6)), Some(Gray8::new(8)));
    assert_eq!(canvas.pixel(Point::new(1, 6)), None);
    canvas.fill_solid(&area(i32::MAX - 1, i32::MIN, 9, 9), Gray8::WHITE).unwrap();
    assert!(!canvas.is_full());
    canvas.clear(Gray8::BLACK).unwrap();
    assert!(canvas.is_full());
}

#[test]
#[should_panic(expected = "23 places for the pixels of Size { width: 6, height: 4 }")]
fn a_canvas_of_another_size_than_its_memory_is_refused() {
    let _ = Canvas::<Gray8, _, Broken>::new(ALL, [None; 23]);
}

#[test]
fn it_fails_before_the_call_of_that_number_once() {
    let mut display = Failing::once(memory(), At::Call(2), BROKEN);
    let pixel = Pixel(Point::new(5, 3), Gray8::WHITE);
    display.draw_iter([pixel]).unwrap();
    display.fill_solid(&area(0, 0, 2, 1), Gray8::WHITE).unwrap();
    assert_eq!(display.fill_contiguous(&area(0, 1, 6, 1), grays(6)), Err(BROKEN));
    assert_eq!(drawn(display.inner()), 3);
    display.fill_contiguous(&area(0, 1, 6, 1), grays(6)).unwrap();
    assert_eq!((drawn(display.inner()), display.failures()), (9, 1));
}

#[test]
fn it_fails_from_a_call_on() {
    let mut display = Failing::from_then_on(memory(), At::Call(1), BROKEN);
    display.clear(Gray8::BLACK).unwrap();
    for _ in 0..3 {
        assert_eq!(display.clear(Gray8::WHITE), Err(BROKEN));
    }
    assert!(display.inner().pixels().iter().all(|pixel| *pixel == Some(Gray8::BLACK)));
    assert_eq!(display.failures(), 3);
}

#[test]
fn it_fails_between_two_pixels_of_every_kind_of_call() {
    for pixel in 0..24 {
        let fails = || Failing::once(memory(), At::Pixel(pixel), BROKEN);
        let [mut one_by_one, mut contiguous, mut solid] = [fails(), fails(), fails()];
        let pixels = || ALL.points().zip(grays(24)).map(|(point, gray)| Pixel(point, gray));
        assert_eq!(one_by_one.draw_iter(pixels()), Err(BROKEN));
        assert_eq!(contiguous.fill_contiguous(&ALL, grays(24)), Err(BROKEN));
        assert_eq!(solid.fill_solid(&ALL, Gray8::WHITE), Err(BROKEN));
        for display in [&one_by_one, &contiguous, &solid] {
            let before = display.inner().pixels().iter().take_while(|pixel| pixel.is_some()).count();
            assert_eq!([before, drawn(display.inner())], [pixel as usize; 2]);
        }
        one_by_one.draw_iter(pixels()).unwrap();
        contiguous.fill_contiguous(&ALL, grays(24)).unwrap();
        assert_eq!(one_by_one.inner().pixels(), contiguous.inner().pixels());
        assert!(contiguous.inner().is_full());
    }
}

#[test]
fn pixels_are_counted_over_calls_and_a_drawing_that_ends_before_does_not_fail() {
    let mut display = Failing::from_then_on(memory(), At::Pixel(24), BROKEN);
    display.fill_contiguous(&area(0, 0, 6, 2), grays(12)).unwrap();
    display.fill_solid(&area(0, 2, 6, 2), Gray8::WHITE).unwrap();
    assert_eq!(display.failures(), 0);
    assert_eq!(display.fill_contiguous(&area(0, 0, 1, 1), grays(1)), Err(BROKEN));
    assert_eq!(display.fill_solid(&area(0, 0, 1, 1), Gray8::WHITE), Err(BROKEN));
    assert_eq!(display.inner().pixel(Point::zero()), Some(Gray8::new(1)));
}

#[test]
fn a_solid_fill_stays_one_unless_it_fails() {
    let logging = Logging::new(memory(), Vec::new());
    let mut display = Failing::once(logging, At::Pixel(24), BROKEN);
    display.clear(Gray8::BLACK).unwrap();
    assert_eq!(display.clear(Gray8::WHITE), Err(BROKEN));
    assert_eq!(*display.inner().calls(), [Call::Solid(ALL), Call::Contiguous(ALL)]);
}

#[test]
fn it_stalls_so_often_and_then_works() {
    let mut display = Stalling::new(memory(), 3, BROKEN);
    for _ in 0..3 {
        assert_eq!(display.clear(Gray8::BLACK), Err(BROKEN));
    }
    assert_eq!(drawn(display.inner()), 0);
    for _ in 0..100 {
        display.clear(Gray8::BLACK).unwrap();
    }
    assert_eq!(display.stalls(), 3);
}

#[test]
fn it_stalls_again_when_so_many_calls_have_worked() {
    let mut display = Stalling::new(memory(), 2, BROKEN).every(3);
    let works: Vec<_> = (0..12).map(|_| display.clear(Gray8::BLACK).is_ok()).collect();
    let once = [false, false, true, true, true];
    assert_eq!(works, [&once[..], &once, &once[..2]].concat());
    let mut never = Stalling::new(memory(), 0, BROKEN).every(0);
    assert!((0..9).all(|_| never.clear(Gray8::BLACK).is_ok()));
}

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

#[test]
fn a_display_that_cannot_fail_gets_an_error_of_the_users() {
    let mock = MockDisplay::<BinaryColor>::new();
    let mut display = Failing::once(Fallible::new(mock), At::Call(0), BROKEN);
    let square = area(2, 2, 3, 3).into_styled(PrimitiveStyle::with_fill(BinaryColor::On));
    assert_eq!(square.draw(&mut display), Err(BROKEN));
    square.draw(&mut display).unwrap();
    display.inner().inner().assert_pattern(&["     ", "     ", "  ###", "  ###", "  ###"]);
}

#[test]
fn they_combine_and_the_display_within_keeps_its_area() {
    let canvas = Canvas::<Gray8, _, Broken>::new(area(-3, 7, 6, 4), vec![None; 24]);
    let failing = Failing::once(canvas, At::Call(1), BROKEN);
    let counting = Counting::new(Stalling::new(failing, 1, Broken { line: 1, ..BROKEN }));
    let mut display = Strict::new(Once::new(counting, [false; 24]));
    assert_eq!(display.bounding_box(), area(-3, 7, 6, 4));
    let mut row = |y| display.fill_contiguous(&area(-3, y, 6, 1), grays(6));
    assert_eq!(row(7).unwrap_err().line, 1);
    row(7).unwrap();
    assert_eq!(row(8), Err(BROKEN));
    (8..11).for_each(|y| row(y).unwrap());
    display.inner().assert_complete();
    assert_eq!(display.inner().inner().counts().fill_contiguous, 6);
}
