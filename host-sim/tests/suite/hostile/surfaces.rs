//! Surfaces of any look: textures, bumps, models, glass.

use super::shelf::Shelf;
use super::values::Values;
use host_sim::rounded::Rounded;
use scanray::hit::Surface;
use scanray::{
    Bump, Checker, CookTorrance, Filter, Fresnel, Glass, Image, Material, Model, Procedural, Rgb, Rings,
    Scalar, Stripes, Texture, Vertices,
};

/// Is a texture of a user's that answers with no light a scene may hold.
fn wild<S: Scalar>(surface: &Surface<S>) -> Rgb<S> {
    // Infinity where the number has it, and then no number.
    let far = surface.u.ratio(S::ZERO) * S::FAR;
    Rgb::new(far * S::ZERO, -far, surface.v.recip())
}

pub fn image<S: Rounded>(values: &mut Values<S>, shelf: &Shelf<S>) -> Image<S> {
    let bitmap = values.dice.pick(shelf.bitmaps);
    let [u, v] = values.place();
    let filter = values.dice.pick(&[Filter::Nearest, Filter::Bilinear]);
    Image::new(bitmap).with_tiles(u, v).with_filter(filter)
}

fn texture<S: Rounded>(values: &mut Values<S>, shelf: &Shelf<S>) -> Texture<S> {
    let [a, b, c] = [values.color(), values.color(), values.color()];
    match values.dice.below(9) {
        0 => Texture::Checker(Checker::new(a, b, values.per_unit())),
        1 => Texture::Vertices(Vertices::new(a, b, c)),
        2 => Texture::Stripes(Stripes::new(a, b, values.place())),
        3 => Texture::Rings(Rings::new(a, b, values.place(), values.per_unit())),
        4 | 5 => Texture::Image(image(values, shelf)),
        6 => Texture::Custom(Procedural::new(wild)),
        _ => Texture::Solid(a),
    }
}

fn model<S: Rounded>(values: &mut Values<S>) -> Model<S> {
    match values.dice.below(5) {
        0 => Model::Flat,
        1 => Model::BlinnPhong,
        2 => Model::CookTorrance(CookTorrance::new(
            values.between(1.0 / 64.0, 1.0),
            values.between(1.0, 256.0),
        )),
        _ => Model::Phong,
    }
}

fn glass<S: Rounded>(values: &mut Values<S>) -> Glass<S> {
    let fresnel = values.dice.pick(&[Fresnel::None, Fresnel::Schlick, Fresnel::Exact]);
    let index = values.dice.pick(&[0.125, 0.7, 1.0, 1.0, 1.5, 2.4, 8.0]);
    Glass::new(values.between(0.0, 0.5), values.between(index, index))
        .with_fresnel(fresnel)
        .with_absorption(values.color())
}

/// Answers how sharp a highlight is.
pub fn exponent<S: Rounded>(values: &mut Values<S>) -> u16 {
    values.dice.pick(&[0, 1, 2, 50, 1000, u16::MAX])
}

pub fn material<S: Rounded>(values: &mut Values<S>, shelf: &Shelf<S>) -> Material<S> {
    let mut material = Material::textured(texture(values, shelf)).with_model(model(values));
    if values.dice.one_in(2) {
        let specular = values.color();
        material = material.with_specular(specular, exponent(values));
    }
    if values.dice.one_in(3) {
        material = material.with_mirror(values.between(0.0, 0.5));
    }
    if values.dice.one_in(10) {
        material = material.with_glass(glass(values));
    }
    if values.dice.one_in(5) {
        let image = image(values, shelf);
        let is_heights = values.dice.one_in(2);
        let bump = if is_heights { Bump::heights(image, values.radius()) } else { Bump::normals(image) };
        material = material.with_bump(bump);
    }
    material.with_ambient(values.between(0.0, 1.0))
}
