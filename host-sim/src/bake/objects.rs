//! Hierarchies over the objects of a scene.

use super::source::{Literal, Planted};
use super::{Accel, Bounds};
use scanray::gallery::View;
use scanray::{Intersect, Object};

/// Puts a hierarchy over the objects of a scene that have an end, if these are two or more; those that have
/// none come behind them in the list, each kind in its order, so that the picture is the same but where an
/// object of one kind coincides with one of the other.
///
/// `exact` is the same scene in `f64`. The list stays in memory as long as the program runs.
pub fn plant<S: Literal>(planted: Planted<S>, exact: &View<f64>, accel: Accel) -> Planted<S> {
    let Planted { mut view, grown, .. } = planted;
    let bounds = exact.scene.objects.iter().map(bounds);
    let (mut bounded, mut endless, mut boxes) = (vec![], vec![], vec![]);
    for (object, bounds) in view.scene.objects.iter().zip(bounds) {
        match bounds {
            Some(bounds) => {
                bounded.push(*object);
                boxes.push(bounds);
            }
            None => endless.push(*object),
        }
    }
    if bounded.len() < 2 {
        return Planted { view, grown, tree: None };
    }
    let tree = accel.build(&boxes).tree::<S>();
    bounded.append(&mut endless);
    view.scene.objects = bounded.leak();
    view.scene.hierarchy = Some(tree.leak());
    Planted { view, grown, tree: Some(tree) }
}

/// Answers the box around an object; `None` for one without end.
fn bounds(object: &Object<f64>) -> Option<Bounds> {
    let hull = object.shape.hull().bounds()?;
    let (center, half) = (hull.center.to_array(), hull.half.to_array());
    let low = std::array::from_fn(|axis| center[axis] - half[axis]);
    Some(Bounds { low, high: std::array::from_fn(|axis| center[axis] + half[axis]) })
}
