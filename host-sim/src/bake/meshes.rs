//! Hierarchies over the triangles of meshes that a scene has.

use super::source::{Grown, Literal};
use super::steps::Steps;
use super::{Accel, Bounds};
use scanray::gallery::View;
use scanray::{Corners, Mesh, Shape};

/// Builds a hierarchy over the triangles of each mesh of a scene, which keep their order: that which a mesh
/// has may be of any kind, or code of the user's own, and is not asked.
///
/// `exact` is the same scene in `f64`. What is built stays in memory as long as the program runs.
pub fn grow<S: Literal>(view: &View<S>, exact: &View<f64>, accel: Accel) -> Vec<Grown<S>> {
    let pairs = view.scene.objects.iter().zip(exact.scene.objects);
    let meshes = pairs.filter_map(|(object, exact)| match (&object.shape, &exact.shape) {
        (Shape::Mesh(mesh), Shape::Mesh(exact)) => Some((*mesh, *exact)),
        _ => None,
    });
    meshes.map(|(mesh, exact)| Grown { mesh, tree: accel.build(&boxes(exact)).tree() }).collect()
}

/// Answers the box around each triangle.
fn boxes(mesh: &Mesh<f64>) -> Vec<Bounds> {
    let place = |corner: u16| place(&mesh.corners, usize::from(corner));
    mesh.triangles.iter().map(|corners| Bounds::around(corners.map(place))).collect()
}

fn place(corners: &Corners<f64>, number: usize) -> [f64; 3] {
    match corners {
        Corners::Exact(places) => places[number].to_array(),
        Corners::Quantized { low, sides, steps } => {
            Steps { low: low.to_array(), sides: sides.to_array() }.place(steps[number])
        }
    }
}
