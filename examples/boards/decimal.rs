//! Numbers as text without `core::fmt`, which would be a quarter of such a small image.

/// Holds the ten digits at most of a `u32`.
pub struct Decimal {
    digits: [u8; 10],
    first: usize,
}

impl Decimal {
    /// Answers the decimal digits of `number`.
    pub fn new(mut number: u32) -> Self {
        let mut digits = [b'0'; 10];
        let mut first = digits.len();
        for (i, digit) in (0..10).zip(&mut digits).rev() {
            *digit = b'0' + (number % 10) as u8;
            number /= 10;
            first = i;
            if number == 0 {
                break;
            }
        }
        Self { digits, first }
    }

    /// Answers the digits without leading zeros.
    pub fn as_bytes(&self) -> &[u8] {
        self.digits.get(self.first..).unwrap_or_default()
    }
}
