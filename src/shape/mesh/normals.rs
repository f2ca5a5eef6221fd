use crate::fault::Fault;
use crate::math::{Scalar, Vec3};

/// Says how a mesh is lit: flat, or smooth by the normals of its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Normals<S: 'static = f32> {
    /// Each triangle by its own normal.
    Flat,
    /// A unit vector for each corner: 12 bytes each.
    Exact(&'static [Vec3<S>]),
    /// An octahedron's point for each corner: 4 bytes each, at most 0.004 degrees off.
    ///
    /// The sphere is mapped onto the octahedron `|x| + |y| + |z| = 1` and its lower half, z < 0, turned out over
    /// the upper one's edges, onto a square (Z. Cigolle et al. 2014, "A Survey of Efficient Representations
    /// for Independent Unit Vectors"); a step is 1/32767.
    Octahedral(&'static [[i16; 2]]),
}

impl<S: Scalar> Normals<S> {
    /// Answers the unit normal of a corner, if it has one.
    pub(super) fn normal(&self, number: u16) -> Option<Vec3<S>> {
        let number = usize::from(number);
        match self {
            Self::Flat => None,
            Self::Exact(normals) => normals.get(number).copied(),
            Self::Octahedral(points) => points.get(number).and_then(|point| unfold(*point)),
        }
    }

    pub(super) fn check(&self, corners: usize) -> Result<(), Fault> {
        match self {
            Self::Flat => Ok(()),
            Self::Exact(normals) if normals.len() != corners => Err(Fault::Mesh),
            Self::Octahedral(points) if points.len() != corners => Err(Fault::Mesh),
            Self::Exact(normals) if !normals.iter().all(|normal| normal.is_unit()) => Err(Fault::NoDirection),
            Self::Exact(_) | Self::Octahedral(_) => Ok(()),
        }
    }
}

/// Answers the unit vector of a point of the square.
fn unfold<S: Scalar>(point: [i16; 2]) -> Option<Vec3<S>> {
    const EDGE: i32 = 32_767;
    let [x, y] = point.map(i32::from);
    let z = EDGE - x.abs() - y.abs();
    // Of the lower half, what lies beyond the edge is folded back.
    let fold = |this: i32, other: i32| if this < 0 { other.abs() - EDGE } else { EDGE - other.abs() };
    let (x, y) = if z < 0 { (fold(x, y), fold(y, x)) } else { (x, y) };
    let share = |n: i32| {
        let size = S::from_light_bits(n.unsigned_abs() << 9);
        if n < 0 { -size } else { size }
    };
    Vec3::new(share(x), share(y), share(z)).normalize().map(|(unit, _)| unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Fixed;

    /// Answers the point of the square for a direction, as published: `p = v.xy / (|x| + |y| + |z|)`, of the lower
    /// half `(1 - |p.yx|) sign(p)`.
    fn fold([x, y, z]: [f64; 3]) -> [i16; 2] {
        let sum = x.abs() + y.abs() + z.abs();
        let upper = [x / sum, y / sum];
        let lower = [(1.0 - upper[1].abs()).copysign(x), (1.0 - upper[0].abs()).copysign(y)];
        // Rounded half away from 0, without the standard library.
        (if z < 0.0 { lower } else { upper }).map(|c| (c * 32_767.0 + 0.5_f64.copysign(c)) as i16)
    }

    /// Tells whether a vector is a direction, but for an angle of 0.004 degrees.
    fn is_near(unfolded: [f64; 3], direction: [f64; 3]) -> bool {
        let off = unfolded.into_iter().zip(direction).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        off < 7e-5 * 7e-5
    }

    #[test]
    fn directions_all_around_come_out_of_the_square() {
        let steps = || (-4..=4).map(f64::from);
        for v in steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| [x, y, z]))) {
            let Some((unit, _)) = Vec3::from_array(v).normalize() else { continue };
            let (unit, point) = (unit.to_array(), fold(v));
            let float = unfold::<f32>(point).expect("a direction").to_array().map(f64::from);
            assert!(is_near(float, unit), "{v:?} in f32: {float:?}");
            let fixed = unfold::<Fixed>(point).expect("a direction").to_array().map(Fixed::to_f64);
            assert!(is_near(fixed, unit), "{v:?} in fixed point: {fixed:?}");
        }
    }

    #[test]
    fn the_octahedrons_corners_are_the_axes() {
        let unit = |x, y, z| Some(Vec3::new(x, y, z));
        assert_eq!(unfold::<f64>([32_767, 0]).map(|n| n.x > 0.999_999), Some(true));
        assert_eq!(unfold::<Fixed>([0, 0]), Vec3::from_f64(0.0, 0.0, 1.0).into());
        let down = unfold::<f64>([32_767, -32_767]);
        assert!(down.zip(unit(0.0, 0.0, -1.0)).is_some_and(|(a, b)| a.dot(b) > 0.999_999), "{down:?}");
    }
}
