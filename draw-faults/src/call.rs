use embedded_graphics_core::primitives::Rectangle;

/// Is what a display was asked to do.
///
/// `clear` is none of its own: it is a solid fill of the whole display, as embedded-graphics has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    /// Is a call of `draw_iter`.
    Pixels,
    /// Is a call of `fill_contiguous` for an area.
    Contiguous(Rectangle),
    /// Is a call of `fill_solid` for an area.
    Solid(Rectangle),
}

impl Call {
    /// Answers the area that is filled; nothing where pixels are drawn one by one.
    pub const fn area(&self) -> Option<Rectangle> {
        match self {
            Self::Pixels => None,
            Self::Contiguous(area) | Self::Solid(area) => Some(*area),
        }
    }
}

/// Answers how many pixels an area has.
pub(crate) fn pixels(area: &Rectangle) -> u64 {
    u64::from(area.size.width) * u64::from(area.size.height)
}

/// Tells whether an area holds all pixels of another, whatever their corners.
pub(crate) fn covers(outer: &Rectangle, inner: &Rectangle) -> bool {
    let end = |start: i32, length: u32| i64::from(start) + i64::from(length);
    let columns = |area: &Rectangle| (area.top_left.x, end(area.top_left.x, area.size.width));
    let rows = |area: &Rectangle| (area.top_left.y, end(area.top_left.y, area.size.height));
    [(columns(outer), columns(inner)), (rows(outer), rows(inner))]
        .iter()
        .all(|(outer, inner)| outer.0 <= inner.0 && inner.1 <= outer.1)
}
