//! Names for materials that have none: what one would call them by their looks.

use super::material::Material;
use super::texture::Texture;
use std::collections::HashMap;

/// Is the mirror's weight from which a material is called a mirror.
const MIRROR: f64 = 0.5;

/// Names materials; no two get the same name.
pub fn names(materials: &[Material]) -> Vec<String> {
    let mut counts = HashMap::new();
    let number = |material| {
        let name = look(material);
        let count: &mut usize = counts.entry(name).or_default();
        *count += 1;
        if *count == 1 { name.to_owned() } else { format!("{name}-{count}") }
    };
    materials.iter().map(number).collect()
}

fn look(material: &Material) -> &'static str {
    match (&material.texture, material.color) {
        (Some(Texture::Checker { .. }), _) => "board",
        _ if material.glass.is_some() => "glass",
        (Some(Texture::Stripes { .. }), _) => "striped",
        (Some(Texture::Rings { .. }), _) => "ringed",
        (Some(Texture::Vertices { .. }), _) => "mixed",
        (Some(Texture::Image(_)), _) => "pictured",
        _ if material.mirror.is_some_and(|weight| weight >= MIRROR) => "mirror",
        (None, Some(color)) => hue(color.0),
        (None, None) => "plain",
    }
}

/// Names a colour.
fn hue([r, g, b]: [f64; 3]) -> &'static str {
    let (low, high) = (r.min(g).min(b), r.max(g).max(b));
    let range = high - low;
    if high < 0.03 {
        return "black";
    }
    if range < 0.2 * high {
        return if low > 0.7 { "white" } else { "grey" };
    }
    // The hue of HSV (A. R. Smith 1978), in sixths of a turn from red.
    let sixth = if high == r {
        ((g - b) / range).rem_euclid(6.0)
    } else if high == g {
        (b - r) / range + 2.0
    } else {
        (r - g) / range + 4.0
    };
    match sixth {
        ..0.25 => "red",
        ..0.75 => "orange",
        ..1.25 => "yellow",
        ..2.5 => "green",
        ..3.3 => "cyan",
        ..4.3 => "blue",
        ..5.2 => "purple",
        ..5.7 => "pink",
        _ => "red",
    }
}

#[cfg(test)]
mod tests {
    use super::super::value::Color;
    use super::*;

    fn of(color: [f64; 3]) -> Material {
        Material { color: Some(Color(color)), ..Material::default() }
    }

    #[test]
    fn colors_have_the_names_that_people_give_them() {
        let pairs = [
            ([0.9, 0.2, 0.15], "red"),
            ([1.0, 0.5, 0.0], "orange"),
            ([0.7, 0.7, 0.0], "yellow"),
            ([0.1, 0.6, 0.2], "green"),
            ([0.2, 0.6, 0.5], "cyan"),
            ([0.0, 0.0, 1.0], "blue"),
            ([0.5, 0.1, 0.6], "purple"),
            ([0.9, 0.3, 0.6], "pink"),
            ([0.5; 3], "grey"),
            ([0.9; 3], "white"),
            ([0.0; 3], "black"),
        ];
        for (color, name) in pairs {
            assert_eq!(names(&[of(color)]), [name], "{color:?}");
        }
    }

    #[test]
    fn no_two_materials_have_the_same_name() {
        let mirror = Material { mirror: Some(0.8), ..of([0.1; 3]) };
        let board = Texture::Checker { even: Color([1.0; 3]), odd: Color([0.0; 3]), per_unit: 1.0 };
        let board = Material { texture: Some(board), ..Material::default() };
        let red = of([0.9, 0.2, 0.15]);
        assert_eq!(
            names(&[red.clone(), mirror, red.clone(), board, red]),
            ["red", "mirror", "red-2", "board", "red-3"]
        );
    }
}
