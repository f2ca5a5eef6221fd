//! The gallery is whole in every number.

use scanray::Fixed;
use scanray::gallery::{Gallery, View, double, fixed, float};
use scanray::math::Scalar;

fn names<S: Gallery>() -> Vec<&'static str> {
    S::views().iter().map(|view| view.name).collect()
}

fn check<S: Gallery>() {
    for view in S::views() {
        assert_eq!(view.scene.check(), Ok(()), "{}", view.name);
        let [columns, rows] = view.size;
        assert!(view.camera.frame(columns, rows).is_ok(), "{}", view.name);
        assert!(S::find(view.name).is_some_and(|found| found.about == view.about));
    }
}

#[test]
fn every_number_has_the_same_scenes_and_all_can_be_drawn() {
    assert_eq!(names::<f32>(), names::<Fixed>());
    assert_eq!(names::<f32>(), names::<f64>());
    let mut unique = names::<f32>();
    unique.sort_unstable();
    unique.dedup();
    assert_eq!(unique.len(), f32::views().len());
    check::<f32>();
    check::<Fixed>();
    check::<f64>();
}

#[test]
fn the_numbers_hold_the_same_scene_to_their_last_digit() {
    fn radius<S: Scalar>(view: &View<S>) -> S {
        match view.scene.objects[0].shape {
            scanray::Shape::Sphere(ball) => ball.radius,
            other => panic!("{other:?} is not the ball"),
        }
    }
    assert_eq!(radius(&double::C_RAY), 0.7);
    assert_eq!(radius(&float::C_RAY), 0.7);
    assert!((radius(&fixed::C_RAY).to_f64() - 0.7).abs() < 5e-7);
}

#[test]
fn a_scene_that_is_not_in_the_gallery_is_not_found() {
    assert!(f32::find("kettle").is_none());
}
