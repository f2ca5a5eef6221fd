use super::description::{Group, Object, Shape};
use super::roots::Ray;
use super::vector::Vector;

/// Is how many triangles of a mesh are passed together.
const MOST: usize = 32;

/// Groups the triangles of meshes, and leaves all else alone.
pub(super) fn groups(objects: &[Object]) -> Vec<Group> {
    let mut groups: Vec<Group> = vec![];
    let mut first = 0;
    for object in objects.chunk_by(|a, b| a.number == b.number) {
        for members in object.chunks(MOST) {
            groups.push(Group { members: first..first + members.len(), ball: ball(members) });
            first += members.len();
        }
    }
    groups
}

/// Answers a ball around triangles; none around anything else.
fn ball(objects: &[Object]) -> Option<(Vector, f64)> {
    let corners = |object: &Object| match &object.shape {
        Shape::Smooth(triangle) => Some(triangle.points),
        _ => None,
    };
    let corners: Option<Vec<[Vector; 3]>> = objects.iter().map(corners).collect();
    let corners = corners?.concat();
    let center =
        corners.iter().fold(Vector([0.0; 3]), |sum, corner| sum + *corner) * (1.0 / corners.len() as f64);
    let radius = corners.iter().map(|corner| (*corner - center).norm()).fold(0.0, f64::max);
    Some((center, radius * (1.0 + 1e-9)))
}

impl Group {
    /// Tells whether the line of a ray comes near enough.
    pub fn may_be_met(&self, ray: &Ray) -> bool {
        let Some((center, radius)) = self.ball else { return true };
        let (way, from) = (ray.direction, center - ray.start);
        let foot = way * (from.inner(way) / way.inner(way));
        (from - foot).norm() <= radius
    }
}
