//! The RAM that rendering takes on a device.

use crate::panel::Panel;
use crate::scenes::HostNumber;
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb666, Rgb888};
use scanray::{Encode, Workspace};
use std::fmt;

/// Is the size of a [`Workspace`] that is just large enough for a picture, item by item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bill {
    columns: usize,
    pixel: usize,
    tracing: usize,
}

impl Bill {
    /// Makes the bill of a picture in the number `S`.
    pub fn new<S: HostNumber>(columns: u32, panel: Panel) -> Self {
        let tracing = size_of::<Workspace<S, [u8; 2], 0, 0>>();
        Self { columns: columns as usize, pixel: pixel_bytes(panel), tracing }
    }

    /// Answers the sum in bytes, an upper bound that devices with 32-bit addresses stay below.
    pub fn total(&self) -> usize {
        self.columns * self.pixel + self.tracing
    }
}

impl fmt::Display for Bill {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { columns, pixel, tracing } = self;
        write!(f, "{} bytes = {columns} columns x {pixel} + {tracing} for tracing", self.total())
    }
}

/// Answers what the core's scanline takes for a pixel of a panel.
fn pixel_bytes(panel: Panel) -> usize {
    fn bytes<C: Encode>() -> usize {
        (size_of::<Workspace<f32, C, 1024, 0>>() - size_of::<Workspace<f32, C, 0, 0>>()) / 1024
    }
    match panel {
        Panel::Rgb565 => bytes::<Rgb565>(),
        Panel::Rgb666 => bytes::<Rgb666>(),
        Panel::Rgb888 => bytes::<Rgb888>(),
        Panel::Gray8 => bytes::<Gray8>(),
        Panel::Gray4 => bytes::<Gray4>(),
        Panel::Mono => bytes::<BinaryColor>(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scanray::Fixed;

    #[test]
    fn the_bill_is_the_size_of_the_real_workspace() {
        let pairs = [
            (Bill::new::<f32>(240, Panel::Rgb565), size_of::<Workspace<f32, Rgb565, 240, 1>>()),
            (Bill::new::<f32>(320, Panel::Rgb888), size_of::<Workspace<f32, Rgb888, 320, 5>>()),
            (Bill::new::<Fixed>(128, Panel::Mono), size_of::<Workspace<Fixed, BinaryColor, 128, 9>>()),
            (Bill::new::<Fixed>(128, Panel::Gray4), size_of::<Workspace<Fixed, Gray4, 128, 0>>()),
        ];
        for (bill, real) in pairs {
            assert!(bill.total().abs_diff(real) < 8, "{bill}; really {real}");
        }
    }

    #[test]
    fn the_bill_names_its_items() {
        let bill = Bill { columns: 240, pixel: 2, tracing: 1000 };
        assert_eq!(bill.to_string(), "1480 bytes = 240 columns x 2 + 1000 for tracing");
    }
}
