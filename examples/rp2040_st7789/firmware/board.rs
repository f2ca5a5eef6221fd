//! The Pico: clocks, pins and the panel on SPI0.

use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::{Builder, Display, interface::SpiInterface, models::ST7789, options::ColorInversion};
use rp2040_hal::{
    Clock, Sio, Spi, Timer, Watchdog,
    clocks::init_clocks_and_plls,
    fugit::RateExtU32,
    gpio::{
        FunctionSio, FunctionSpi, Pin, Pins, PullDown, SioOutput,
        bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio21, Gpio25},
    },
    pac,
    spi::Enabled,
};

/// Counts the pixels of a row, and the rows, of the panel.
pub const SIDE: u16 = 240;

/// Is the frequency of the crystal on a Pico.
const CRYSTAL_HZ: u32 = 12_000_000;

/// Is 125 MHz / 2, the fastest SPI0 goes, and just inside the 16 ns write cycle of the ST7789.
const SPI_HZ: u32 = 62_500_000;

type Output<P> = Pin<P, FunctionSio<SioOutput>, PullDown>;
type SpiPin<P> = Pin<P, FunctionSpi, PullDown>;
type Bus = Spi<Enabled, pac::SPI0, (SpiPin<Gpio19>, SpiPin<Gpio18>), 8>;
type PanelBus<'a> = SpiInterface<'a, ExclusiveDevice<Bus, Output<Gpio17>, NoDelay>, Output<Gpio16>>;

/// Is the panel as an `embedded-graphics` target.
pub type Panel<'a> = Display<PanelBus<'a>, ST7789, Output<Gpio21>>;

/// Is the LED on the Pico.
pub type Lamp = Output<Gpio25>;

/// Is what the boot ROM copies to RAM and runs: it sets up the flash chip so that code can run from there.
// SAFETY: `.boot2` is the 256 bytes that `memory.x` keeps for exactly this, and no code of ours refers to it.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT_LOADER: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Answers what is wired to the Pico, or nothing when it was taken before or a part does not answer.
///
/// `batch` gathers pixels on their way to the bus.
pub fn take(batch: &mut [u8]) -> Option<(Panel<'_>, Lamp)> {
    let mut p = pac::Peripherals::take()?;
    let mut watchdog = Watchdog::new(p.WATCHDOG);
    let clocks = init_clocks_and_plls(
        CRYSTAL_HZ,
        p.XOSC,
        p.CLOCKS,
        p.PLL_SYS,
        p.PLL_USB,
        &mut p.RESETS,
        &mut watchdog,
    )
    .ok()?;
    let sio = Sio::new(p.SIO);
    let pins = Pins::new(p.IO_BANK0, p.PADS_BANK0, sio.gpio_bank0, &mut p.RESETS);
    let mut timer = Timer::new(p.TIMER, &mut p.RESETS, &clocks);

    let bus: Bus = Spi::new(p.SPI0, (pins.gpio19.reconfigure(), pins.gpio18.reconfigure())).init(
        &mut p.RESETS,
        clocks.peripheral_clock.freq(),
        SPI_HZ.Hz(),
        embedded_hal::spi::MODE_0,
    );
    let device = ExclusiveDevice::new_no_delay(bus, pins.gpio17.reconfigure()).ok()?;
    let panel = Builder::new(ST7789, SpiInterface::new(device, pins.gpio16.reconfigure(), batch))
        .display_size(SIDE, SIDE)
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(pins.gpio21.reconfigure())
        .init(&mut timer)
        .ok()?;

    let mut backlight: Output<_> = pins.gpio20.reconfigure();
    backlight.set_high().ok()?;
    Some((panel, pins.gpio25.reconfigure()))
}
