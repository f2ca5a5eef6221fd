use super::step::Step;
use crate::math::Scalar;
use core::ops::Range;

/// Names what a ray is sent for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RayKind {
    /// From the eye through a pixel.
    Primary,
    /// From a surface to a light.
    Shadow,
    /// From a surface into the mirror direction.
    Reflection,
    /// From a surface of glass through it.
    Refraction,
}

/// Watches the tracer at work, from outside: the core asks nothing of it.
///
/// `()` watches nothing and costs nothing.
pub trait Observer {
    /// Tells whether it looks at the tiles that [`Observer::met`] names: without, none is worked out.
    const SEES_TILES: bool = true;

    /// Is told of each ray before it is traced.
    fn ray(&mut self, kind: RayKind);

    /// Is told what a ray has met, at every level of reflection and refraction; the sky is object
    /// [`u16::MAX`], a volume on the way of a ray from the eye the one before it.
    ///
    /// `lane` tells the rays of a packet apart and stays with a ray through all its mirrors, and with both
    /// rays into which it splits at glass. `tile` is a number of the object's part and the tile of its
    /// texture, other for other ones nearby.
    fn met(&mut self, _lane: u8, _object: u16, _tile: u32) {}

    /// Is told that the place met last is lit by a light: it faces it, and nothing stands between.
    fn lit(&mut self, _lane: u8, _light: u16) {}

    /// Is offered each step of a ray's calculation with its values, in the order in which it is taken.
    ///
    /// The step is put together only if `step` is called, which owns what it needs: a borrowed local stays in
    /// memory, 7 instructions a pixel on an M4F. Of one ray of a packet, by its `lane` as in
    /// [`Observer::met`], steps come in order; those of several mix.
    #[inline(always)]
    fn step<'c, S: Scalar>(&mut self, _lane: u8, _step: impl FnOnce() -> Step<'c, S>) {}

    /// Is told that the z-buffer tests an object's depths in some columns of a row.
    fn span(&mut self, _object: u16, _columns: &Range<u32>) {}
}

impl Observer for () {
    const SEES_TILES: bool = false;

    fn ray(&mut self, _: RayKind) {}
}

/// Counts rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// Rays from the eye.
    pub primary: u64,
    /// Rays to lights.
    pub shadow: u64,
    /// Rays into mirror directions.
    pub reflection: u64,
    /// Rays through surfaces of glass.
    pub refraction: u64,
}

impl RayCounts {
    /// Answers how many rays there are of all kinds.
    pub fn total(&self) -> u64 {
        self.primary + self.shadow + self.reflection + self.refraction
    }
}

impl Observer for RayCounts {
    const SEES_TILES: bool = false;

    fn ray(&mut self, kind: RayKind) {
        match kind {
            RayKind::Primary => self.primary += 1,
            RayKind::Shadow => self.shadow += 1,
            RayKind::Reflection => self.reflection += 1,
            RayKind::Refraction => self.refraction += 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_of_all_kinds_are_counted_together() {
        let counts = RayCounts { primary: 1, shadow: 20, reflection: 300, refraction: 4000 };
        assert_eq!(counts.total(), 4321);
    }
}
