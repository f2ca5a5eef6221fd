use crate::scene_file::describe;
use crate::scenes::Entry;
use scanray::{Light, Shape};

/// Holds what a scene's things are called.
#[derive(Clone, Debug)]
pub struct Names {
    objects: Vec<String>,
    lights: Vec<String>,
}

impl Names {
    /// Finds the names: those of a scene file's materials, for the gallery what they look like.
    pub fn of(scene: &Entry) -> Self {
        let view = scene.double;
        let described = scene.file.map(|file| file.drawn().clone()).or_else(|| describe(view).ok());
        let materials: Vec<String> =
            described.map_or(vec![], |words| words.materials.into_iter().map(|(name, _)| name).collect());
        let object = |(index, object): (usize, &scanray::Object<f64>)| {
            let material = materials.get(usize::from(object.material)).map_or("", String::as_str);
            format!("{index} ({})", format!("{material} {}", shape(&object.shape)).trim_start())
        };
        let lights = view.scene.lights.iter().enumerate();
        Self {
            objects: view.scene.objects.iter().enumerate().map(object).collect(),
            lights: lights.map(|(index, light)| format!("{} {index}", lamp(light))).collect(),
        }
    }

    /// Answers the name of an object, such as `2 (red sphere)`; the sky has none of the scene's places.
    pub fn object(&self, index: Option<usize>) -> &str {
        index.map_or("the sky", |index| self.objects.get(index).map_or("an object", String::as_str))
    }

    /// Answers the name of a light, such as `point light 0`.
    pub fn light(&self, index: usize) -> &str {
        self.lights.get(index).map_or("a light", String::as_str)
    }
}

fn shape(shape: &Shape<f64>) -> &'static str {
    match shape {
        Shape::Sphere(_) => "sphere",
        Shape::Plane(_) => "plane",
        Shape::Triangle(_) => "triangle",
        Shape::Cuboid(_) => "box",
        Shape::Polygon(_) => "polygon",
        Shape::Cone(_) => "cone",
        Shape::SmoothTriangle(_) => "smooth triangle",
        Shape::Displaced(_) => "ball with a relief",
        Shape::Mesh(_) => "mesh",
        Shape::Isosurface(_) => "isosurface",
        Shape::Custom(none) => match *none {},
    }
}

fn lamp(light: &Light<f64>) -> &'static str {
    match light {
        Light::Point { .. } => "point light",
        Light::Directional { .. } => "directional light",
        Light::Spot(_) => "spot light",
        // The enum is open to the core's future.
        _ => "light",
    }
}
