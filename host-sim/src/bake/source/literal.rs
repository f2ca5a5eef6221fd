use crate::scenes::HostNumber;
use scanray::{Fixed, Rgb, Vec3};

/// Is a number that can be written as Rust source, to be read back to the same bits.
pub trait Literal: HostNumber {
    /// Is the name of the type in source.
    const NAME: &'static str;

    /// Is its name on the command line and in reports.
    const WORD: &'static str;

    /// Is the function of a vector or a colour that takes three literals.
    const OF_THREE: &'static str;

    /// Writes the literal alone.
    fn digits(self) -> String;

    /// Writes a number.
    fn number(self) -> String;

    /// Writes a vector.
    fn vector(vector: Vec3<Self>) -> String {
        let [x, y, z] = vector.to_array().map(Self::digits);
        format!("Vec3::{}({x}, {y}, {z})", Self::OF_THREE)
    }

    /// Writes a colour.
    fn color(Rgb { r, g, b }: Rgb<Self>) -> String {
        let [r, g, b] = [r, g, b].map(Self::digits);
        format!("Rgb::{}({r}, {g}, {b})", Self::OF_THREE)
    }
}

impl Literal for f32 {
    const NAME: &'static str = "f32";
    const WORD: &'static str = "f32";
    const OF_THREE: &'static str = "new";

    /// Debug's digits are the fewest that are read back to the same bits.
    fn digits(self) -> String {
        format!("{self:?}")
    }

    fn number(self) -> String {
        self.digits()
    }
}

impl Literal for Fixed {
    const NAME: &'static str = "Fixed";
    const WORD: &'static str = "fixed";
    const OF_THREE: &'static str = "from_f64";

    /// The fewest decimals that are rounded to the same bits: seven tell any two steps of 2^-20 apart.
    fn digits(self) -> String {
        let value = self.to_f64();
        let texts = (1..=7).map(|decimals| format!("{value:.decimals$}"));
        let mut right = texts.filter(|text| text.parse().is_ok_and(|read| Self::new(read) == self));
        right.next().unwrap_or_else(|| format!("{value:?}"))
    }

    fn number(self) -> String {
        format!("Fixed::new({})", self.digits())
    }
}

impl Literal for f64 {
    const NAME: &'static str = "f64";
    const WORD: &'static str = "exact";
    const OF_THREE: &'static str = "new";

    fn digits(self) -> String {
        format!("{self:?}")
    }

    fn number(self) -> String {
        self.digits()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_literal_of_f32_is_read_back_to_the_same_bits(value: f32) {
            prop_assume!(value.is_finite());
            prop_assert_eq!(value.digits().parse::<f32>().unwrap().to_bits(), value.to_bits());
        }

        #[test]
        fn a_literal_of_fixed_point_is_read_back_to_the_same_bits(value in -2048.0..2048.0_f64) {
            let value = Fixed::new(value);
            prop_assert_eq!(Fixed::new(value.digits().parse::<f64>().unwrap()), value);
        }
    }

    #[test]
    fn every_literal_has_a_point_or_an_exponent() {
        assert_eq!([1.0_f32, -0.0, 1e20, 1e-9].map(Literal::digits), ["1.0", "-0.0", "1e20", "1e-9"]);
        assert_eq!(Fixed::new(3.0).number(), "Fixed::new(3.0)");
        assert_eq!(
            [0.1, -0.78, 1.0 / 3.0].map(|value| Fixed::new(value).digits()),
            ["0.1", "-0.78", "0.333333"]
        );
    }
}
