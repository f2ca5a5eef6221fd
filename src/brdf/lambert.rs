use crate::math::{Scalar, Vec3};

/// Answers Lambert's diffuse factor `n.l`, at least 0 (row L2).
pub fn lambert<S: Scalar>(normal: Vec3<S>, to_light: Vec3<S>) -> S {
    normal.dot(to_light).max(S::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn diffuse_light_falls_with_the_cosine_and_never_below_zero() {
        let (up, light) = (Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.5, 0.866_025_403_784_438_6, 0.0));
        assert!((lambert(up, light) - 0.75_f64.sqrt()).abs() < 1e-12);
        assert_eq!(lambert(up, -light), 0.0);
    }
}
