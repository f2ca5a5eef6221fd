use super::random::Random;
use crate::bake::Bounds;
use crate::rounded::Rounded;
use scanray::{Shape, Sphere, Triangle, Vec3};

/// Names the crowds of things that hierarchies are measured on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crowd {
    /// Triangles of a ball with bumps, finer and finer.
    Triangles,
    /// Balls strewn in a cube, smaller and smaller: a ray through the cube meets about one, however many
    /// there are.
    Balls,
}

/// Is a thing of a crowd, about 1 from the origin at most along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thing {
    /// A triangle's corners.
    Triangle([[f64; 3]; 3]),
    /// A ball's middle and its radius.
    Ball([f64; 3], f64),
}

impl Thing {
    /// Answers it in a number.
    pub fn shape<S: Rounded>(&self) -> Shape<S> {
        let point = |place: [f64; 3]| Vec3::from_array(place.map(S::round));
        match *self {
            Self::Triangle([a, b, c]) => Shape::Triangle(Triangle::new(point(a), point(b), point(c))),
            Self::Ball(center, radius) => Shape::Sphere(Sphere::new(point(center), S::round(radius))),
        }
    }

    /// Answers the box around it.
    pub fn bounds(&self) -> Bounds {
        match *self {
            Self::Triangle(corners) => Bounds::around(corners),
            Self::Ball(center, radius) => {
                Bounds { low: center.map(|c| c - radius), high: center.map(|c| c + radius) }
            }
        }
    }
}

impl Crowd {
    /// Lists all.
    pub const ALL: [Self; 2] = [Self::Triangles, Self::Balls];

    /// Answers what it is of.
    pub fn name(self) -> &'static str {
        match self {
            Self::Triangles => "triangles of a bumpy ball",
            Self::Balls => "balls in a cube",
        }
    }

    /// Answers crowds from the smallest to the largest, each about four to ten times the last.
    pub fn sizes(self) -> Vec<Vec<Thing>> {
        match self {
            Self::Triangles => [1, 2, 4, 8, 16, 32, 57].map(bumpy_ball).to_vec(),
            Self::Balls => [1, 10, 100, 1000, 10_000, 100_000].map(strewn_balls).to_vec(),
        }
    }
}

fn strewn_balls(count: u32) -> Vec<Thing> {
    let mut random = Random::new();
    let radius = 1.0 / f64::from(count).sqrt();
    (0..count).map(|_| Thing::Ball(random.point(), radius)).collect()
}

/// Answers a ball of 20 `frequency`^2 triangles: each face of an icosahedron is cut into `frequency`^2.
fn bumpy_ball(frequency: u32) -> Vec<Thing> {
    let places = corners_of_icosahedron();
    let step = 1.0 / f64::from(frequency);
    let triangle = |face: [usize; 3], at: [[u32; 2]; 3]| {
        Thing::Triangle(at.map(|[i, j]| {
            let [along, up] = [i, j].map(|n| f64::from(n) * step);
            let [a, b, c] = face.map(|corner| places[corner]);
            bumpy(std::array::from_fn(|k| a[k] + along * (b[k] - a[k]) + up * (c[k] - a[k])))
        }))
    };
    let mut triangles = vec![];
    for face in FACES {
        for (i, j) in (0..frequency).flat_map(|j| (0..frequency - j).map(move |i| (i, j))) {
            triangles.push(triangle(face, [[i, j], [i + 1, j], [i, j + 1]]));
            if i + j + 1 < frequency {
                triangles.push(triangle(face, [[i + 1, j], [i + 1, j + 1], [i, j + 1]]));
            }
        }
    }
    triangles
}

/// Moves a point to where the ball's surface is in its direction, from 0.85 to 1.
fn bumpy(point: [f64; 3]) -> [f64; 3] {
    let length = point.iter().map(|c| c * c).sum::<f64>().sqrt();
    let direction = point.map(|c| c / length);
    let waves: f64 =
        direction.iter().zip([0.0, 1.0, 2.0]).map(|(c, phase)| (7.0 * c + phase).sin()).product();
    direction.map(|c| c * (0.925 + 0.075 * waves))
}

fn corners_of_icosahedron() -> [[f64; 3]; 12] {
    let golden = 0.5 * (1.0 + 5_f64.sqrt());
    std::array::from_fn(|corner| {
        let sign = |bit: usize| if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
        let flat = [0.0, sign(0), golden * sign(1)];
        std::array::from_fn(|axis| flat[(axis + 3 - corner / 4) % 3])
    })
}

/// Names the corners of each face, anticlockwise as seen from outside.
#[rustfmt::skip]
const FACES: [[usize; 3]; 20] = [
    [0, 4, 1], [0, 1, 6], [0, 8, 4], [0, 6, 9], [0, 9, 8],
    [1, 4, 10], [1, 11, 6], [1, 10, 11], [2, 3, 5], [2, 7, 3],
    [2, 5, 8], [2, 9, 7], [2, 8, 9], [3, 10, 5], [3, 7, 11],
    [3, 11, 10], [4, 8, 5], [4, 5, 10], [6, 7, 9], [6, 11, 7],
];
