use crate::math::{Scalar, Vec3};

/// Answers Phong's specular factor `(r.v)^n` with `r = 2 (n.l) n - l`, at least 0 (row L3).
pub fn phong<S: Scalar>(normal: Vec3<S>, to_light: Vec3<S>, to_eye: Vec3<S>, shininess: u16) -> S {
    // r.v without r: 2 (n.l) (n.v) - l.v.
    let along = normal.dot(to_light) * normal.dot(to_eye);
    let cosine = along + along - to_light.dot(to_eye);
    // c^n is below exp(-n (1 - c)): most of a ball is too far from its highlight to count.
    let faint = (S::ONE - cosine) * S::from_i32(i32::from(shininess)) > S::FADED;
    if cosine > S::ZERO && !faint { cosine.pow_unit(shininess) } else { S::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);
    /// To the light, 30 degrees off the normal.
    const LIGHT: Vec3<f64> = Vec3::new(0.5, 0.866_025_403_784_438_6, 0.0);

    #[test]
    fn a_highlight_is_brightest_in_the_mirror_direction_and_a_power_of_the_cosine_beside_it() {
        let mirrored = Vec3::new(-LIGHT.x, LIGHT.y, 0.0);
        assert!((phong(UP, LIGHT, mirrored, 50) - 1.0).abs() < 1e-12);
        // The normal is 30 degrees off the mirror direction, the light itself 60: cosine 1/2.
        assert!((phong(UP, LIGHT, UP, 4) - 0.75 * 0.75).abs() < 1e-12);
        assert!((phong(UP, LIGHT, LIGHT, 3) - 0.125).abs() < 1e-12);
        assert_eq!(phong(UP, LIGHT, -mirrored, 1), 0.0);
    }
}
