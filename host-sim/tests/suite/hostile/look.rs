//! How a scene is looked at and lit: cameras, lights, skies.

use super::shelf::Shelf;
use super::surfaces::exponent;
use super::values::Values;
use host_sim::rounded::Rounded;
use scanray::{Camera, Cube, Filter, Light, Projection, Sky};

pub fn light<S: Rounded>(values: &mut Values<S>) -> Light<S> {
    let (position, color) = (values.point(), values.color());
    match values.dice.below(3) {
        0 => Light::point(position, color),
        1 => Light::directional(values.direction(), color),
        _ => Light::spot(position, values.direction(), values.between(0.0, 0.999), exponent(values), color),
    }
}

pub fn sky<S: Rounded>(values: &mut Values<S>, shelf: &Shelf<S>) -> Sky<S> {
    match values.dice.below(4) {
        0 => {
            let (nadir, zenith) = (values.color(), values.color());
            Sky::Gradient { up: values.direction(), nadir, zenith }
        }
        1 => {
            let filter = values.dice.pick(&[Filter::Nearest, Filter::Bilinear]);
            Sky::Cube(Cube::new(values.dice.pick(&shelf.faces)).with_filter(filter))
        }
        _ => Sky::Solid(values.color()),
    }
}

pub fn camera<S: Rounded>(values: &mut Values<S>) -> Camera<S> {
    let points = [values.point(), values.point(), values.direction()];
    let near = if values.dice.one_in(3) { values.radius() } else { S::ZERO };
    let far = if values.dice.one_in(3) { values.radius() } else { S::FAR };
    match values.dice.below(4) {
        0 => {
            let window = [-1.0, 1.0, -1.0, 1.0].map(|edge| values.between(edge, edge));
            Camera::frustum(points, window, [values.radius(), far])
        }
        1 => Camera::new(points, Projection::Orthographic { height: values.radius() }, [near, far]),
        _ => {
            let fovy = values.dice.pick(&[0.001, 1.0, 40.0, 90.0, 170.0, 179.99]);
            Camera::new(points, Projection::Perspective { fovy: values.between(fovy, fovy) }, [near, far])
        }
    }
}
