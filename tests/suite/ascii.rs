//! Pictures small enough to read.

use crate::support::{ball, v};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use scanray::{
    Camera, Cuboid, Dither, Material, Object, Renderer, Rgb, Scene, Settings, Shape, Triangle, Workspace,
};

fn draw(objects: &[Object]) -> MockDisplay<BinaryColor> {
    let materials = [Material::flat(Rgb::WHITE)];
    let scene = Scene::new(objects, &materials, &[]);
    let camera = Camera::orthographic(v(0.0, 0.0, 10.0), v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0), 8.0);
    let settings = Settings::new().with_dither(Dither::None);
    let mut workspace = Workspace::<f32, BinaryColor, 16, 1>::new();
    let mut display = MockDisplay::new();
    Renderer::new(&scene, &camera, Size::new(16, 8), settings, &mut workspace)
        .unwrap()
        .draw(&mut display)
        .unwrap();
    display
}

#[test]
fn a_ball_is_round() {
    draw(&[ball(0.0, 0.0, 0.0, 3.0, 0)]).assert_pattern(&[
        "................",
        "......####......",
        ".....######.....",
        ".....######.....",
        ".....######.....",
        ".....######.....",
        "......####......",
        "................",
    ]);
}

#[test]
fn a_box_stands_where_its_corners_are_left_right_up_and_down() {
    draw(&[Object::new(Shape::Cuboid(Cuboid::new(v(-7.0, 1.0, 0.0), v(-2.0, 3.0, 1.0))), 0)]).assert_pattern(
        &[
            "................",
            ".#####..........",
            ".#####..........",
            "................",
            "................",
            "................",
            "................",
            "................",
        ],
    );
}

#[test]
fn a_triangle_has_its_three_corners() {
    let corners = Triangle::new(v(-8.0, -4.0, 0.0), v(8.0, -4.0, 0.0), v(8.0, 4.0, 0.0));
    draw(&[Object::new(Shape::Triangle(corners), 0)]).assert_pattern(&[
        "...............#",
        ".............###",
        "...........#####",
        ".........#######",
        ".......#########",
        ".....###########",
        "...#############",
        ".###############",
    ]);
}
