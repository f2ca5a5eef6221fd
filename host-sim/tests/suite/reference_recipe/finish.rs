//! What things are made of.

use super::form::Form;
use super::number::{Maker, Triple, number, triple};
use embedded_graphics::image::ImageRaw;
use embedded_graphics::pixelcolor::Rgb888;
use proptest::prelude::*;
use scanray::{
    Bitmap, Bump, Checker, CookTorrance, Filter, Fresnel, Glass, Image, Material, Model, Rgb, Rings, Scalar,
    Stripes, Texture, Vertices,
};

/// Is 4 x 3 colours without order; as heights they are hills, as normals a crumpled sheet.
static CARPET: ImageRaw<Rgb888> = ImageRaw::new(
    &[
        90, 10, 200, 150, 60, 250, 128, 128, 255, 30, 200, 180, // the upper row
        128, 220, 190, 255, 130, 160, 100, 90, 230, 140, 20, 210, //
        60, 160, 240, 128, 40, 128, 200, 100, 220, 110, 250, 190,
    ],
    4,
);

#[derive(Clone, Debug)]
enum Pattern {
    Solid,
    Checker(f64),
    Stripes([f64; 2]),
    Rings([f64; 2], f64),
    Image([f64; 2], Filter),
    /// The third corner's colour; only triangles have corners.
    Corners(Triple),
}

#[derive(Clone, Debug)]
enum Relief {
    Heights([f64; 2], f64),
    Normals([f64; 2]),
}

#[derive(Clone, Debug)]
enum Sheen {
    Flat,
    Phong,
    BlinnPhong,
    CookTorrance(f64, f64),
}

#[derive(Clone, Debug)]
struct Pane {
    /// Share of what the mirror leaves.
    clear: f64,
    index: f64,
    fresnel: Fresnel,
    absorption: Triple,
}

#[derive(Clone, Debug)]
pub struct Finish {
    colors: [Triple; 2],
    pattern: Pattern,
    relief: Option<Relief>,
    sheen: Sheen,
    specular: f64,
    shininess: u16,
    mirror: f64,
    pane: Option<Pane>,
}

fn pair(low: f64, high: f64) -> impl Strategy<Value = [f64; 2]> + Clone {
    [number(low, high), number(low, high)]
}

fn pattern() -> impl Strategy<Value = Pattern> {
    let filter = prop_oneof![Just(Filter::Nearest), Just(Filter::Bilinear)];
    prop_oneof![
        6 => Just(Pattern::Solid),
        2 => number(0.5, 3.0).prop_map(Pattern::Checker),
        1 => pair(-3.0, 3.0).prop_map(Pattern::Stripes),
        1 => (pair(-1.0, 1.0), number(0.5, 3.0)).prop_map(|(center, per_unit)| Pattern::Rings(center, per_unit)),
        2 => (pair(-2.0, 2.0), filter).prop_map(|(tiles, filter)| Pattern::Image(tiles, filter)),
        1 => triple(0.0, 1.0).prop_map(Pattern::Corners),
    ]
}

fn relief() -> impl Strategy<Value = Option<Relief>> {
    prop_oneof![
        6 => Just(None),
        1 => (pair(-2.0, 2.0), number(-0.25, 0.25)).prop_map(|(tiles, height)| Some(Relief::Heights(tiles, height))),
        1 => pair(-2.0, 2.0).prop_map(|tiles| Some(Relief::Normals(tiles))),
    ]
}

fn sheen() -> impl Strategy<Value = Sheen> {
    prop_oneof![
        1 => Just(Sheen::Flat),
        5 => Just(Sheen::Phong),
        2 => Just(Sheen::BlinnPhong),
        2 => (number(0.25, 1.0), number(1.0, 4.0)).prop_map(|(roughness, index)| Sheen::CookTorrance(roughness, index)),
    ]
}

