//! Smooth triangles are lit as the curved surface that their normals stand for, in every number.

use crate::kit::{Kit, ahead, scattered, scattered_point};
use scanray::gallery::{Gallery, double, fixed, float};
use scanray::math::Scalar;
use scanray::ray::{Interval, Ray};
use scanray::trace::{Candidates, Packet, Tracer};
use scanray::{
    Intersect, Light, Material, Object, Rgb, Scene, Shape, SmoothTriangle, Triangle, Vec3, Vertex, Vertices,
};

in_every_number! {
    with_the_normal_of_its_plane_it_is_the_triangle,
    normals_and_texture_coordinates_are_mixed_between_the_corners,
    no_viewer_sees_a_normal_that_looks_away,
    light_from_behind_does_not_shine_through,
    colours_are_mixed_between_the_corners_and_end_at_the_edges,
}

#[test]
fn a_smooth_ball_is_lit_wherever_its_normals_face_the_light_without_a_speck() {
    checks::is_lit_by_its_normals(&float::SMOOTH.scene, |x| x as f32, f64::from);
    checks::is_lit_by_its_normals(&fixed::SMOOTH.scene, scanray::Fixed::new, scanray::Fixed::to_f64);
    checks::is_lit_by_its_normals(&double::SMOOTH.scene, |x| x, |x| x);
}

mod checks {
    use super::*;

    const CORNERS: [[f64; 3]; 3] = [[-1.0, -0.5, 0.25], [1.0, -0.75, 0.0], [0.25, 1.0, -0.5]];

    fn unit(v: [f64; 3]) -> [f64; 3] {
        v.map(|c| c / v.iter().map(|c| c * c).sum::<f64>().sqrt())
    }

    /// Answers the triangle of `CORNERS`, and it with normals tilted toward the middle by so much.
    fn pair<S: Scalar>(kit: &Kit<S>, tilt: f64) -> (Triangle<S>, SmoothTriangle<S>) {
        let [a, b, c] = CORNERS.map(|corner| kit.at(corner));
        let flat = Triangle::new(a, b, c);
        let ([x, y, z], [p, q, r]) = (
            [0, 1, 2].map(|i| CORNERS[1][i] - CORNERS[0][i]),
            [0, 1, 2].map(|i| CORNERS[2][i] - CORNERS[0][i]),
        );
        let normal = unit([y * r - z * q, z * p - x * r, x * q - y * p]);
        let vertices = CORNERS.map(|corner| {
            let tilted = unit([0, 1, 2].map(|i| normal[i] - tilt * corner[i]));
            let texture = [corner[0], 3.0 * corner[1]].map(kit.0);
            Vertex::new(kit.at(corner), kit.at(tilted), texture)
        });
        let smooth = SmoothTriangle::new(Box::leak(Box::new(vertices)));
        assert_eq!(smooth.check(), Ok(()), "tilted by {tilt}");
        (flat, smooth)
    }

    /// Answers rays from all around at the triangle, of which about a third meets it.
    fn rays<S: Scalar>(kit: &Kit<S>) -> impl Iterator<Item = Ray<S>> {
        let toward = |i| scattered_point(i, true).map(|c| 0.7 * c);
        (0..10_000).map(move |i| kit.ray_at(scattered_point(i, false).map(|c| c + c.signum()), toward(i)))
    }

