//! The SSD0323 controller: 128x64 pixels of 16 greys behind a serial bus.

use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiDevice};

/// Counts the pixels of a row.
pub const WIDTH: u32 = 128;
/// Counts the rows.
pub const HEIGHT: u32 = 64;

/// Counts the bytes of a row: two pixels share a byte.
const ROW_BYTES: usize = WIDTH as usize / 2;

/// Lists the power-up settings for this panel, as its maker gives them.
const SETTINGS: &[&[u8]] = &[
    // contrast
    &[0x81, 50],
    // half the current
    &[0x85],
    // left pixel in the high half of a byte, rows from the top
    &[0xa0, 0x52],
    // first line
    &[0xa1, 0],
    // offset of the glass
    &[0xa2, 76],
    // show memory
    &[0xa4],
    // rows that are driven
    &[0xa8, 63],
    // phase length
    &[0xb1, 0x22],
    // row period
    &[0xb2, 70],
    // clock divider
    &[0xb3, 0xf1],
    // low voltage of the segments
    &[0xbf, 0x0d],
    // high voltage of the rows
    &[0xbe, 0x02],
    // precharge voltage
    &[0xbc, 0x10],
    // steps of the greys
    &[0xb8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76],
    // panel's own voltage converter on
    &[0xad, 0x03],
];

/// Says why something was not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Error<S, P> {
    /// Says that the bus failed.
    Bus(S),
    /// Says that the D/C pin failed.
    Pin(P),
    /// Says that half a byte cannot be written, as the controller cannot be read over its serial bus: areas must begin and end on
    /// even columns.
    HalfByte,
}

/// Names what a panel on the bus `S` with the D/C pin `P` may complain about.
type ErrorOf<S, P> =
    Error<<S as embedded_hal::spi::ErrorType>::Error, <P as embedded_hal::digital::ErrorType>::Error>;

/// Is the panel as an `embedded-graphics` target. It holds no picture: all it needs is a row of 64 bytes on the stack.
pub struct Ssd0323<S, P> {
    bus: S,
    data_not_command: P,
}

impl<S: SpiDevice, P: OutputPin> Ssd0323<S, P> {
    /// Sets the panel up, clears it and turns it on.
    pub fn new(bus: S, data_not_command: P) -> Result<Self, ErrorOf<S, P>> {
        let mut panel = Self { bus, data_not_command };
        for command in SETTINGS {
            panel.command(command)?;
        }
        panel.fill_solid(&panel.bounding_box(), Gray4::BLACK)?;
        panel.command(&[0xaf])?;
        Ok(panel)
    }

    fn command(&mut self, bytes: &[u8]) -> Result<(), ErrorOf<S, P>> {
        self.data_not_command.set_low().map_err(Error::Pin)?;
        self.bus.write(bytes).map_err(Error::Bus)
    }

    fn data(&mut self, bytes: &[u8]) -> Result<(), ErrorOf<S, P>> {
        self.data_not_command.set_high().map_err(Error::Pin)?;
        self.bus.write(bytes).map_err(Error::Bus)
    }

    /// Opens `window`, which lies on the panel; the pixels that follow fill it row by row.
    fn open(&mut self, window: &Rectangle) -> Result<(), ErrorOf<S, P>> {
        let [left, top] = [window.top_left.x as u32, window.top_left.y as u32];
        let [width, height] = [window.size.width, window.size.height];
        if left % 2 == 1 || width % 2 == 1 {
            return Err(Error::HalfByte);
        }
        self.command(&[0x15, (left / 2) as u8, ((left + width) / 2 - 1) as u8])?;
        self.command(&[0x75, top as u8, (top + height - 1) as u8])
    }

    /// Sends `colors`, the pixels of `window`, a row a transfer.
    fn send(&mut self, window: &Rectangle, colors: impl Iterator<Item = Gray4>) -> Result<(), ErrorOf<S, P>> {
        self.open(window)?;
        let mut colors = colors.fuse();
        let mut row = [0; ROW_BYTES];
        for _ in 0..window.size.height {
            let mut sent = 0;
            for (byte, _) in row.iter_mut().zip(0..window.size.width / 2) {
                let (Some(left), Some(right)) = (colors.next(), colors.next()) else { break };
                *byte = left.luma() << 4 | right.luma();
                sent += 1;
            }
            self.data(row.get(..sent).unwrap_or_default())?;
        }
        Ok(())
    }
}

impl<S, P> OriginDimensions for Ssd0323<S, P> {
    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT)
    }
}

impl<S: SpiDevice, P: OutputPin> DrawTarget for Ssd0323<S, P> {
    type Color = Gray4;
    type Error = ErrorOf<S, P>;

    /// Draws pairs of neighbours that share a byte, left one first; a pixel without its other half is an error.
    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        let panel = self.bounding_box();
        let mut pixels = pixels.into_iter().filter(|pixel| panel.contains(pixel.0));
        while let Some(Pixel(at, left)) = pixels.next() {
            match pixels.next() {
                Some(Pixel(next, right)) if next == at + Point::new(1, 0) => {
                    self.send(&Rectangle::new(at, Size::new(2, 1)), [left, right].into_iter())?;
                }
                _ => return Err(Error::HalfByte),
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Gray4>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Self::Error> {
        let window = area.intersection(&self.bounding_box());
        if window.is_zero_sized() {
            return Ok(());
        }
        if window == *area {
            return self.send(area, colors.into_iter());
        }
        let seen = area.points().zip(colors).filter(|(at, _)| window.contains(*at));
        self.send(&window, seen.map(|(_, color)| color))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray4) -> Result<(), Self::Error> {
        let window = area.intersection(&self.bounding_box());
        if window.is_zero_sized() {
            return Ok(());
        }
        self.send(&window, core::iter::repeat(color))
    }
}
