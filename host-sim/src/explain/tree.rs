use super::column::Column;
use crate::reference::Shine;
use std::collections::BTreeSet;

/// Is a ray of the tree with the name that it has in drawings of such trees: R1 the ray from the eye, R2 and so on
/// those that mirrors send on, T1 and so on those that go through glass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// Its name.
    pub name: String,
    /// Place in the binary tree, as [`Visit::place`](crate::reference::Visit::place) counts.
    pub place: u64,
    /// Where in the list of nodes the ray is that it comes from.
    pub parent: Option<usize>,
    /// The rays to lights.
    pub lights: Vec<LightRay>,
}

/// Is a ray to a light: L1, L2 and so on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LightRay {
    /// Its name.
    pub name: String,
    /// Place of the light in the scene's list.
    pub light: usize,
}

/// Counts names given.
#[derive(Default)]
struct Count {
    reflected: usize,
    refracted: usize,
    lights: usize,
}

/// Names all rays that any of the columns has, each before those that it gives rise to.
pub(super) fn tree(columns: &[Column]) -> Vec<Node> {
    let (mut nodes, mut count) = (vec![], Count::default());
    grow(columns, 1, None, &mut count, &mut nodes);
    nodes
}

/// Adds a ray and all that it gives rise to, which is no deeper than the deepest picture.
fn grow(columns: &[Column], place: u64, parent: Option<usize>, count: &mut Count, nodes: &mut Vec<Node>) {
    let visits: Vec<_> = columns.iter().filter_map(|column| column.visit(place)).collect();
    if visits.is_empty() {
        return;
    }
    let is_refracted = place > 1 && place % 2 == 1;
    let (letter, number) =
        if is_refracted { ("T", &mut count.refracted) } else { ("R", &mut count.reflected) };
    *number += 1;
    let name = format!("{letter}{number}");
    let surfaces = visits.iter().filter_map(|visit| visit.surface.as_ref());
    let shines = surfaces.flat_map(|surface| surface.lights.iter().enumerate());
    let asked: BTreeSet<usize> =
        shines.filter(|(_, shine)| **shine != Shine::Away).map(|(light, _)| light).collect();
    let lights = asked.into_iter().map(|light| {
        count.lights += 1;
        LightRay { name: format!("L{}", count.lights), light }
    });
    let lights = lights.collect();
    let index = nodes.len();
    nodes.push(Node { name, place, parent, lights });
    for child in [2 * place, 2 * place + 1] {
        grow(columns, child, Some(index), count, nodes);
    }
}
