//! A whole scene from the shelf and the dice.

use super::bodies::body;
use super::dice::Dice;
use super::liar::Liar;
use super::look::{camera, light, sky};
use super::shelf::Shelf;
use super::surfaces::material;
use super::values::Values;
use host_sim::rounded::Rounded;
use scanray::accel::Hierarchy;
use scanray::output::BLUE_NOISE;
use scanray::{
    Camera, Dither, Light, Material, Object, Rgb, Scalar, Scene, Settings, Shape, Sky, Transfer, Volume,
};

/// Is the most that surfaces may hand light on.
pub const DEPTH: u8 = 5;

/// Owns a scene and how it is drawn.
pub struct Recipe<S: Scalar> {
    objects: Vec<Object<S, Liar<S>>>,
    materials: Vec<Material<S>>,
    lights: Vec<Light<S>>,
    sky: Sky<S>,
    ambient: Rgb<S>,
    hierarchy: Option<&'static dyn Hierarchy<S>>,
    volume: Option<&'static Volume<S>>,
    pub camera: Camera<S>,
    pub settings: Settings<S>,
    pub size: [u32; 2],
}

fn settings<S: Rounded>(values: &mut Values<S>) -> Settings<S> {
    let depth = if values.dice.one_in(40) { values.dice.bits() as u8 } else { values.dice.below(6) as u8 };
    let dithers = [Dither::None, Dither::Ordered, Dither::Mask(&BLUE_NOISE), Dither::Diffused];
    Settings::new()
        .with_depth(depth)
        .with_exposure(values.between(0.0, 2.0))
        .with_transfer(values.dice.pick(&[Transfer::Srgb, Transfer::Linear]))
        .with_dither(values.dice.pick(&dithers))
}

fn size(dice: &mut Dice) -> [u32; 2] {
    if dice.one_in(50) {
        return dice.pick(&[[0, 5], [5, 0], [0, 0], [32_768, 1], [1, 40_000], [u32::MAX; 2], [25, 16]]);
    }
    dice.pick(&[[1, 1], [8, 8], [24, 16], [24, 1], [1, 16], [7, 5], [16, 9]])
}

impl<S: Rounded> Recipe<S> {
    pub fn thrown(shelf: &Shelf<S>, dice: &mut Dice) -> Self {
        let size = size(dice);
        let mut values = Values::new(dice.clone());
        let kinds = 1 + values.dice.below(4);
        let materials = (0..kinds).map(|_| material(&mut values, shelf)).collect();
        // Glass on what has no inside is refused: many objects of many materials seldom pass.
        let count = values.dice.pick(&[0, 1, 1, 2, 3, 4, 8, 40]);
        let mut objects = Vec::with_capacity(count);
        for _ in 0..count {
            let last = kinds - 1 + usize::from(values.dice.one_in(200));
            objects.push(Object::new(body(&mut values, shelf), values.dice.below(last + 1) as u16));
        }
        let lights = (0..values.dice.below(4)).map(|_| light(&mut values)).collect();
        let hierarchy = values.dice.one_in(12).then(|| values.dice.pick(&shelf.hierarchies));
        let volume = values.dice.one_in(8).then(|| values.dice.pick(&shelf.volumes));
        let (sky, ambient) = (sky(&mut values, shelf), values.color());
        let (camera, settings) = (camera(&mut values), settings(&mut values));
        *dice = values.dice;
        Self { objects, materials, lights, sky, ambient, hierarchy, volume, camera, settings, size }
    }

    pub fn scene(&self) -> Scene<'_, S, Liar<S>> {
        let scene = Scene::new(&self.objects, &self.materials, &self.lights);
        let (hierarchy, volume) = (self.hierarchy, self.volume);
        Scene { hierarchy, volume, ..scene.with_sky(self.sky).with_ambient(self.ambient) }
    }

    /// Tells whether a shape of the user's has its say.
    pub fn has_a_liar(&self) -> bool {
        self.objects.iter().any(|object| matches!(object.shape, Shape::Custom(_)))
    }

    /// Answers the most rays that a ray from the eye may become: one into each mirror and through each glass, and at
    /// each surface one to each light.
    pub fn most_rays(&self) -> u64 {
        let surfaces = (1 << (u64::from(self.settings.depth) + 1)) - 1;
        surfaces * (1 + self.lights.len() as u64)
    }
}
