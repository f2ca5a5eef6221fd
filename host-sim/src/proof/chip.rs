use crate::bench::QEMU;

/// Is a processor core that the gallery is drawn on, in each number.
#[derive(Debug)]
pub struct Chip {
    /// Name, as tables and commands have it.
    pub name: &'static str,
    /// The compiler's name for it.
    pub target: &'static str,
    /// The linker script of the emulated board.
    pub script: &'static str,
    /// The emulator's command, and its machine and core.
    pub emulator: &'static str,
    /// What the emulator is told beside the image.
    pub board: &'static [&'static str],
}

const MPS2: &str = "examples/boards/mps2_an386.ld";

/// Lists the cores.
pub static CHIPS: [Chip; 4] = [
    // The M3 executes the M0+'s instructions, one by one the same.
    Chip {
        name: "m0+",
        target: "thumbv6m-none-eabi",
        script: MPS2,
        emulator: QEMU,
        board: &["-M", "mps2-an385"],
    },
    Chip {
        name: "m3",
        target: "thumbv7m-none-eabi",
        script: MPS2,
        emulator: QEMU,
        board: &["-M", "mps2-an385"],
    },
    Chip {
        name: "m4f",
        target: "thumbv7em-none-eabihf",
        script: MPS2,
        emulator: QEMU,
        board: &["-M", "mps2-an386"],
    },
    // Extensions that the chip lacks are switched off, so that their instructions fault.
    Chip {
        name: "rv32imc",
        target: "riscv32imc-unknown-none-elf",
        script: "examples/boards/virt_riscv.ld",
        emulator: "qemu-system-riscv32",
        board: &["-M", "virt", "-bios", "none", "-cpu", "rv32,a=off,f=off,d=off"],
    },
];

impl Chip {
    /// Finds a core by its name.
    pub fn find(name: &str) -> Option<&'static Self> {
        CHIPS.iter().find(|chip| chip.name == name)
    }
}
