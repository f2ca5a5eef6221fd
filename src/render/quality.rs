use super::pattern::Pattern;

/// Is how many rays a picture takes.
///
/// From few to many: [`Adaptive`] fills in pixels, [`Exact`] sends one ray through each, [`AtEdges`]
/// several through those on an edge, [`Uniform`] and [`Jittered`] several through each. It is a type, so
/// that firmware carries the code of the quality it draws in and of no other: a choice at run time takes
/// 12 to 14 KB more of every image.
pub trait Quality: Copy + Default + sealed::Means {}

/// Is a [`Quality`] in which no pixel depends on another: pictures may be drawn in any order of pixels.
pub trait Pointwise: Quality {}

/// Traces every pixel, by a ray through its middle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exact;

/// Traces every eighth pixel, and more between two that do not see the same objects, tiles, mirror images
/// and lights in about the same colour; the others are filled in.
///
/// In 320x240, at least 99.5 % of each gallery scene's pixels are at most 2 steps of a 5-bit channel
/// from the exact picture, and the others at most 28 steps: tests hold it to that. Objects are not lost
/// where their hull is tight and they are among the first 32 of a row; shadows and mirror images narrower
/// than 8 pixels can be missed in a row, and the next row then looks elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adaptive;

/// Traces n x n rays a pixel, through the middles of its n x n squares, and averages their light before
/// the transfer curve (row S1; F. Crow 1977); n is 1 to 8.
///
/// A straight edge crosses at most 2 n - 1 of the squares, each of which counts whole or not at all by the
/// side its middle is on: the share of the pixel that lies beyond the edge is right within 1/n.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Uniform(pub u8);

/// Traces n x n rays a pixel, each somewhere in its own of the n x n squares, and averages their light
/// (row S1; R. Cook 1986, "Stochastic Sampling in Computer Graphics"); n is 1 to 8.
///
/// Where stripes are finer than the squares, noise takes the place of false stripes. A straight edge's share
/// is right within 2/n. Places are hashed of pixel and sample: nothing is remembered from one to the next,
/// and every number, chip and order of rows gets the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Jittered(pub u8);

/// Traces several rays through the pixels on an edge and one through each other pixel (row S3): as in
/// `AtEdges(Uniform(3))`.
///
/// A row is looked at along a zigzag between its upper and its lower edge. Where two neighbours saw other
/// objects, tiles, mirror images or lights, or levels more than two steps of 5 bits apart, both pixels are
/// on an edge, as is the first and the last of a row; any other takes half its own light and a quarter of
/// either neighbour's, the light of its middle wherever light changes evenly. A straight edge that nobody
/// notices cuts off at most 1/8 of a pixel; what is smaller than a pixel can be lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AtEdges<P>(pub P);

impl Uniform {
    /// Is the largest n.
    pub const MOST: u8 = super::pattern::MOST;
}

impl Default for Uniform {
    fn default() -> Self {
        Self(2)
    }
}

impl Default for Jittered {
    fn default() -> Self {
        Self(2)
    }
}

impl Quality for Exact {}
impl Quality for Adaptive {}
impl Quality for Uniform {}
impl Quality for Jittered {}
impl<P: Pointwise> Quality for AtEdges<P> {}

impl Pointwise for Exact {}
impl Pointwise for Uniform {}
impl Pointwise for Jittered {}

/// Names how the pixels of a row come by their light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// One ray each.
    Traced,
    /// Some by a ray, others from what lies beside them.
    FilledIn,
    /// Several rays each.
    Sampled,
    /// Several rays on edges, one elsewhere.
    SampledAtEdges,
}

pub(super) mod sealed {
    use super::{Adaptive, AtEdges, Exact, Jittered, Pattern, Pointwise, Uniform, Way};

    /// Keeps the list of qualities closed, and knows what each does.
    pub trait Means {
        /// How the pixels of a row come by their light.
        const WAY: Way;

        /// Where the rays of a pixel go through it.
        fn pattern(&self) -> Pattern {
            Pattern::MIDDLE
        }
    }

    impl Means for Exact {
        const WAY: Way = Way::Traced;
    }

    impl Means for Adaptive {
        const WAY: Way = Way::FilledIn;
    }

    impl Means for Uniform {
        const WAY: Way = Way::Sampled;

        fn pattern(&self) -> Pattern {
            Pattern::middles(self.0)
        }
    }

    impl Means for Jittered {
        const WAY: Way = Way::Sampled;

        fn pattern(&self) -> Pattern {
            Pattern::scattered(self.0)
        }
    }

    impl<P: Pointwise> Means for AtEdges<P> {
        const WAY: Way = Way::SampledAtEdges;

        fn pattern(&self) -> Pattern {
            self.0.pattern()
        }
    }
}
