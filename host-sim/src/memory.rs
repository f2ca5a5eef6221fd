//! The RAM that rendering takes on a device.

use crate::panel::Panel;
use crate::scenes::HostNumber;
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb666, Rgb888};
use scanray::trace::Bounce;
use scanray::{Encode, Workspace};
use std::fmt;

/// Is what a workspace takes beside its row and its bounces, as its documentation promises.
const LISTS: usize = 96;

/// Is the size of a [`Workspace`] that is just large enough for a picture, item by item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bill {
    columns: usize,
    pixel: usize,
    bounces: usize,
    bounce: usize,
}

impl Bill {
    /// Makes the bill of a picture in the number `S`.
    pub fn new<S: HostNumber>(columns: u32, panel: Panel, depth: u8) -> Self {
        let (columns, bounces) = (columns as usize, usize::from(depth));
        Self { columns, pixel: pixel_bytes(panel), bounces, bounce: size_of::<Bounce<S>>() }
    }

    /// Answers the sum in bytes, an upper bound that devices with 32-bit addresses stay below.
    pub fn total(&self) -> usize {
        self.columns * self.pixel + self.bounces * self.bounce + LISTS
    }
}

impl fmt::Display for Bill {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { columns, pixel, bounces, bounce } = self;
        let total = self.total();
        let plural = if *bounces == 1 { "" } else { "s" };
        write!(f, "{total} bytes = {columns} columns x {pixel} + {bounces} bounce{plural} x {bounce}")?;
        write!(f, " + {LISTS} for lists")
    }
}

/// Answers what the core's scanline takes for a pixel of a panel.
fn pixel_bytes(panel: Panel) -> usize {
    fn bytes<C: Encode>() -> usize {
        size_of::<Workspace<f32, C, 1024, 0>>().div_euclid(1024)
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
    fn the_bill_is_the_size_of_the_real_workspace_rounded_up_by_less_than_its_lists() {
        let pairs = [
            (Bill::new::<f32>(240, Panel::Rgb565, 1), size_of::<Workspace<f32, Rgb565, 240, 1>>()),
            (Bill::new::<f32>(320, Panel::Rgb888, 5), size_of::<Workspace<f32, Rgb888, 320, 5>>()),
            (Bill::new::<Fixed>(128, Panel::Mono, 9), size_of::<Workspace<Fixed, BinaryColor, 128, 9>>()),
            (Bill::new::<Fixed>(128, Panel::Gray4, 0), size_of::<Workspace<Fixed, Gray4, 128, 0>>()),
        ];
        for (bill, real) in pairs {
            assert!(bill.total() >= real && bill.total() - LISTS < real, "{bill}; really {real}");
        }
    }

    #[test]
    fn the_bill_names_its_items() {
        let bill = Bill::new::<f32>(240, Panel::Rgb565, 1);
        assert_eq!(bill.to_string(), "616 bytes = 240 columns x 2 + 1 bounce x 40 + 96 for lists");
    }
}
