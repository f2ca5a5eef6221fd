use super::{Object, Scene};
use crate::light::Light;
use crate::material::Material;
use crate::math::Scalar;
use crate::shape::Shape;
use core::convert::Infallible;
use core::fmt;
use heapless::Vec;

/// Owns a scene that is built at run time, in buffers of fixed capacity.
///
/// ```
/// use scanray::{Material, Rgb, SceneBuffer, Shape, Sphere, Vec3};
///
/// let mut buffer = SceneBuffer::<f32, 1, 1, 1>::new();
/// let red = buffer.add_material(Material::matte(Rgb::new(1.0, 0.0, 0.0)))?;
/// let ball = Shape::Sphere(Sphere::new(Vec3::new(0.0, 0.0, -3.0), 1.0));
/// buffer.add_object(ball, red)?;
/// assert!(buffer.add_object(ball, red).is_err(), "there was room for one");
/// assert_eq!(buffer.scene().objects.len(), 1);
/// # Ok::<(), scanray::Full>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneBuffer<
    S: Scalar,
    const OBJECTS: usize,
    const MATERIALS: usize,
    const LIGHTS: usize,
    X = Infallible,
> {
    objects: Vec<Object<S, X>, OBJECTS>,
    materials: Vec<Material<S>, MATERIALS>,
    lights: Vec<Light<S>, LIGHTS>,
}

/// Tells which list of a [`SceneBuffer`] had no room left, and how much it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Full {
    /// The objects' list.
    Objects(usize),
    /// The materials' list.
    Materials(usize),
    /// The lights' list.
    Lights(usize),
}

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, room) = match self {
            Self::Objects(room) => ("objects", room),
            Self::Materials(room) => ("materials", room),
            Self::Lights(room) => ("lights", room),
        };
        write!(f, "the scene buffer has room for {room} {what} and all of it is taken")
    }
}

impl core::error::Error for Full {}

impl<S: Scalar, const O: usize, const M: usize, const L: usize, X> SceneBuffer<S, O, M, L, X> {
    /// Makes an empty scene.
    pub const fn new() -> Self {
        Self { objects: Vec::new(), materials: Vec::new(), lights: Vec::new() }
    }

    /// Adds a material and answers the index by which objects name it.
    ///
    /// # Errors
    /// [`Full`] when the list is full; the scene is as before.
    pub fn add_material(&mut self, material: Material<S>) -> Result<u16, Full> {
        let index = u16::try_from(self.materials.len()).map_err(|_| Full::Materials(M))?;
        self.materials.push(material).map_err(|_| Full::Materials(M))?;
        Ok(index)
    }

    /// Adds a shape made of a material.
    ///
    /// # Errors
    /// [`Full`] when the list is full; the scene is as before.
    pub fn add_object(&mut self, shape: Shape<S, X>, material: u16) -> Result<(), Full> {
        let object = Object::new(shape, material);
        self.objects.push(object).map_err(|_| Full::Objects(O))
    }

    /// Adds a light.
    ///
    /// # Errors
    /// [`Full`] when the list is full; the scene is as before.
    pub fn add_light(&mut self, light: Light<S>) -> Result<(), Full> {
        self.lights.push(light).map_err(|_| Full::Lights(L))
    }

    /// Answers the scene as the renderer takes it; sky and ambient light are set on the answer.
    pub fn scene(&self) -> Scene<'_, S, X> {
        Scene::new(&self.objects, &self.materials, &self.lights)
    }
}

impl<S: Scalar, const O: usize, const M: usize, const L: usize, X> Default for SceneBuffer<S, O, M, L, X> {
    fn default() -> Self {
        Self::new()
    }
}
