use draw_faults::{Call, Canvas, Logging, Strict};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// Is the error of every display here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BusFault(pub usize);

/// Is a display that keeps its pixels.
pub type Memory<C> = Canvas<C, Vec<Option<C>>, BusFault>;

/// Is a display that keeps what it was sent and how, and accepts nothing but whole areas inside of it.
pub type Panel<C> = Strict<Logging<Memory<C>, Vec<Call>>>;

/// Makes a panel that begins at zero.
pub fn panel<C: PixelColor>(size: Size) -> Panel<C> {
    panel_of(Rectangle::new(Point::zero(), size))
}

pub fn panel_of<C: PixelColor>(area: Rectangle) -> Panel<C> {
    Strict::new(Logging::new(memory(area), Vec::new())).only(|call| *call != Call::Pixels)
}

pub fn memory<C: PixelColor>(area: Rectangle) -> Memory<C> {
    Canvas::new(area, vec![None; (area.size.width * area.size.height) as usize])
}

/// Tells whether a call is one row of pixels.
pub fn is_a_row(call: &Call) -> bool {
    matches!(call, Call::Contiguous(area) if area.size.height == 1)
}

/// Answers the pixels of a panel, row by row.
pub fn pixels<C: PixelColor>(panel: &Panel<C>) -> &[Option<C>] {
    panel.inner().inner().pixels()
}

/// Answers how many pixels were sent.
pub fn written<C: PixelColor>(panel: &Panel<C>) -> u32 {
    let areas = panel.inner().calls().iter().filter_map(Call::area);
    areas.map(|area| area.size.width * area.size.height).sum()
}
