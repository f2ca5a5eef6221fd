//! Displays that keep, fail and stall.

use super::{ALL, BROKEN, Broken, area, drawn, grays, memory};
use draw_faults::{At, Call, Canvas, Failing, Logging, Stalling};
use embedded_graphics::pixelcolor::Gray8;
use embedded_graphics::prelude::*;

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
