//! Where a scene is seen from.

use super::number::{Maker, Triple, number, triple};
use proptest::prelude::*;
use scanray::{Camera, Projection, Scalar};

#[derive(Clone, Debug)]
enum Window {
    Perspective(f64),
    Frustum([f64; 4]),
    Orthographic(f64),
}

#[derive(Clone, Debug)]
pub struct Lens {
    points: [Triple; 3],
    window: Window,
    clip: [f64; 2],
}

fn window() -> impl Strategy<Value = Window> {
    let edge = || number(0.25, 1.0);
    let edges = [edge(), edge(), edge(), edge()].prop_map(|[l, r, b, t]| [-l, r, -b, t + 0.5]);
    prop_oneof![
        number(20.0, 90.0).prop_map(Window::Perspective),
        edges.prop_map(Window::Frustum),
        number(3.0, 9.0).prop_map(Window::Orthographic),
    ]
}

pub fn lens() -> impl Strategy<Value = Lens> {
    // Somewhere around the things, not among them, whichever way up.
    let eye = (triple(-2.0, 2.0), 0..3_usize, prop::bool::ANY).prop_map(|(mut eye, axis, other)| {
        eye[axis] += if other { 7.0 } else { -7.0 };
        eye
    });
    let points = (eye, triple(-1.0, 1.0), triple(-1.0, 1.0)).prop_map(|(eye, center, up)| [eye, center, up]);
    let clip = (number(0.5, 6.0), number(8.0, 100.0)).prop_map(|(near, far)| [near, far]);
    (points, window(), clip).prop_map(|(points, window, clip)| Lens { points, window, clip })
}

impl Lens {
    /// Sees all before it: where a near plane cuts glass open, nothing says what light has come through.
    pub fn without_near_plane(mut self) -> Self {
        self.clip[0] = 0.0;
        self
    }
}

impl<S: Scalar> Maker<S> {
    pub fn camera(&self, lens: &Lens) -> Camera<S> {
        let projection = match lens.window {
            Window::Perspective(fovy) => Projection::Perspective { fovy: self.0(fovy) },
            Window::Frustum(edges) => {
                let [left, right, bottom, top] = edges.map(self.0);
                Projection::Frustum { left, right, bottom, top }
            }
            Window::Orthographic(height) => Projection::Orthographic { height: self.0(height) },
        };
        Camera::new(lens.points.map(|p| self.vector(p)), projection, lens.clip.map(self.0))
    }
}
