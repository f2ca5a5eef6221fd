//! The BBC micro:bit, version 2: its pins at the edge connector, and the panel on them.
//!
//! | micro:bit | panel |
//! |---|---|
//! | P1 (P0.03) | D/C |
//! | P16 (P1.02) | CS |
//! | P13 (P0.17) | SCL (SPI clock) |
//! | P15 (P0.13) | SDA (SPI data) |
//! | P0 (P0.02) | backlight |
//! | P2 (P0.04) | RES |

use cortex_m::singleton;
use embedded_hal::{delay::DelayNs, digital::OutputPin, spi::MODE_0};
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::{
    Builder,
    interface::SpiInterface,
    models::ST7735s,
    options::{ColorInversion, ColorOrder, Orientation, Rotation},
};
use nrf52833_hal::{
    Delay, Spim,
    gpio::{Level, Output, Pin, PushPull, p0, p1},
    pac::{CorePeripherals, Peripherals, SPIM0},
    spim::{Frequency, Pins},
};

/// Counts the columns of the panel as it is held.
pub const WIDTH: u16 = 160;

/// Counts the columns and rows of the panel held upright.
const PANEL: (u16, u16) = (128, 160);
/// Is the column and row of the controller's memory that the panel's first pixel shows.
const OFFSET: (u16, u16) = (0, 0);
/// Is which way up the panel is held, and whether it mirrors.
const ORIENTATION: Orientation = Orientation::new().rotate(Rotation::Deg90);
/// Says whether the glass shows colours inverted.
const INVERSION: ColorInversion = ColorInversion::Normal;
/// Is the order of the colours of a pixel.
const ORDER: ColorOrder = ColorOrder::Rgb;
/// Is the clock of the bus, 8 MHz: the fastest of SPIM0, and about half of what the ST7735S takes.
const SPI_CLOCK: Frequency = Frequency::M8;
/// Holds as many bytes as go to the bus at a time.
const BUFFER: usize = 512;

/// Is a pin that drives something.
type Driver = Pin<Output<PushPull>>;
type Wires = SpiInterface<'static, ExclusiveDevice<Spim<SPIM0>, Driver, NoDelay>, Driver>;

/// Is the panel, as a display of embedded-graphics.
pub type Display = mipidsi::Display<Wires, ST7735s, Driver>;

/// Says why there is no picture.
#[derive(Clone, Copy)]
pub enum Trouble {
    /// The renderer refuses the scene, or a panel wider than its workspace.
    Scene,
    /// The panel cannot be reached.
    Panel,
}

/// Starts the panel, and answers the upper left LED of the micro:bit and the panel.
///
/// It panics when it is called twice.
pub fn take() -> (Lamp, Result<Display, Trouble>) {
    let p = Peripherals::take().expect("the board is taken once");
    let core = CorePeripherals::take().expect("the core is taken once");
    let mut delay = Delay::new(core.SYST);
    let (port0, port1) = (p0::Parts::new(p.P0), p1::Parts::new(p.P1));
    let sck = port0.p0_17.into_push_pull_output(Level::Low).degrade();
    let mosi = port0.p0_13.into_push_pull_output(Level::Low).degrade();
    let pins = Pins { sck: Some(sck), mosi: Some(mosi), miso: None };
    let bus = Spim::new(p.SPIM0, pins, SPI_CLOCK, MODE_0, 0);
    let select = port1.p1_02.into_push_pull_output(Level::High).degrade();
    let data = port0.p0_03.into_push_pull_output(Level::Low).degrade();
    let reset = port0.p0_04.into_push_pull_output(Level::High).degrade();
    let display = start(bus, (select, data, reset), &mut delay);
    // It stays lit for as long as the board has power, once the panel is awake.
    port0.p0_02.into_push_pull_output(Level::High);
    // An LED shines while its row is high and its column low.
    port0.p0_28.into_push_pull_output(Level::Low);
    let pin = port0.p0_21.into_push_pull_output(Level::Low).degrade();
    (Lamp { pin, delay }, display.ok_or(Trouble::Panel))
}

/// Wakes the panel; answers nothing when a pin or the bus cannot be driven.
fn start(
    bus: Spim<SPIM0>,
    (select, data, reset): (Driver, Driver, Driver),
    delay: &mut Delay,
) -> Option<Display> {
    let buffer = singleton!(: [u8; BUFFER] = [0; BUFFER])?;
    let device = ExclusiveDevice::new_no_delay(bus, select).ok()?;
    Builder::new(ST7735s, SpiInterface::new(device, data, buffer))
        .display_size(PANEL.0, PANEL.1)
        .display_offset(OFFSET.0, OFFSET.1)
        .orientation(ORIENTATION)
        .invert_colors(INVERSION)
        .color_order(ORDER)
        .reset_pin(reset)
        .init(delay)
        .ok()
}

/// Is the upper left LED of the micro:bit, and the time that it flashes in.
pub struct Lamp {
    pin: Driver,
    delay: Delay,
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
            self.delay.delay_ms(pause);
            let _ = self.pin.set_low();
            self.delay.delay_ms(pause);
        }
    }
}
