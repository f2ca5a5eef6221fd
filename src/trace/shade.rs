use super::departure::Departure;
use super::observer::{Observer, RayKind};
use super::shadow::Query;
use super::step::Step;
use super::vicinity::Vicinities;
use crate::brdf;
use crate::color::Rgb;
use crate::hit::Surface;
use crate::light::{Light, Spot};
use crate::material::{Material, Model};
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};
use crate::scene::Scene;
use crate::shape::Intersect;

/// Is a lit place: the surface seen from outside, what it is made of and who looks.
pub(super) struct Site<'a, S: Scalar> {
    /// The surface; its normal points to the viewer's side.
    pub surface: Surface<S>,
    pub material: &'a Material<S>,
    /// What of the ambient light the material reflects where it is white.
    pub ambient: Rgb<S>,
    /// Where the viewer looks to, unit length.
    pub direction: Vec3<S>,
    /// Cosine between the normal and the way to the viewer.
    pub facing: S,
    /// Distance to the viewer.
    pub distance: S,
    /// The surface from which rays to the lights start.
    pub from: Departure,
    /// How many mirrors the viewer looks through.
    pub level: u8,
    /// Which of the rays traced together the viewer follows.
    pub lane: u8,
}

/// Lights surfaces, with shadows or as if nothing stood between them and the lights.
pub(super) struct Shader<'a, 's, S: Scalar, X, const SHADOWS: bool = true> {
    pub scene: &'s Scene<'a, S, X>,
    /// What is remembered of shadows; without it every object is asked every time.
    pub vicinities: Option<&'s mut Vicinities<S>>,
}

impl<S: Scalar, X: Intersect<S>, const SHADOWS: bool> Shader<'_, '_, S, X, SHADOWS> {
    /// Answers the light that a surface sends to the viewer, mirrors left out (rows L1, L2, L3, L7):
    /// `Ia kd + sum of fs l kd (n.L) + fs l ks (r.v)^n`.
    #[inline(always)]
    pub fn direct(&mut self, site: &Site<'_, S>, observer: &mut impl Observer) -> Rgb<S> {
        let color = site.material.texture.color(&site.surface);
        if matches!(site.material.model, Model::Flat) {
            return color;
        }
        let mut sum = site.ambient * color;
        observer.step(site.lane, move || Step::Ambient { color, light: sum });
        for (number, light) in (0..u16::MAX).zip(self.scene.lights) {
            let Some((direction, distance)) = facing(light, &site.surface) else { continue };
            let cosine = brdf::lambert(site.surface.normal, direction);
            if cosine > S::ZERO
                && let Some(arriving) = light.arriving(direction)
                && !self.shadowed(site, number, direction, distance, observer)
            {
                observer.lit(site.lane, number);
                let (diffuse, highlight) = (color * cosine, highlight(site, direction, cosine));
                let sent = arriving * (diffuse + highlight);
                observer.step(site.lane, move || Step::Lit {
                    light: number,
                    arriving,
                    cosine,
                    diffuse,
                    highlight,
                    sent,
                });
                sum += sent;
            }
        }
        sum
    }

    /// Tells whether anything stands between the surface and a light.
    #[inline(always)]
    fn shadowed(
        &mut self,
        site: &Site<'_, S>,
        number: u16,
        direction: Vec3<S>,
        distance: S,
        observer: &mut impl Observer,
    ) -> bool {
        if !SHADOWS {
            return false;
        }
        observer.ray(RayKind::Shadow);
        let point = site.surface.point;
        observer.step(site.lane, move || Step::Asks {
            light: number,
            ray: Ray::new(point, direction),
            distance,
        });
        let query = || Query {
            ray: Ray::new(point, direction),
            interval: Interval::new(S::ZERO, distance),
            from: site.from,
        };
        let (Some(vicinities), 0, None) = (&mut self.vicinities, site.level, self.scene.tree()) else {
            return query().is_blocked(self.scene);
        };
        let vicinity = vicinities.of(self.scene, number, point, site.distance);
        !vicinity.is_open(site.from) && query().is_blocked_near(self.scene, vicinity)
    }
}

/// Answers direction and distance of a light; `None` where the surface faces away from it, and for
/// a light on the surface.
fn facing<S: Scalar>(light: &Light<S>, surface: &Surface<S>) -> Option<(Vec3<S>, S)> {
    match *light {
        Light::Point { position, .. } | Light::Spot(Spot { position, .. }) => {
            let toward = position - surface.point;
            // A surface that faces away needs no root.
            if toward.dot(surface.normal) > S::ZERO { toward.normalize() } else { None }
        }
        Light::Directional { toward, .. } => toward.normalize().map(|(unit, _)| (unit, S::FAR)),
    }
}

// A call would be handed the whole site, which then is written to memory: 40 instructions a pixel.
#[inline(always)]
fn highlight<S: Scalar>(site: &Site<'_, S>, to_light: Vec3<S>, cosine: S) -> Rgb<S> {
    let material = site.material;
    if !material.specular.is_lit() {
        return Rgb::BLACK;
    }
    let factor = match &material.model {
        Model::BlinnPhong if cfg!(feature = "models") => {
            brdf::blinn_phong(site.surface.normal, to_light, -site.direction, material.shininess)
        }
        Model::CookTorrance(facets) if cfg!(feature = "models") => {
            facets.factor(site.surface.normal, to_light, -site.direction)
        }
        _ => {
            let cosines = [cosine, site.facing, -to_light.dot(site.direction)];
            brdf::phong(cosines, material.shininess)
        }
    };
    material.specular * factor
}
