//! The bits that a panel is sent for a pixel.

use crate::panel::Panel;

/// Answers the levels of a panel's channels that what it shows, in 8 bits, stands for.
pub fn levels(panel: Panel, shown: [u8; 3]) -> Vec<u8> {
    // As many steps of 255 as the panel has levels, back to the nearest level, which is below 256.
    let level = |(shown, top): (u8, &u8)| ((u16::from(shown) * u16::from(*top) + 127) / 255) as u8;
    shown.into_iter().zip(panel.tops()).map(level).collect()
}

/// Answers the bits of a pixel as a panel is sent them, such as `11010 100110 00111`.
pub fn bits(panel: Panel, shown: [u8; 3]) -> String {
    let levels = levels(panel, shown);
    let channels = levels.iter().zip(panel.tops());
    let texts = channels.map(|(level, top)| format!("{level:0width$b}", width = top.count_ones() as usize));
    texts.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics_core::pixelcolor::{Gray4, IntoStorage, Rgb565};
    use scanray::Dither;
    use scanray::output::Rounding;

    fn shown(panel: Panel, levels: [u32; 3]) -> [u8; 3] {
        panel.round_pixel(0, levels, &mut Rounding::of_row(Dither::None, 0))
    }

    #[test]
    fn the_bits_of_a_pixel_are_those_that_a_driver_stores() {
        for step in 0..=64_u32 {
            let levels = [step * 1024, 65_536 - step * 1024, step * 317 % 65_536];
            let color: Rgb565 = Rounding::of_row(Dither::None, 0).round(0, levels);
            let word = bits(Panel::Rgb565, shown(Panel::Rgb565, levels)).replace(' ', "");
            assert_eq!(u16::from_str_radix(&word, 2), Ok(color.into_storage()), "{levels:?}");
            let gray: Gray4 = Rounding::of_row(Dither::None, 0).round(0, levels);
            let word = bits(Panel::Gray4, shown(Panel::Gray4, levels));
            assert_eq!(u8::from_str_radix(&word, 2), Ok(gray.into_storage()), "{levels:?}");
        }
        assert_eq!(bits(Panel::Rgb565, [255, 0, 255]), "11111 000000 11111");
    }

    #[test]
    fn every_level_of_every_panel_is_told_apart() {
        for panel in Panel::ALL {
            for (channel, top) in panel.tops().iter().enumerate() {
                for level in 0..=*top {
                    let mut color = [0; 3];
                    let top = u32::from(*top);
                    color[channel] = ((u32::from(level) * 255 + top / 2) / top) as u8;
                    assert_eq!(levels(panel, color)[channel], level, "{} {channel}", panel.name());
                }
            }
        }
    }
}
