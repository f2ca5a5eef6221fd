use super::description::{Material, Model};
use super::vector::Vector;

/// Is how flat a surface of facets may be seen before it is seen no flatter, as n.v.
const FLATTEST: f64 = 1.0 / 1024.0;

/// Is light on its way to the eye: unit vectors that point away from the surface.
#[derive(Clone, Copy)]
pub(super) struct Way {
    pub normal: Vector,
    pub to_light: Vector,
    pub to_eye: Vector,
}

impl Material {
    /// Answers the factor of the specular reflection, 0 or more.
    pub fn shine(&self, way: &Way) -> f64 {
        let exponent = f64::from(self.shininess);
        match self.model {
            Model::Flat => 0.0,
            Model::Phong => way.eye_off_mirrored().max(0.0).powf(exponent),
            Model::BlinnPhong => way.facet_lean().cos().max(0.0).powf(exponent),
            Model::CookTorrance { roughness, index } => way.facets(roughness, index),
        }
    }
}

impl Way {
    /// Answers the cosine between the eye and the mirror direction `2 (l.n) n - l`.
    fn eye_off_mirrored(&self) -> f64 {
        let along = self.normal.inner(self.to_light);
        (self.normal * (2.0 * along) - self.to_light).inner(self.to_eye)
    }

    /// Answers the normal of the facets that send light to the eye.
    fn facet(&self) -> Vector {
        (self.to_light + self.to_eye).unit()
    }

    /// Answers how far such a facet leans, in radians.
    fn facet_lean(&self) -> f64 {
        angle(self.normal, self.facet())
    }

    /// Answers `D G F / (n.v)` of Cook and Torrance as the lecture writes it, Fresnel's share by his
    /// own equations.
    fn facets(&self, roughness: f64, index: f64) -> f64 {
        let facet = self.facet();
        let [n_h, n_l, n_v] = [facet, self.to_light, self.to_eye].map(|v| self.normal.inner(v));
        if n_l <= 0.0 || n_v <= 0.0 {
            return 0.0;
        }
        let v_h = self.to_eye.inner(facet);
        let square = roughness * roughness;
        let spread = (square / (n_h * n_h * (square - 1.0) + 1.0)).powi(2);
        let cases = [1.0, 2.0 * n_h * n_v / v_h, 2.0 * n_h * n_l / v_h];
        let open = cases.into_iter().fold(f64::INFINITY, f64::min);
        spread * open * reflected(angle(self.to_eye, facet), index) / n_v.max(FLATTEST)
    }
}

/// Answers the angle between two directions, in radians, exact for small ones too.
pub(super) fn angle(a: Vector, b: Vector) -> f64 {
    a.outer(b).norm().atan2(a.inner(b))
}

/// Answers the share of unpolarised light that is reflected at an angle of incidence: the mean of the
/// two polarisations', with the refracted angle of Snell's law.
fn reflected(incident: f64, index: f64) -> f64 {
    let (i, t) = (incident.cos(), (incident.sin() / index).asin().cos());
    let across = (i - index * t) / (i + index * t);
    let along = (index * i - t) / (index * i + t);
    (across * across + along * along) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glass_reflects_what_its_index_says() {
        // 4 % head on, all of it grazing, and at Brewster's angle but one of the two polarisations.
        assert!((reflected(0.0, 1.5) - 0.04).abs() < 1e-12);
        let brewster = 1.5_f64.atan();
        assert!((reflected(brewster, 1.5) - 0.5 * (1.25_f64 / 3.25).powi(2)).abs() < 1e-12);
        assert!((reflected(90_f64.to_radians(), 1.5) - 1.0).abs() < 1e-12);
    }
}
