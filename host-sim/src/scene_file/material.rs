//! Materials of a scene file.
//!
//! A field that a file leaves out keeps the value that the core's constructor gave it. To add one: the
//! field, and a line in each of the two functions.

use super::bump::Bump;
use super::glass::Glass;
use super::image::ImageFile;
use super::texture::Texture;
use super::value::{Color, unless};
use crate::rounded::Rounded;
use scanray::{CookTorrance, Rgb};
use serde::{Deserialize, Serialize};

/// Is what a surface does with light; its fields are those of the core's material of the same name.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// Colour of the diffuse and ambient reflection, where there is no texture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<Color>,
    /// Colours of the diffuse and ambient reflection, where there is no single one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub texture: Option<Texture>,
    /// Roughness that only light sees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bump: Option<Bump>,
    /// Reflection model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<Model>,
    /// Share of the scene's ambient light it reflects.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ambient: Option<f64>,
    /// Colour of the specular reflection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub specular: Option<Color>,
    /// Exponent of the specular reflection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shininess: Option<u16>,
    /// Weight of the light that a mirror in its place would show.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mirror: Option<f64>,
    /// What comes through, if anything does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub glass: Option<Glass>,
}

/// Names a reflection model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Model {
    /// The colour as it is, without light or shadow.
    Flat,
    /// Ambient, diffuse and Phong's specular light.
    Phong,
    /// The same with Blinn's specular light.
    BlinnPhong,
    /// The same with the specular light of facets.
    CookTorrance {
        /// Eccentricity of the facets' distribution.
        roughness: f64,
        /// Their refractive index.
        index: f64,
    },
}

impl Model {
    fn of(model: scanray::Model<f64>) -> Option<Self> {
        Some(match model {
            scanray::Model::Flat => Self::Flat,
            scanray::Model::Phong => Self::Phong,
            scanray::Model::BlinnPhong => Self::BlinnPhong,
            scanray::Model::CookTorrance(CookTorrance { roughness, index }) => {
                Self::CookTorrance { roughness, index }
            }
            _ => return None,
        })
    }

    fn in_number<S: Rounded>(self) -> scanray::Model<S> {
        match self {
            Self::Flat => scanray::Model::Flat,
            Self::Phong => scanray::Model::Phong,
            Self::BlinnPhong => scanray::Model::BlinnPhong,
            Self::CookTorrance { roughness, index } => {
                scanray::Model::CookTorrance(CookTorrance::new(S::round(roughness), S::round(index)))
            }
        }
    }
}

impl Material {
    /// Tells whether it has either a colour or a texture, as every material of a file must.
    pub fn is_painted_once(&self) -> bool {
        self.color.is_some() != self.texture.is_some()
    }

    /// Lists its images, each with a word for what it is for.
    pub fn images_mut(&mut self) -> impl Iterator<Item = (&'static str, &mut ImageFile)> {
        let texture = self.texture.as_mut().and_then(|texture| match texture {
            Texture::Image(image) => Some(("image", image)),
            _ => None,
        });
        let bump = self.bump.as_mut().map(Bump::image_mut);
        texture.into_iter().chain(bump).map(|(role, image)| (role, &mut image.file))
    }

    /// Makes the core's material, rounded to a number.
    pub fn in_number<S: Rounded>(&self) -> scanray::Material<S> {
        let color = self.color.map_or(Rgb::BLACK, Color::in_number);
        let texture = self.texture.as_ref().map_or(scanray::Texture::Solid(color), Texture::in_number);
        let mut material = scanray::Material::textured(texture);
        material.bump = self.bump.as_ref().map(Bump::in_number);
        material.model = self.model.map_or(material.model, Model::in_number);
        material.ambient = self.ambient.map_or(material.ambient, S::round);
        material.specular = self.specular.map_or(material.specular, Color::in_number);
        material.shininess = self.shininess.unwrap_or(material.shininess);
        material.mirror = self.mirror.map_or(material.mirror, S::round);
        material.glass = self.glass.as_ref().map(Glass::in_number);
        material
    }

    /// Takes a material of the core, with what differs from its constructor's; `None` for one that scene
    /// files do not know.
    pub fn of(material: &scanray::Material<f64>) -> Option<Self> {
        let usual = scanray::Material::textured(material.texture);
        let (color, texture) = match &material.texture {
            scanray::Texture::Solid(color) => (Some(Color::of(*color)), None),
            texture => (None, Some(Texture::of(texture)?)),
        };
        Some(Self {
            color,
            texture,
            bump: material.bump.as_ref().and_then(Bump::of),
            model: unless(usual.model, material.model).and_then(Model::of),
            ambient: unless(usual.ambient, material.ambient),
            specular: unless(usual.specular, material.specular).map(Color::of),
            shininess: unless(usual.shininess, material.shininess),
            mirror: unless(usual.mirror, material.mirror),
            glass: material.glass.as_ref().map(Glass::of),
        })
    }
}
