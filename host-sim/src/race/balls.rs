//! The scene `balls` of the Standard Procedural Databases (E. Haines, *A Proposal for Standard Graphics
//! Environments*, IEEE Computer Graphics and Applications 7(11), 1987): the "sphereflake" of 91 balls.

use crate::scenes::HostNumber;
use scanray::gallery::View;
use scanray::{
    Camera, Light, Material, Object, Rgb, Scene, Settings, Shape, Sky, Sphere, Transfer, Triangle, Vec3,
};

/// Is how often balls sit on balls; 1 + 9 + 81 of them.
const GENERATIONS: u32 = 2;

/// Is the way a ball and its children go.
#[derive(Clone, Copy)]
struct Ball {
    center: Vec3<f64>,
    radius: f64,
    /// From the parent, unit length.
    outward: Vec3<f64>,
}

/// Makes the scene; it stays in memory as long as the program runs.
pub fn balls<S: HostNumber>() -> View<S> {
    let point = |p: Vec3<f64>| Vec3::from_array(p.to_array().map(S::round));
    let rgb = |r, g, b| Rgb::new(S::round(r), S::round(g), S::round(b));
    let spheres = flake()
        .into_iter()
        .map(|ball| Object::new(Shape::Sphere(Sphere::new(point(ball.center), S::round(ball.radius))), 1));
    let [a, b, c, d] = [[12.0, 12.0], [-12.0, 12.0], [-12.0, -12.0], [12.0, -12.0]]
        .map(|[x, y]| point(Vec3::new(x, y, -0.5)));
    let floor = [[a, b, c], [a, c, d]];
    let floor = floor.map(|[a, b, c]| Object::new(Shape::Triangle(Triangle::new(a, b, c)), 0));
    // Colours are those of the database times its share of diffuse light; a shininess of 3.0827 is 3.
    let yellow = Material::matte(rgb(1.0 * 0.8, 0.75 * 0.8, 0.33 * 0.8));
    let half = S::round(0.5);
    let bronze = Material::matte(rgb(1.0 * 0.5, 0.9 * 0.5, 0.7 * 0.5)).with_specular(Rgb::gray(half), 3);
    // Three lights that are together as bright as the database asks for: 1 / sqrt(3) each.
    let white = S::round(3_f64.sqrt().recip());
    let lamp = |[x, y, z]: [f64; 3]| Light::point(point(Vec3::new(x, y, z)), Rgb::gray(white));
    let scene = Scene::new(
        Vec::leak(floor.into_iter().chain(spheres).collect()),
        Vec::leak(vec![yellow, bronze.with_mirror(half)]),
        Vec::leak([[4.0, 3.0, 2.0], [1.0, -4.0, 4.0], [-3.0, 1.0, 5.0]].map(lamp).to_vec()),
    );
    let (eye, up) = (Vec3::new(2.1, 1.3, 1.7), Vec3::new(0.0, 0.0, 1.0));
    View {
        name: "balls",
        about: "91 balls on balls, the sphereflake of E. Haines's Standard Procedural Databases",
        scene: scene.with_sky(Sky::Solid(rgb(0.078, 0.361, 0.753))),
        camera: Camera::perspective(point(eye), Vec3::ZERO, point(up), S::round(45.0)),
        settings: Settings::new().with_depth(5).with_transfer(Transfer::Linear),
        size: [320, 240],
    }
}

/// Lists the balls, parents before their children.
fn flake() -> Vec<Ball> {
    let mut all = vec![Ball { center: Vec3::ZERO, radius: 0.5, outward: Vec3::new(0.0, 0.0, 1.0) }];
    let mut parents = 0..1;
    for _ in 0..GENERATIONS {
        let children: Vec<Ball> = all[parents.clone()].iter().flat_map(Ball::children).collect();
        parents = all.len()..all.len() + children.len();
        all.extend(children);
    }
    all
}

impl Ball {
    /// Answers the nine balls of a third of the size that sit on this one: six around its equator, three
    /// on the side that looks away from its parent.
    fn children(&self) -> [Ball; 9] {
        std::array::from_fn(|number| {
            let equator = number < 6;
            let degrees = if equator { 15 + 60 * number } else { 45 + 120 * number };
            let height = if equator { 0.0 } else { (2.0_f64 / 3.0).sqrt() };
            let (sine, cosine) = (degrees as f64).to_radians().sin_cos();
            let across = (1.0 - height * height).sqrt();
            let outward = self.turn(Vec3::new(across * cosine, across * sine, height));
            let radius = self.radius / 3.0;
            Ball { center: self.center + outward * (self.radius + radius), radius, outward }
        })
    }

    /// Turns a direction the shortest way that takes z to where this ball looks.
    fn turn(&self, v: Vec3<f64>) -> Vec3<f64> {
        let pole = Vec3::new(0.0, 0.0, 1.0);
        // Two reflections: at the plane across both directions' sum, and back along the new pole.
        let between = pole + self.outward;
        v - between * (between.dot(v) / (1.0 + self.outward.z)) + self.outward * (2.0 * v.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_balls_are_those_of_the_database() {
        let flake = flake();
        assert_eq!(flake.len(), 91);
        // Lines of the file that the database's own program writes.
        let published = [
            [0.272166, 0.272166, 0.544331, 0.166667],
            [0.420314, 0.420314, 0.618405, 0.0555556],
            [0.461844, 0.304709, 0.43322, 0.0555556],
            [0.643951, 0.172546, 0.0, 0.166667],
            [0.802608, 0.281471, -0.111111, 0.0555556],
            [-0.191247, 0.166275, 0.655442, 0.0555556],
            [0.335322, -0.607487, -0.111111, 0.0555556],
            [0.471405, -0.471405, -0.222222, 0.0555556],
        ];
        for [x, y, z, radius] in published {
            let place = Vec3::new(x, y, z);
            let found = flake
                .iter()
                .any(|ball| (ball.center - place).length() < 2e-6 && (ball.radius - radius).abs() < 1e-6);
            assert!(found, "no ball at {x} {y} {z}");
        }
    }

    #[test]
    fn children_touch_their_parent_and_no_balls_overlap() {
        let flake = flake();
        for (i, a) in flake.iter().enumerate() {
            for b in &flake[..i] {
                assert!((a.center - b.center).length() > a.radius + b.radius - 1e-9);
            }
        }
    }
}
