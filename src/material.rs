//! What surfaces are made of.

use crate::brdf::CookTorrance;
use crate::color::Rgb;
use crate::fault::Fault;
use crate::glass::Glass;
use crate::hit::Surface;
use crate::math::Scalar;
use crate::texture::{Bump, Texture};

/// Names the reflection model of a [`Material`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Model<S = f32> {
    /// The texture's colour as it is, without light or shadow (row L1).
    Flat,
    /// Ambient, Lambert's diffuse and Phong's specular term (rows L2 and L3).
    Phong,
    /// The same with Blinn's half-way direction in the specular term (row L4).
    BlinnPhong,
    /// The same with Cook's and Torrance's specular term, which takes no exponent (row L5).
    CookTorrance(CookTorrance<S>),
}

/// Is what a surface does with light.
///
/// Made by [`Material::flat`] or [`Material::matte`] and refined by the `with_` functions, so
/// that it can grow:
///
/// ```
/// use scanray::{Material, Rgb};
/// const RUBY: Material = Material::matte(Rgb::new(0.8, 0.05, 0.1))
///     .with_specular(Rgb::gray(0.4), 50)
///     .with_mirror(0.2);
/// assert_eq!(RUBY.shininess, 50);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material<S = f32> {
    /// Colour of the diffuse and ambient reflection.
    pub texture: Texture<S>,
    /// Roughness that only light sees (row T2).
    pub bump: Option<Bump<S>>,
    /// Reflection model.
    pub model: Model<S>,
    /// Share of the scene's ambient light it reflects, from 0 to 1024 as light is.
    pub ambient: S,
    /// Colour of the specular reflection; black for none.
    pub specular: Rgb<S>,
    /// Exponent of Phong's and Blinn's specular reflection.
    pub shininess: u16,
    /// Weight of the light that a mirror in its place would show; 0 for none (row R1).
    pub mirror: S,
    /// What comes through, if anything does (rows R2 and R3).
    pub glass: Option<Glass<S>>,
}

impl<S: Scalar> Material<S> {
    /// Makes a material that shows its colour whatever the light.
    pub const fn flat(color: Rgb<S>) -> Self {
        Self { model: Model::Flat, ..Self::matte(color) }
    }

    /// Makes a diffuse material.
    pub const fn matte(color: Rgb<S>) -> Self {
        Self::textured(Texture::Solid(color))
    }

    /// Makes a diffuse material of a texture.
    pub const fn textured(texture: Texture<S>) -> Self {
        Self {
            texture,
            bump: None,
            model: Model::Phong,
            ambient: S::ONE,
            specular: Rgb::BLACK,
            shininess: 1,
            mirror: S::ZERO,
            glass: None,
        }
    }

    /// Adds a highlight.
    pub const fn with_specular(mut self, specular: Rgb<S>, shininess: u16) -> Self {
        self.specular = specular;
        self.shininess = shininess;
        self
    }

    /// Sets the reflection model.
    pub const fn with_model(mut self, model: Model<S>) -> Self {
        self.model = model;
        self
    }

    /// Adds a mirror reflection.
    pub const fn with_mirror(mut self, weight: S) -> Self {
        self.mirror = weight;
        self
    }

    /// Lets light through.
    pub const fn with_glass(mut self, glass: Glass<S>) -> Self {
        self.glass = Some(glass);
        self
    }

    /// Adds bumps.
    pub const fn with_bump(mut self, bump: Bump<S>) -> Self {
        self.bump = Some(bump);
        self
    }

    /// Sets the share of the scene's ambient light.
    pub const fn with_ambient(mut self, share: S) -> Self {
        self.ambient = share;
        self
    }

    /// Tells whether what it looks like depends on texture coordinates.
    pub fn is_detailed(&self) -> bool {
        self.texture.is_varied() || self.bump.is_some()
    }

    /// Answers a number of the tile of the texture and of the bumps at a hit: neighbouring tiles have
    /// different ones.
    pub fn tile(&self, surface: &Surface<S>) -> u32 {
        let bump = self.bump.as_ref().map_or(0, |bump| bump.image.tile(surface.u, surface.v));
        self.texture.tile(surface) ^ bump.rotate_left(8)
    }

    /// Tells whether this program was built with all that the material needs.
    fn is_carried(&self) -> Result<(), Fault> {
        let needs = [
            ("images", cfg!(feature = "images"), self.texture.image().is_some() || self.bump.is_some()),
            ("glass", cfg!(feature = "glass"), self.glass.is_some()),
            ("models", cfg!(feature = "models"), !matches!(self.model, Model::Flat | Model::Phong)),
        ];
        let missing = needs.iter().find(|(_, carried, needed)| *needed && !carried);
        missing.map_or(Ok(()), |(feature, ..)| Err(Fault::LeftOut(feature)))
    }

    /// Tells what is wrong with the material, if anything.
    ///
    /// # Errors
    /// A value that no scene may contain, facets that no surface has, an image without texels or too
    /// large, or a mirror or glass that gives more light than it gets.
    pub fn check(&self) -> Result<(), Fault> {
        self.is_carried()?;
        if let Model::CookTorrance(facets) = &self.model {
            facets.check()?;
        }
        let ambient = Rgb::gray(self.ambient);
        let usable = self.texture.in_range() && ambient.in_range() && self.specular.in_range();
        let images = [self.texture.image(), self.bump.as_ref().map(|bump| &bump.image)];
        if !usable || self.bump.is_some_and(|bump| !bump.in_range()) {
            Err(Fault::OutOfRange)
        } else if images.into_iter().flatten().any(|image| !image.bitmap.fits()) {
            Err(Fault::ImageSize)
        } else if self.mirror >= S::ZERO && self.mirror <= S::ONE {
            self.glass.map_or(Ok(()), |glass| glass.check(self.mirror))
        } else {
            Err(Fault::MirrorWeight)
        }
    }
}
