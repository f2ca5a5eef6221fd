//! The ESP32-C3: its clocks, its pins, and the panel on them.
//!
//! | ESP32-C3 | panel |
//! |---|---|
//! | GPIO 4 | D/C |
//! | GPIO 5 | CS |
//! | GPIO 6 | SCL (SPI clock) |
//! | GPIO 7 | SDA (SPI data) |
//! | GPIO 3 | backlight |
//! | GPIO 10 | reset |

use embedded_hal::delay::DelayNs;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use esp_hal::{
    Blocking,
    clock::CpuClock,
    gpio::{Level, Output, OutputConfig},
    spi::{
        Mode,
        master::{Config, Spi},
    },
    time::{Duration, Instant, Rate},
};
use mipidsi::{
    Builder,
    interface::SpiInterface,
    models::ST7789,
    options::{ColorInversion, ColorOrder, Orientation},
};

/// Counts the columns of the panel.
pub const WIDTH: u16 = 240;
/// Counts the rows of the panel.
pub const HEIGHT: u16 = 240;

/// Is the column and row of the controller's memory that the panel's first pixel shows.
const OFFSET: (u16, u16) = (0, 0);
/// Is which way up the panel is held, and whether it mirrors.
const ORIENTATION: Orientation = Orientation::new();
/// Says whether the glass shows colours inverted, as that of most ST7789 modules does.
const INVERSION: ColorInversion = ColorInversion::Inverted;
/// Is the order of the colours of a pixel.
const ORDER: ColorOrder = ColorOrder::Rgb;
/// Is the clock of the bus. The ST7789 takes 62 500 000; long wires do not.
const SPI_HZ: u32 = 40_000_000;
/// Holds as many bytes as go to the bus at a time.
pub const BUFFER: usize = 512;

type Wires<'b> =
    SpiInterface<'b, ExclusiveDevice<Spi<'static, Blocking>, Output<'static>, NoDelay>, Output<'static>>;

/// Is the panel, as a display of embedded-graphics.
pub type Display<'b> = mipidsi::Display<Wires<'b>, ST7789, Output<'static>>;

/// Says that the panel cannot be reached.
pub struct NoAnswer;

/// Starts the clocks and the panel, whose pixels go to the bus by way of `bytes`.
///
/// It panics when it is called twice.
pub fn take(bytes: &mut [u8; BUFFER]) -> Result<Display<'_>, NoAnswer> {
    let p = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));
    let output = OutputConfig::default;
    // The panel reads bits on rising edges.
    let settings = Config::default().with_frequency(Rate::from_hz(SPI_HZ)).with_mode(Mode::_0);
    let bus = Spi::new(p.SPI2, settings).map_err(|_| NoAnswer)?.with_sck(p.GPIO6).with_mosi(p.GPIO7);
    let select = Output::new(p.GPIO5, Level::High, output());
    let data = Output::new(p.GPIO4, Level::Low, output());
    let reset = Output::new(p.GPIO10, Level::High, output());
    let display = start(bus, (select, data, reset), bytes).ok_or(NoAnswer)?;
    // A pin that is let go keeps its level.
    Output::new(p.GPIO3, Level::High, output());
    Ok(display)
}

/// Wakes the panel; answers nothing when a pin or the bus cannot be driven.
fn start<'b>(
    bus: Spi<'static, Blocking>,
    (select, data, reset): (Output<'static>, Output<'static>, Output<'static>),
    bytes: &'b mut [u8; BUFFER],
) -> Option<Display<'b>> {
    let device = ExclusiveDevice::new_no_delay(bus, select).ok()?;
    Builder::new(ST7789, SpiInterface::new(device, data, bytes))
        .display_size(WIDTH, HEIGHT)
        .display_offset(OFFSET.0, OFFSET.1)
        .orientation(ORIENTATION)
        .invert_colors(INVERSION)
        .color_order(ORDER)
        .reset_pin(reset)
        .init(&mut Wait)
        .ok()
}

/// Waits by the system's timer.
struct Wait;

impl DelayNs for Wait {
    fn delay_ns(&mut self, ns: u32) {
        // The timer counts microseconds: one too many rather than one too few.
        let time = Duration::from_micros(u64::from(ns).div_ceil(1000) + 1);
        let start = Instant::now();
        while start.elapsed() < time {}
    }
}
