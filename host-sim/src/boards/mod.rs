//! Boards that firmware of one's own begins from: what each is, and a project for it.

mod lock;
mod name;
mod project;
mod refusal;

pub use project::{Source, create};
pub use refusal::Refusal;

use include_dir::{Dir, include_dir};

/// Holds a crate for each board, in a folder of its name.
static TEMPLATES: Dir = include_dir!("$CARGO_MANIFEST_DIR/templates");

/// Is a board with a panel, for which there is a crate to begin from.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// What it is asked for by.
    pub name: &'static str,
    /// The board and its chip.
    pub chip: &'static str,
    /// The panel, and how the picture gets there.
    pub panel: &'static str,
    /// Rust's name for the chip's instructions.
    pub target: &'static str,
    /// The number it traces in: `f32` where the chip computes it, otherwise `fixed`.
    pub number: &'static str,
    /// What brings the image to the board and starts it; `cargo run` does the same.
    pub flash: &'static str,
    /// The emulated board that the image also runs on, as `host-sim/boards/run` calls it.
    pub emulator: Option<&'static str>,
}

/// Lists the boards.
pub const BOARDS: [Board; 7] = [
    Board {
        name: "pico",
        chip: "Raspberry Pi Pico (RP2040)",
        panel: "ST7789 240x240",
        target: "thumbv6m-none-eabi",
        number: "fixed",
        flash: "probe-rs run --chip RP2040",
        emulator: Some("rp2040"),
    },
    Board {
        name: "pico-embassy",
        chip: "Raspberry Pi Pico (RP2040)",
        panel: "ST7789 240x240, async, by DMA",
        target: "thumbv6m-none-eabi",
        number: "fixed",
        flash: "probe-rs run --chip RP2040",
        emulator: Some("rp2040"),
    },
    Board {
        name: "pico2",
        chip: "Raspberry Pi Pico 2 (RP2350)",
        panel: "ST7789 240x240",
        target: "thumbv8m.main-none-eabihf",
        number: "f32",
        flash: "probe-rs run --chip RP235x",
        emulator: None,
    },
    Board {
        name: "stm32f4-discovery",
        chip: "STM32F4-Discovery (STM32F407)",
        panel: "ILI9341 320x240",
        target: "thumbv7em-none-eabihf",
        number: "f32",
        flash: "probe-rs run --chip STM32F407VG",
        emulator: None,
    },
    Board {
        name: "esp32c3",
        chip: "ESP32-C3",
        panel: "ST7789 240x240",
        target: "riscv32imc-unknown-none-elf",
        number: "fixed",
        flash: "espflash flash --monitor",
        emulator: None,
    },
    Board {
        name: "microbit-v2",
        chip: "BBC micro:bit v2 (nRF52833)",
        panel: "ST7735S 160x128",
        target: "thumbv7em-none-eabihf",
        number: "f32",
        flash: "probe-rs run --chip nRF52833_xxAA",
        emulator: None,
    },
    Board {
        name: "lm3s6965evb",
        chip: "LM3S6965 evaluation board, emulated by QEMU",
        panel: "SSD0323 128x64, 16 greys",
        target: "thumbv7m-none-eabi",
        number: "fixed",
        flash: "qemu-system-arm -M lm3s6965evb -serial stdio -kernel",
        emulator: Some("lm3s6965"),
    },
];

/// Answers the board of a name.
pub fn find(name: &str) -> Result<&'static Board, Refusal> {
    let board = BOARDS.iter().find(|board| board.name == name);
    board.ok_or_else(|| Refusal::UnknownBoard(name.to_owned()))
}
