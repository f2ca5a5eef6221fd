//! Where the time of a picture goes: that of each row, and of each of its pixels traced alone.

use embedded_graphics::geometry::Size;
use scanray::{Exact, Renderer};

use super::board;
use super::chosen::{HEIGHT, WIDTH};
use super::decimal::Decimal;
use super::scene::VIEW;
use super::{Row, Space};

/// Is how long a number is at most, with the space before it.
const LONGEST: usize = 11;

/// Is a line of numbers: printed whole, since each printing takes the host some time.
struct Line {
    text: [u8; (WIDTH as usize + 1) * LONGEST],
    used: usize,
}

impl Line {
    const EMPTY: Self = Self { text: [0; (WIDTH as usize + 1) * LONGEST], used: 0 };

    /// Adds a space and a number; a full line takes no more.
    fn add(&mut self, number: u32) {
        for byte in b" ".iter().chain(Decimal::new(number).as_bytes()) {
            if let Some(place) = self.text.get_mut(self.used) {
                *place = *byte;
                self.used += 1;
            }
        }
    }

    fn print(&self, name: &[u8]) {
        board::print(&[name, self.text.get(..self.used).unwrap_or_default()]);
    }
}

/// Prints a line for each row: the ticks that it takes whole, then those of each pixel traced alone.
pub fn account() -> Result<(), &'static str> {
    let mut space = Space::new();
    let settings = VIEW.settings.with_quality(Exact);
    let size = Size::new(WIDTH, HEIGHT);
    let mut renderer = Renderer::new(&VIEW.scene, &VIEW.camera, size, settings, &mut space)
        .map_err(|_| "the renderer refuses the scene")?;
    let mut row: Row = [[0; 2]; WIDTH as usize];
    for y in 0..HEIGHT {
        let mut line = Line::EMPTY;
        line.add(timed(|| renderer.render_row(y, &mut row).is_ok())?);
        for x in 0..WIDTH {
            let mut trace = |end| timed(|| renderer.trace_row(y, x..end, &mut (), |_, _| {}).is_ok());
            // What a row takes to begin at a column is no pixel's.
            let begun = trace(x)?;
            line.add(trace(x + 1)?.saturating_sub(begun));
        }
        line.print(b"row");
    }
    Ok(())
}

/// Answers how many ticks something takes that answers whether it went well.
fn timed(act: impl FnOnce() -> bool) -> Result<u32, &'static str> {
    let start = board::ticks();
    let well = act();
    let ticks = board::ticks().wrapping_sub(start);
    if well { Ok(ticks) } else { Err("the renderer refuses a row") }
}
