use crate::fault::Fault;
use crate::math::{Scalar, Vec3};

/// Is a surface of tiny mirrors, the facets, of which those whose normal is h send light to the eye
/// (Cook and Torrance 1982; row L5).
///
/// The factor is `D G F / (n.v)`. D is Blinn's for ellipsoids (Blinn 1977, after Trowbridge and Reitz
/// 1975), which is 1 at its peak for every roughness: `pi c^2` times the distribution that integrates
/// to 1. G is the shadow of facets on each other in V-shaped grooves, F is [`fresnel`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CookTorrance<S = f32> {
    /// Eccentricity c of the ellipsoids, from 1/64, a polish with sharp highlights, to 1, where
    /// facets lie in all directions alike.
    pub roughness: S,
    /// Index of refraction, 1 to 256: 1.5 for glass; a metal's reflection takes a large one.
    pub index: S,
}

impl<S: Scalar> CookTorrance<S> {
    /// Makes a surface of facets.
    pub const fn new(roughness: S, index: S) -> Self {
        Self { roughness, index }
    }

    /// Tells what is wrong with the surface, if anything.
    ///
    /// # Errors
    /// A roughness or an index outside its range.
    pub fn check(&self) -> Result<(), Fault> {
        // Compared 64 times as large, which every number holds exactly.
        let roughness = self.roughness * S::from_i32(64);
        if !(roughness >= S::ONE && self.roughness <= S::ONE) {
            Err(Fault::Roughness)
        } else if !(self.index >= S::ONE && self.index <= S::from_i32(256)) {
            Err(Fault::FacetIndex)
        } else {
            Ok(())
        }
    }

    /// Answers the factor `D G F / (n.v)`, from 0 to 1024.
    ///
    /// For that n.v counts as at least 1/1024: a surface seen at a flatter angle is an outline, thinner
    /// on a ball than a two-millionth of its radius, and a fixed-point n.v has no digits left there.
    #[inline(never)]
    pub fn factor(&self, normal: Vec3<S>, to_light: Vec3<S>, to_eye: Vec3<S>) -> S {
        let Some((half, length)) = (to_light + to_eye).normalize() else { return S::ZERO };
        // l.h = v.h = |l + v| / 2.
        let v_h = length * S::HALF;
        let (n_l, n_v) = (normal.dot(to_light), normal.dot(to_eye));
        if !(v_h > S::ZERO && n_l > S::ZERO && n_v > S::ZERO) {
            return S::ZERO;
        }
        let spread = self.spread(normal, half);
        let open = masking(normal.dot(half), n_l.min(n_v), v_h);
        let grazing = S::SLACK * S::from_i32(8);
        S::div((spread * fresnel(v_h, self.index)).mul_wide(open), n_v.max(grazing).mul_wide(S::ONE))
    }

    /// Answers D, `(c^2 / (cos^2 (c^2 - 1) + 1))^2` of the angle between normal and facet.
    ///
    /// As `c^2 / (sin^2 + c^2 cos^2)`: where the highlight is narrow, 1 - cos^2 has lost its digits.
    fn spread(&self, normal: Vec3<S>, half: Vec3<S>) -> S {
        let c = self.roughness;
        let (sine, flattened) = (normal.cross(half), normal.dot(half) * c);
        let root = S::div(c.mul_wide(c), sine.dot_wide(sine) + flattened.mul_wide(flattened));
        root * root
    }
}

/// Answers G, the least of 1, `2 (n.h)(n.v) / (v.h)` and `2 (n.h)(n.l) / (v.h)`, of the lesser of n.v
/// and n.l.
fn masking<S: Scalar>(n_h: S, lesser: S, v_h: S) -> S {
    let both = n_h * lesser;
    (both + both).ratio(v_h).min(S::ONE)
}

