//! The STM32F4-Discovery: its clocks, its pins, and the panel on them.
//!
//! | Discovery | panel |
//! |---|---|
//! | PB11 | D/C |
//! | PB12 | CS |
//! | PB13 | SCK (SPI clock) |
//! | PB15 | SDI (SPI data) |
//! | PB0 | LED (backlight) |
//! | PB1 | RESET |

use cortex_m::singleton;
use embedded_hal::delay::DelayNs;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::{
    Builder,
    interface::SpiInterface,
    models::ILI9341Rgb565,
    options::{ColorInversion, ColorOrder, Orientation, Rotation},
};
use stm32f4xx_hal::{
    gpio::{Output, PB1, PB11, PB12, PD12},
    pac::{CorePeripherals, Peripherals, SPI2},
    prelude::*,
    rcc::Config,
    spi::{Mode, Phase, Polarity, Spi},
    timer::SysDelay,
};

/// Counts the columns of the panel as it is held.
pub const WIDTH: u16 = 320;

/// Counts the columns and rows of the panel held upright.
const PANEL: (u16, u16) = (240, 320);
/// Is the column and row of the controller's memory that the panel's first pixel shows.
const OFFSET: (u16, u16) = (0, 0);
/// Is which way up the panel is held, and whether it mirrors.
const ORIENTATION: Orientation = Orientation::new().rotate(Rotation::Deg90).flip_vertical();
/// Says whether the glass shows colours inverted.
const INVERSION: ColorInversion = ColorInversion::Normal;
/// Is the order of the colours of a pixel.
const ORDER: ColorOrder = ColorOrder::Bgr;
/// Is the clock of the bus: half of what SPI2 gets.
const SPI_HZ: u32 = 21_000_000;
/// Is the frequency of the Discovery's crystal.
const CRYSTAL_HZ: u32 = 8_000_000;
/// Is the frequency of the core, the highest it takes.
const CORE_HZ: u32 = 168_000_000;
/// Holds as many bytes as go to the bus at a time.
const BUFFER: usize = 512;

type Wires = SpiInterface<'static, ExclusiveDevice<Spi<SPI2>, PB12<Output>, NoDelay>, PB11<Output>>;

/// Is the panel, as a display of embedded-graphics.
pub type Display = mipidsi::Display<Wires, ILI9341Rgb565, PB1<Output>>;

/// Says why there is no picture.
#[derive(Clone, Copy)]
pub enum Trouble {
    /// The renderer refuses the scene, or a panel wider than its workspace.
    Scene,
    /// The panel cannot be reached.
    Panel,
}

/// Starts the clocks and the panel, and answers the Discovery's green LED and the panel.
///
/// It panics when it is called twice; without its crystal it waits for good.
pub fn take() -> (Lamp, Result<Display, Trouble>) {
    let p = Peripherals::take().expect("the board is taken once");
    let core = CorePeripherals::take().expect("the core is taken once");
    let mut rcc = p.RCC.freeze(Config::hse(CRYSTAL_HZ.Hz()).sysclk(CORE_HZ.Hz()));
    let mut delay = core.SYST.delay(&rcc.clocks);
    let (b, d) = (p.GPIOB.split(&mut rcc), p.GPIOD.split(&mut rcc));
    // The panel reads bits on rising edges.
    let mode = Mode { polarity: Polarity::IdleLow, phase: Phase::CaptureOnFirstTransition };
    let pins = (Some(b.pb13), SPI2::NoMiso, Some(b.pb15));
    let bus = Spi::new(p.SPI2, pins, mode, SPI_HZ.Hz(), &mut rcc);
    let wires = (b.pb12.into_push_pull_output(), b.pb11.into_push_pull_output());
    let display = start(bus, wires, b.pb1.into_push_pull_output(), &mut delay);
    // It stays lit for as long as the board has power, once the panel is awake.
    b.pb0.into_push_pull_output().set_high();
    (Lamp { pin: d.pd12.into_push_pull_output(), delay }, display.ok_or(Trouble::Panel))
}

/// Wakes the panel; answers nothing when a pin or the bus cannot be driven.
fn start(
    bus: Spi<SPI2>,
    (select, data): (PB12<Output>, PB11<Output>),
    reset: PB1<Output>,
    delay: &mut SysDelay,
) -> Option<Display> {
    let buffer = singleton!(: [u8; BUFFER] = [0; BUFFER])?;
    let device = ExclusiveDevice::new_no_delay(bus, select).ok()?;
    Builder::new(ILI9341Rgb565, SpiInterface::new(device, data, buffer))
        .display_size(PANEL.0, PANEL.1)
        .display_offset(OFFSET.0, OFFSET.1)
        .orientation(ORIENTATION)
        .invert_colors(INVERSION)
        .color_order(ORDER)
        .reset_pin(reset)
        .init(delay)
        .ok()
}

/// Is the green LED of the Discovery, and the time that it flashes in.
pub struct Lamp {
    pin: PD12<Output>,
    delay: SysDelay,
}

impl Lamp {
    /// Lights it: the picture is being drawn.
    pub fn on(&mut self) {
        self.pin.set_high();
    }

    /// Goes dark over a finished picture; otherwise flashes for good, twice a second for a scene that is refused, ten
    /// times for a panel that does not answer.
    pub fn tell(&mut self, drawn: Result<(), Trouble>) -> ! {
        self.pin.set_low();
        let pause = match drawn {
            Ok(()) => loop {
                cortex_m::asm::wfi();
            },
            Err(Trouble::Scene) => 250,
            Err(Trouble::Panel) => 50,
        };
        loop {
            self.pin.set_high();
            self.delay.delay_ms(pause);
            self.pin.set_low();
            self.delay.delay_ms(pause);
        }
    }
}
