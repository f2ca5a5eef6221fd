use super::plain::{Body, Plain};
use super::rival::Rival;
use super::window::Window;
use scanray::{Rgb, Shape, Vec3};
use std::ffi::OsString;
use std::fmt::Write;
use std::path::Path;

/// Is John E. Stone's Tachyon Parallel/Multiprocessor Ray Tracer.
pub(super) const TACHYON: Rival = Rival {
    name: "tachyon",
    package: "tachyon",
    scene_file: "scene.dat",
    describe,
    arguments,
    label: "Ray Tracing Time:",
};

fn arguments(_: &Plain, threads: usize, scene: &Path, picture: &Path) -> Vec<OsString> {
    let mut arguments = vec![scene.into(), "-o".into(), picture.into()];
    // Phong's highlights instead of Blinn's; it prints its times only when it is told to speak.
    arguments
        .extend(["-format", "PNG", "-fullshade", "-shade_phong", "+V", "-numthreads"].map(OsString::from));
    arguments.push(threads.to_string().into());
    arguments
}

/// Writes a view in Tachyon's own format.
fn describe(plain: &Plain) -> String {
    let [columns, rows] = plain.size;
    let mut text = format!("BEGIN_SCENE\nRESOLUTION {columns} {rows}\n{}", camera(plain));
    // Writing to a string cannot fail.
    let _ = writeln!(text, "BACKGROUND {}", color(plain.background));
    for lamp in &plain.lights {
        // A lamp is a ball that can be seen, made too small for it.
        let _ =
            writeln!(text, "LIGHT CENTER {} RAD 0.000001 COLOR {}", vector(lamp.position), color(lamp.color));
    }
    for body in &plain.bodies {
        let _ = writeln!(text, "{}", self::body(body));
    }
    text.push_str("END_SCENE\n");
    text
}

fn camera(plain: &Plain) -> String {
    let Window { eye, forward, corner, right, down } = plain.window;
    let upright = -down * (1.0 / down.length());
    // Its right hand is our left one; its window takes care of that, as it may run the other way.
    let sideways = upright.cross(forward);
    let [columns, rows] = plain.size.map(f64::from);
    // Its rays pass the lower left corners of pixels numbered from 1: half a pixel too far.
    let (width, height) = (right.dot(sideways), -down.dot(upright));
    let left = corner.dot(sideways) - 0.5 * width / columns;
    let bottom = corner.dot(upright) - height - 0.5 * height / rows;
    let (eye, forward, upright) = (vector(eye), vector(forward), vector(upright));
    format!(
        "CAMERA\nZOOM 1\nASPECTRATIO 1\nANTIALIASING 0\nRAYDEPTH {}\n\
         CENTER {eye}\nVIEWDIR {forward}\nUPDIR {upright}\n\
         FRUSTUM {left} {} {bottom} {}\nEND_CAMERA\n",
        plain.levels,
        left + width,
        bottom + height
    )
}

fn body(Body { shape, finish }: &Body) -> String {
    // What it calls specular is the mirror.
    let texture = format!(
        "TEXTURE AMBIENT {} DIFFUSE 1 SPECULAR {} OPACITY 1 PHONG PLASTIC {} PHONG_SIZE {} COLOR {} TEXFUNC 0",
        finish.ambient,
        finish.mirror,
        finish.phong,
        finish.shininess,
        color(finish.color)
    );
    match shape {
        Shape::Sphere(ball) => format!("SPHERE CENTER {} RAD {} {texture}", vector(ball.center), ball.radius),
        Shape::Plane(plane) => {
            format!("PLANE CENTER {} NORMAL {} {texture}", vector(plane.point), vector(plane.normal))
        }
        Shape::Triangle(triangle) => {
            let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(vector);
            format!("TRI V0 {a} V1 {b} V2 {c} {texture}")
        }
        // No such shape is put in plain words.
        Shape::Cuboid(_) | Shape::Displaced(_) | Shape::Custom(_) => String::new(),
    }
}

fn vector(v: Vec3<f64>) -> String {
    format!("{} {} {}", v.x, v.y, v.z)
}

fn color(c: Rgb<f64>) -> String {
    format!("{} {} {}", c.r, c.g, c.b)
}
