use super::scalar::{Scalar, Wide};
use core::ops::{Add, Mul, Neg, Sub};

/// Is a point or a direction in world space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3<S = f32> {
    /// Component along the first axis.
    pub x: S,
    /// Component along the second axis; the gallery's "up".
    pub y: S,
    /// Component along the third axis.
    pub z: S,
}

impl<S> Vec3<S> {
    /// Makes a vector of its components.
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }
}

/// Error bounds: sums and the products of [`Vec3::mul_wide`] and [`Vec3::dot_wide`] are exact in
/// fixed point and rounded one by one in floats. With e for half a step in fixed point, and for
/// 6e-8 of the product of the lengths in `f32` (1.1e-16 in `f64`): [`Vec3::dot`] 3 e, a component of
/// [`Vec3::cross`] 3 e, of [`Vec3::reflect`] at a unit normal 12 e. [`Vec3::length`] is as good as
/// [`Scalar::sqrt`].
impl<S: Scalar> Vec3<S> {
    /// Is the origin.
    pub const ZERO: Self = Self::new(S::ZERO, S::ZERO, S::ZERO);

    /// Answers the components as an array.
    pub fn to_array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }

    /// Makes a vector of an array of components.
    pub fn from_array([x, y, z]: [S; 3]) -> Self {
        Self::new(x, y, z)
    }

    /// Answers the scalar product as a wide value.
    pub fn dot_wide(self, rhs: Self) -> S::Wide {
        S::dot_wide(self.to_array(), rhs.to_array())
    }

    /// Answers the scalar product.
    pub fn dot(self, rhs: Self) -> S {
        S::dot(self.to_array(), rhs.to_array())
    }

    /// Answers the vector product (right-handed).
    pub fn cross(self, rhs: Self) -> Self {
        Self::new(
            S::determinant([self.y, self.z], [rhs.y, rhs.z]),
            S::determinant([self.z, self.x], [rhs.z, rhs.x]),
            S::determinant([self.x, self.y], [rhs.x, rhs.y]),
        )
    }

    /// Answers `self + rhs by`.
    pub fn add_scaled(self, rhs: Self, by: S) -> Self {
        Self::new(self.x.add_product(rhs.x, by), self.y.add_product(rhs.y, by), self.z.add_product(rhs.z, by))
    }

    /// Scales to unit length and answers the length too; `None` for a vector of no length.
    pub fn normalize(self) -> Option<(Self, S)> {
        let (unit, length) = S::normalize(self.to_array())?;
        Some((Self::from_array(unit), length))
    }

    /// Answers the length.
    pub fn length(self) -> S {
        S::sqrt(self.dot_wide(self))
    }

    /// Mirrors a travelling direction at a unit normal: `d - 2 (d.n) n`.
    pub fn reflect(self, normal: Self) -> Self {
        let along = self.dot(normal);
        self.add_scaled(normal, -(along + along))
    }

    /// Answers the largest magnitude of a component.
    pub fn largest(self) -> S {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// Tells whether the length is within 1/256 of 1.
    pub fn is_unit(self) -> bool {
        (self.length() - S::ONE).abs() < S::recip(S::from_i32(256))
    }

    /// Multiplies by a scalar into wide components.
    pub fn mul_wide(self, rhs: S) -> WideVec3<S> {
        WideVec3 { x: self.x.mul_wide(rhs), y: self.y.mul_wide(rhs), z: self.z.mul_wide(rhs) }
    }

    /// Tells whether every component may stand in a scene.
    pub fn in_range(self) -> bool {
        self.to_array().iter().all(|c| c.in_range())
    }
}

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self::new(self.x + rhs.x, self.y + rhs.y, self.z + rhs.z)
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self::new(self.x - rhs.x, self.y - rhs.y, self.z - rhs.z)
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;
    fn mul(self, rhs: S) -> Self {
        Self::new(self.x * rhs, self.y * rhs, self.z * rhs)
    }
}

/// Is a vector of wide components, for sums that must not drift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WideVec3<S: Scalar> {
    x: S::Wide,
    y: S::Wide,
    z: S::Wide,
}

impl<S: Scalar> WideVec3<S> {
    /// Is the zero vector.
    pub const ZERO: Self = Self { x: S::Wide::ZERO, y: S::Wide::ZERO, z: S::Wide::ZERO };

    /// Multiplies by the fraction `numerator / denominator`.
    pub fn scale(self, numerator: i32, denominator: i32) -> Self {
        Self {
            x: self.x.scale(numerator, denominator),
            y: self.y.scale(numerator, denominator),
            z: self.z.scale(numerator, denominator),
        }
    }

    /// Rounds to a plain vector.
    pub fn narrow(self) -> Vec3<S> {
        Vec3::new(S::narrow(self.x), S::narrow(self.y), S::narrow(self.z))
    }
}

impl<S: Scalar> Add for WideVec3<S> {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self { x: self.x + rhs.x, y: self.y + rhs.y, z: self.z + rhs.z }
    }
}
