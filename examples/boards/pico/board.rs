//! The Pico's clocks, pins and parts.

use embedded_hal::digital::OutputPin;
use rp2040_hal::{
    Clock, Sio, Spi, Timer, Watchdog,
    clocks::init_clocks_and_plls,
    dma::DMAExt,
    fugit::RateExtU32,
    gpio::{Pins, bank0::Gpio25},
    pac,
    sio::SioFifo,
};

use super::panel::{Bus, Output, Panel, Row};

/// Is the frequency of the crystal on a Pico.
const CRYSTAL_HZ: u32 = 12_000_000;

/// Is 125 MHz / 2, the fastest SPI0 goes, and just inside the 16 ns write cycle of the ST7789.
const SPI_HZ: u32 = 62_500_000;

/// Is the LED on the Pico.
pub type Lamp = Output<Gpio25>;

/// Is what starts the second core and talks to it.
pub type SecondCore = (pac::PSM, pac::PPB, SioFifo);

/// Is what the boot ROM copies to RAM and runs: it sets up the flash chip so that code can run from there.
// SAFETY: `.boot2` is the 256 bytes that `memory.x` keeps for exactly this, and no code of ours refers to it.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT_LOADER: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Answers what is wired to the Pico, or nothing when it was taken before or a part does not answer.
///
/// `spare` is the buffer that stands in for the row before the first.
pub fn take(spare: Row) -> Option<(Panel, Lamp, SecondCore)> {
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
    let channels = p.DMA.split(&mut p.RESETS);
    let bus: Bus = Spi::new(p.SPI0, (pins.gpio19.reconfigure(), pins.gpio18.reconfigure())).init(
        &mut p.RESETS,
        clocks.peripheral_clock.freq(),
        SPI_HZ.Hz(),
        // The panel reads bits on rising edges, as in mode 0; but there SPI0 pauses after every byte.
        embedded_hal::spi::MODE_3,
    );
    let reset: Output<_> = pins.gpio21.reconfigure();
    let wires = (pins.gpio17.reconfigure(), pins.gpio16.reconfigure(), reset);
    let panel = Panel::new(((channels.ch0, channels.ch1), spare, bus), wires, &mut timer)?;
    let mut backlight: Output<_> = pins.gpio20.reconfigure();
    backlight.set_high().ok()?;
    Some((panel, pins.gpio25.reconfigure(), (p.PSM, p.PPB, sio.fifo)))
}
