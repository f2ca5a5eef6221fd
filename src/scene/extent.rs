use super::Scene;
use crate::color::Rgb;
use crate::environment::Sky;
use crate::hull::Hull;
use crate::light::{Light, Spot};
use crate::material::{Material, Model};
use crate::math::Scalar;
use crate::shape::Intersect;
use crate::texture::Texture;

fn reach<S: Scalar>(hull: &Hull<S>) -> S {
    match *hull {
        Hull::Plane { point, .. } => point.largest(),
        _ => hull.bounds().map_or(S::ZERO, |bounds| bounds.center.largest() + bounds.half.largest()),
    }
}

fn brightest_of_texture<S: Scalar>(texture: &Texture<S>) -> S {
    match texture {
        Texture::Solid(color) => color.max(),
        Texture::Checker(checker) => checker.even.max().max(checker.odd.max()),
        Texture::Vertices(vertices) => {
            vertices.colors.iter().fold(S::ZERO, |most, color| most.max(color.max()))
        }
        Texture::Stripes(stripes) => stripes.even.max().max(stripes.odd.max()),
        Texture::Rings(rings) => rings.even.max().max(rings.odd.max()),
        Texture::Image(_) | Texture::Custom(_) => S::ONE,
    }
}

fn brightest_highlight<S: Scalar>(material: &Material<S>) -> S {
    let factor = if let Model::CookTorrance(_) = material.model { S::from_i32(1024) } else { S::ONE };
    material.specular.max() * factor
}

impl<S: Scalar, X: Intersect<S>> Scene<'_, S, X> {
    /// Answers the largest magnitude among the coordinates of shapes, lights and the volume: at most this is
    /// what [`Scene::check`] compares with [`Scalar::LIMIT`].
    pub fn largest(&self) -> S {
        let shapes = self.objects.iter().map(|object| reach(&object.shape.hull()));
        let lights = self.lights.iter().map(|light| match *light {
            Light::Point { position, .. } | Light::Spot(Spot { position, .. }) => position.largest(),
            Light::Directional { .. } => S::ZERO,
        });
        let volume = self.volume.map(|volume| reach(&Hull::Box(volume.grid.bounds())));
        shapes.chain(lights).chain(volume).fold(S::ZERO, S::max)
    }

    /// Answers a bound of the light that any surface or the sky sends without mirrors: every term of
    /// the shading at its largest.
    pub fn brightest(&self) -> S {
        let arriving = self.lights.iter().fold(S::ZERO, |sum, light| sum + light.color().max());
        let sent = |material: &Material<S>| {
            let color = brightest_of_texture(&material.texture);
            let lit = self.ambient.max() * material.ambient * color
                + arriving * (color + brightest_highlight(material));
            lit.max(color)
        };
        let sky = match self.sky {
            Sky::Solid(color) => color,
            Sky::Gradient { nadir, zenith, .. } => {
                let Rgb { r, g, b } = zenith;
                Rgb::new(nadir.r.max(r), nadir.g.max(g), nadir.b.max(b))
            }
            Sky::Cube(_) => Rgb::WHITE,
        };
        self.materials.iter().map(sent).fold(sky.max(), S::max)
    }
}
