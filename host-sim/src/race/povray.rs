use super::plain::{Body, Plain};
use super::rival::Rival;
use scanray::{Rgb, Shape, Vec3};
use std::ffi::OsString;
use std::fmt::Write;
use std::path::Path;

/// Is the Persistence of Vision Raytracer.
pub(super) const POVRAY: Rival = Rival {
    name: "povray",
    package: "povray",
    scene_file: "scene.pov",
    describe,
    arguments,
    label: "Trace Time:",
};

fn arguments(plain: &Plain, threads: usize, scene: &Path, picture: &Path) -> Vec<OsString> {
    let [columns, rows] = plain.size;
    let file = |option: &str, path: &Path| {
        let mut argument = OsString::from(option);
        argument.push(path);
        argument
    };
    let mut arguments = vec![file("+I", scene), file("+O", picture)];
    // No window, no anti-aliasing, full quality; levels proportional to light.
    let others = ["-D", "-A", "+Q9", "+FN", "File_Gamma=1.0"].map(OsString::from);
    let numbers = [format!("+W{columns}"), format!("+H{rows}"), format!("+WT{threads}")];
    arguments.extend(others.into_iter().chain(numbers.map(OsString::from)));
    arguments
}

/// Writes a view in the Scene Description Language.
fn describe(plain: &Plain) -> String {
    let mut text = String::from("#version 3.7;\n");
    // Its default leaves out rays that count for less than 1/255; ours are all traced.
    let settings = format!("assumed_gamma 1 max_trace_level {} adc_bailout 0", plain.levels);
    let window = &plain.window;
    let middle = window.corner + (window.right + window.down) * 0.5;
    let (eye, right, up, middle) =
        (vector(window.eye), vector(window.right), vector(-window.down), vector(middle));
    // Writing to a string cannot fail.
    let _ = writeln!(text, "global_settings {{ {settings} }}");
    let _ = writeln!(text, "background {{ rgb {} }}", color(plain.background));
    let _ = writeln!(text, "camera {{ location {eye} right {right} up {up} direction {middle} }}");
    for lamp in &plain.lights {
        let _ = writeln!(text, "light_source {{ {} rgb {} }}", vector(lamp.position), color(lamp.color));
    }
    for body in &plain.bodies {
        let _ = writeln!(text, "{}", self::body(body));
    }
    text
}

fn body(Body { shape, finish }: &Body) -> String {
    let pigment = format!("pigment {{ rgb {} }}", color(finish.color));
    let finish = format!(
        "finish {{ ambient {} diffuse 1 phong {} phong_size {} reflection {} }}",
        finish.ambient, finish.phong, finish.shininess, finish.mirror
    );
    let texture = format!("texture {{ {pigment} {finish} }}");
    match shape {
        Shape::Sphere(ball) => format!("sphere {{ {}, {} {texture} }}", vector(ball.center), ball.radius),
        Shape::Plane(plane) => {
            let height = plane.point.dot(plane.normal) / plane.normal.length();
            format!("plane {{ {}, {height} {texture} }}", vector(plane.normal))
        }
        Shape::Triangle(triangle) => {
            let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(vector);
            format!("triangle {{ {a}, {b}, {c} {texture} }}")
        }
        // No such shape is put in plain words.
        Shape::Cuboid(_) | Shape::Displaced(_) | Shape::Custom(_) => String::new(),
    }
}

fn vector(v: Vec3<f64>) -> String {
    format!("<{}, {}, {}>", v.x, v.y, v.z)
}

fn color(c: Rgb<f64>) -> String {
    format!("<{}, {}, {}>", c.r, c.g, c.b)
}
