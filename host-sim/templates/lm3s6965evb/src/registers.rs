//! The registers of the LM3S6965 that this firmware touches, and its only `unsafe` blocks.

/// Is a device register: aligned, always there, and free of side effects on memory.
#[derive(Clone, Copy)]
pub struct Register(usize);

impl Register {
    /// Answers what the register says now.
    pub fn read(self) -> u32 {
        // SAFETY: values of this type are made in this module alone, each from an address of the chip's data sheet that
        // is word-aligned and can be read at any time; no Rust object lies there.
        unsafe { core::ptr::read_volatile(self.0 as *const u32) }
    }

    /// Sets the register.
    pub fn write(self, value: u32) {
        // SAFETY: as in `read`; and none of these registers starts a transfer into memory.
        unsafe { core::ptr::write_volatile(self.0 as *mut u32, value) }
    }

    /// Sets the bits of `mask` and leaves the others.
    pub fn set(self, mask: u32) {
        self.write(self.read() | mask);
    }

    /// Clears the bits of `mask` and leaves the others.
    pub fn clear(self, mask: u32) {
        self.write(self.read() & !mask);
    }
}

/// Is a port of eight pins.
#[derive(Clone, Copy)]
pub struct Port(usize);

impl Port {
    /// Answers the levels of the pins in `mask`; the address itself carries the mask, so that a write leaves the other pins.
    pub const fn levels(self, mask: u8) -> Register {
        Register(self.0 + ((mask as usize) << 2))
    }

    /// Answers the register in which a set bit makes its pin an output.
    pub const fn direction(self) -> Register {
        Register(self.0 + 0x400)
    }

    /// Answers the register in which a set bit gives its pin to a peripheral.
    pub const fn alternate(self) -> Register {
        Register(self.0 + 0x420)
    }

    /// Answers the register in which a set bit lets its pin drive 8 mA.
    pub const fn drive_8ma(self) -> Register {
        Register(self.0 + 0x508)
    }

    /// Answers the register in which a set bit connects its pin.
    pub const fn digital(self) -> Register {
        Register(self.0 + 0x51c)
    }
}

/// Is port A: UART0 on pins 0 and 1, SSI0 on pins 2 to 5.
pub const PORT_A: Port = Port(0x4000_4000);
/// Is port C: pin 7 is the panel's D/C.
pub const PORT_C: Port = Port(0x4000_6000);
/// Is port D: pin 0 deselects the SD card, which shares the bus.
pub const PORT_D: Port = Port(0x4000_7000);

/// Is the raw interrupt status: bit 6 once the PLL is locked.
pub const RIS: Register = Register(0x400f_e050);
/// Is the run-mode clock configuration.
pub const RCC: Register = Register(0x400f_e060);
/// Is the clock gates of the serial ports: bit 0 UART0, bit 4 SSI0.
pub const RCGC1: Register = Register(0x400f_e104);
/// Is the clock gates of the pin ports: bit 0 port A, 2 C, 3 D.
pub const RCGC2: Register = Register(0x400f_e108);

/// Is SSI0: frame format and clock rate.
pub const SSI_CR0: Register = Register(0x4000_8000);
/// Is SSI0: bit 1 enables the port.
pub const SSI_CR1: Register = Register(0x4000_8004);
/// Is SSI0: data.
pub const SSI_DR: Register = Register(0x4000_8008);
/// Is SSI0: status; bit 2 says that a byte has arrived.
pub const SSI_SR: Register = Register(0x4000_800c);
/// Is SSI0: clock prescaler.
pub const SSI_CPSR: Register = Register(0x4000_8010);

/// Is UART0: data.
pub const UART_DR: Register = Register(0x4000_c000);
/// Is UART0: flags; bit 5 says that there is no room to send.
pub const UART_FR: Register = Register(0x4000_c018);
/// Is UART0: whole part of the baud-rate divisor.
pub const UART_IBRD: Register = Register(0x4000_c024);
/// Is UART0: 64ths of the baud-rate divisor.
pub const UART_FBRD: Register = Register(0x4000_c028);
/// Is UART0: line control.
pub const UART_LCRH: Register = Register(0x4000_c02c);
/// Is UART0: control.
pub const UART_CTL: Register = Register(0x4000_c030);
