//! The bits that a panel is sent for a pixel.

use host_sim::panel::Panel;

/// Answers how many bits each channel of a panel has, those that come first in its word first.
pub fn widths(panel: Panel) -> &'static [u32] {
    match panel {
        Panel::Rgb565 => &[5, 6, 5],
        Panel::Rgb666 => &[6, 6, 6],
        Panel::Rgb888 => &[8, 8, 8],
        Panel::Gray8 => &[8],
        Panel::Gray4 => &[4],
        Panel::Mono => &[1],
    }
}

/// Answers the levels of a panel's channels that what it shows, in 8 bits, stands for.
pub fn levels(panel: Panel, shown: [u8; 3]) -> Vec<u32> {
    let level = |(width, shown): (&u32, u8)| {
        let top = (1 << width) - 1;
        (u32::from(shown) * top + 127) / 255
    };
    widths(panel).iter().zip(shown).map(level).collect()
}

/// Answers the bits of a pixel as a panel is sent them, such as `11010 100110 00111`.
pub fn bits(panel: Panel, shown: [u8; 3]) -> String {
    let channels = widths(panel).iter().zip(levels(panel, shown));
    let texts: Vec<String> =
        channels.map(|(width, level)| format!("{level:0w$b}", w = *width as usize)).collect();
    texts.join(" ")
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
            for (channel, width) in widths(panel).iter().enumerate() {
                let top = (1_u32 << width) - 1;
                for level in 0..=top {
                    let mut color = [0; 3];
                    color[channel] = ((level * 255 + top / 2) / top) as u8;
                    assert_eq!(levels(panel, color)[channel], level, "{} {channel}", panel.name());
                }
            }
        }
    }
}
