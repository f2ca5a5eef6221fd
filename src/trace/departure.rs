/// Names the object on whose surface a ray starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Departure {
    /// Place of the object in the scene's list.
    pub index: u16,
    /// Whether the ray leaves a convex shape outward: then it never meets it again.
    pub free: bool,
}

impl Departure {
    /// Stands for a start off all surfaces.
    pub const NOWHERE: Self = Self { index: u16::MAX, free: true };

    /// Fills a place that is written to before it is read; in zeros, as all of an empty workspace.
    pub const UNSET: Self = Self { index: 0, free: false };
}
