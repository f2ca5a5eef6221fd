//! Meshes: triangles that share their corners, in flash.

mod corners;
mod normals;

pub use corners::Corners;
pub use normals::Normals;

use super::smooth::{Facet, Vertex};
use super::{Intersect, Triangle};
use crate::aabb::Aabb;
use crate::accel::Hierarchy;
use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::{Scalar, Vec3};
use crate::ray::{Interval, Ray};

/// Is a surface of triangles that share their corners (row O8), seen from both sides.
///
/// Each triangle is the [`SmoothTriangle`](super::SmoothTriangle) of its corners, to the bit, and a flat
/// one has its own normal at each; so has a triangle at a corner whose normal does not look to its outward side.
/// The part of a hit is the triangle's number. At most 65535 triangles of as many corners.
///
/// ```
/// use scanray::accel::Every;
/// use scanray::{Corners, Mesh, Normals, Shape, Vec3};
///
/// static TRIANGLES: [[u16; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
/// static PLACES: [Vec3; 4] = [
///     Vec3::new(0.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
/// static SQUARE: Mesh = Mesh::new(&TRIANGLES, Corners::Exact(&PLACES), Normals::Flat, &Every(2));
/// let shape: Shape = Shape::Mesh(&SQUARE);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mesh<S: 'static = f32> {
    /// Numbers of the corners of each triangle, anticlockwise as seen from outside.
    pub triangles: &'static [[u16; 3]],
    /// Where the corners are.
    pub corners: Corners<S>,
    /// How it is lit.
    pub normals: Normals<S>,
    /// Texture coordinates u and v of each corner; none where it has none: then those of a triangle's corners
    /// are (0, 0), (1, 0) and (0, 1).
    pub texture: &'static [[S; 2]],
    /// Which triangles a ray may meet.
    pub hierarchy: &'static dyn Hierarchy<S>,
    /// The box around it, as far as it is known: rays that miss it ask nothing.
    pub bounds: Option<Aabb<S>>,
}

/// Is the same mesh, not one of equal triangles.
impl<S> PartialEq for Mesh<S> {
    fn eq(&self, other: &Self) -> bool {
        core::ptr::eq(self, other)
    }
}

impl<S: Copy> Mesh<S> {
    /// Makes a mesh without texture coordinates.
    pub const fn new(
        triangles: &'static [[u16; 3]],
        corners: Corners<S>,
        normals: Normals<S>,
        hierarchy: &'static dyn Hierarchy<S>,
    ) -> Self {
        Self { triangles, corners, normals, texture: &[], hierarchy, bounds: None }
    }

    /// Sets the texture coordinates, of each corner.
    pub const fn with_texture(mut self, texture: &'static [[S; 2]]) -> Self {
        self.texture = texture;
        self
    }

    /// Sets the box that holds all corners.
    pub const fn with_bounds(mut self, bounds: Aabb<S>) -> Self {
        self.bounds = Some(bounds);
        self
    }
}

impl<S: Scalar> Mesh<S> {
    /// Answers the flat triangle of a number.
    fn triangle(&self, number: u16) -> Option<Triangle<S>> {
        let [a, b, c] = *self.triangles.get(usize::from(number))?;
        Some(Triangle::new(self.corners.place(a), self.corners.place(b), self.corners.place(c)))
    }

    /// Answers the triangle of a number with all that its corners have.
    fn facet(&self, number: u16) -> Option<Facet<S>> {
        let numbers = *self.triangles.get(usize::from(number))?;
        let flat = self.triangle(number)?;
        let face = flat.normal().unwrap_or(Vec3::ZERO);
        let plain = [[S::ZERO, S::ZERO], [S::ONE, S::ZERO], [S::ZERO, S::ONE]];
        let mut facet = Facet::new([flat.a, flat.b, flat.c].map(|place| Vertex::new(place, face, plain[0])));
        for ((vertex, number), plain) in facet.vertices.iter_mut().zip(numbers).zip(plain) {
            // A normal that looks to the back is of no use.
            let normal = self.normals.normal(number).filter(|normal| normal.dot(face) > S::ZERO);
            vertex.normal = normal.unwrap_or(face);
            vertex.texture = self.texture.get(usize::from(number)).copied().unwrap_or(plain);
        }
        Some(facet)
    }
}

