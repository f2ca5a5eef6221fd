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

use embassy_rp::{
    bind_interrupts, dma,
    gpio::{Level, Output},
    peripherals::{DMA_CH0, SPI0},
    spi::{Async, Config, Phase, Polarity, Spi},
};
use embassy_time::{Delay, Timer};
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use lcd_async::{
    Builder,
    interface::{Interface, SpiInterface},
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
const SPI_HZ: u32 = 31_250_000;

bind_interrupts!(struct Interrupts {
    DMA_IRQ_0 => dma::InterruptHandler<DMA_CH0>;
});

type Wires =
    SpiInterface<ExclusiveDevice<Spi<'static, SPI0, Async>, Output<'static>, NoDelay>, Output<'static>>;

/// Says why there is no picture.
#[derive(Clone, Copy)]
pub enum Trouble {
    /// The renderer refuses the scene.
    Scene,
    /// The panel cannot be reached.
    Panel,
}

/// Is a panel that is awake. A pin that is dropped would be let go: the panel keeps its backlight.
pub struct Panel {
    display: lcd_async::Display<Wires, ST7789, Output<'static>>,
    _backlight: Output<'static>,
}

/// Starts the clocks and the panel, and answers the Pico's LED and the panel.
///
/// It panics when it is called twice.
pub async fn take() -> (Lamp, Result<Panel, Trouble>) {
    let p = embassy_rp::init(Default::default());
    let lamp = Lamp(Output::new(p.PIN_25, Level::Low));
    let mut settings = Config::default();
    settings.frequency = SPI_HZ;
    // The panel reads bits on rising edges, as in mode 0; but there SPI0 pauses after every byte.
    settings.polarity = Polarity::IdleHigh;
    settings.phase = Phase::CaptureOnSecondTransition;
    let bus = Spi::new_txonly(p.SPI0, p.PIN_18, p.PIN_19, p.DMA_CH0, Interrupts, settings);
    let select = Output::new(p.PIN_17, Level::High);
    let data = Output::new(p.PIN_16, Level::Low);
    let reset = Output::new(p.PIN_21, Level::High);
    let panel = Panel::start(bus, (select, data, reset), Output::new(p.PIN_20, Level::Low)).await;
    (lamp, panel.ok_or(Trouble::Panel))
}

impl Panel {
    /// Wakes the panel; answers nothing when it cannot be reached.
    async fn start(
        bus: Spi<'static, SPI0, Async>,
        (select, data, reset): (Output<'static>, Output<'static>, Output<'static>),
        mut backlight: Output<'static>,
    ) -> Option<Self> {
        let device = ExclusiveDevice::new_no_delay(bus, select).ok()?;
        let display = Builder::new(ST7789, SpiInterface::new(device, data))
            .display_size(WIDTH, HEIGHT)
            .display_offset(OFFSET.0, OFFSET.1)
            .orientation(ORIENTATION)
            .invert_colors(INVERSION)
            .color_order(ORDER)
            .reset_pin(reset)
            .init(&mut Delay)
            .await
            .ok()?;
        backlight.set_high();
        Some(Self { display, _backlight: backlight })
    }

    /// Sends row `y`; rows come in their order, from the first to the last.
    pub async fn send(&mut self, y: u16, row: &[u8]) -> Result<(), Trouble> {
        let sent = if y == 0 {
            // Opens the whole panel and fills the first row of it; those that follow find it open.
            self.display.show_raw_data(0, 0, WIDTH, HEIGHT, row).await
        } else {
            // SAFETY: pixels alone are sent, into the window that the first row has opened; no setting changes.
            unsafe { self.display.dcs() }.send_data_slice(row).await
        };
        sent.map_err(|_| Trouble::Panel)
    }
}

/// Is the LED of the Pico.
pub struct Lamp(Output<'static>);

impl Lamp {
    /// Lights it: the picture is being drawn.
    pub fn on(&mut self) {
        self.0.set_high();
    }

    /// Goes dark over a finished picture; otherwise flashes for good, twice a second for a scene that is refused, ten
    /// times for a panel that does not answer.
    pub async fn tell(&mut self, drawn: Result<(), Trouble>) -> ! {
        self.0.set_low();
        let pause = match drawn {
            Ok(()) => core::future::pending().await,
            Err(Trouble::Scene) => 250,
            Err(Trouble::Panel) => 50,
        };
        loop {
            self.0.toggle();
            Timer::after_millis(pause).await;
        }
    }
}
