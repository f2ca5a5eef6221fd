use super::{Object, Scene};
use crate::environment::Sky;
use crate::fault::Fault;
use crate::light::Light;
use crate::material::Material;
use crate::math::Scalar;
use crate::shape::{Cuboid, Intersect, Shape};
use crate::texture::Bitmap;
use crate::volume::Volume;
use core::fmt;

/// Names the thing of a scene that is wrong, by its place in its list, and the fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneError {
    /// An object.
    Object(usize, Fault),
    /// A material.
    Material(usize, Fault),
    /// A light.
    Light(usize, Fault),
    /// The sky.
    Sky(Fault),
    /// The ambient light.
    Ambient(Fault),
    /// The hierarchy.
    Hierarchy(Fault),
    /// The volume.
    Volume(Fault),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Object(index, fault) => write!(f, "object {index}: {fault}"),
            Self::Material(index, fault) => write!(f, "material {index}: {fault}"),
            Self::Light(index, fault) => write!(f, "light {index}: {fault}"),
            Self::Sky(fault) => write!(f, "sky: {fault}"),
            Self::Hierarchy(fault) => write!(f, "hierarchy of objects: {fault}"),
            Self::Ambient(fault) => write!(f, "ambient light: {fault}"),
            Self::Volume(fault) => write!(f, "volume: {fault}"),
        }
    }
}

impl core::error::Error for SceneError {}

fn in_range(usable: bool) -> Result<(), Fault> {
    if usable { Ok(()) } else { Err(Fault::OutOfRange) }
}

fn check_object<S: Scalar, X: Intersect<S>>(
    object: &Object<S, X>,
    materials: &[Material<S>],
) -> Result<(), Fault> {
    let material = materials.get(usize::from(object.material));
    let material = material.ok_or(Fault::NoSuchMaterial(object.material))?;
    object.shape.check()?;
    if material.glass.is_none() || has_inside(&object.shape) { Ok(()) } else { Err(Fault::NotClosed) }
}

/// Tells whether a shape bounds a body, as glass asks; a user's own is taken to.
fn has_inside<S: Scalar, X>(shape: &Shape<S, X>) -> bool {
    match shape {
        Shape::Triangle(_) | Shape::Polygon(_) | Shape::SmoothTriangle(_) | Shape::Mesh(_) => false,
        Shape::Cuboid(Cuboid { low, high }) => low.x < high.x && low.y < high.y && low.z < high.z,
        Shape::Cone(cone) => cone.capped,
        Shape::Isosurface(surface) => cfg!(feature = "volumes") && surface.is_closed(),
        // On the far side of a plane there is no end of it.
        Shape::Plane(_) | Shape::Sphere(_) | Shape::Displaced(_) | Shape::Custom(_) => true,
    }
}

fn check_light<S: Scalar>(light: &Light<S>) -> Result<(), Fault> {
    match light {
        Light::Point { position, color } => in_range(position.in_range() && color.in_range()),
        Light::Directional { toward, color } => {
            in_range(toward.in_range() && color.in_range())?;
            toward.normalize().map(|_| ()).ok_or(Fault::NoDirection)
        }
        Light::Spot(spot) => spot.check(),
    }
}

fn check_sky<S: Scalar>(sky: &Sky<S>) -> Result<(), Fault> {
    match sky {
        Sky::Solid(color) => in_range(color.in_range()),
        Sky::Gradient { up, nadir, zenith } => {
            in_range(up.in_range() && nadir.in_range() && zenith.in_range())?;
            if up.is_unit() { Ok(()) } else { Err(Fault::NoDirection) }
        }
        Sky::Cube(cube) => {
            if !cfg!(feature = "images") {
                Err(Fault::LeftOut("images"))
            } else if cube.faces.iter().all(Bitmap::fits) {
                Ok(())
            } else {
                Err(Fault::ImageSize)
            }
        }
    }
}

/// Runs a check over a list and names the first that fails.
fn each<T>(
    list: &[T],
    name: fn(usize, Fault) -> SceneError,
    check: impl Fn(&T) -> Result<(), Fault>,
) -> Result<(), SceneError> {
    for (index, item) in list.iter().enumerate() {
        check(item).map_err(|fault| name(index, fault))?;
    }
    Ok(())
}

impl<S: Scalar, X: Intersect<S>> Scene<'_, S, X> {
    /// Tells whether the scene can be drawn in its number type.
    ///
    /// # Errors
    /// The first thing that is wrong and what is wrong with it.
    pub fn check(&self) -> Result<(), SceneError> {
        if self.objects.len() > usize::from(u16::MAX) {
            return Err(SceneError::Object(self.objects.len(), Fault::TooMany));
        }
        self.check_hierarchy().map_err(SceneError::Hierarchy)?;
        each(self.objects, SceneError::Object, |o| check_object(o, self.materials))?;
        each(self.materials, SceneError::Material, Material::check)?;
        each(self.lights, SceneError::Light, check_light)?;
        check_sky(&self.sky).map_err(SceneError::Sky)?;
        in_range(self.ambient.in_range()).map_err(SceneError::Ambient)?;
        self.volume.map_or(Ok(()), Volume::check).map_err(SceneError::Volume)
    }

    fn check_hierarchy(&self) -> Result<(), Fault> {
        let Some(hierarchy) = self.hierarchy else { return Ok(()) };
        if !cfg!(feature = "meshes") {
            return Err(Fault::LeftOut("meshes"));
        }
        let held = usize::from(hierarchy.count());
        if held > self.objects.len() { Err(Fault::Hierarchy) } else { hierarchy.check() }
    }
}
