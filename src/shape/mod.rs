//! Shapes: a closed set with a spare room for the user's own.
//!
//! Each file holds the same four parts: the equation, the struct with its `const fn new`, its
//! [`Intersect`], its tests.

mod called;
mod cone;
mod cubic;
mod cuboid;
mod displaced;
mod isosurface;
#[cfg(not(all(feature = "shapes", feature = "meshes", feature = "volumes")))]
mod left_out;
mod march;
mod mesh;
mod plane;
mod polygon;
mod smooth;
mod sphere;
mod triangle;

pub use cone::Cone;
pub use cuboid::Cuboid;
pub use displaced::Displaced;
pub use isosurface::Isosurface;
#[cfg(not(all(feature = "shapes", feature = "meshes", feature = "volumes")))]
pub(crate) use left_out::LeftOut;
pub use mesh::{Corners, Mesh, Normals};
pub use plane::Plane;
pub use polygon::{FillRule, Polygon};
pub use smooth::{SmoothTriangle, Vertex};
pub use sphere::Sphere;
pub use triangle::Triangle;

use crate::fault::Fault;
use crate::hit::{Crossing, Surface, Tangent};
use crate::hull::Hull;
use crate::math::Scalar;
use crate::ray::{Interval, Ray};
use core::convert::Infallible;

/// Is what a shape must be able to do.
pub trait Intersect<S: Scalar> {
    /// Finds the nearest crossing inside the interval.
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>>;

    /// Finds the nearest crossing of a ray that starts on this very surface, leaving out the start.
    ///
    /// The shapes of this crate know the answer without a tolerance: a ray cannot meet a plane
    /// again. A shape that leaves this to the default ignores crossings nearer than
    /// [`Scalar::SKIN`].
    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        self.intersect(ray, &Interval::new(interval.near.max(S::SKIN), interval.far))
    }

    /// Works out the surface at a crossing that [`Intersect::intersect`] found for the same ray.
    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S>;

    /// Answers the texture coordinates of a surface that [`Intersect::surface`] worked out.
    ///
    /// Asked only where a texture or bumps want them: a shape whose coordinates take long to find
    /// finds them here.
    fn texture_coordinates(&self, surface: &Surface<S>) -> [S; 2] {
        [surface.u, surface.v]
    }

    /// Answers the ways along which u and v grow over a surface; asked only where there are bumps.
    ///
    /// The default is that of coordinates which are those of the world, as on a [`Plane`].
    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        plane::tangents(surface.normal)
    }

    /// Tells whether the shape stands anywhere inside the interval: all that a shadow asks.
    ///
    /// An answer other than that of [`Intersect::intersect`] is right only at grazing rays, where
    /// rounding decides.
    fn occludes(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        self.intersect(ray, interval).is_some()
    }

    /// Tells the same of a ray that starts on this very surface, the start left out.
    fn occludes_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        self.intersect_leaving(ray, interval).is_some()
    }

    /// Tells whether the shape is convex: a ray that leaves it outward never meets it again.
    fn is_convex(&self) -> bool {
        false
    }

    /// Answers a convex set that holds the shape: rays that miss it are not asked of the shape.
    ///
    /// The better it fits, the fewer pixels ask. A shape that leaves this to the default is asked
    /// in every pixel.
    fn hull(&self) -> Hull<S> {
        Hull::Everything
    }

    /// Tells what is wrong with the shape, if anything.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// Is one of the shapes a scene is made of; `X` is the user's own, by default none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<S: 'static = f32, X = Infallible> {
    /// A ball.
    Sphere(Sphere<S>),
    /// An endless plane.
    Plane(Plane<S>),
    /// A triangle.
    Triangle(Triangle<S>),
    /// A box along the axes.
    Cuboid(Cuboid<S>),
    /// A flat polygon of any outline.
    Polygon(Polygon<S>),
    /// A cone or a cylinder, whole or cut off, solid or open.
    Cone(Cone<S>),
    /// A triangle lit as a piece of a curved surface.
    SmoothTriangle(SmoothTriangle<S>),
    /// A ball with a relief.
    Displaced(Displaced<S>),
    /// Many triangles.
    Mesh(&'static Mesh<S>),
    /// The surface in a sampled field.
    Isosurface(Isosurface<S>),
    /// The user's own shape.
    Custom(X),
}