    pub fn with_the_normal_of_its_plane_it_is_the_triangle<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let (flat, smooth) = pair(&kit, 0.0);
        let mut met = 0;
        for ray in rays(&kit) {
            let hit = flat.intersect(&ray, &ahead());
            assert_eq!(smooth.intersect(&ray, &ahead()), hit);
            let Some(hit) = hit else { continue };
            met += 1;
            let [one, other] = [flat.surface(&ray, &hit), smooth.surface(&ray, &hit)];
            // An edge-on view bends the normal even of a plane, by 2^-13.
            let bent = read((one.normal - other.normal).length());
            assert!(bent < 2e-4, "bent by {bent}");
            let apart = read((one.point - other.point).length());
            assert!((apart - 2.0 / 8192.0).abs() < 1e-5, "put {apart} off");
            // On the side it was seen from.
            assert!(read((other.point - one.point).dot(ray.direction)) < 1e-6);
            kit.assert_near(Some(read(other.u)), read(one.point.x));
            kit.assert_near(Some(read(other.v)), 3.0 * read(one.point.y));
        }
        assert!(met > 1000, "{met}");
    }

    pub fn normals_and_texture_coordinates_are_mixed_between_the_corners<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let slanted = unit([1.0, 0.0, 2.0]);
        let vertex =
            |point, normal, texture: [f64; 2]| Vertex::new(kit.at(point), kit.at(normal), texture.map(make));
        let vertices = [
            vertex([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 2.0]),
            vertex([4.0, 0.0, 0.0], slanted, [1.0, 4.0]),
            vertex([0.0, 4.0, 0.0], [0.0, 0.0, 1.0], [0.0, 6.0]),
        ];
        let smooth = SmoothTriangle::new(Box::leak(Box::new(vertices)));
        for side in [9.0, -9.0] {
            let ray = kit.ray([2.0, 0.0, side], [0.0, 0.0, -side]);
            let surface = smooth.surface(&ray, &smooth.intersect(&ray, &ahead()).expect("half way"));
            kit.assert_near(Some(read(surface.u)), 0.5);
            kit.assert_near(Some(read(surface.v)), 3.0);
            let middle = unit([slanted[0], 0.0, slanted[2] + 1.0]);
            kit.assert_vector(surface.normal, middle);
        }
    }

    pub fn no_viewer_sees_a_normal_that_looks_away<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        for tilt in [-2.0, -0.3, 0.3, 0.9] {
            let (flat, smooth) = pair(&kit, tilt);
            for ray in rays(&kit) {
                let Some(hit) = smooth.intersect(&ray, &ahead()) else { continue };
                let front = read(flat.surface(&ray, &hit).normal.dot(ray.direction)) <= 0.0;
                let normal = smooth.surface(&ray, &hit).normal;
                assert_eq!(normal.dot(ray.direction) <= S::ZERO, front, "tilted by {tilt}: {ray:?}");
                assert!((read(normal.length()) - 1.0).abs() < 1e-5);
            }
        }
    }

    pub fn light_from_behind_does_not_shine_through<S: Scalar>(make: fn(f64) -> S, read: fn(S) -> f64) {
        let kit = Kit(make, read);
        // Hollow: its normals lean toward the middle, and near a corner face lights behind the plane.
        let (flat, smooth) = pair(&kit, 0.9);
        let materials = [Material::matte(Rgb::WHITE)];
        let eye = [0.5, 0.25, 6.0];
        let mut facing = 0;
        for i in 0..2000 {
            let target = [0, 1, 2].map(|axis| {
                let (u, v) = (0.5 + scattered(i, 0), 0.5 + scattered(i, 1));
                let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                let [a, b, c] = CORNERS.map(|corner| corner[axis]);
                let (u, v) = (0.02 + 0.94 * u, 0.02 + 0.94 * v);
                a + (b - a) * u + (c - a) * v
            });
            let ray = kit.ray_at(eye, target);
            let surface = smooth.surface(&ray, &smooth.intersect(&ray, &ahead()).expect("aimed at it"));
            let toward = kit.at(unit(scattered_point(i, true)));
            let behind =
                read(flat.surface(&ray, &flat.intersect(&ray, &ahead()).expect("it too")).normal.dot(toward))
                    < -0.05;
            if !behind || read(surface.normal.dot(toward)) < 0.0 {
                continue;
            }
            facing += 1;
            let objects = [Object::new(Shape::SmoothTriangle(smooth), 0)];
            let lights = [Light::directional(toward, Rgb::WHITE)];
            let scene: Scene<'_, S> = Scene::new(&objects, &materials, &lights);
            let (mut packet, rays) = (Packet::new(), std::iter::once((ray, Interval::AHEAD)));
            let light =
                Tracer::new(&scene, &mut []).radiance(&mut packet, rays, Candidates::all(&scene), &mut ())[0];
            assert_eq!(light, Rgb::BLACK, "ray {i}");
        }
        assert!(facing > 50, "{facing}");
    }

    pub fn colours_are_mixed_between_the_corners_and_end_at_the_edges<S: Scalar>(
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let pure = |r: f64, g: f64, b: f64| Rgb::new(make(r), make(g), make(b));
        let colors = Vertices::new(pure(1.0, 0.0, 0.0), pure(0.0, 1.0, 0.0), pure(0.0, 0.0, 1.0));
        let at = |u: f64, v: f64| {
            let Rgb { r, g, b } = colors.color(make(u), make(v));
            [r, g, b].map(read)
        };
        assert_eq!(at(0.0, 0.0), [1.0, 0.0, 0.0]);
        assert_eq!(at(0.25, 0.5), [0.25, 0.25, 0.5]);
        assert_eq!(at(-0.25, 1.5), [0.0, 0.0, 1.0]);
        assert_eq!(at(1.0, 0.25), [0.0, 1.0, 0.0]);
    }

    /// Demands of the smooth solid in the gallery that light falls where its normals face the light, though
    /// its flat faces turn away from it there, and that nothing of the solid stands before it.
    pub fn is_lit_by_its_normals<S: Scalar + Gallery>(
        scene: &Scene<'_, S>,
        make: fn(f64) -> S,
        read: fn(S) -> f64,
    ) {
        let kit = Kit(make, read);
        let solid = scene.objects.iter().filter(|o| matches!(o.shape, Shape::SmoothTriangle(_)));
        let solid: Vec<Shape<S>> = solid.map(|object| object.shape).collect();
        let mut turned = 0;
        for i in 0..3000 {
            let [x, y, z] = unit(scattered_point(i, false));
            let middle = [1.15, 0.7946545, 0.0];
            let ray = kit.ray_at([middle[0] + 4.0 * x, middle[1] + 4.0 * y, middle[2] + 4.0 * z], middle);
            let hits =
                solid.iter().enumerate().filter_map(|(j, shape)| Some((j, shape.intersect(&ray, &ahead())?)));
            let (own, hit) = hits.min_by(|(_, a), (_, b)| read(a.t).total_cmp(&read(b.t))).expect("a hit");
            let surface = solid[own].surface(&ray, &hit);
            let toward: Vec3<S> = kit.at(unit(scattered_point(i, true)));
            if read(surface.normal.dot(toward)) < 1e-3 {
                continue;
            }
            let Shape::SmoothTriangle(triangle) = solid[own] else { unreachable!() };
            let [a, b, c] = triangle.vertices.each_ref().map(|vertex| vertex.point);
            let flat = Triangle::new(a, b, c).surface(&ray, &hit).normal;
            turned += usize::from(read(flat.dot(toward)) < 0.0);
            let light = Ray::new(surface.point, toward);
            let blocked = solid.iter().enumerate().any(|(j, shape)| {
                let crossing = if j == own {
                    shape.intersect_leaving(&light, &ahead())
                } else {
                    shape.intersect(&light, &ahead())
                };
                crossing.is_some()
            });
            assert!(!blocked, "a speck at {:?} in light from {toward:?}", surface.point);
        }
        assert!(turned > 20, "{turned}");
    }
}