/// Answers which share of unpolarised light a smooth surface reflects, 0 to 1 (Fresnel 1823; row L5):
/// `F = 1/2 ((g - k) / (g + k))^2 (1 + ((k (g + k) - 1) / (k (g - k) + 1))^2)`, `g^2 = n^2 + k^2 - 1`.
///
/// `k`, above 0 to 1, is the cosine of the angle of incidence; `index`, 1 to 256, that of refraction.
pub fn fresnel<S: Scalar>(k: S, index: S) -> S {
    let one = S::ONE.mul_wide(S::ONE);
    let g = S::sqrt(index.mul_wide(index) + k.mul_wide(k) - one);
    let (sum, difference) = (g + k, g - k);
    let across = difference.ratio(sum);
    let along = (k * sum - S::ONE).ratio(k * difference + S::ONE);
    across * across * (S::ONE + along * along) * S::HALF
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);

    /// Answers a direction so many degrees off the normal, in one plane.
    fn at(degrees: f64) -> Vec3<f64> {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Vec3::new(sine, cosine, 0.0)
    }

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12
    }

    #[test]
    fn head_on_facets_reflect_what_a_mirror_of_their_index_does() {
        for index in [1.0, 1.33, 1.8, 50.0, 200.0] {
            let mirror = ((index - 1.0) / (index + 1.0)) * ((index - 1.0) / (index + 1.0));
            assert!(near(fresnel(1.0, index), mirror));
            for roughness in [1.0 / 64.0, 0.35, 1.0] {
                // D and G are 1.
                assert!(near(CookTorrance::new(roughness, index).factor(UP, UP, UP), mirror));
            }
        }
    }

    #[test]
    fn at_brewster_s_angle_only_one_polarisation_is_reflected_and_grazing_light_is_reflected_whole() {
        for n in [1.33, 1.8, 200.0_f64] {
            let (k, across) = (1.0 / (1.0 + n * n).sqrt(), (n * n - 1.0) / (n * n + 1.0));
            assert!(near(fresnel(k, n), across * across / 2.0));
            assert!(fresnel(1e-9, n) > 0.999_99);
        }
        assert!((1..=64).all(|k| near(fresnel(f64::from(k) / 64.0, 1.0), 0.0)));
    }

    #[test]
    fn a_larger_index_reflects_more_head_on() {
        let shares = [1.0, 1.2, 1.5, 1.8, 2.4, 50.0, 256.0].map(|index| fresnel(1.0, index));
        assert!(shares.is_sorted_by(|a, b| a < b), "{shares:?}");
    }

    #[test]
    fn facets_are_fewer_the_farther_they_lean_and_those_of_roughness_1_lie_everywhere() {
        let spread = |c: f64, degrees: f64| CookTorrance::new(c, 1.5).spread(UP, at(degrees));
        for c in [1.0 / 64.0, 0.2, 0.35, 0.9] {
            let falling: [f64; 19] = core::array::from_fn(|i| spread(c, 5.0 * i as f64));
            assert!(falling.is_sorted_by(|a, b| a > b), "{c}: {falling:?}");
            assert!(near(falling[0], 1.0));
            assert!(near(falling[18], c * c * c * c));
        }
        assert!((0..=90).all(|degrees| near(spread(1.0, f64::from(degrees)), 1.0)));
    }

    #[test]
    fn a_groove_hides_what_leans_away_from_light_or_eye() {
        // From above and from 80 degrees the facets lean by 40: G = 2 cos 40 cos 80 / cos 40.
        let facets = CookTorrance::new(1.0, 1e3);
        let metal = fresnel(at(40.0).y, 1e3);
        assert!(near(facets.factor(UP, UP, at(80.0)), 2.0 * metal));
        assert!(near(facets.factor(UP, at(80.0), UP), 2.0 * at(80.0).y * metal));
        // From both sides at 45 degrees nothing is hidden.
        let open = fresnel(at(45.0).y, 1e3) / at(45.0).y;
        assert!(near(facets.factor(UP, at(45.0), at(-45.0)), open));
    }

    #[test]
    fn nothing_comes_from_behind_and_no_more_than_1024_along_the_surface() {
        let facets = CookTorrance::new(0.35, 1.8);
        assert_eq!(facets.factor(UP, UP, at(91.0)), 0.0);
        assert_eq!(facets.factor(UP, at(91.0), UP), 0.0);
        assert_eq!(facets.factor(UP, UP, -UP), 0.0);
        let grazing = facets.factor(UP, at(89.999), at(-89.999));
        assert!((1000.0..=1024.0).contains(&grazing), "{grazing}");
    }
}
