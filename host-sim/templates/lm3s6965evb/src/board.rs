//! The LM3S6965 evaluation board: its clock, its pins, the panel on SSI0 and UART0.
//!
//! | LM3S6965 | panel |
//! |---|---|
//! | PA2 | SCLK (SSI0 clock) |
//! | PA3 | CS |
//! | PA5 | SDIN (SSI0 data) |
//! | PC7 | D/C |
//! | PD0 | CS of the SD card, which shares the bus |

use core::convert::Infallible;

use embedded_hal::{
    digital::{self, OutputPin},
    spi::{self, Operation, SpiDevice},
};

use crate::{
    registers::{
        PORT_A, PORT_C, PORT_D, RCC, RCGC1, RCGC2, RIS, SSI_CPSR, SSI_CR0, SSI_CR1, SSI_DR, SSI_SR, UART_CTL,
        UART_DR, UART_FBRD, UART_FR, UART_IBRD, UART_LCRH,
    },
    ssd0323::{self, Error, Ssd0323},
};

/// Counts the columns of the panel.
pub const WIDTH: u32 = ssd0323::WIDTH;

/// Is the panel, as a display of embedded-graphics.
pub type Display = Ssd0323<Ssi, DataCommand>;

/// Names what the panel may complain about.
pub type PanelError = Error<Infallible, Infallible>;

/// Runs the chip at 50 MHz (the PLL's 200 MHz, divided by 4) and connects what this firmware uses; answers the panel.
pub fn take() -> Result<Display, PanelError> {
    run_at_50_mhz();
    RCGC1.set(1 << 4 | 1);
    RCGC2.set(1 << 3 | 1 << 2 | 1);
    // A gate takes three cycles to open; this read is at least that far from the first use.
    RCGC2.read();
    connect_pins();
    start_serial_ports();
    Ssd0323::new(Ssi, DataCommand)
}

/// Moves from the reset clock to the PLL in the order the data sheet asks for.
fn run_at_50_mhz() {
    const USE_DIVIDER: u32 = 1 << 22;
    const DIVIDER_MASK: u32 = 0xf << 23;
    const DIVIDE_BY_4: u32 = 3 << 23;
    const PLL_OFF: u32 = 1 << 13;
    const PLL_OUTPUT_OFF: u32 = 1 << 12;
    const BYPASS_PLL: u32 = 1 << 11;
    const CRYSTAL_MASK: u32 = 0xf << 6;
    const CRYSTAL_8_MHZ: u32 = 0xe << 6;
    const SOURCE_MASK: u32 = 3 << 4;
    const CRYSTAL_OFF: u32 = 1;
    const PLL_LOCKED: u32 = 1 << 6;

    RCC.write((RCC.read() | BYPASS_PLL) & !USE_DIVIDER);
    RCC.clear(CRYSTAL_OFF);
    // About 5 ms at the reset clock of 12 MHz, for the crystal to swing up.
    cortex_m::asm::delay(60_000);
    RCC.write((RCC.read() & !(CRYSTAL_MASK | SOURCE_MASK)) | CRYSTAL_8_MHZ);
    RCC.clear(PLL_OFF | PLL_OUTPUT_OFF);
    RCC.write((RCC.read() & !DIVIDER_MASK) | DIVIDE_BY_4 | USE_DIVIDER);
    while RIS.read() & PLL_LOCKED == 0 {}
    RCC.clear(BYPASS_PLL);
}

fn connect_pins() {
    const UART: u32 = 0b11;
    const SSI: u32 = 0b10_1100;

    PORT_A.alternate().set(UART | SSI);
    PORT_A.drive_8ma().set(SSI);
    PORT_A.digital().set(UART | SSI);
    for (port, pin) in [(PORT_C, DataCommand::PIN), (PORT_D, 1)] {
        port.direction().set(pin.into());
        port.digital().set(pin.into());
        port.levels(pin).write(pin.into());
    }
}

fn start_serial_ports() {
    // 50 MHz / 14 = 3.6 MHz, below the panel's 4 MHz; eight bits, the clock at rest high.
    SSI_CPSR.write(14);
    SSI_CR0.write(1 << 6 | 7);
    SSI_CR1.write(1 << 1);
    // 50 MHz / 16 / 115 200 = 27 + 8/64; eight bits, no parity, with the queue.
    UART_IBRD.write(27);
    UART_FBRD.write(8);
    UART_LCRH.write(0x70);
    UART_CTL.write(0x301);
}

/// Drives the D/C pin of the panel.
pub struct DataCommand;

impl DataCommand {
    const PIN: u8 = 1 << 7;
}

impl digital::ErrorType for DataCommand {
    type Error = Infallible;
}

impl OutputPin for DataCommand {
    fn set_low(&mut self) -> Result<(), Infallible> {
        PORT_C.levels(Self::PIN).write(0);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        PORT_C.levels(Self::PIN).write(Self::PIN.into());
        Ok(())
    }
}

/// Is SSI0 with its own select pin, which nothing but the panel hears.
pub struct Ssi;

impl Ssi {
    /// Sends `byte` and waits for the one that comes back: then it is out, and D/C may change.
    fn exchange(byte: u8) -> u8 {
        SSI_DR.write(byte.into());
        while SSI_SR.read() & 1 << 2 == 0 {}
        SSI_DR.read() as u8
    }
}

impl spi::ErrorType for Ssi {
    type Error = Infallible;
}

impl SpiDevice for Ssi {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            match operation {
                Operation::Write(bytes) => bytes.iter().for_each(|&byte| _ = Self::exchange(byte)),
                Operation::Read(bytes) => bytes.fill_with(|| Self::exchange(0)),
                Operation::TransferInPlace(bytes) => {
                    bytes.iter_mut().for_each(|byte| *byte = Self::exchange(*byte))
                }
                Operation::Transfer(read, write) => transfer(read, write),
                // 50 cycles are a microsecond.
                Operation::DelayNs(nanos) => cortex_m::asm::delay(*nanos / 20),
            }
        }
        Ok(())
    }
}

/// Sends `write` and fills `read`, whichever is longer; what is missing is sent as zero.
fn transfer(read: &mut [u8], write: &[u8]) {
    for i in 0..read.len().max(write.len()) {
        let received = Ssi::exchange(write.get(i).copied().unwrap_or(0));
        if let Some(byte) = read.get_mut(i) {
            *byte = received;
        }
    }
}

/// Is UART0 at 115 200 baud. It is silent until the board has started.
#[derive(Clone, Copy)]
pub struct Uart;

impl Uart {
    /// Sends `text`.
    pub fn write(self, text: &[u8]) {
        for &byte in text {
            while UART_FR.read() & 1 << 5 != 0 {}
            UART_DR.write(byte.into());
        }
    }
}
