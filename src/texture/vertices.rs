use crate::color::Rgb;
use crate::math::Scalar;

/// Is a colour that changes evenly between the corners of a triangle: `(1 - u - v) a + u b + v c`
/// (Gouraud 1971; row O6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertices<S = f32> {
    /// Colours at u = v = 0, at u = 1 and at v = 1: of a triangle's corners in order.
    pub colors: [Rgb<S>; 3],
}

impl<S> Vertices<S> {
    /// Makes a colour of those of a triangle's corners.
    pub const fn new(a: Rgb<S>, b: Rgb<S>, c: Rgb<S>) -> Self {
        Self { colors: [a, b, c] }
    }
}

impl<S: Scalar> Vertices<S> {
    /// Answers the colour at barycentric coordinates; beyond the triangle, the nearest of an edge.
    pub fn color(&self, u: S, v: S) -> Rgb<S> {
        let [a, b, c] = self.colors;
        // A hit may be off the edge by a rounding, which must not make light of less than none.
        let u = u.max(S::ZERO).min(S::ONE);
        let v = v.max(S::ZERO).min(S::ONE - u);
        let mut mixed = a * (S::ONE - u - v);
        mixed += b * u;
        mixed += c * v;
        mixed
    }

    /// Tells whether every value is one a scene may contain.
    pub fn in_range(&self) -> bool {
        self.colors.iter().all(|color| color.in_range())
    }
}
