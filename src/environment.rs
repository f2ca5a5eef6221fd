//! What lies around the scene.

use crate::color::Rgb;
use crate::math::{Scalar, Vec3};
use crate::texture::{Bitmap, Filter, Spot, last_texel, sample};

/// Is what a ray sees that meets nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Sky<S = f32> {
    /// The same light everywhere.
    Solid(Rgb<S>),
    /// Light that changes with the height of the direction: `s = (1 + d.up) / 2` runs from
    /// `nadir` at 0 to `zenith` at 1.
    Gradient {
        /// Unit vector toward the zenith.
        up: Vec3<S>,
        /// Light from straight below.
        nadir: Rgb<S>,
        /// Light from straight above.
        zenith: Rgb<S>,
    },
    /// Images on the six faces of a cube that is infinitely far away.
    Cube(Cube),
}

/// Is an environment map on the six faces of a cube around the scene (Greene 1986; row T4).
///
/// A direction sees the face of its largest component m; its other two components a and b, in the
/// order of the axes, give the place `u = (a + m) / 2m`, `v = (b + m) / 2m`. Seen from inside, u
/// grows with a on the faces at high x, y, z and against it on the others, and so does v with b.
/// Texels' middles lie on the cube's edges, as in an [`Image`](crate::texture::Image), so that faces
/// whose rims agree have no seams. Levels count as sRGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube {
    /// The images seen toward low x, high x, low y, high y, low z and high z.
    pub faces: &'static [Bitmap; 6],
    /// How the colour between texels is found.
    pub filter: Filter,
}

impl Cube {
    /// Makes an environment of the images seen toward low x, high x, low y, high y, low z and high z,
    /// smoothed.
    pub const fn new(faces: &'static [Bitmap; 6]) -> Self {
        Self { faces, filter: Filter::Bilinear }
    }

    /// Sets how the colour between texels is found.
    pub const fn with_filter(mut self, filter: Filter) -> Self {
        self.filter = filter;
        self
    }

    /// Answers the light that arrives from a unit direction.
    #[inline(never)]
    pub fn color<S: Scalar>(&self, direction: Vec3<S>) -> Rgb<S> {
        if !cfg!(feature = "images") {
            return Rgb::BLACK;
        }
        let (face, spot) = self.spot(direction);
        self.faces.get(face).map_or(Rgb::BLACK, |bitmap| sample(bitmap, self.filter, &spot))
    }

    /// Answers a number of the texels that the light from a direction comes from, other for
    /// neighbouring ones.
    #[inline(never)]
    pub fn tile<S: Scalar>(&self, direction: Vec3<S>) -> u32 {
        if !cfg!(feature = "images") {
            return 0;
        }
        let (face, spot) = self.spot(direction);
        spot.number(self.filter) ^ (face as u32).rotate_right(3)
    }

    /// Answers the face that a direction sees, and where.
    fn spot<S: Scalar>(&self, direction: Vec3<S>) -> (usize, Spot<S>) {
        let Vec3 { x, y, z } = direction;
        let (wide, high, deep) = (x.abs(), y.abs(), z.abs());
        let (axis, m, a, b) = if wide > high && wide > deep {
            (0, x, y, z)
        } else if high > deep {
            (2, y, x, z)
        } else {
            (4, z, x, y)
        };
        let face = axis + usize::from(m > S::ZERO);
        let [columns, rows] = self.faces.get(face).map_or([S::ZERO; 2], last_texel);
        let place = |c: S| (c + m).ratio(m + m).max(S::ZERO).min(S::ONE);
        (face, Spot::at(place(a) * columns, (S::ONE - place(b)) * rows))
    }
}

impl<S: Scalar> Sky<S> {
    /// Answers the light that arrives from a unit direction.
    pub fn color(&self, direction: Vec3<S>) -> Rgb<S> {
        match *self {
            Self::Solid(color) => color,
            Self::Gradient { up, nadir, zenith } => {
                let s = (S::ONE + direction.dot(up)) * S::HALF;
                nadir * (S::ONE - s) + zenith * s
            }
            Self::Cube(cube) => cube.color(direction),
        }
    }

    /// Answers a number of the tile that a direction sees: neighbouring tiles have different ones.
    pub fn tile(&self, direction: Vec3<S>) -> u32 {
        if let Self::Cube(cube) = self { cube.tile(direction) } else { 0 }
    }
}
