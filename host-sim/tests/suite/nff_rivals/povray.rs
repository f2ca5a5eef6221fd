//! Scenes in the language of the Persistence of Vision Raytracer.

use super::{Kind, Pixels, run};
use host_sim::nff::scene::{Scene, Shape, View};
use std::fmt::Write;

/// Draws a scene.
pub fn draw(kind: Kind, scene: &Scene) -> Pixels {
    let [columns, rows] = scene.view.resolution;
    let size = [format!("+W{columns}"), format!("+H{rows}")];
    let arguments = ["+Ix.pov", "+Ox.png", "-D", "-A", "+FN", "File_Gamma=1.0", &size[0], &size[1]];
    run("povray", &arguments, ["x.pov", &describe(kind, scene)])
}

/// Writes a scene, its camera by the sides of its window one unit ahead.
fn describe(kind: Kind, scene: &Scene) -> String {
    let View { from, at, up, angle, resolution: [columns, rows], .. } = &scene.view;
    let [columns, rows] = [columns, rows].map(|n| f64::from(*n));
    // From the middles of the first and the last row to the edges of the picture.
    let half = (0.5 * angle.to_radians()).tan() * rows / (rows - 1.0);
    let mut text = String::from("#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 0 }\n");
    let _ = writeln!(text, "#declare ahead = vnormalize({} - {});", vector(at), vector(from));
    let _ = writeln!(text, "#declare side = vnormalize(vcross(ahead, {}));", vector(up));
    let _ = writeln!(
        text,
        "camera {{ location {} direction ahead right side * {} up vcross(side, ahead) * {} }}",
        vector(from),
        2.0 * half * columns / rows,
        2.0 * half
    );
    for light in &scene.lights {
        let _ = writeln!(text, "light_source {{ {} rgb 1 }}", vector(&light.position));
    }
    let finish = if kind == Kind::Objects { "ambient 1 diffuse 0" } else { "ambient 0 diffuse 1" };
    for object in &scene.objects {
        let color = vector(&scene.fills[object.fill].color);
        let _ = writeln!(text, "{} pigment {{ rgb {color} }} finish {{ {finish} }} }}", shape(&object.shape));
    }
    text
}

fn shape(shape: &Shape) -> String {
    match shape {
        Shape::Sphere { center, radius } => format!("sphere {{ {}, {radius}", vector(center)),
        Shape::Cone { ends: [a, b], radii: [p, q] } if p == q => {
            format!("cylinder {{ {}, {}, {p} open", vector(a), vector(b))
        }
        Shape::Cone { ends: [a, b], radii: [p, q] } => {
            format!("cone {{ {}, {p}, {}, {q} open", vector(a), vector(b))
        }
        Shape::Polygon(corners) => {
            let closed: Vec<_> = corners.iter().chain(corners.first()).map(vector).collect();
            format!("polygon {{ {}, {}", closed.len(), closed.join(", "))
        }
        Shape::Patch(_) => unreachable!("patches are flat here"),
    }
}

fn vector([x, y, z]: &[f64; 3]) -> String {
    format!("<{x}, {y}, {z}>")
}
