use crate::camera::Frame;
use crate::math::{Scalar, Vec3};
use crate::scene::Scene;
use crate::shape::Intersect;
use heapless::Vec;

/// Is how many objects a row names one by one.
const ROOM: usize = 32;

/// Names the objects that the rays of one row can meet: none that they meet is missing.
///
/// All rays of a row lie in a plane. An object whose box does not reach that plane, or lies
/// wholly behind the eye, is left out. What no longer fits the list is taken in unseen: the rest
/// of the objects from `rest` on.
#[derive(Clone, Debug, Default)]
pub struct Candidates {
    near: Vec<u16, ROOM>,
    rest: u16,
    total: u16,
}

impl Candidates {
    /// Makes an empty list.
    pub const fn new() -> Self {
        Self { near: Vec::new(), rest: 0, total: 0 }
    }

    /// Finds the objects that row `y` can touch.
    pub fn find<S: Scalar, X: Intersect<S>>(&mut self, scene: &Scene<'_, S, X>, frame: &Frame<S>, y: u32) {
        self.near.clear();
        self.total = u16::try_from(scene.objects.len()).unwrap_or(u16::MAX);
        let normal = frame.row_normal(y);
        let point = frame.row_point(y);
        self.rest = 0;
        for object in scene.objects {
            let touches = normal.is_none_or(|normal| touches(&object.shape, frame, point, normal));
            if touches && self.near.push(self.rest).is_err() {
                return;
            }
            self.rest = self.rest.saturating_add(1);
        }
        self.rest = self.total;
    }

    /// Answers the objects' places in the scene's list, in rising order.
    pub fn iter(&self) -> impl Iterator<Item = u16> + '_ {
        self.near.iter().copied().chain(self.rest..self.total)
    }
}

fn touches<S: Scalar>(shape: &impl Intersect<S>, frame: &Frame<S>, point: Vec3<S>, normal: Vec3<S>) -> bool {
    let Some(bounds) = shape.bounds() else { return true };
    let from_plane = bounds.center - point;
    // 1/1024 of the distance outweighs the rounding of the normal and of the rays.
    let [x, y, z] = (from_plane + bounds.half).to_array().map(S::abs);
    let slack = (x + y + z + S::ONE) * S::recip(S::from_i32(1024));
    let depth = (bounds.center - frame.eye).dot(frame.forward);
    from_plane.dot(normal).abs() <= bounds.reach(normal) + slack
        && depth + bounds.reach(frame.forward) + slack > S::ZERO
}
