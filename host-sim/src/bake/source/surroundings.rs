//! What is not an object, in source: lights, sky, camera, settings.

use super::layout::Layout;
use super::literal::Literal;
use super::material::filter;
use super::pool::Pool;
use scanray::output::BLUE_NOISE;
use scanray::{Camera, Cube, Dither, Light, Projection, Settings, Sky, Transfer};

/// Writes a light; `None` for one that there is no source for.
pub(super) fn light<S: Literal>(light: &Light<S>) -> Option<String> {
    Some(match light {
        Light::Point { position, color } => {
            format!("Light::point({}, {})", S::vector(*position), S::color(*color))
        }
        Light::Directional { toward, color } => {
            format!("Light::directional({}, {})", S::vector(*toward), S::color(*color))
        }
        Light::Spot(spot) => {
            let [position, axis] = [spot.position, spot.axis].map(S::vector);
            let (cutoff, falloff, color) = (spot.cutoff.number(), spot.falloff, S::color(spot.color));
            format!("Light::spot({position}, {axis}, {cutoff}, {falloff}, {color})")
        }
        _ => return None,
    })
}

/// Writes a sky, and the list of faces that it borrows; `None` for one that there is no source for.
pub(super) fn sky<S: Literal>(sky: &Sky<S>, pool: &mut Pool<'_, S>, layout: &mut Layout) -> Option<String> {
    Some(match sky {
        Sky::Solid(color) => format!("Sky::Solid({})", S::color(*color)),
        Sky::Gradient { up, nadir, zenith } => {
            let (up, nadir, zenith) = (S::vector(*up), S::color(*nadir), S::color(*zenith));
            format!(
                "Sky::Gradient {{\n        up: {up},\n        nadir: {nadir},\n        zenith: {zenith},\n    }}"
            )
        }
        Sky::Cube(cube) => {
            let faces = cube.faces.map(|face| pool.image(face));
            layout.list("FACES", "Bitmap", &faces);
            let usual = Cube::new(cube.faces).filter == cube.filter;
            let set = if usual { String::new() } else { format!(".with_filter({})", filter(cube.filter)) };
            format!("Sky::Cube(Cube::new(&FACES){set})")
        }
        _ => return None,
    })
}

/// Writes a camera; `None` for one that there is no source for.
pub(super) fn camera<S: Literal>(camera: &Camera<S>) -> Option<String> {
    let [eye, center, up] = [camera.eye, camera.center, camera.up].map(S::vector);
    let n = S::number;
    let projection = match camera.projection {
        Projection::Perspective { fovy } => format!("Perspective {{ fovy: {} }}", n(fovy)),
        Projection::Frustum { left, right, bottom, top } => {
            let [left, right, bottom, top] = [left, right, bottom, top].map(n);
            format!("Frustum {{ left: {left}, right: {right}, bottom: {bottom}, top: {top} }}")
        }
        Projection::Orthographic { height } => format!("Orthographic {{ height: {} }}", n(height)),
        _ => return None,
    };
    let far = if camera.far == S::FAR { "Scalar::FAR".to_owned() } else { n(camera.far) };
    Some(format!(
        "Camera {{\n    eye: {eye},\n    center: {center},\n    up: {up},\n    \
         projection: Projection::{projection},\n    near: {},\n    far: {far},\n}}",
        n(camera.near)
    ))
}

/// Writes settings; `None` for those that there is no source for.
pub(super) fn settings<S: Literal>(settings: &Settings<S>) -> Option<String> {
    let dither = match settings.dither {
        Dither::None => "None",
        Dither::Ordered => "Ordered",
        Dither::Mask(mask) if std::ptr::eq(mask, &BLUE_NOISE) => "Mask(&output::BLUE_NOISE)",
        Dither::Mask(_) => return None,
        Dither::Diffused => "Diffused",
    };
    let transfer = match settings.transfer {
        Transfer::Srgb => "Srgb",
        Transfer::Linear => "Linear",
    };
    let (depth, exposure) = (settings.depth, settings.exposure.number());
    let mut text = format!("Settings::new().with_depth({depth}).with_exposure({exposure})");
    text += &format!("\n    .with_transfer(Transfer::{transfer}).with_dither(Dither::{dither})");
    Some(text)
}
