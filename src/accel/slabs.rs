use super::lattice::{Entry, Steps};
use crate::math::{Scalar, rough_reciprocal};

/// Is how many units of distance make the side of the cube, as many as it has steps.
const SIDE: i32 = 1 << 16;

/// Is how far off two distances to a box's sides may be together, in units: each is out by 2^-14 + 5e-5 of at
/// most a cube's diagonal of 1.74 sides, which makes 26, and rounding adds 2.
const SLACK: i32 = 28;

/// Is the least slope that is told by its reciprocal, 2^-13, as a number of 24 places.
const LEAST_SLOPE: u32 = 1 << 11;

/// Is how many steps boxes are widened along an axis that a ray goes across: on its way through the cube
/// it strays by 14 at most, and to leave a box so much widened takes it more than the cube's diagonal.
const STRAY: i32 = 32;

/// Is a ray as boxes are asked whether it meets them: as the slabs between their sides (T. Kay and J. Kajiya
/// 1986), one pair for each axis, in whole numbers of 32 bits.
///
/// It meets every box that the ray comes within less than a half step of, and some that it just misses. What
/// makes it cheap is that steps have 16 bits and paces 14: their product is one instruction on every chip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slabs {
    slabs: [Slab; 3],
    /// Distance up to which the ray looks, in units from where it enters the cube, and [`SLACK`] more.
    far: i32,
}

/// Is how a ray goes along one axis.
#[derive(Clone, Copy, Debug)]
struct Slab {
    /// Step from which the way to the first side of a box is counted.
    enter: i32,
    /// Step from which the way to the last side is counted.
    leave: i32,
    /// Units of distance in a step, times 2^`shift`: from 2^13 to 2^14, negative toward lower coordinates.
    pace: i32,
    shift: u32,
}

impl Slab {
    /// Is of a ray of which so little is known that no box is left out.
    const BLIND: Self = Self { enter: SIDE, leave: -STRAY, pace: 1 << 13, shift: 0 };

    fn new<S: Scalar>(start: S, slope: S) -> Self {
        // A cube as small as a ray's rounding at its distance is entered from more than half a side away.
        let place = (start + S::ONE).light_bits().saturating_add(0x80) >> 8;
        let Ok(place @ 0x8001..0x2_8000) = i32::try_from(place) else { return Self::BLIND };
        let origin = place.wrapping_sub(SIDE);
        let bits = slope.abs().light_bits();
        if bits < LEAST_SLOPE {
            let [enter, leave] = [origin.wrapping_add(STRAY), origin.wrapping_sub(STRAY)];
            return Self { enter, leave, pace: 1 << 13, shift: 0 };
        }
        let zeros = bits.leading_zeros();
        let pace = i32::from(rough_reciprocal(bits.wrapping_shl(zeros))).wrapping_add(2) >> 2;
        let pace = if slope < S::ZERO { pace.wrapping_neg() } else { pace };
        Self { enter: origin, leave: origin, pace, shift: 21_u32.saturating_sub(zeros) }
    }

    fn descends(&self) -> bool {
        self.pace < 0
    }

    /// Answers the distances at which the ray passes the sides of a box, in the order in which it does.
    ///
    /// Steps from a start are fewer than 2^17, so that no product is too long.
    #[inline(always)]
    fn passes(&self, low: u16, high: u16) -> (i32, i32) {
        let (first, last) = if self.descends() { (high, low) } else { (low, high) };
        let pass = |side: u16, start: i32| {
            i32::from(side).wrapping_sub(start).wrapping_mul(self.pace).wrapping_shr(self.shift)
        };
        (pass(first, self.enter), pass(last, self.leave))
    }
}

impl Slabs {
    pub fn new<S: Scalar>(entry: &Entry<S>, far: S) -> Self {
        let [x, y, z] = entry.starts;
        let [dx, dy, dz] = entry.slopes;
        let slabs = [Slab::new(x, dx), Slab::new(y, dy), Slab::new(z, dz)];
        let mut slabs = Self { slabs, far: 0 };
        slabs.look_up_to(entry, far);
        slabs
    }

    /// Moves the far end, given as a distance from the ray's start.
    pub fn look_up_to<S: Scalar>(&mut self, entry: &Entry<S>, far: S) {
        let two = S::ONE + S::ONE;
        // Rounded up, and as far beyond as boxes may be off; no way through the cube is as long as two sides.
        let units = entry.sides_to(far).min(two).light_bits() >> 8;
        self.far = (units as i32).wrapping_add(1 + SLACK);
    }

