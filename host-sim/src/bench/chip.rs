use crate::shot::Number;

/// Is a processor core to measure on, with the number that suits it.
#[derive(Debug)]
pub struct Chip {
    /// Name, as tables and commands have it.
    pub name: &'static str,
    /// The number it computes in.
    pub number: Number,
    /// The compiler's name for it.
    pub target: &'static str,
    /// The emulated machine that executes its instructions, an MPS2 board.
    pub machine: &'static str,
    /// Whether an emulator that knows its cycles is at hand.
    pub counts_cycles: bool,
}

/// Lists the cores.
pub static CHIPS: [Chip; 3] = [
    Chip {
        name: "m4f",
        number: Number::F32,
        target: "thumbv7em-none-eabihf",
        machine: "mps2-an386",
        counts_cycles: false,
    },
    Chip {
        name: "m3",
        number: Number::Fixed,
        target: "thumbv7m-none-eabi",
        machine: "mps2-an385",
        counts_cycles: false,
    },
    // The M3 executes the M0+'s instructions, one by one the same.
    Chip {
        name: "m0+",
        number: Number::Fixed,
        target: "thumbv6m-none-eabi",
        machine: "mps2-an385",
        counts_cycles: true,
    },
];

impl Chip {
    /// Finds a core by its name.
    pub fn find(name: &str) -> Option<&'static Self> {
        CHIPS.iter().find(|chip| chip.name == name)
    }
}
