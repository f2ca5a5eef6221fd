//! Reflection models and spots: what holds in every number, and what they owe to physics.

use crate::support::{MATERIALS, OBJECTS, camera, v};
use embedded_graphics::prelude::Size;
use scanray::brdf::{CookTorrance, blinn_phong, phong};
use scanray::math::{Scalar, cosine};
use scanray::trace::RayCounts;
use scanray::{
    Fault, Fixed, Light, Material, Model, Renderer, Rgb, Scene, SceneError, Settings, Vec3, Workspace,
};

const UP: Vec3<f64> = Vec3::new(0.0, 1.0, 0.0);

/// Answers directions all over the half of space above a surface.
fn above() -> impl Iterator<Item = Vec3<f64>> + Clone {
    (0..400).map(|i| {
        let (height, turn) = ((f64::from(i) + 0.5) / 400.0, f64::from(i) * 2.399_963);
        let across = (1.0 - height * height).sqrt();
        Vec3::new(across * turn.cos(), height, across * turn.sin())
    })
}

#[test]
fn facets_reflect_the_same_share_with_light_and_eye_exchanged() {
    for (c, index) in [(0.1, 1.5), (0.35, 200.0), (1.0, 1.8)] {
        let facets = CookTorrance::new(c, index);
        for (light, eye) in above().flat_map(|light| above().map(move |eye| (light, eye))) {
            if light.y.min(eye.y) > 0.01 {
                let (there, back) =
                    (facets.factor(UP, light, eye) * eye.y, facets.factor(UP, eye, light) * light.y);
                assert!((there - back).abs() < 1e-9, "{light:?} {eye:?}: {there} and {back}");
            }
        }
    }
}

#[test]
fn facets_of_roughness_up_to_a_half_give_back_no_more_than_they_get() {
    for (c, bound) in [(0.2, 0.16), (0.35, 0.49), (0.5, 1.0)] {
        for light in above().step_by(13) {
            // The mean of f / (n.l) n.v over the half of space, twice: its solid angle is 2 pi, white's part pi.
            let sent =
                above().map(|eye| CookTorrance::new(c, 256.0).factor(UP, light, eye) * eye.y / light.y);
            let share = sent.sum::<f64>() / 400.0 * 2.0;
            assert!(share < bound * 1.1, "{c} {light:?}: {share}");
        }
    }
}

#[test]
fn every_model_has_the_factor_of_f64_in_f32_and_in_fixed_point() {
    fn all<S: Scalar>(number: fn(f64) -> S, vectors: [Vec3<f64>; 2]) -> [S; 3] {
        let [n, l, e] = [UP, vectors[0], vectors[1]].map(|v| Vec3::from_array(v.to_array().map(number)));
        let facets = CookTorrance::new(number(0.35), number(200.0));
        [phong([n.dot(l), n.dot(e), l.dot(e)], 50), blinn_phong(n, l, e, 50), facets.factor(n, l, e)]
    }
    for vectors in above().flat_map(|light| above().map(move |eye| [light, eye])) {
        if vectors[1].y < 0.1 {
            continue;
        }
        let exact = all(|x| x, vectors);
        let float = all(|x| x as f32, vectors).map(f64::from);
        let fixed = all(Fixed::new, vectors).map(Fixed::to_f64);
        for i in 0..3 {
            assert!((float[i] - exact[i]).abs() < 1e-4, "{i} {vectors:?}: {} for {}", float[i], exact[i]);
            assert!((fixed[i] - exact[i]).abs() < 3e-4, "{i} {vectors:?}: {} for {}", fixed[i], exact[i]);
        }
    }
}

fn draw(lights: &[Light]) -> (Vec<Rgb>, RayCounts) {
    let scene = Scene::new(&OBJECTS, &MATERIALS, lights);
    let mut workspace = Workspace::<f32, [u8; 2], 0, 2>::new();
    let settings = Settings::new().with_depth(2);
    let mut renderer = Renderer::new(&scene, &camera(), Size::new(96, 64), settings, &mut workspace).unwrap();
    let (mut light, mut counts) = (Vec::new(), RayCounts::default());
    for y in 0..64 {
        renderer.trace_row(y, 0..96, &mut counts, |_, color| light.push(color)).unwrap();
    }
    (light, counts)
}

#[test]
fn a_spot_that_lights_half_of_space_evenly_is_a_point_light() {
    let (place, color) = (v(3.0, 50.0, 4.0), Rgb::gray(0.7));
    let point = draw(&[Light::point(place, color)]);
    assert!(point == draw(&[Light::spot(place, v(0.0, -3.0, 0.0), 0.0, 0, color)]));
    assert!(point != draw(&[Light::spot(place, v(0.0, -3.0, 0.0), 0.0, 4, color)]));
}

#[test]
fn outside_of_its_cone_a_spot_costs_no_shadow_ray() {
    let place = v(0.0, 5.0, 0.0);
    let aside = draw(&[Light::spot(place, v(0.0, 1.0, 0.0), cosine(80.0) as f32, 1, Rgb::WHITE)]);
    assert_eq!(aside.1.shadow, 0);
    assert!(aside.0.iter().all(|light| !light.is_lit()));
    let down =
        |degrees| draw(&[Light::spot(place, v(0.0, -1.0, 0.0), cosine(degrees) as f32, 1, Rgb::WHITE)]);
    let [narrow, wide] = [10.0, 30.0].map(|degrees| down(degrees).1.shadow);
    assert!(0 < narrow && 2 * narrow < wide, "{narrow}, {wide}");
}

#[test]
fn facets_and_cones_out_of_range_are_refused_by_name() {
    let fault = |roughness, index| {
        let facets = Model::CookTorrance(CookTorrance::new(roughness, index));
        Material::matte(Rgb::WHITE).with_model(facets).check().err()
    };
    assert_eq!([fault(1.0, 1.0), fault(1.0 / 64.0, 256.0)], [None, None]);
    for roughness in [0.0, 0.015, 1.01, f32::NAN] {
        assert_eq!(fault(roughness, 1.5), Some(Fault::Roughness));
    }
    for index in [0.99, 256.5, f32::NAN] {
        assert_eq!(fault(0.5, index), Some(Fault::FacetIndex));
    }
    let spot = |axis, cutoff| {
        let lights = [Light::spot(v(0.0, 1.0, 0.0), axis, cutoff, 1, Rgb::WHITE)];
        Scene::new(&OBJECTS, &MATERIALS, &lights).check().err()
    };
    let down = v(0.0, -1.0, 0.0);
    assert_eq!(spot(down, 0.0), None);
    for cutoff in [-0.1, 1.0, f32::NAN] {
        assert_eq!(spot(down, cutoff), Some(SceneError::Light(0, Fault::Cone)));
    }
    assert_eq!(spot(Vec3::ZERO, 0.5), Some(SceneError::Light(0, Fault::NoDirection)));
}

#[test]
fn cosines_of_degrees_are_right_to_the_last_digits() {
    for degrees in 0..=1800 {
        let degrees = f64::from(degrees) / 10.0;
        assert!((cosine(degrees) - degrees.to_radians().cos()).abs() < 4e-16, "{degrees}");
    }
}
