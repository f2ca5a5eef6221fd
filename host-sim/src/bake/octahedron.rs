//! Unit vectors in four bytes, as [`scanray::Normals::Octahedral`] has them.

/// Answers the octahedron's point whose unit vector is nearest to a normal: of the four around its image.
pub fn fold(normal: [f64; 3]) -> [i16; 2] {
    let [x, y, z] = normal;
    let length = x.abs() + y.abs() + z.abs();
    let [u, v] = [x / length, y / length];
    // The lower half is turned out over the edges of the upper one.
    let over = |this: f64, other: f64| (1.0 - other.abs()).copysign(this);
    let [u, v] = if z < 0.0 { [over(u, v), over(v, u)] } else { [u, v] };
    let around =
        |value: f64| [value.floor(), value.ceil()].map(|step| step.clamp(-32_767.0, 32_767.0) as i16);
    let points = around(u * 32_767.0).into_iter().flat_map(|u| around(v * 32_767.0).map(|v| [u, v]));
    points.max_by(|a, b| dot(unfold(*a), normal).total_cmp(&dot(unfold(*b), normal))).unwrap_or_default()
}

/// Answers the unit vector of an octahedron's point.
pub fn unfold(point: [i16; 2]) -> [f64; 3] {
    let [u, v] = point.map(|step| f64::from(step) / 32_767.0);
    let z = 1.0 - u.abs() - v.abs();
    let below = (-z).max(0.0);
    let place = [u - below.copysign(u), v - below.copysign(v), z];
    let length = dot(place, place).sqrt();
    place.map(|value| value / length)
}

/// Answers by how many degrees the vector of a normal's point is off.
pub fn error(normal: [f64; 3]) -> f64 {
    dot(unfold(fold(normal)), normal).min(1.0).acos().to_degrees()
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_normal_comes_back_within_4_thousandths_of_a_degree(z in -1.0..=1.0_f64, turn in 0.0..std::f64::consts::TAU) {
            let r = (1.0 - z * z).sqrt();
            prop_assert!(error([r * turn.cos(), r * turn.sin(), z]) < 0.004);
        }
    }

    #[test]
    fn the_axes_come_back_as_they_are() {
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let mut normal = [0.0; 3];
                normal[axis] = sign;
                let back = unfold(fold(normal));
                assert!(dot(back, normal) > 1.0 - 1e-12, "{normal:?}: {back:?}");
            }
        }
    }
}
