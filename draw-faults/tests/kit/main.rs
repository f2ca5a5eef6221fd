//! Each display does what it says, alone and around another.

mod faults;
mod watching;

use draw_faults::{At, Canvas, Counting, Failing, Fallible, Once, Stalling, Strict};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Gray8};
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
