use crate::math::Scalar;

/// Answers Phong's specular factor `(r.v)^n` with `r = 2 (n.l) n - l`, at least 0 (row L3).
///
/// It is told the cosines `n.l`, `n.v` and `l.v` of unit vectors that point away from the surface, for the
/// first two are known to whoever asks.
pub fn phong<S: Scalar>([normal_light, normal_eye, light_eye]: [S; 3], shininess: u16) -> S {
    // r.v without r: 2 (n.l) (n.v) - l.v.
    let along = normal_light * normal_eye;
    let cosine = along + along - light_eye;
    // c^n is below exp(-n (1 - c)): most of a ball is too far from its highlight to count.
    let faint = (S::ONE - cosine) * S::from_i32(i32::from(shininess)) > S::FADED;
    if cosine > S::ZERO && !faint { cosine.pow_unit(shininess) } else { S::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);
    /// To the light, 30 degrees off the normal.
    const LIGHT: Vec3<f64> = Vec3::new(0.5, 0.866_025_403_784_438_6, 0.0);

    #[test]
    fn a_highlight_is_brightest_in_the_mirror_direction_and_a_power_of_the_cosine_beside_it() {
        let mirrored = Vec3::new(-LIGHT.x, LIGHT.y, 0.0);
        let seen_from = |eye: Vec3<f64>, n| phong([UP.dot(LIGHT), UP.dot(eye), LIGHT.dot(eye)], n);
        assert!((seen_from(mirrored, 50) - 1.0).abs() < 1e-12);
        // The normal is 30 degrees off the mirror direction, the light itself 60: cosine 1/2.
        assert!((seen_from(UP, 4) - 0.75 * 0.75).abs() < 1e-12);
        assert!((seen_from(LIGHT, 3) - 0.125).abs() < 1e-12);
        assert_eq!(seen_from(-mirrored, 1), 0.0);
    }
}
