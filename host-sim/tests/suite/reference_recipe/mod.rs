//! Recipes of scenes: plain numbers that every number type of the core can hold exactly.

mod finish;
mod form;
mod lamp;
mod lens;
mod number;

use finish::{Finish, finish};
use form::{Form, form};
use lamp::{Lamp, Source, lamp};
use lens::{Lens, lens};
use number::{Maker, Triple, inner, number, triple};
use proptest::collection::vec;
use proptest::prelude::*;
use scanray::gallery::View;
use scanray::{Object, Rgb, Scalar, Scene, Settings, Sky, Vec3};

/// Is a scene before it has a number type.
#[derive(Clone, Debug)]
pub struct Recipe {
    objects: Vec<(Form, Finish)>,
    lights: Vec<Lamp>,
    sky: [Triple; 2],
    ambient: f64,
    lens: Lens,
    depth: u8,
}

/// Leaves of glass what no glass before it may cut: bodies that cut each other have no inside of their own.
fn part_glass(mut objects: Vec<(Form, Finish)>) -> Vec<(Form, Finish)> {
    let mut kept: Vec<[Triple; 2]> = vec![];
    for (form, finish) in objects.iter_mut().filter(|(_, finish)| finish.is_glass()) {
        let apart = |[low, high]: [Triple; 2], other: &[Triple; 2]| {
            (0..3).any(|axis| high[axis] < other[0][axis] || other[1][axis] < low[axis])
        };
        match form.body().filter(|body| kept.iter().all(|other| apart(*body, other))) {
            Some(body) => kept.push(body),
            None => *finish = finish.without_glass(),
        }
    }
    objects
}

/// Answers any scene of a few things.
pub fn recipe() -> impl Strategy<Value = Recipe> {
    let sky = [triple(0.0, 1.0), triple(0.0, 1.0)];
    let things = (vec((form(), finish()), 1..7).prop_map(part_glass), vec(lamp(), 0..4));
    (things, sky, number(0.0, 0.5), lens(), 0_u8..4).prop_map(
        |((objects, lights), sky, ambient, lens, depth)| {
            let glass = objects.iter().any(|(_, finish)| finish.is_glass());
            let lens = if glass { lens.without_near_plane() } else { lens };
            Recipe { objects, lights, sky, ambient, lens, depth }
        },
    )
}

/// Answers how steeply a direction meets a plane: the sine of the angle between them.
fn steepness(direction: Triple, normal: Triple) -> f64 {
    inner(direction, normal).abs() / (inner(direction, direction) * inner(normal, normal)).sqrt()
}

impl Recipe {
    /// Tells whether light from infinity runs almost along an endless plane.
    ///
    /// It would then be the plane's shadow that falls from thousands of units away, beyond the end
    /// of a fixed-point number.
    pub fn light_grazes_a_plane(&self) -> bool {
        let planes = self.objects.iter().filter_map(|(form, _)| match form {
            Form::Plane(_, normal) => Some(*normal),
            _ => None,
        });
        let distant = || {
            self.lights.iter().filter_map(|lamp| match lamp.source {
                Source::Distant(toward) => Some(toward),
                _ => None,
            })
        };
        planes.into_iter().any(|normal| distant().any(|toward| steepness(toward, normal) < 1.0 / 32.0))
    }

    /// Makes the scene in a number type. Its lists are never freed: a test is soon over.
    pub fn view<S: Scalar>(&self, number: fn(f64) -> S) -> View<S> {
        let maker = Maker(number);
        let object = |(i, (form, _)): (usize, &(Form, Finish))| Object::new(maker.shape(form), i as u16);
        let objects: Vec<_> = self.objects.iter().enumerate().map(object).collect();
        let materials: Vec<_> =
            self.objects.iter().map(|(form, finish)| maker.material(finish, form)).collect();
        let lights: Vec<_> = self.lights.iter().map(|lamp| maker.light(lamp)).collect();
        let [nadir, zenith] = self.sky.map(|color| maker.color(color));
        let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
        View {
            name: "random",
            about: "a scene nobody chose",
            scene: Scene::new(objects.leak(), materials.leak(), lights.leak())
                .with_ambient(Rgb::gray(number(self.ambient)))
                .with_sky(Sky::Gradient { up, nadir, zenith }),
            camera: maker.camera(&self.lens),
            settings: Settings::new().with_depth(self.depth),
            size: [0; 2],
        }
    }
}
