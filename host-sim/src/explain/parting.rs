use super::{Column, Explanation, Node};
use crate::reference::{Output, Shine, Surface, Vector, Visit, wanted};

/// Tells where a column parts from the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Parting {
    /// The first step that alone changes what the panel is to show by more than one of its steps.
    pub step: Option<Difference>,
    /// How many steps of the panel the colours are apart before they are rounded.
    pub apart: f64,
}

/// Is what a step of the calculation does to the pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The ray and what of it is another.
    pub what: String,
    /// How many steps of the panel it changes.
    pub steps: f64,
}

/// Finds where a column parts from the reference.
///
/// Each step is judged alone: what it sends to the eye otherwise than in the reference is added to the reference's
/// light, and that sent through the transfer curve.
pub fn parting(explanation: &Explanation, column: &Column) -> Parting {
    let Explanation { shot, reference, .. } = explanation;
    let output = Output::copy(shot.panel, shot.transfer, shot.dither);
    let truth = reference.account.light;
    let level = |light| wanted(output, light);
    let steps = |change| furthest(&level(truth + change), &level(truth));
    let differences = differences(explanation, column);
    let judged = differences.map(|(what, change)| Difference { what, steps: steps(change) });
    // What is not a number is far from every level.
    let first = judged.into_iter().find(|difference| difference.steps > 1.0 || difference.steps.is_nan());
    Parting { step: first, apart: furthest(&column.levels, &reference.levels) }
}

/// Answers the largest distance of two lists of values, which is not a number where one is not.
pub(super) fn furthest(a: &[f64], b: &[f64]) -> f64 {
    let further = |most: f64, off: f64| if most.is_nan() || off <= most { most } else { off };
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, further)
}

/// Lists every step with what it sends to the eye otherwise than in the reference.
fn differences(explanation: &Explanation, column: &Column) -> impl Iterator<Item = (String, Vector)> {
    let Explanation { reference, tree, .. } = explanation;
    let veil = |column: &Column| column.account.veil.unwrap_or((Vector::default(), 1.0));
    let ((own, through), (ours, truth)) = (veil(column), veil(reference));
    let behind = reference.account.light - ours;
    let thinner = if truth > 0.0 { behind * ((through - truth) / truth) } else { Vector::default() };
    let veiled = [("light of the volume", own - ours), ("what comes through the volume", thinner)];
    let veiled = veiled.map(|(what, change)| (what.to_owned(), change));
    let rays = tree.iter().flat_map(move |node| of_ray(explanation, column, node));
    let rays = rays.map(move |(what, change)| (what, change * truth));
    veiled.into_iter().chain(rays.collect::<Vec<_>>())
}

/// Lists the steps of a ray.
fn of_ray(explanation: &Explanation, column: &Column, node: &Node) -> Vec<(String, Vector)> {
    let named = |what: &str| format!("{}: {what}", node.name);
    let brings = |visit: &Visit| visit.weight.filter(visit.sent);
    let (own, truth) = match (column.visit(node.place), explanation.reference.visit(node.place)) {
        (Some(own), Some(truth)) => (own, truth),
        (Some(own), None) => return vec![(named("the reference sends no such ray"), brings(own))],
        (None, Some(truth)) => return vec![(named("no such ray is sent"), -brings(truth))],
        (None, None) => return vec![],
    };
    let object = |visit: &Visit| visit.surface.as_ref().map(|surface| surface.object);
    let (met, expected) = (object(own), object(truth));
    if met != expected {
        let [met, expected] = [met, expected].map(|index| explanation.names.object(index));
        let what = named(&format!("it meets {met}, in the reference {expected}"));
        return vec![(what, brings(own) - brings(truth))];
    }
    let mut steps =
        vec![(named("what of its light reaches the eye"), (own.weight - truth.weight).filter(own.sent))];
    match (&own.surface, &truth.surface) {
        (Some(own), Some(expected)) if own.ambient.is_some() => {
            steps.extend(of_surface(explanation, node, [own, expected], truth.weight));
        }
        _ => steps.push((named("the colour"), truth.weight.filter(own.sent - truth.sent))),
    }
    steps
}

/// Lists the terms of a surface's light, each weighted by what reaches the eye.
fn of_surface(
    explanation: &Explanation,
    node: &Node,
    [own, truth]: [&Surface; 2],
    weight: Vector,
) -> Vec<(String, Vector)> {
    let ambient = |surface: &Surface| surface.ambient.map_or(Vector::default(), |[_, light]| light);
    let mut terms = vec![(format!("{}: ambient light", node.name), ambient(own) - ambient(truth))];
    for ray in &node.lights {
        let shine = |surface: &Surface| surface.lights.get(ray.light).copied().unwrap_or(Shine::Away);
        let sent = |surface| shine(surface).lit().map_or(Vector::default(), |lit| lit.sent);
        let what = format!("{} at {}: {}", ray.name, node.name, explanation.names.light(ray.light));
        terms.push((what, sent(own) - sent(truth)));
    }
    terms.into_iter().map(|(what, change)| (what, weight.filter(change))).collect()
}
