//! Points and colours: what every part of a scene file is made of.

use crate::rounded::Rounded;
use scanray::{Rgb, Vec3};
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// Is a point or a direction, written `(x, y, z)`.
pub type Point = [f64; 3];

/// Is what is up where a file does not say it: along the second axis, as in the gallery.
pub const UP: Point = [0.0, 1.0, 0.0];

/// Rounds a point to a number.
pub fn point<S: Rounded>(point: Point) -> Vec3<S> {
    Vec3::from_array(point.map(S::round))
}

/// Answers a value that a file has to say: one that differs from what it would be anyway.
pub fn unless<T: PartialEq>(usual: T, value: T) -> Option<T> {
    (value != usual).then_some(value)
}

/// Is linear light: red, green and blue written `(r, g, b)`, or a grey written as one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Color(pub [f64; 3]);

impl Color {
    /// Takes a colour of the core.
    pub fn of(color: Rgb<f64>) -> Self {
        Self([color.r, color.g, color.b])
    }

    /// Rounds it to a number.
    pub fn in_number<S: Rounded>(self) -> Rgb<S> {
        let [r, g, b] = self.0.map(S::round);
        Rgb::new(r, g, b)
    }
}

impl Serialize for Color {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        let [r, g, b] = self.0.map(f64::to_bits);
        if r == g && g == b { self.0[0].serialize(serializer) } else { self.0.serialize(serializer) }
    }
}

impl<'de> Deserialize<'de> for Color {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(GrayOrRgb)
    }
}

/// Takes a colour in either form.
struct GrayOrRgb;

impl<'de> Visitor<'de> for GrayOrRgb {
    type Value = Color;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a grey such as 0.5 or red, green and blue such as (0.9, 0.2, 0.1)")
    }

    fn visit_f64<E: Error>(self, level: f64) -> Result<Color, E> {
        Ok(Color([level; 3]))
    }

    fn visit_u64<E: Error>(self, level: u64) -> Result<Color, E> {
        self.visit_f64(level as f64)
    }

    fn visit_i64<E: Error>(self, level: i64) -> Result<Color, E> {
        self.visit_f64(level as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut lights: A) -> Result<Color, A::Error> {
        let mut light = |index| lights.next_element()?.ok_or_else(|| Error::invalid_length(index, &self));
        Ok(Color([light(0)?, light(1)?, light(2)?]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_color_is_a_grey_or_three_lights() {
        let read = |text| ron::from_str::<Color>(text);
        assert_eq!(read("0.1"), Ok(Color([0.1; 3])));
        assert_eq!(read("-1"), Ok(Color([-1.0; 3])));
        assert_eq!(read("(1, 0.25, 1e-3)"), Ok(Color([1.0, 0.25, 0.001])));
        for wrong in ["(1, 2)", "(1, 2, 3, 4)", "\"red\"", "Red", "()", "(r: 1, g: 2, b: 3)"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_written_color_is_read_to_the_bit() {
        for color in [Color([75.0 / 255.0; 3]), Color([0.1, 1e-300, 5e-324]), Color([1024.0, 0.0, 1.0 / 3.0])]
        {
            let text = ron::to_string(&color).unwrap();
            assert_eq!(ron::from_str::<Color>(&text), Ok(color), "{text}");
        }
    }
}
