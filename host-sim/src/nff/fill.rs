use super::scene::Fill;
use crate::scene_file::glass::Glass;
use crate::scene_file::material::Material;
use crate::scene_file::value::Color;
use std::collections::HashMap;

/// Holds the materials that fills become, no two alike.
pub(super) struct Palette<'a> {
    fills: &'a [Fill],
    /// Materials, each with the place of the first fill it was made of.
    pub materials: Vec<(Material, usize)>,
    known: HashMap<String, u16>,
}

impl<'a> Palette<'a> {
    /// Begins with no materials.
    pub fn of(fills: &'a [Fill]) -> Self {
        Self { fills, materials: vec![], known: HashMap::new() }
    }

    /// Answers the place of the material of a fill, as a body has it or as a surface has it.
    pub fn material(&mut self, fill: usize, body: bool) -> u16 {
        let Some(material) = self.fills.get(fill).map(|fill| material(fill, body)) else { return 0 };
        let next = self.materials.len() as u16;
        let index = *self.known.entry(format!("{material:?}")).or_insert(next);
        if index == next {
            self.materials.push((material, fill));
        }
        index
    }

    /// Tells whether light is to come through what a fill is on.
    pub fn lets_light_through(&self, fill: usize) -> bool {
        self.fills.get(fill).is_some_and(|fill| fill.transmittance > 0.0)
    }

    /// Tells whether a fill gives more light than it gets; what its digits round does not count.
    pub fn is_too_bright(&self, fill: usize) -> bool {
        self.fills.get(fill).is_some_and(|fill| fill.specular + fill.transmittance > 1.0 + 1e-9)
    }
}

/// Makes a material: of `rgb Kd` for diffuse light, with a white highlight and a mirror of weight Ks; a body
/// lets T of the light through.
fn material(fill: &Fill, body: bool) -> Material {
    let Fill { color, diffuse, specular, shine, transmittance, index } = *fill;
    let transmission = if body { transmittance } else { 0.0 };
    let shines = specular > 0.0;
    Material {
        color: Some(Color(color.map(|c| c * diffuse))),
        specular: shines.then_some(Color([specular; 3])),
        // The cast saturates: beyond 65535 a highlight is smaller than a pixel.
        shininess: shines.then_some(shine.round() as u16),
        mirror: shines.then_some(specular.min(1.0 - transmission)),
        glass: (transmission > 0.0).then_some(Glass { transmission, index, fresnel: None, absorption: None }),
        ..Material::default()
    }
}
