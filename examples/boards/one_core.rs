//! One core draws a picture: a row is traced while the one before it travels to the panel.

use super::wire::Wire;

/// Draws rows 0 to `rows` - 1: `trace` fills a buffer with a row while `wire` sends the row before it.
///
/// Answers the wire with the last row still on its way, and the buffer that is free.
pub fn draw<B, W: Wire<B>>(
    rows: u32,
    mut wire: W,
    mut buffer: B,
    mut trace: impl FnMut(u32, &mut B),
) -> (W, B) {
    for y in 0..rows {
        trace(y, &mut buffer);
        (wire, buffer) = wire.exchange(buffer);
    }
    (wire, buffer)
}
