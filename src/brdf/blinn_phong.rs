use crate::math::{Scalar, Vec3};

/// Answers Blinn's form of Phong's factor, `(n.h)^n` with `h = unit(l + v)` (Blinn 1977; row L4).
///
/// It is 0 where light and eye are opposite, so that no direction lies half-way between them.
#[inline(never)]
pub fn blinn_phong<S: Scalar>(normal: Vec3<S>, to_light: Vec3<S>, to_eye: Vec3<S>, shininess: u16) -> S {
    let between = to_light + to_eye;
    let (square, along) = (between.dot(between), normal.dot(between));
    // c^n is below exp(-n (1 - c^2) / 2): most of a ball is too far from its highlight to need a root.
    let off = (square - along * along) * S::from_i32(i32::from(shininess));
    if off > (S::FADED + S::FADED) * square {
        return S::ZERO;
    }
    let Some((half, _)) = between.normalize() else { return S::ZERO };
    normal.dot(half).max(S::ZERO).pow_unit(shininess)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::phong;

    const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);
    /// To the light, 30 degrees off the normal.
    const LIGHT: Vec3<f64> = Vec3::new(0.5, 0.866_025_403_784_438_6, 0.0);

    #[test]
    fn a_highlight_is_brightest_where_the_normal_lies_half_way_between_light_and_eye() {
        let mirrored = Vec3::new(-LIGHT.x, LIGHT.y, 0.0);
        assert!((blinn_phong(UP, LIGHT, mirrored, 200) - 1.0).abs() < 1e-12);
        // Seen from the light the half-way direction is the light's: 30 degrees.
        assert!((blinn_phong(UP, LIGHT, LIGHT, 4) - 0.75 * 0.75).abs() < 1e-12);
        assert_eq!(blinn_phong(UP, LIGHT, -LIGHT, 1), 0.0);
        assert_eq!(blinn_phong(UP, LIGHT, -mirrored, 1), 0.0);
    }

    #[test]
    fn in_the_plane_of_the_normal_the_angle_is_half_of_phong_s() {
        // 15 degrees against 30: cos^2 15 = (1 + cos 30) / 2.
        assert!(
            (blinn_phong(UP, LIGHT, UP, 2) - (1.0 + phong([UP.dot(LIGHT), 1.0, UP.dot(LIGHT)], 1)) / 2.0)
                .abs()
                < 1e-12
        );
    }

    #[test]
    fn what_is_left_out_as_faint_is_less_than_the_number_s_step() {
        let steps = (0..90).map(|degrees| f64::from(degrees).to_radians());
        for (angle, shininess) in steps.flat_map(|angle| [1, 8, 50, 200, 4000].map(|n| (angle, n))) {
            let eye = Vec3::new(angle.sin(), angle.cos(), 0.0);
            let exact = (angle / 2.0).cos().powi(i32::from(shininess));
            let factor = blinn_phong(UP, UP, eye, shininess);
            assert!((factor - exact).abs() < 1e-12, "{angle}, {shininess}: {factor}, not {exact}");
        }
    }
}