fn pane() -> impl Strategy<Value = Option<Pane>> {
    let fresnel = prop_oneof![Just(Fresnel::None), Just(Fresnel::Schlick), Just(Fresnel::Exact)];
    let pane = (number(0.0, 1.0), number(0.75, 2.0), fresnel, triple(0.0, 1.0))
        .prop_map(|(clear, index, fresnel, absorption)| Some(Pane { clear, index, fresnel, absorption }));
    prop_oneof![3 => Just(None), 1 => pane]
}

pub fn finish() -> impl Strategy<Value = Finish> {
    let colors = [triple(0.0, 1.0), triple(0.0, 1.0)];
    let shine = (number(0.0, 1.0), 1_u16..80, number(-0.5, 0.9));
    (colors, pattern(), relief(), sheen(), shine, pane()).prop_map(
        |(colors, pattern, relief, sheen, (specular, shininess, mirror), pane)| {
            // Below 0 is none: a third of all.
            let mirror = mirror.max(0.0);
            // A bumpy normal may bend a ray out of glass that it has not gone into.
            let relief = relief.filter(|_| pane.is_none());
            Finish { colors, pattern, relief, sheen, specular, shininess, mirror, pane }
        },
    )
}

impl Finish {
    pub fn is_glass(&self) -> bool {
        self.pane.is_some()
    }

    pub fn without_glass(&self) -> Self {
        Self { pane: None, ..self.clone() }
    }
}

impl<S: Scalar> Maker<S> {
    fn image(&self, tiles: [f64; 2]) -> Image<S> {
        let [u, v] = tiles.map(self.0);
        Image::new(Bitmap::new(&CARPET)).with_tiles(u, v)
    }

    fn texture(&self, finish: &Finish, form: &Form) -> Texture<S> {
        let [even, odd] = finish.colors.map(|color| self.color(color));
        match finish.pattern {
            Pattern::Checker(tiles) => Texture::Checker(Checker::new(even, odd, self.0(tiles))),
            Pattern::Stripes(tiles) => Texture::Stripes(Stripes::new(even, odd, tiles.map(self.0))),
            Pattern::Rings(center, tiles) => {
                Texture::Rings(Rings::new(even, odd, center.map(self.0), self.0(tiles)))
            }
            Pattern::Image(tiles, filter) => Texture::Image(self.image(tiles).with_filter(filter)),
            Pattern::Corners(third) if matches!(form, Form::Triangle(_)) => {
                Texture::Vertices(Vertices::new(even, odd, self.color(third)))
            }
            Pattern::Solid | Pattern::Corners(_) => Texture::Solid(even),
        }
    }

    fn model(&self, sheen: &Sheen) -> Model<S> {
        match *sheen {
            Sheen::Flat => Model::Flat,
            Sheen::Phong => Model::Phong,
            Sheen::BlinnPhong => Model::BlinnPhong,
            Sheen::CookTorrance(roughness, index) => {
                Model::CookTorrance(CookTorrance::new(self.0(roughness), self.0(index)))
            }
        }
    }

    fn glass(&self, pane: &Pane, mirror: f64) -> Glass<S> {
        Glass::new(self.0(pane.clear * (1.0 - mirror)), self.0(pane.index))
            .with_fresnel(pane.fresnel)
            .with_absorption(self.color(pane.absorption))
    }

    pub fn material(&self, finish: &Finish, form: &Form) -> Material<S> {
        let mut material = Material::textured(self.texture(finish, form))
            .with_model(self.model(&finish.sheen))
            .with_specular(Rgb::gray(self.0(finish.specular)), finish.shininess)
            .with_mirror(self.0(finish.mirror));
        if let Some(relief) = &finish.relief {
            material = material.with_bump(match *relief {
                Relief::Heights(tiles, height) => Bump::heights(self.image(tiles), self.0(height)),
                Relief::Normals(tiles) => Bump::normals(self.image(tiles)),
            });
        }
        match &finish.pane {
            Some(pane) => material.with_glass(self.glass(pane, finish.mirror)),
            None => material,
        }
    }
}
