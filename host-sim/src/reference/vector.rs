use std::ops::{Add, Mul, Neg, Sub};

/// Is three numbers: a point, a direction, or a light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vector(pub [f64; 3]);

impl Vector {
    /// Answers a normal that looks to the viewer: one that looks away, mirrored at the line of sight.
    pub fn turned_to(self, to_eye: Self) -> Self {
        let away = self.inner(to_eye).min(0.0);
        self - to_eye * (2.0 * away)
    }

    /// Makes the vector whose components a function of the axis gives.
    pub fn by_axis(component: impl FnMut(usize) -> f64) -> Self {
        Self(std::array::from_fn(component))
    }

    /// Answers the inner product.
    pub fn inner(self, other: Self) -> f64 {
        (0..3).map(|axis| self.0[axis] * other.0[axis]).sum()
    }

    /// Answers the outer product, right-handed.
    pub fn outer(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// Answers the Euclidean norm.
    pub fn norm(self) -> f64 {
        self.inner(self).sqrt()
    }

    /// Answers the vector of norm 1 in this direction.
    pub fn unit(self) -> Self {
        self * (1.0 / self.norm())
    }

    /// Multiplies component by component, as coloured light is filtered.
    pub fn filter(self, other: Self) -> Self {
        Self::by_axis(|axis| self.0[axis] * other.0[axis])
    }
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::by_axis(|axis| self.0[axis] + other.0[axis])
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::by_axis(|axis| self.0[axis] - other.0[axis])
    }
}

impl Neg for Vector {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Mul<f64> for Vector {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}
