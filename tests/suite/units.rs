//! Scenes in any unit of length make the same picture once their lengths are brought into range.

use embedded_graphics::prelude::Size;
use scanray::math::Units;
use scanray::{
    Camera, Checker, Fixed, Light, Material, Plane, Projection, Renderer, Rgb, SceneBuffer, Settings, Shape,
    Sphere, Texture, Vec3, Workspace,
};

const SIZE: u32 = 40;
/// Is the largest length of the scene below: where its light stands.
const LARGEST: f64 = 6.0;

/// Draws a ball on a chessboard whose lengths are given in a unit that is `unit` times shorter.
fn draw(unit: f64, units: Units) -> Result<Vec<[u8; 2]>, String> {
    let point = |x: f64, y: f64, z: f64| units.point(x * unit, y * unit, z * unit);
    let up = Vec3::from_f64(0.0, 1.0, 0.0);
    let gray = |level: f64| Rgb::gray(Fixed::new(level));
    let mut buffer = SceneBuffer::<Fixed, 2, 2, 1>::new();
    let board = Checker::new(gray(0.8), gray(0.2), units.per_length(1.0 / unit));
    let board = buffer.add_material(Material::textured(Texture::Checker(board))).unwrap();
    let red = buffer.add_material(Material::matte(Rgb::from_f64(0.9, 0.2, 0.1))).unwrap();
    buffer.add_object(Shape::Plane(Plane::new(point(0.0, 0.0, 0.0), up)), board).unwrap();
    let ball = Sphere::new(point(0.0, 1.0, 0.0), units.length(unit));
    buffer.add_object(Shape::Sphere(ball), red).unwrap();
    buffer.add_light(Light::point(point(3.0, LARGEST, 3.0), gray(1.0))).unwrap();
    let eyes = [point(0.0, 1.5, 5.0), point(0.0, 1.0, 0.0), up];
    let fovy = Fixed::new(45.0);
    let depths = [units.length(0.0), units.length(50.0 * unit)];
    let camera = Camera::new(eyes, Projection::Perspective { fovy }, depths);
    let mut workspace = Workspace::<Fixed, [u8; 2], 0, 1>::new();
    let size = Size::new(SIZE, SIZE);
    let mut renderer = Renderer::new(&buffer.scene(), &camera, size, Settings::new(), &mut workspace)
        .map_err(|error| error.to_string())?;
    let mut picture = vec![[0; 2]; (SIZE * SIZE) as usize];
    for (y, row) in (0..).zip(picture.chunks_mut(SIZE as usize)) {
        renderer.render_row(y, row).unwrap();
    }
    Ok(picture)
}

fn differing(one: &[[u8; 2]], other: &[[u8; 2]]) -> usize {
    one.iter().zip(other).filter(|(a, b)| a != b).count()
}

#[test]
fn metres_millimetres_and_light_years_make_the_same_picture() {
    let metres = draw(1.0, Units::for_largest(LARGEST)).unwrap();
    for unit in [4096.0, 1.0 / 4096.0, 1.0 / 1_073_741_824.0] {
        assert_eq!(draw(unit, Units::for_largest(LARGEST * unit)).unwrap(), metres, "{unit}");
    }
    // A unit that is no power of two is rounded otherwise: a few pixels in edges and in dithering.
    let millimetres = draw(1000.0, Units::for_largest(LARGEST * 1000.0)).unwrap();
    let moved = differing(&millimetres, &metres);
    assert!((1..SIZE as usize).contains(&moved), "{moved} pixels");
}

#[test]
fn without_units_large_scenes_are_refused_and_small_ones_lose_their_digits() {
    let plain = Units::for_largest(0.0);
    assert_eq!(plain.scale(), 1.0);
    let refused = draw(4096.0, plain).unwrap_err();
    assert!(refused.contains("too large"), "{refused}");
    let metres = draw(1.0, Units::for_largest(LARGEST)).unwrap();
    let tiny = draw(1.0 / 65_536.0, plain);
    assert!(tiny.is_err() || differing(&tiny.unwrap(), &metres) > (SIZE * SIZE / 10) as usize);
}
