//! Materials in source: their constructor, and what differs from what it makes.

use super::literal::Literal;
use super::pool::Pool;
use scanray::{Bump, Filter, Fresnel, Glass, Image, Material, Model, Relief, Rgb, Texture};

/// Writes a material; `None` for one that there is no source for.
pub(super) fn material<S: Literal>(material: &Material<S>, pool: &mut Pool<'_, S>) -> Option<String> {
    let mut text = match &material.texture {
        Texture::Solid(color) => format!("Material::matte({})", S::color(*color)),
        texture => format!("Material::textured({})", self::texture(texture, pool)?),
    };
    let usual = Material::textured(material.texture);
    if let Some(bump) = &material.bump {
        text += &format!("\n        .with_bump({})", self::bump(bump, pool)?);
    }
    if material.model != usual.model {
        text += &format!("\n        .with_model({})", model(&material.model)?);
    }
    if material.ambient != usual.ambient {
        text += &format!("\n        .with_ambient({})", material.ambient.number());
    }
    if (material.specular, material.shininess) != (usual.specular, usual.shininess) {
        text += &format!("\n        .with_specular({}, {})", S::color(material.specular), material.shininess);
    }
    if material.mirror != usual.mirror {
        text += &format!("\n        .with_mirror({})", material.mirror.number());
    }
    if let Some(glass) = &material.glass {
        text += &format!("\n        .with_glass({})", self::glass(glass)?);
    }
    Some(text)
}

fn model<S: Literal>(model: &Model<S>) -> Option<String> {
    Some(match model {
        Model::Flat => "Model::Flat".to_owned(),
        Model::Phong => "Model::Phong".to_owned(),
        Model::BlinnPhong => "Model::BlinnPhong".to_owned(),
        Model::CookTorrance(facets) => {
            let [roughness, index] = [facets.roughness, facets.index].map(S::number);
            format!("Model::CookTorrance(CookTorrance::new({roughness}, {index}))")
        }
        _ => return None,
    })
}

fn glass<S: Literal>(glass: &Glass<S>) -> Option<String> {
    let mut text = format!("Glass::new({}, {})", glass.transmission.number(), glass.index.number());
    text += match glass.fresnel {
        Fresnel::None => "",
        Fresnel::Schlick => ".with_fresnel(Fresnel::Schlick)",
        Fresnel::Exact => ".with_fresnel(Fresnel::Exact)",
        _ => return None,
    };
    if glass.absorption != Rgb::BLACK {
        text += &format!(".with_absorption({})", S::color(glass.absorption));
    }
    Some(text)
}

fn texture<S: Literal>(texture: &Texture<S>, pool: &mut Pool<'_, S>) -> Option<String> {
    let n = S::number;
    let pair = |even: Rgb<S>, odd: Rgb<S>| format!("{}, {}", S::color(even), S::color(odd));
    Some(match texture {
        Texture::Solid(color) => format!("Texture::Solid({})", S::color(*color)),
        Texture::Checker(t) => {
            format!("Texture::Checker(Checker::new({}, {}))", pair(t.even, t.odd), n(t.per_unit))
        }
        Texture::Vertices(t) => {
            format!("Texture::Vertices(Vertices::new({}))", t.colors.map(S::color).join(", "))
        }
        Texture::Stripes(t) => {
            let [u, v] = t.per_unit.map(n);
            format!("Texture::Stripes(Stripes::new({}, [{u}, {v}]))", pair(t.even, t.odd))
        }
        Texture::Rings(t) => {
            let [u, v] = t.center.map(n);
            format!("Texture::Rings(Rings::new({}, [{u}, {v}], {}))", pair(t.even, t.odd), n(t.per_unit))
        }
        Texture::Image(t) => format!("Texture::Image({})", image(t, pool)),
        _ => return None,
    })
}

fn bump<S: Literal>(bump: &Bump<S>, pool: &mut Pool<'_, S>) -> Option<String> {
    let image = image(&bump.image, pool);
    Some(match bump.relief {
        Relief::Heights(height) => format!("Bump::heights({image}, {})", height.number()),
        Relief::Normals => format!("Bump::normals({image})"),
        _ => return None,
    })
}

/// Writes an image over texture coordinates.
pub(super) fn image<S: Literal>(image: &Image<S>, pool: &mut Pool<'_, S>) -> String {
    let usual = Image::new(image.bitmap);
    let mut text = format!("Image::new({})", pool.image(image.bitmap));
    if image.per_unit != usual.per_unit {
        let [u, v] = image.per_unit.map(S::number);
        text += &format!(".with_tiles({u}, {v})");
    }
    if image.filter != usual.filter {
        text += &format!(".with_filter({})", filter(image.filter));
    }
    text
}

/// Writes how the colour between texels is found.
pub(super) fn filter(filter: Filter) -> &'static str {
    match filter {
        Filter::Nearest => "Filter::Nearest",
        Filter::Bilinear => "Filter::Bilinear",
    }
}