impl<S: Scalar> Intersect<S> for &'static Mesh<S> {
    #[inline(never)]
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        let mut nearest: Option<Crossing<S>> = None;
        self.hierarchy.walk(ray, interval, &mut |number| {
            let far = nearest.map_or(interval.far, |crossing| crossing.t);
            // Of two at the same distance the one listed first counts, in whichever order they are named.
            let first = nearest.is_some_and(|crossing| number < crossing.part);
            let look = Interval::new(interval.near, if first { far.next_up() } else { far });
            let crossing = self.triangle(number).and_then(|triangle| triangle.intersect(ray, &look));
            if let Some(crossing) = crossing {
                nearest = Some(Crossing { part: number, ..crossing });
            }
            crossing.map_or(far, |crossing| crossing.t)
        });
        nearest
    }

    /// What starts on it starts on one side of it, off it: it may meet it again.
    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        self.intersect(ray, interval)
    }

    #[inline(never)]
    fn occludes(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        let mut met = false;
        self.hierarchy.walk(ray, interval, &mut |number| {
            met |= self.triangle(number).is_some_and(|triangle| triangle.intersect(ray, interval).is_some());
            if met { S::ZERO } else { interval.far }
        });
        met
    }

    /// What starts on it is asked like any other: the first triangle met ends the search.
    fn occludes_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        self.occludes(ray, interval)
    }

    #[inline(never)]
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        let surface = self.facet(crossing.part).map(|facet| facet.surface(ray, crossing));
        let lost = Surface { point: ray.origin, normal: -ray.direction, u: S::ZERO, v: S::ZERO, part: 0 };
        surface.map_or(lost, |surface| Surface { part: crossing.part, ..surface })
    }

    #[inline(never)]
    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        match self.facet(surface.part) {
            Some(facet) => facet.tangents(surface),
            None => super::plane::tangents(surface.normal),
        }
    }

    fn hull(&self) -> Hull<S> {
        self.bounds.map_or(Hull::Everything, Hull::Box)
    }

    #[inline(never)]
    fn check(&self) -> Result<(), Fault> {
        let corners = self.corners.len();
        let named = self.triangles.iter().flatten().all(|number| usize::from(*number) < corners);
        let textured = self.texture.is_empty() || self.texture.len() == corners;
        if !(named && textured) {
            return Err(Fault::Mesh);
        }
        if self.triangles.len() > usize::from(u16::MAX) {
            return Err(Fault::TooMany);
        }
        self.corners.check()?;
        self.normals.check(corners)?;
        if !self.texture.iter().flatten().all(|coordinate| coordinate.in_range()) {
            return Err(Fault::OutOfRange);
        }
        self.hierarchy.check()?;
        if usize::from(self.hierarchy.count()) == self.triangles.len() {
            Ok(())
        } else {
            Err(Fault::Hierarchy)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fixed;
    use crate::gallery::Gallery;
    use crate::shape::Shape;

    fn check<S: Gallery>() {
        let objects = S::find("teapot").expect("a scene").scene.objects;
        let mesh = objects.iter().find_map(|object| match object.shape {
            Shape::Mesh(mesh) => Some(mesh),
            _ => None,
        });
        let mesh = mesh.expect("a mesh");
        let (mut blocked, mut open) = (0, 0);
        for number in (0..992).step_by(31) {
            let triangle = mesh.triangle(number).expect("a triangle");
            let origin = triangle.point(S::HALF * S::HALF, S::HALF);
            for [x, y, z] in [[1, 2, 3], [-3, 1, 2], [2, -1, -3], [-1, 3, -2], [0, 1, 0]] {
                let toward = Vec3::new(S::from_i32(x), S::from_i32(y), S::from_i32(z));
                let ray = Ray::new(origin, toward.normalize().expect("a direction").0);
                for far in [S::HALF, S::FAR] {
                    let interval = Interval::new(S::SKIN, far);
                    let met = mesh.intersect_leaving(&ray, &interval).is_some();
                    assert_eq!(mesh.occludes_leaving(&ray, &interval), met, "{number}: {ray:?}");
                    (blocked, open) = (blocked + i32::from(met), open + i32::from(!met));
                }
            }
        }
        assert!(blocked > 50 && open > 50, "{blocked} {open}");
    }

    #[test]
    #[cfg_attr(miri, ignore = "an interpreter takes minutes for the teapot")]
    fn a_mesh_stands_in_the_light_of_its_own_points_exactly_where_it_is_met_again() {
        check::<f32>();
        check::<Fixed>();
    }
}
