//! The Raspberry Pi Pico: its clocks, its pins, and the panel on them.
//!
//! | Pico | panel |
//! |---|---|
//! | GPIO 16 | D/C |
//! | GPIO 17 | CS |
//! | GPIO 18 | SCL (SPI clock) |
//! | GPIO 19 | SDA (SPI data) |
//! | GPIO 20 | backlight |
//! | GPIO 21 | reset |

use cortex_m::singleton;
use embedded_hal::{delay::DelayNs, digital::OutputPin, spi::MODE_3};
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::{
    Builder,
    interface::SpiInterface,
    models::ST7789,
    options::{ColorInversion, ColorOrder, Orientation},
};
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
const SPI_HZ: u32 = 31_250_000;
/// Is the frequency of the Pico's crystal.
const CRYSTAL_HZ: u32 = 12_000_000;
/// Holds as many bytes as go to the bus at a time.
const BUFFER: usize = 512;

type Output<P> = Pin<P, FunctionSio<SioOutput>, PullDown>;
type SpiPin<P> = Pin<P, FunctionSpi, PullDown>;
type Bus = Spi<Enabled, pac::SPI0, (SpiPin<Gpio19>, SpiPin<Gpio18>)>;
type Wires = SpiInterface<'static, ExclusiveDevice<Bus, Output<Gpio17>, NoDelay>, Output<Gpio16>>;

/// Is the panel, as a display of embedded-graphics.
pub type Display = mipidsi::Display<Wires, ST7789, Output<Gpio21>>;

/// Says why there is no picture.
#[derive(Clone, Copy)]
pub enum Trouble {
    /// The renderer refuses the scene, or a panel wider than its workspace.
    Scene,
    /// The panel cannot be reached.
    Panel,
}

/// Is what the boot ROM copies to RAM and runs: it sets up the flash chip so that code can run from there.
// SAFETY: `.boot2` is the 256 bytes that `memory.x` keeps for exactly this, and no code of ours refers to it.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT_LOADER: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Starts the clocks and the panel, and answers the Pico's LED and the panel.
///
/// It panics when it is called twice, or when the crystal does not swing.
pub fn take() -> (Lamp, Result<Display, Trouble>) {
    let mut p = pac::Peripherals::take().expect("the board is taken once");
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
    .ok()
    .expect("the crystal swings");
    let pins = Pins::new(p.IO_BANK0, p.PADS_BANK0, Sio::new(p.SIO).gpio_bank0, &mut p.RESETS);
    let mut timer = Timer::new(p.TIMER, &mut p.RESETS, &clocks);
    let bus: Bus = Spi::new(p.SPI0, (pins.gpio19.reconfigure(), pins.gpio18.reconfigure())).init(
        &mut p.RESETS,
        clocks.peripheral_clock.freq(),
        SPI_HZ.Hz(),
        // The panel reads bits on rising edges, as in mode 0; but there SPI0 pauses after every byte.
        MODE_3,
    );
    let mut backlight: Output<_> = pins.gpio20.reconfigure();
    let display = start(
        bus,
        (pins.gpio17.reconfigure(), pins.gpio16.reconfigure(), pins.gpio21.reconfigure()),
        &mut timer,
    )
    .filter(|_| backlight.set_high().is_ok());
    (Lamp { pin: pins.gpio25.reconfigure(), timer }, display.ok_or(Trouble::Panel))
}

/// Wakes the panel; answers nothing when a pin or the bus cannot be driven.
fn start(
    bus: Bus,
    (select, data, reset): (Output<Gpio17>, Output<Gpio16>, Output<Gpio21>),
    timer: &mut Timer,
) -> Option<Display> {
    let buffer = singleton!(: [u8; BUFFER] = [0; BUFFER])?;
    let device = ExclusiveDevice::new_no_delay(bus, select).ok()?;
    Builder::new(ST7789, SpiInterface::new(device, data, buffer))
        .display_size(WIDTH, HEIGHT)
        .display_offset(OFFSET.0, OFFSET.1)
        .orientation(ORIENTATION)
        .invert_colors(INVERSION)
        .color_order(ORDER)
        .reset_pin(reset)
        .init(timer)
        .ok()
}

/// Is the LED of the Pico, and the time that it flashes in.
pub struct Lamp {
    pin: Output<Gpio25>,
    timer: Timer,
}

impl Lamp {
    /// Lights it: the picture is being drawn.
    pub fn on(&mut self) {
        // A pin that cannot be driven would cost the light, not the picture.
        let _ = self.pin.set_high();
    }

    /// Goes dark over a finished picture; otherwise flashes for good, twice a second for a scene that is refused, ten
    /// times for a panel that does not answer.
    pub fn tell(&mut self, drawn: Result<(), Trouble>) -> ! {
        let _ = self.pin.set_low();
        let pause = match drawn {
            Ok(()) => loop {
                cortex_m::asm::wfi();
            },
            Err(Trouble::Scene) => 250,
            Err(Trouble::Panel) => 50,
        };
        loop {
            let _ = self.pin.set_high();
            self.timer.delay_ms(pause);
            let _ = self.pin.set_low();
            self.timer.delay_ms(pause);
        }
    }
}
