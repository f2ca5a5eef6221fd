use super::observer::{Observer, RayKind};
use super::visibility::occluded;
use crate::brdf;
use crate::color::Rgb;
use crate::hit::Surface;
use crate::light::Incidence;
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
    /// Where the viewer is, unit length.
    pub to_eye: Vec3<S>,
    /// Which object the surface belongs to.
    pub index: u16,
}

/// Answers the light that a surface sends to the viewer, mirrors left out (rows L1, L2, L3, L7):
/// `Ia kd + sum of fs l kd (n.L) + fs l ks (r.v)^n`.
pub(super) fn direct<S: Scalar, X: Intersect<S>>(
    scene: &Scene<'_, S, X>,
    site: &Site<'_, S>,
    observer: &mut impl Observer,
) -> Rgb<S> {
    let color = site.material.texture.color(&site.surface);
    if site.material.model == Model::Flat {
        return color;
    }
    let mut sum = scene.ambient * color * site.material.ambient;
    for light in scene.lights {
        let Some(incidence) = light.incidence(site.surface.point) else { continue };
        let cosine = brdf::lambert(site.surface.normal, incidence.direction);
        if cosine > S::ZERO && !shadowed(scene, site, &incidence, observer) {
            sum += incidence.color * (color * cosine + highlight(site, &incidence));
        }
    }
    sum
}

fn shadowed<S: Scalar, X: Intersect<S>>(
    scene: &Scene<'_, S, X>,
    site: &Site<'_, S>,
    incidence: &Incidence<S>,
    observer: &mut impl Observer,
) -> bool {
    observer.ray(RayKind::Shadow);
    let ray = Ray::new(site.surface.point, incidence.direction);
    occluded(scene, &ray, &Interval::new(S::ZERO, incidence.distance), Some(site.index))
}

fn highlight<S: Scalar>(site: &Site<'_, S>, incidence: &Incidence<S>) -> Rgb<S> {
    let material = site.material;
    if !material.specular.is_lit() {
        return Rgb::BLACK;
    }
    let normal = site.surface.normal;
    material.specular * brdf::phong(normal, incidence.direction, site.to_eye, material.shininess)
}
