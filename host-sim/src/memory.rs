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
    levels: usize,
    /// What a ray takes that waits at glass.
    waiting: usize,
    tracing: usize,
}

impl Bill {
    /// Makes the bill of a picture in the number `S`.
    pub fn new<S: HostNumber>(columns: u32, panel: Panel, depth: u8) -> Self {
        let tracing = size_of::<Workspace<S, [u8; 2], 0, 0>>();
        let waiting = (size_of::<Workspace<S, [u8; 2], 0, 64>>() - tracing) / 64;
        let (columns, pixel) = (columns as usize, pixel_bytes(panel));
        Self { columns, pixel, levels: usize::from(depth), waiting, tracing }
    }

    /// Answers the sum in bytes, an upper bound that devices with 32-bit addresses stay below.
    pub fn total(&self) -> usize {
        self.columns * self.pixel + self.levels * self.waiting + self.tracing
    }
}

impl fmt::Display for Bill {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { columns, pixel, levels, waiting, tracing } = self;
        let total = self.total();
        write!(
            f,
            "{total} bytes = {columns} columns x {pixel} + {levels} levels x {waiting} + {tracing} for tracing"
        )
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
            (Bill::new::<f32>(240, Panel::Rgb565, 1), size_of::<Workspace<f32, Rgb565, 240, 1>>()),
            (Bill::new::<f32>(320, Panel::Rgb888, 5), size_of::<Workspace<f32, Rgb888, 320, 5>>()),
            (Bill::new::<Fixed>(128, Panel::Mono, 9), size_of::<Workspace<Fixed, BinaryColor, 128, 9>>()),
            (Bill::new::<Fixed>(128, Panel::Gray4, 0), size_of::<Workspace<Fixed, Gray4, 128, 0>>()),
        ];
        for (bill, real) in pairs {
            assert!(bill.total().abs_diff(real) < 8, "{bill}; really {real}");
        }
    }

    #[test]
    fn the_bill_names_its_items() {
        let bill = Bill { columns: 240, pixel: 2, levels: 3, waiting: 40, tracing: 1000 };
        assert_eq!(bill.to_string(), "1600 bytes = 240 columns x 2 + 3 levels x 40 + 1000 for tracing");
    }
}
