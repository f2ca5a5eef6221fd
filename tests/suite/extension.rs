//! A user's own shape takes part in everything the built-in ones do.

use crate::support::{LIGHTS, MATERIALS, camera, v};
use embedded_graphics::prelude::Size;
use scanray::aabb::Aabb;
use scanray::hit::{Crossing, Surface};
use scanray::hull::Hull;
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::{
    Fault, Intersect, Object, Renderer, Rgb, Scene, SceneError, Settings, Shape, Sphere, Workspace,
};

/// Is a disc that faces up.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Disc {
    center: scanray::Vec3,
    radius: f32,
}

impl Intersect<f32> for Disc {
    fn intersect(&self, ray: &Ray, interval: &Interval) -> Option<Crossing> {
        let t = (self.center.y - ray.origin.y) / ray.direction.y;
        let out = ray.at(t) - self.center;
        (interval.contains(t) && out.x * out.x + out.z * out.z <= self.radius * self.radius)
            .then_some(Crossing::at(t))
    }

    fn surface(&self, ray: &Ray, crossing: &Crossing) -> Surface {
        let point = ray.at(crossing.t);
        Surface { point, normal: v(0.0, 1.0, 0.0), u: 0.0, v: 0.0, part: 0 }
    }

    fn hull(&self) -> Hull {
        Hull::Box(Aabb { center: self.center, half: v(self.radius, 0.0, self.radius) })
    }

    fn check(&self) -> Result<(), Fault> {
        if self.radius > 0.0 { Ok(()) } else { Err(Fault::RadiusNotPositive) }
    }
}

fn draw(objects: &[Object<f32, Disc>]) -> Vec<Rgb> {
    let mut workspace = Workspace::<f32, [u8; 2], 0, 2>::new();
    let scene = Scene::new(objects, &MATERIALS, &LIGHTS);
    let size = Size::new(60, 40);
    let mut renderer = Renderer::new(&scene, &camera(), size, Settings::new(), &mut workspace).unwrap();
    let mut light = Vec::new();
    for y in 0..40 {
        renderer.trace_row(y, 0..60, &mut (), |_, color| light.push(color)).unwrap();
    }
    light
}

const DISC: Object<f32, Disc> = Object::new(Shape::Custom(Disc { center: v(0.0, 0.0, 0.0), radius: 1.5 }), 0);
const BALL: Object<f32, Disc> = Object::new(Shape::Sphere(Sphere::new(v(0.0, 1.0, 0.0), 0.8)), 1);

#[test]
fn a_shape_of_the_users_is_seen_lit_shadowed_and_mirrored() {
    let (disc, both) = (draw(&[DISC]), draw(&[DISC, BALL]));
    let lit = |picture: &[Rgb]| picture.iter().filter(|light| light.is_lit()).count();
    assert!(lit(&disc) > 100, "the disc is seen");
    let darkened = disc.iter().zip(&both).filter(|(before, after)| after.r < before.r * 0.5).count();
    assert!(darkened > 10, "the ball's shadow falls on it");
    let ball = draw(&[BALL]);
    let brightened =
        ball.iter().zip(&both).filter(|(alone, with)| alone.is_lit() && with.r > alone.r).count();
    assert!(brightened > 10, "the ball shows it");
}

#[test]
fn a_shape_of_the_users_does_not_shadow_itself() {
    // Whatever is lit at all is lit by both lamps: one direction, so one ratio of the colours.
    let colors: Vec<Rgb> = draw(&[DISC]).into_iter().filter(|light| light.is_lit()).collect();
    let darkest = colors.iter().map(|light| light.r).fold(f32::MAX, f32::min);
    let brightest = colors.iter().map(|light| light.r).fold(0.0, f32::max);
    assert!(darkest > 0.6 * brightest, "from {darkest} to {brightest}");
}

#[test]
fn the_order_of_own_and_built_in_shapes_does_not_matter() {
    assert_eq!(draw(&[DISC, BALL]), draw(&[BALL, DISC]));
}

#[test]
fn a_fault_of_the_users_shape_is_found() {
    let flat = Object::new(Shape::Custom(Disc { center: v(0.0, 0.0, 0.0), radius: 0.0 }), 0);
    let objects = [BALL, flat];
    let scene = Scene::new(&objects, &MATERIALS, &LIGHTS);
    assert_eq!(scene.check(), Err(SceneError::Object(1, Fault::RadiusNotPositive)));
    let _: f32 = <f32 as Scalar>::SKIN;
}