/// Calls the same method of whichever shape it is.
macro_rules! dispatch {
    ($shape:expr, $inner:ident => $call:expr) => {
        match $shape {
            $crate::shape::Shape::Sphere($inner) => $call,
            $crate::shape::Shape::Plane($inner) => $call,
            $crate::shape::Shape::Triangle($inner) => $call,
            $crate::shape::Shape::Cuboid($inner) => $call,
            #[cfg(feature = "shapes")]
            $crate::shape::Shape::Polygon($inner) => $call,
            #[cfg(feature = "shapes")]
            $crate::shape::Shape::Cone($inner) => $call,
            #[cfg(feature = "shapes")]
            $crate::shape::Shape::SmoothTriangle($inner) => $call,
            #[cfg(feature = "shapes")]
            $crate::shape::Shape::Displaced($inner) => $call,
            #[cfg(feature = "meshes")]
            $crate::shape::Shape::Mesh($inner) => $call,
            #[cfg(not(feature = "meshes"))]
            $crate::shape::Shape::Mesh(_) => {
                let $inner = &$crate::shape::LeftOut("meshes");
                $call
            }
            #[cfg(not(feature = "shapes"))]
            $crate::shape::Shape::Polygon(_)
            | $crate::shape::Shape::Cone(_)
            | $crate::shape::Shape::SmoothTriangle(_)
            | $crate::shape::Shape::Displaced(_) => {
                let $inner = &$crate::shape::LeftOut("shapes");
                $call
            }
            #[cfg(feature = "volumes")]
            $crate::shape::Shape::Isosurface($inner) => $call,
            #[cfg(not(feature = "volumes"))]
            $crate::shape::Shape::Isosurface(_) => {
                let $inner = &$crate::shape::LeftOut("volumes");
                $call
            }
            $crate::shape::Shape::Custom($inner) => $call,
        }
    };
}

pub(crate) use dispatch;

impl<S: Scalar, X: Intersect<S>> Intersect<S> for Shape<S, X> {
    fn intersect(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        dispatch!(self, shape => shape.intersect(ray, interval))
    }

    fn intersect_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> Option<Crossing<S>> {
        dispatch!(self, shape => shape.intersect_leaving(ray, interval))
    }

    fn surface(&self, ray: &Ray<S>, crossing: &Crossing<S>) -> Surface<S> {
        dispatch!(self, shape => shape.surface(ray, crossing))
    }

    fn texture_coordinates(&self, surface: &Surface<S>) -> [S; 2] {
        dispatch!(self, shape => shape.texture_coordinates(surface))
    }

    fn tangents(&self, surface: &Surface<S>) -> [Tangent<S>; 2] {
        dispatch!(self, shape => shape.tangents(surface))
    }

    fn occludes(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        dispatch!(self, shape => shape.occludes(ray, interval))
    }

    fn occludes_leaving(&self, ray: &Ray<S>, interval: &Interval<S>) -> bool {
        dispatch!(self, shape => shape.occludes_leaving(ray, interval))
    }

    fn is_convex(&self) -> bool {
        dispatch!(self, shape => Intersect::<S>::is_convex(shape))
    }

    fn hull(&self) -> Hull<S> {
        dispatch!(self, shape => shape.hull())
    }

    fn check(&self) -> Result<(), Fault> {
        dispatch!(self, shape => Intersect::<S>::check(shape))
    }
}

/// Fills the spare room of [`Shape`] when there is no shape of the user's: it costs nothing.
impl<S: Scalar> Intersect<S> for Infallible {
    fn intersect(&self, _: &Ray<S>, _: &Interval<S>) -> Option<Crossing<S>> {
        match *self {}
    }

    fn surface(&self, _: &Ray<S>, _: &Crossing<S>) -> Surface<S> {
        match *self {}
    }
}
