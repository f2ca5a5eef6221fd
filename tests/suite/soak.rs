//! Pictures that are drawn again and again stay the same: nothing that a picture leaves behind shows in the next.

use embedded_graphics::prelude::Size;
use scanray::gallery::{Gallery, View};
use scanray::*;

/// Counts the pictures of a turn.
const STEPS: u16 = 12;

const SIZE: Size = Size::new(16, 12);

/// Draws a turn of the camera with one workspace, picture by picture.
fn turn<S: Scalar, Q: Quality>(
    view: &View<S>,
    settings: Settings<S, Q>,
    space: &mut Workspace<S, [u8; 2], 0, 5>,
    first: u32,
) -> Vec<[u8; 2]> {
    let mut pixels = vec![[0; 2]; (SIZE.width * SIZE.height * u32::from(STEPS)) as usize];
    for (step, picture) in (first..).zip(pixels.chunks_mut((SIZE.width * SIZE.height) as usize)) {
        let camera = view.camera.turned(step, STEPS);
        let mut renderer = Renderer::new(&view.scene, &camera, SIZE, settings, space).expect("a good view");
        for (y, row) in (0..).zip(picture.chunks_mut(SIZE.width as usize)) {
            renderer.render_row(y, row).expect("a row of the picture");
        }
    }
    pixels
}

/// Turns so often, and goes on counting steps from turn to turn as firmware does.
fn soak<S: Gallery>(turns: u32, quality: impl Quality) {
    let view = S::find("three-spheres").expect("a scene of the gallery");
    let (mut space, settings) = (Workspace::new(), view.settings.with_quality(quality));
    let begun = turn(view, settings, &mut space, 0);
    for number in 1..=turns {
        let now = turn(view, settings, &mut space, number * u32::from(STEPS));
        assert!(now == begun, "turn {number} is another than the first");
    }
}

/// Answers the number of turns: `SCANRAY_SOAK_TURNS`, or so many that the test takes seconds.
fn turns() -> u32 {
    std::env::var("SCANRAY_SOAK_TURNS").map_or(1000, |turns| turns.parse().expect("a number of turns"))
}

#[test]
fn a_thousand_turns_end_with_the_picture_they_began_with_in_f32() {
    soak::<f32>(turns(), Exact);
}

#[test]
fn a_thousand_turns_end_with_the_picture_they_began_with_in_fixed_point() {
    soak::<Fixed>(turns(), Exact);
}

#[test]
fn turns_of_adaptive_rows_end_with_the_picture_they_began_with() {
    soak::<f32>(turns() / 2, Adaptive);
    soak::<Fixed>(turns() / 2, Adaptive);
}

/// Pictures in between, of other scenes and sizes, must not show in those that follow.
#[test]
fn a_workspace_that_drew_the_whole_gallery_draws_as_a_new_one_does() {
    fn check<S: Gallery>(quality: impl Quality) {
        let mut used = Workspace::new();
        for view in S::views().iter().chain(S::views().iter().rev()) {
            let settings = view.settings.with_quality(quality);
            let fresh = turn(view, settings, &mut Workspace::new(), 0);
            assert!(turn(view, settings, &mut used, 0) == fresh, "{}", view.name);
        }
    }
    check::<f32>(Exact);
    check::<Fixed>(Adaptive);
}

/// A renderer remembers what stands near a lit point: of the picture before, that would be wrong.
#[test]
fn what_comes_into_a_scene_between_two_pictures_casts_its_shadow() {
    let v = Vec3::<f32>::new;
    let floor = Object::new(Shape::Plane(Plane::new(Vec3::ZERO, v(0.0, 1.0, 0.0))), 0);
    let ball = Object::new(Shape::Sphere(Sphere::new(v(0.0, 3.0, 0.0), 1.0)), 0);
    let (materials, lights) = ([Material::matte(Rgb::WHITE)], [Light::point(v(0.0, 9.0, 0.0), Rgb::WHITE)]);
    // Looks at the point of the floor that the ball stands above.
    let camera = Camera::perspective(v(0.0, 1.0, 4.0), Vec3::ZERO, v(0.0, 1.0, 0.0), 2.0);
    let mut space = Workspace::<f32, [u8; 2], 0, 0>::new();
    let mut is_lit = |objects: &[Object]| {
        let (scene, settings) = (Scene::new(objects, &materials, &lights), Settings::new().with_depth(0));
        let mut row = [[0; 2]; 2];
        let mut renderer = Renderer::new(&scene, &camera, Size::new(2, 1), settings, &mut space).unwrap();
        renderer.render_row(0, &mut row).unwrap();
        row != [[0; 2]; 2]
    };
    assert_eq!([is_lit(&[floor]), is_lit(&[floor, ball]), is_lit(&[floor])], [true, false, true]);
}
