/// Answers numbers without any pattern, the same ones every time (SplitMix64, G. Steele et al. 2014).
#[derive(Clone, Debug)]
pub(super) struct Random(u64);

impl Random {
    pub fn new() -> Self {
        Self(1)
    }

    /// Answers a number from -1 to 1.
    fn value(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ mixed >> 31) as f64 / 2_f64.powi(63) - 1.0
    }

    /// Answers a point in the cube from -1 to 1.
    pub fn point(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.value())
    }
}
