//! The panel as a display of embedded-graphics: each area goes into a window of its own.
#![allow(dead_code, reason = "most of the firmware draws row by row, in one window")]

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use mipidsi::{
    dcs::{InterfaceExt, SetColumnAddress, SetPageAddress, WriteMemoryStart},
    interface::Interface,
};
use rp2040_hal::gpio::bank0::{Gpio16, Gpio17};

use super::panel::{Bus, Output, Panel, SIDE, commands};

/// Holds as many bytes as go to the bus at a time: a block of eight by eight pixels.
const BUFFER: usize = 128;

/// Is an ST7789 that areas are drawn on, and the core waits meanwhile.
pub struct Display {
    bus: Bus,
    select: Output<Gpio17>,
    data: Output<Gpio16>,
}

/// Says that a pin or the bus could not be driven.
#[derive(Debug)]
pub struct NoAnswer;

impl Panel {
    /// Answers the panel as a display, once its last pixel is out.
    pub fn into_display(self) -> Display {
        let (bus, select, data) = self.into_parts();
        Display { bus, select, data }
    }
}

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        Size::new_equal(SIDE as u32)
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = NoAnswer;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), NoAnswer> {
        let area = |point| Rectangle::new(point, Size::new_equal(1));
        pixels.into_iter().try_for_each(|Pixel(point, color)| self.fill_contiguous(&area(point), [color]))
    }

    /// Fills an area that lies on the panel; others are left out.
    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), NoAnswer> {
        let Some(corner) = area.bottom_right().filter(|_| area.intersection(&self.bounding_box()) == *area)
        else {
            return Ok(());
        };
        let mut buffer = [0; BUFFER];
        let mut commands =
            commands(&mut self.bus, &mut self.select, &mut self.data, &mut buffer).ok_or(NoAnswer)?;
        let fill = || {
            commands.write_command(SetColumnAddress::new(area.top_left.x as u16, corner.x as u16))?;
            commands.write_command(SetPageAddress::new(area.top_left.y as u16, corner.y as u16))?;
            commands.write_command(WriteMemoryStart)?;
            commands.send_pixels(colors.into_iter().map(|color| color.into_storage().to_be_bytes()))
        };
        fill().map_err(|_| NoAnswer)
    }
}
