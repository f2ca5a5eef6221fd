//! What surfaces of a model do with light.

use crate::bake::source::Literal;
use scanray::{Bitmap, Image, Material, Model, Rgb, Texture};

/// Is what a surface of a model does with light.
#[derive(Clone, Debug, PartialEq)]
pub struct Paint {
    /// Its name in the file.
    pub name: String,
    /// Colour of the diffuse reflection where there is no image, linear light from 0 to 1.
    pub color: [f64; 3],
    /// Image of the diffuse reflection.
    pub image: Option<Bitmap>,
    /// Reflection model.
    pub model: Model<f64>,
    /// Share of the scene's ambient light it reflects, 0 to 1.
    pub ambient: f64,
    /// Colour of the specular reflection, linear light from 0 to 1.
    pub specular: [f64; 3],
    /// Exponent of the specular reflection.
    pub shininess: u16,
    /// Whether the file wants light to come through, which a surface without an inside cannot do.
    pub lets_light_through: bool,
}

impl Default for Paint {
    fn default() -> Self {
        Self {
            name: String::new(),
            color: [1.0; 3],
            image: None,
            model: Model::Phong,
            ambient: 1.0,
            specular: [0.0; 3],
            shininess: 1,
            lets_light_through: false,
        }
    }
}

impl Paint {
    /// Makes the core's material, rounded to a number.
    pub fn in_number<S: Literal>(&self) -> Material<S> {
        let color = |color: [f64; 3]| {
            let [r, g, b] = color.map(S::round);
            Rgb::new(r, g, b)
        };
        let solid = Texture::Solid(color(self.color));
        let texture = self.image.map_or(solid, |bitmap| Texture::Image(Image::new(bitmap)));
        let model = if self.model == Model::Flat { Model::Flat } else { Model::Phong };
        let material = Material::textured(texture).with_model(model).with_ambient(S::round(self.ambient));
        if self.specular == [0.0; 3] {
            return material;
        }
        material.with_specular(color(self.specular), self.shininess)
    }
}
