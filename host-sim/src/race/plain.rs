use super::Fault;
use super::window::Window;
use scanray::gallery::View;
use scanray::material::Model;
use scanray::{Light, Material, Rgb, Shape, Sky, Texture, Vec3};

/// Is a view in the words all programs share.
#[derive(Clone, Debug)]
pub(super) struct Plain {
    pub size: [u32; 2],
    pub window: Window,
    /// Levels of rays, that of the eye included.
    pub levels: u32,
    pub background: Rgb<f64>,
    pub lights: Vec<Lamp>,
    pub bodies: Vec<Body>,
}

/// Is a light at a point, the same at any distance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lamp {
    pub position: Vec3<f64>,
    pub color: Rgb<f64>,
}

/// Is a shape with its finish.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    pub shape: Shape<f64>,
    pub finish: Finish,
}

/// Is what a surface does with light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finish {
    pub color: Rgb<f64>,
    /// Share of the colour that is always sent out.
    pub ambient: f64,
    pub phong: f64,
    pub shininess: u16,
    pub mirror: f64,
}

impl Plain {
    /// Puts a view in plain words.
    ///
    /// # Errors
    /// What of it some program has no word for.
    pub fn of(view: &View<f64>, size: [u32; 2]) -> Result<Self, Fault> {
        let scene = &view.scene;
        let Sky::Solid(background) = scene.sky else { return Err(Fault::Unwritable("a graded sky")) };
        if scene.volume.is_some() {
            return Err(Fault::Unwritable("volumes"));
        }
        let lights = scene.lights.iter().map(|light| match *light {
            Light::Point { position, color } => Ok(Lamp { position, color }),
            _ => Err(Fault::Unwritable("lights that are no points")),
        });
        let ambient = grey(scene.ambient)?;
        let bodies = scene.objects.iter().map(|object| {
            if let Some(word) = unwritable(&object.shape) {
                return Err(Fault::Unwritable(word));
            }
            let material = &scene.materials[usize::from(object.material)];
            Ok(Body { shape: object.shape, finish: Finish::of(material, ambient)? })
        });
        Ok(Self {
            size,
            window: Window::of(&view.camera, size)?,
            levels: u32::from(view.settings.depth) + 1,
            background,
            lights: lights.collect::<Result<_, _>>()?,
            bodies: bodies.collect::<Result<_, _>>()?,
        })
    }
}

/// Answers what a shape is called that some program has no word for.
fn unwritable(shape: &Shape<f64>) -> Option<&'static str> {
    match shape {
        Shape::Sphere(_) | Shape::Plane(_) | Shape::Triangle(_) => None,
        Shape::Cuboid(_) => Some("boxes"),
        Shape::Polygon(_) => Some("polygons"),
        Shape::Cone(_) => Some("cones"),
        Shape::SmoothTriangle(_) => Some("smooth triangles"),
        Shape::Displaced(_) => Some("reliefs"),
        Shape::Mesh(_) => Some("meshes"),
        Shape::Isosurface(_) => Some("isosurfaces"),
        Shape::Custom(none) => match *none {},
    }
}

impl Finish {
    fn of(material: &Material<f64>, ambient: f64) -> Result<Self, Fault> {
        let Texture::Solid(color) = material.texture else { return Err(Fault::Unwritable("textures")) };
        if material.glass.is_some() {
            return Err(Fault::Unwritable("glass"));
        }
        if material.bump.is_some() {
            return Err(Fault::Unwritable("bumps"));
        }
        if material.model != Model::Phong {
            return Err(Fault::Unwritable("reflection models other than Phong's"));
        }
        let (phong, ambient) = (grey(material.specular)?, ambient * material.ambient);
        Ok(Self { color, ambient, phong, shininess: material.shininess, mirror: material.mirror })
    }
}

/// Answers the level of a grey.
fn grey(color: Rgb<f64>) -> Result<f64, Fault> {
    let level = color.r;
    if color == Rgb::gray(level) {
        Ok(level)
    } else {
        Err(Fault::Unwritable("coloured highlights or ambient light"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scanray::gallery::double;

    #[test]
    fn what_some_program_has_no_word_for_is_refused() {
        let refused = [
            (double::BUSINESS_CARD, "a graded sky"),
            (double::ORTHOGRAPHIC, "parallel rays"),
            (double::SIMPLE, "boxes"),
        ];
        for (view, what) in refused {
            let plain = Plain::of(&view, [4, 3]);
            assert!(
                matches!(plain, Err(Fault::Unwritable(word)) if word == what),
                "{}: {plain:?}",
                view.name
            );
        }
    }
}
