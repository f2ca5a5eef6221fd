use super::departure::Departure;
use super::detail::refine_one;
use super::observer::Observer;
use super::shade::{Shader, Site};
use super::tracer::tile;
use crate::color::Rgb;
use crate::hit::Crossing;
use crate::math::Scalar;
use crate::ray::Ray;
use crate::scene::Scene;
use crate::shape::Intersect;

/// Answers the light that an object sends along a primary ray that is known to meet it, by its own
/// surface alone: nothing stands in the light, and no mirror is followed.
///
/// `None` where the scene has no such object.
pub(crate) fn direct_light<S: Scalar, X: Intersect<S>>(
    scene: &Scene<'_, S, X>,
    index: u16,
    ray: &Ray<S>,
    crossing: &Crossing<S>,
    observer: &mut impl Observer,
) -> Option<Rgb<S>> {
    let object = scene.objects.get(usize::from(index))?;
    let material = scene.materials.get(usize::from(object.material))?;
    let mut surface = object.shape.surface(ray, crossing);
    if material.is_detailed() {
        refine_one(&object.shape, material, &mut surface, ray.direction);
    }
    let slope = surface.normal.dot(ray.direction);
    if slope > S::ZERO {
        surface.normal = -surface.normal;
    }
    observer.met(0, index, tile(material, &surface));
    let site = Site {
        surface,
        material,
        ambient: scene.ambient * material.ambient,
        direction: ray.direction,
        facing: slope.abs(),
        distance: crossing.t,
        from: Departure::NOWHERE,
        level: 0,
        lane: 0,
    };
    let mut shader = Shader::<S, X, false> { scene, vicinities: None };
    Some(shader.direct(&site, observer))
}