    /// Tells whether the ray goes toward lower coordinates along an axis.
    pub fn descends(&self, axis: usize) -> bool {
        self.slabs.get(axis).is_some_and(Slab::descends)
    }

    /// Tells whether the ray meets a box before its far end.
    #[inline(always)]
    pub fn meets(&self, [low, high]: &Steps) -> bool {
        let (mut near, mut far) = (0, self.far);
        for ((slab, low), high) in self.slabs.iter().zip(low).zip(high) {
            let (enters, leaves) = slab.passes(*low, *high);
            near = near.max(enters);
            far = far.min(leaves.saturating_add(SLACK));
            if near > far {
                return false;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::super::Lattice;
    use super::*;
    use crate::math::{Fixed, Vec3};
    use crate::ray::{Interval, Ray};
    use proptest::prelude::*;

    /// Tells by the formula of slabs in `f64` whether a ray meets a box in the cube before a distance.
    fn passes_through(start: [f64; 3], slopes: [f64; 3], [low, high]: &Steps, far: f64) -> bool {
        let place = |step: u16| f64::from(step) / 65_536.0;
        let (mut near, mut far) = (0.0_f64, far);
        for axis in 0..3 {
            let sides = [low[axis], high[axis]].map(|step| place(step) - start[axis]);
            if slopes[axis] == 0.0 {
                if sides[0] > 0.0 || sides[1] < 0.0 {
                    return false;
                }
                continue;
            }
            let ways = sides.map(|side| side / slopes[axis]);
            near = near.max(ways[0].min(ways[1]));
            far = far.min(ways[0].max(ways[1]));
        }
        near <= far
    }

    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![3 => -1.0..1.0, 1 => Just(0.0), 1 => -1e-3..1e-3, 1 => -2e-4..2e-4]
    }

    fn steps() -> impl Strategy<Value = Steps> {
        let side = prop_oneof![Just(2_u16), Just(40), Just(3000), Just(40_000)];
        (prop::array::uniform3(any::<u16>()), prop::array::uniform3(side))
            .prop_map(|(low, side)| [low, core::array::from_fn(|i| low[i].saturating_add(side[i]))])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(if cfg!(miri) { 4 } else { 20_000 }))]

        #[test]
        fn a_box_that_a_ray_goes_through_is_met(
            start in prop::array::uniform3(0.0..1.0_f64),
            toward in prop::array::uniform3(coordinate()),
            bounds in steps(),
            far in prop_oneof![Just(1000.0), 0.0..2.0],
        ) {
            let vector = |p: [f64; 3]| Vec3::from_array(p.map(Fixed::new));
            let Some((direction, _)) = vector(toward).normalize() else { return Ok(()) };
            let ray = Ray::new(vector(start), direction);
            let lattice = Lattice::new(Vec3::ZERO, Fixed::ONE);
            let interval = Interval::new(Fixed::ZERO, Fixed::new(far));
            let entry = lattice.enter(&ray, &interval).expect("it starts inside");
            let slabs = Slabs::new(&entry, entry.far);
            let [start, slopes] = [ray.origin, ray.direction].map(|v| v.to_array().map(Fixed::to_f64));
            if passes_through(start, slopes, &bounds, far) {
                prop_assert!(slabs.meets(&bounds), "{:?} {:?}", ray, slabs);
            }
        }
    }

    #[test]
    fn a_box_beside_a_ray_is_not_met() {
        let meets = |ray: Ray<f32>, bounds: Steps| {
            let entry = Lattice::new(Vec3::ZERO, 1.0).enter(&ray, &Interval::AHEAD).expect("it goes in");
            Slabs::new(&entry, entry.far).meets(&bounds)
        };
        let aslant = Ray::new(Vec3::new(-1.0, -1.0, 0.5), Vec3::new(0.6, 0.8, 0.0));
        assert!(meets(aslant, [[20_000, 51_000, 30_000], [50_000, 52_000, 40_000]]));
        assert!(!meets(aslant, [[30_000, 50_000, 33_000], [50_000, 60_000, 40_000]]), "it is beside");
        assert!(!meets(aslant, [[30_000, 10_000, 30_000], [50_000, 15_000, 40_000]]), "it is below");
        let along = Ray::new(Vec3::new(0.25, 0.25, -3.0), Vec3::new(0.0, 0.0, 1.0));
        assert!(meets(along, [[16_000, 16_000, 0], [17_000, 17_000, 9]]));
        assert!(!meets(along, [[16_500, 16_000, 0], [17_000, 17_000, 9]]));
    }
}
