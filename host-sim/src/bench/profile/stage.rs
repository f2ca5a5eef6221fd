//! Which stage and shape a function belongs to: the one place that knows the core's modules by name.

use std::fmt;

/// Is a stage of a picture's making.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the table below says what belongs to each")]
pub enum Stage {
    Rays,
    Candidates,
    Hits,
    Shadows,
    Bounces,
    Shading,
    Encoding,
    Other,
}

/// Is a shape of the core's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Shape {
    Sphere,
    Plane,
    Cuboid,
    Triangle,
}

use Shape::*;
use Stage::*;

/// Names stages by a part of a function's path and by a part of its type parameters, if these matter. Of the
/// functions that an instruction lies in, the innermost that is listed decides; of its lines here, the first.
const STAGES: [(&str, &str, Stage); 16] = [
    ("scanray::camera::section", "", Candidates),
    ("scanray::camera::fan", "", Candidates),
    ("scanray::camera", "", Rays),
    ("scanray::render::spans", "", Candidates),
    ("scanray::trace::tracer::Tracer::seek_mirrored", "", Bounces),
    ("scanray::trace::tracer::unit_reflection", "", Bounces),
    ("scanray::trace::tracer::gather", "", Bounces),
    ("scanray::trace::visibility", "", Hits),
    ("scanray::trace::vicinity", "", Shadows),
    ("scanray::trace::shadow", "", Shadows),
    ("scanray::trace::shade", "", Shading),
    ("scanray::trace::tracer", "visit", Shading),
    ("scanray::brdf", "", Shading),
    ("scanray::environment", "", Shading),
    ("scanray::light", "", Shading),
    ("scanray::output", "", Encoding),
];

/// Is the function below which a search for hits is a search for what mirrors show.
const MIRRORED: &str = "scanray::trace::tracer::Tracer::seek_mirrored";

const SHAPES: [(&str, Shape); 4] = [
    ("scanray::shape::sphere", Sphere),
    ("scanray::shape::plane", Plane),
    ("scanray::shape::cuboid", Cuboid),
    ("scanray::shape::triangle", Triangle),
];

impl Stage {
    /// Answers the stage of an instruction by the functions it lies in, the outermost first.
    pub fn of(frames: &[&str]) -> Self {
        match frames.iter().rev().find_map(|frame| Self::of_function(frame)) {
            Some(Hits) if frames.iter().any(|frame| plain(frame).contains(MIRRORED)) => Bounces,
            found => found.unwrap_or(Other),
        }
    }

    fn of_function(frame: &str) -> Option<Self> {
        let path = plain(frame);
        let fits = |(part, with, _): &&(&str, &str, Self)| path.contains(part) && frame.contains(with);
        STAGES.iter().find(fits).map(|(_, _, stage)| *stage)
    }
}

impl Shape {
    /// Answers the shape that an instruction works on, if it does.
    pub fn of(frames: &[&str]) -> Option<Self> {
        let of_function = |frame: &&str| {
            let path = plain(frame);
            SHAPES.iter().find(|(part, _)| path.contains(part)).map(|(_, shape)| *shape)
        };
        frames.iter().rev().find_map(of_function)
    }
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&format!("{self:?}").to_lowercase())
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&format!("{self:?}").to_lowercase())
    }
}

/// Answers the innermost function of the core or of the compiler's arithmetic: what others say of themselves,
/// such as that they multiply, tells little.
pub fn telling(frames: &[&str]) -> String {
    let paths: Vec<String> = frames.iter().map(|frame| plain(frame)).collect();
    let is_telling = |path: &&String| path.starts_with("scanray") || path.starts_with("__");
    paths.iter().rev().find(is_telling).or(paths.last()).cloned().unwrap_or_default()
}

/// Answers a function's path without type parameters: `<a::B<C> as d::E<F>>::g::<H>` is `a::B as d::E::g`.
pub fn plain(name: &str) -> String {
    let mut path = String::new();
    // A path may begin with the type whose method it is: that bracket encloses no parameters.
    let mut open = if name.starts_with('<') { vec![false] } else { vec![] };
    let mut before = ' ';
    for letter in name.chars().skip(open.len()) {
        match letter {
            '<' => open.push(true),
            '>' if before != '-' => _ = open.pop(),
            _ if !open.contains(&true) => path.push(letter),
            _ => {}
        }
        before = letter;
    }
    path.replace("::::", "::").trim_end_matches("::").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn type_parameters_are_left_out_and_the_methods_type_is_not() {
        assert_eq!(plain("a::b::<c::d, fn() -> e>"), "a::b");
        assert_eq!(plain("<a::B<C> as d::E<F<G>>>::g::<H>"), "a::B as d::E::g");
        assert_eq!(plain("<a::B>::c::<d::E>::{closure#0}"), "a::B::c::{closure#0}");
    }

    #[test]
    fn the_innermost_listed_function_decides() {
        let nearest = "scanray::trace::visibility::nearest::<f32, Infallible>";
        let sphere = "<scanray::shape::sphere::Sphere<f32> as scanray::shape::Intersect<f32>>::intersect";
        let mirrored = "<scanray::trace::tracer::Tracer<f32, Infallible>>::seek_mirrored";
        assert_eq!(
            Stage::of(&["scanray::trace::tracer::Tracer::radiance", nearest, sphere, "f32::mul"]),
            Hits
        );
        assert_eq!(Stage::of(&[mirrored, nearest, sphere]), Bounces);
        assert_eq!(Stage::of(&["measure::main"]), Other);
        assert_eq!(Shape::of(&[nearest, sphere]), Some(Sphere));
        assert_eq!(Shape::of(&[nearest]), None);
        assert_eq!(telling(&[sphere, "<f32 as core::ops::arith::Mul>::mul"]), plain(sphere));
    }
}
