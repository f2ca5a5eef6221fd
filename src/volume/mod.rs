//! Volumes: fields sampled on a grid of voxels, seen as a body that light comes through.
//!
//! ```text
//! ray -> pieces, one a cell (partition) -> value in the middle of each (grid) -> colour and opacity (classes)
//!   -> lit by the gradient (gradient) -> laid front to back (composite) -> over the surfaces behind
//! ```
//!
//! A [`Volume`] glows and dims; the surface in a field, `f = a`, is the shape [`Isosurface`](crate::Isosurface).
//! [`walks`] are the discrete ways through a grid that the partition is compared with.

mod classes;
mod composite;
mod gradient;
mod grid;
mod partition;
mod voxels;
pub mod walks;

pub use classes::Class;
pub use composite::Veil;
pub use gradient::Gradient;
pub use grid::{Grid, Place};
pub(crate) use partition::{Course, Piece};
pub use voxels::Voxels;

use crate::fault::Fault;
use crate::math::Scalar;

/// Names how the value between voxels is found (row V4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reconstruction {
    /// The value of the nearest voxel, and its gradient.
    Nearest,
    /// The values of the eight voxels around, mixed by the distances along the axes.
    #[default]
    Trilinear,
}

impl Reconstruction {
    /// Answers where the field is read for a place.
    fn of<S: Scalar>(self, place: Place<S>) -> Place<S> {
        match self {
            Self::Nearest => place.nearest(),
            Self::Trilinear => place,
        }
    }
}

/// Is a body of which every point sends light and dims what is behind it: a sampled field with the classes that say
/// what its values look like (Levoy 1988, "Display of Surfaces from Volume Data"; rows V1, V2, V4 to V6).
///
/// A ray is cut at the planes between cells. The piece in a cell, or each of several equal parts of it, is sampled in
/// its middle and has the opacity
/// `1 - exp(-density (opacity / 255) length)` of its length: a homogeneous body is as opaque whatever its voxels
/// and however a ray cuts them. What the sample sends is `C = Camb + sum of Clight (N.L)`, both times its colour,
/// where N looks toward lower values and nothing stands in the light; where the field is level there is no N, and
/// ambient light is all.
///
/// Rays from the eye see it, and what they meet behind it through it. Shadow rays, mirrors and glass see surfaces
/// only: for those there is the [`Isosurface`](crate::Isosurface).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volume<S: 'static = f32> {
    /// The field.
    pub grid: Grid<S>,
    /// What its values look like, by rising value.
    pub classes: &'static [Class<S>],
    /// How much light a class of opacity 255 takes away: all but 1/e of it within a length of 1/density.
    pub density: S,
    /// How the value between voxels is found.
    pub reconstruction: Reconstruction,
    /// How many samples the piece of a ray in one cell takes, at least 1.
    pub samples: u8,
    /// How normals are found.
    pub gradient: Gradient,
    /// Transparency at which a ray ends. What is left out changes a channel by no more than this share of the
    /// brightest that lies behind.
    pub faintest: S,
}

impl<S: Scalar> Volume<S> {
    /// Makes a volume, trilinear, sampled once a cell, with normals by central differences; rays end where 1/8192 of the light comes
    /// through, less than half the darkest step of 8 bits.
    pub const fn new(grid: Grid<S>, classes: &'static [Class<S>], density: S) -> Self {
        let (reconstruction, gradient) = (Reconstruction::Trilinear, Gradient::Second);
        Self { grid, classes, density, reconstruction, samples: 1, gradient, faintest: S::SLACK }
    }

    /// Sets how the value between voxels is found.
    pub const fn with_reconstruction(mut self, reconstruction: Reconstruction) -> Self {
        self.reconstruction = reconstruction;
        self
    }

    /// Sets how many samples the piece of a ray in one cell takes: where opacity rises steeply with the value, one
    /// leaves a grain of the cells' size.
    pub const fn with_samples(mut self, samples: u8) -> Self {
        self.samples = samples;
        self
    }

    /// Sets how normals are found.
    pub const fn with_gradient(mut self, gradient: Gradient) -> Self {
        self.gradient = gradient;
        self
    }

    /// Sets the transparency at which a ray ends; 0 for never.
    pub const fn with_faintest(mut self, transparency: S) -> Self {
        self.faintest = transparency;
        self
    }

    /// Tells what is wrong with the volume, if anything.
    ///
    /// # Errors
    /// What is wrong with its grid or its classes, no samples, a density or a transparency out of range, or that this program
    /// was built without volumes.
    pub fn check(&self) -> Result<(), Fault> {
        if !cfg!(feature = "volumes") {
            return Err(Fault::LeftOut("volumes"));
        }
        self.grid.check()?;
        classes::check(self.classes)?;
        let share = self.faintest >= S::ZERO && self.faintest <= S::ONE;
        if self.samples == 0 {
            return Err(Fault::Samples);
        }
        if self.density >= S::ZERO && self.density.in_range() && share {
            Ok(())
        } else {
            Err(Fault::OutOfRange)
        }
    }
}
