//! Walks: where a scene is seen from, in whole parts of a step.

use host_sim::orbit::{STEP, ZOOM, orbit, pivot, rises, zoom};
use scanray::Camera;
use scanray::gallery::View;
use serde::{Deserialize, Serialize};

/// Is how many parts a step of an arrow key has: a drag goes by parts.
pub const PARTS: i32 = 1024;

/// Is how many parts a walk once around has.
pub const AROUND: i32 = 48 * PARTS;

/// Is the most notches that one can zoom in or out: a tenth closer each, ten times closer together.
pub const NOTCHES: i32 = 24;

/// Is how far the camera was carried from where the scene has it.
///
/// It counts whole parts, from the scene's own camera on: whoever goes back to where he was sees the same bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Walk {
    /// Parts of a step to the right; [`AROUND`] is once around.
    pub right: i32,
    /// Parts of a step up.
    pub up: i32,
    /// Notches closer.
    pub zoom: i32,
}

/// Answers the angle of some parts, in radians.
fn angle(parts: i32) -> f64 {
    STEP * f64::from(parts) / f64::from(PARTS)
}

impl Walk {
    /// Answers the camera of a view after the walk.
    pub fn carry(self, view: &View<f64>) -> Camera<f64> {
        let right = self.right.rem_euclid(AROUND);
        let moved = match (right, self.up) {
            (0, 0) => view.camera,
            (right, up) => orbit(&view.camera, pivot(view), angle(right), angle(up)),
        };
        match self.zoom.clamp(-NOTCHES, NOTCHES) {
            0 => moved,
            notches => zoom(&moved, ZOOM.powi(notches)),
        }
    }
}

/// Answers how many parts one can walk down and up in a view: the first at most 0, the second at least 0.
pub fn reach(view: &View<f64>) -> [i32; 2] {
    let [down, up] = rises(&view.camera, pivot(view)).map(|radians| radians / angle(1));
    [down.ceil() as i32, up.floor() as i32]
}

#[cfg(test)]
mod tests {
    use super::*;
    use host_sim::scenes;

    fn simple() -> &'static View<f64> {
        scenes::find("simple").unwrap().double
    }

    #[test]
    fn whoever_does_not_walk_sees_the_scene_from_its_own_camera() {
        for entry in scenes::all() {
            assert_eq!(Walk::default().carry(entry.double), entry.double.camera, "{}", entry.name());
        }
    }

    #[test]
    fn a_walk_once_around_ends_where_it_began_to_the_bit() {
        for right in [0, 1, PARTS, 5 * PARTS + 3] {
            let [once, twice] =
                [right + AROUND, right - 2 * AROUND].map(|right| Walk { right, up: 9, zoom: 1 });
            let here = Walk { right, up: 9, zoom: 1 }.carry(simple());
            assert_eq!([once, twice].map(|walk| walk.carry(simple())), [here; 2]);
        }
    }

    #[test]
    fn every_part_of_a_step_moves_the_eye() {
        let eyes: Vec<_> =
            (0..4).map(|right| Walk { right, ..Walk::default() }.carry(simple()).eye).collect();
        assert!(eyes.windows(2).all(|pair| pair[0] != pair[1]), "{eyes:?}");
    }

    #[test]
    fn one_can_walk_up_as_far_as_the_view_says_and_no_farther() {
        for entry in scenes::all() {
            let view = entry.double;
            let [down, up] = reach(view);
            let eye = |up| Walk { right: 1, up, zoom: 0 }.carry(view).eye;
            assert!(down <= 0 && up >= 0, "{}: {down} {up}", entry.name());
            assert_eq!(eye(up + 2), eye(up + 3), "{}", entry.name());
            assert_eq!(eye(down - 2), eye(down - 3), "{}", entry.name());
            assert_ne!(eye(up - 1), eye(up - 2), "{}", entry.name());
        }
    }

    #[test]
    fn zooming_in_narrows_the_view_and_has_an_end() {
        let at = |zoom| Walk { zoom, ..Walk::default() }.carry(simple()).projection;
        assert_ne!(at(1), at(0));
        assert_eq!(at(i32::MAX), at(NOTCHES));
    }
}
