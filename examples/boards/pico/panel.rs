//! The panel: mipidsi wakes it and opens its window, DMA sends the pixels.

use embedded_hal::{delay::DelayNs, digital::OutputPin};
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::{
    Builder,
    dcs::{InterfaceExt, SetColumnAddress, SetPageAddress, WriteMemoryStart},
    interface::{Interface, SpiInterface},
    models::ST7789,
    options::ColorInversion,
};
use rp2040_hal::{
    Spi,
    dma::{CH0, CH1, Channel, double_buffer},
    gpio::{
        FunctionSio, FunctionSpi, Pin, PullDown, SioOutput,
        bank0::{Gpio16, Gpio17, Gpio18, Gpio19},
    },
    pac,
    spi::Enabled,
};

use super::super::wire::Wire;

/// Counts the pixels of a row, and the rows, of the panel.
pub const SIDE: usize = 240;

/// Is a row of pixels in a buffer that DMA may read: it lives as long as the firmware.
pub type Row = &'static mut [[u8; 2]; SIDE];

/// Is a pin that drives something.
pub type Output<P> = Pin<P, FunctionSio<SioOutput>, PullDown>;

type SpiPin<P> = Pin<P, FunctionSpi, PullDown>;

/// Is the bus to the panel.
pub type Bus = Spi<Enabled, pac::SPI0, (SpiPin<Gpio19>, SpiPin<Gpio18>), 8>;

/// Is the two DMA channels that take turns, so that a row follows the last without a gap.
pub type Channels = (Channel<CH0>, Channel<CH1>);

pub(super) type Commands<'a> =
    SpiInterface<'a, ExclusiveDevice<&'a mut Bus, &'a mut Output<Gpio17>, NoDelay>, &'a mut Output<Gpio16>>;

/// Is an ST7789 on its bus.
pub struct Panel {
    line: Line,
    select: Output<Gpio17>,
    data: Output<Gpio16>,
}

/// Is the way from buffers to the bus, with the buffer that is on it.
enum Line {
    Idle(Channels, Row, Bus),
    Busy(double_buffer::Transfer<Channel<CH0>, Channel<CH1>, Row, Bus, ()>),
}

impl Line {
    /// Waits until the last bit is out.
    fn settle(self) -> (Channels, Row, Bus) {
        let (channels, row, bus) = match self {
            Self::Idle(channels, row, bus) => (channels, row, bus),
            Self::Busy(transfer) => {
                let (first, second, row, bus) = transfer.wait();
                ((first, second), row, bus)
            }
        };
        // DMA is done when the last byte is in the bus's queue, eight bytes before it is out.
        while bus.is_busy() {}
        (channels, row, bus)
    }
}

impl Panel {
    /// Wakes the panel; `spare` is the buffer that stands in for the row before the first.
    ///
    /// Answers nothing when a pin or the bus cannot be driven.
    pub fn new(
        (channels, spare, mut bus): (Channels, Row, Bus),
        (mut select, mut data, reset): (Output<Gpio17>, Output<Gpio16>, impl OutputPin),
        delay: &mut impl DelayNs,
    ) -> Option<Self> {
        Builder::new(ST7789, commands(&mut bus, &mut select, &mut data, &mut [])?)
            .display_size(SIDE as u16, SIDE as u16)
            .invert_colors(ColorInversion::Inverted)
            .reset_pin(reset)
            .init(delay)
            .ok()?;
        Some(Self { line: Line::Idle(channels, spare, bus), select, data })
    }

    /// Begins a frame: pixels that follow fill the panel from its upper left corner.
    pub fn begin(self) -> Option<Self> {
        let Self { line, mut select, mut data } = self.end()?;
        let (channels, spare, mut bus) = line.settle();
        open_window(commands(&mut bus, &mut select, &mut data, &mut [])?).ok()?;
        select.set_low().ok()?;
        Some(Self { line: Line::Idle(channels, spare, bus), select, data })
    }

    /// Answers bus, select and D/C, once the last pixel is out.
    #[allow(dead_code, reason = "rows go by DMA in most of the firmware")]
    pub(super) fn into_parts(self) -> (Bus, Output<Gpio17>, Output<Gpio16>) {
        let (_, _, bus) = self.line.settle();
        (bus, self.select, self.data)
    }

    /// Ends a frame, once its last pixel is out.
    pub fn end(self) -> Option<Self> {
        let Self { line, mut select, data } = self;
        let (channels, spare, bus) = line.settle();
        select.set_high().ok()?;
        Some(Self { line: Line::Idle(channels, spare, bus), select, data })
    }
}

impl Wire<Row> for Panel {
    fn exchange(self, full: Row) -> (Self, Row) {
        let (transfer, empty) = match self.line {
            Line::Idle(channels, spare, bus) => {
                (double_buffer::Config::new(channels, full, bus).start(), spare)
            }
            Line::Busy(transfer) => {
                let (empty, transfer) = transfer.read_next(full).wait();
                (transfer, empty)
            }
        };
        (Self { line: Line::Busy(transfer), ..self }, empty)
    }
}

/// Answers the panel's command interface, which leaves D/C at "data"; it needs a buffer only for pixels.
pub(super) fn commands<'a>(
    bus: &'a mut Bus,
    select: &'a mut Output<Gpio17>,
    data: &'a mut Output<Gpio16>,
    buffer: &'a mut [u8],
) -> Option<Commands<'a>> {
    Some(SpiInterface::new(ExclusiveDevice::new_no_delay(bus, select).ok()?, data, buffer))
}

fn open_window<I: Interface>(mut panel: I) -> Result<(), I::Error> {
    panel.write_command(SetColumnAddress::new(0, SIDE as u16 - 1))?;
    panel.write_command(SetPageAddress::new(0, SIDE as u16 - 1))?;
    panel.write_command(WriteMemoryStart)
}
