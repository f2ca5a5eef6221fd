//! What scenes borrow for ever, made once: outlines, meshes, fields, images.

use super::dice::Dice;
use super::hierarchies::{astray, sound};
use super::values::Values;
use host_sim::bake::Bounds;
use host_sim::rounded::Rounded;
use scanray::accel::Hierarchy;
use scanray::{Bitmap, Class, Corners, Grid, Mesh, Normals, Scalar, Texels, Vec3, Vertex, Volume, Voxels};

/// Is how many of each there are.
const STOCK: usize = 600;

/// Holds a stock of everything that is borrowed.
pub struct Shelf<S: Scalar> {
    pub bitmaps: &'static [Bitmap],
    pub faces: Vec<&'static [Bitmap; 6]>,
    pub outlines: Vec<&'static [Vec3<S>]>,
    pub facets: Vec<&'static [Vertex<S>; 3]>,
    pub meshes: Vec<&'static Mesh<S>>,
    pub grids: Vec<&'static Grid<S>>,
    pub volumes: Vec<&'static Volume<S>>,
    pub hierarchies: Vec<&'static dyn Hierarchy<S>>,
}

/// Is an image of any size, in colours of its own.
struct Noise([u32; 2]);

impl Texels for Noise {
    fn size(&self) -> [u32; 2] {
        self.0
    }

    fn texel(&self, column: u32, row: u32) -> [u8; 3] {
        let level = column.wrapping_mul(97) ^ row.wrapping_mul(193);
        [level as u8, (level >> 3) as u8, (level >> 5) as u8]
    }
}

static NOISE: [Noise; 8] = [
    Noise([1, 1]),
    Noise([1, 2]),
    Noise([2, 1]),
    Noise([16, 9]),
    Noise([2048, 1]),
    Noise([2048, 2048]),
    Noise([0, 5]),
    Noise([2049, u32::MAX]),
];

static BITMAPS: [Bitmap; 120] = {
    // Each sound one comes more than once, so that most scenes have none of the others.
    let mut bitmaps = [Bitmap::new(&NOISE[3]); 120];
    let mut place = 0;
    while place < NOISE.len() {
        bitmaps[place] = Bitmap::new(&NOISE[place]);
        place += 1;
    }
    bitmaps
};

fn stock<S: Rounded, T>(dice: &mut Dice, make: fn(&mut Values<S>) -> T) -> Vec<T> {
    (0..STOCK).map(|_| make(&mut Values::new(Dice::of(dice.bits())))).collect()
}

fn faces<S: Rounded>(values: &mut Values<S>) -> &'static [Bitmap; 6] {
    Box::leak(Box::new([0; 6].map(|_| values.dice.pick(&BITMAPS))))
}

/// Answers an outline, most of them in a plane across an axis.
fn outline<S: Rounded>(values: &mut Values<S>) -> &'static [Vec3<S>] {
    let count = values.dice.pick(&[2, 3, 3, 4, 4, 5, 6, 9]);
    let (axis, height) = (values.dice.below(4), values.length());
    let corner = |_| {
        let mut corner = values.point().to_array();
        if let Some(across) = corner.get_mut(axis) {
            *across = height;
        }
        Vec3::from_array(corner)
    };
    (0..count).map(corner).collect::<Vec<_>>().leak()
}

/// Answers three corners whose normals look to about the triangle's outward side.
fn facet<S: Rounded>(values: &mut Values<S>) -> &'static [Vertex<S>; 3] {
    let [a, b, c] = [values.point(), values.point(), values.point()];
    let face = (b - a).cross(c - a).normalize().map(|(unit, _)| unit);
    let vertex = |point| {
        let lean = values.direction() * S::HALF;
        let normal = face.and_then(|face| (face + lean).normalize()).map_or(lean, |(unit, _)| unit);
        Vertex::new(point, normal, values.place())
    };
    Box::leak(Box::new([a, b, c].map(vertex)))
}

/// Answers the box around a triangle's corners as they were rounded, if they are numbers.
fn bounds<S: Rounded>(places: &[Vec3<S>], triangle: [u16; 3], plain: fn(S) -> f64) -> Option<Bounds> {
    let corners: Option<Vec<_>> = triangle.iter().map(|corner| places.get(usize::from(*corner))).collect();
    let corners: Vec<[f64; 3]> = corners?.iter().map(|place| place.to_array().map(plain)).collect();
    let usable = corners.iter().flatten().all(|value| value.is_finite());
    usable.then(|| Bounds::around(corners))
}

/// Answers about what a number is, from its comparisons: numbers need not tell it.
fn plain<S: Rounded>(value: S) -> f64 {
    if !value.in_range() {
        return f64::NAN;
    }
    let mut scale = S::ONE;
    let mut exponent = 0;
    while value.abs() > scale {
        scale = scale + scale;
        exponent += 1;
    }
    let (mut low, mut high) = (-2_f64.powi(exponent), 2_f64.powi(exponent));
    for _ in 0..60 {
        let middle = (low + high) * 0.5;
        if S::round(middle) <= value { low = middle } else { high = middle }
    }
    low
}

fn corners<S: Rounded>(values: &mut Values<S>, places: &[Vec3<S>]) -> Corners<S> {
    if !values.dice.one_in(3) {
        return Corners::Exact(places.to_vec().leak());
    }
    let steps = places.iter().map(|_| [0; 3].map(|_: u16| values.dice.bits() as u16));
    let steps = steps.collect::<Vec<_>>().leak();
    Corners::Quantized { low: values.point(), sides: values.point(), steps }
}

fn normals<S: Rounded>(values: &mut Values<S>, corners: usize) -> Normals<S> {
    match values.dice.below(3) {
        0 => Normals::Flat,
        1 => Normals::Exact((0..corners).map(|_| values.direction()).collect::<Vec<_>>().leak()),
        _ => {
            let point = |_| [values.dice.bits() as i16, values.dice.pick(&[0, i16::MIN, i16::MAX, 77])];
            Normals::Octahedral((0..corners).map(point).collect::<Vec<_>>().leak())
        }
    }
}

fn mesh<S: Rounded>(values: &mut Values<S>) -> &'static Mesh<S> {
    let places: Vec<Vec3<S>> = (0..1 + values.dice.below(8)).map(|_| values.point()).collect();
    let named = places.len() + usize::from(values.dice.one_in(10));
    let count = values.dice.below(12);
    let triangles = (0..count).map(|_| [0; 3].map(|_: u16| values.dice.below(named) as u16));
    let triangles = triangles.collect::<Vec<_>>().leak();
    let boxes: Option<Vec<_>> = triangles.iter().map(|corners| bounds(&places, *corners, plain)).collect();
    let hierarchy = match boxes {
        Some(boxes) if !values.dice.one_in(20) => sound(values, &boxes),
        _ => astray(values),
    };
    let (corners, normals) = (corners(values, &places), normals(values, places.len()));
    let mesh = Mesh::new(triangles, corners, normals, hierarchy);
    let textured = values.dice.one_in(2);
    let texture: Vec<[S; 2]> = places.iter().map(|_| values.place()).collect();
    Box::leak(Box::new(if textured { mesh.with_texture(texture.leak()) } else { mesh }))
}

fn grid<S: Rounded>(values: &mut Values<S>) -> &'static Grid<S> {
    let sides = [0; 3].map(|_| values.dice.pick(&[2, 2, 3, 4, 5, 6, 9]));
    let count = sides.iter().map(|side| usize::from(*side)).product::<usize>();
    let level = |dice: &mut Dice| dice.pick(&[0, 0, 0, 1, 100, 128, 254, 255]);
    let bytes: Vec<u8> = (0..count).map(|_| level(&mut values.dice)).collect();
    let sides = if values.dice.one_in(20) { [values.dice.pick(&[0, 1, 1025, u16::MAX]); 3] } else { sides };
    let mut voxels = Voxels::new(sides, bytes.leak());
    if values.dice.one_in(3) {
        // Now and then they say what is not so: cells are left out, and nothing else.
        let blocks = voxels.block_sides().iter().map(|side| usize::from(*side)).product::<usize>().min(1000);
        voxels =
            voxels.with_blocks((0..2 * blocks).map(|_| level(&mut values.dice)).collect::<Vec<_>>().leak());
    }
    let spacing = Vec3::new(values.between(0.01, 1.0), values.between(0.01, 1.0), values.between(0.01, 1.0));
    Box::leak(Box::new(Grid::new(voxels, values.point(), spacing)))
}

fn classes<S: Rounded>(values: &mut Values<S>) -> &'static [Class<S>] {
    let mut levels: Vec<u8> = (0..values.dice.below(5)).map(|_| values.dice.bits() as u8).collect();
    if !values.dice.one_in(8) {
        levels.sort_unstable();
        levels.dedup();
    }
    let opacities = [0, 1, 128, 255];
    let class = |value| Class::new(value, values.color(), values.dice.pick(&opacities));
    levels.into_iter().map(class).collect::<Vec<_>>().leak()
}

fn volume<S: Rounded>(values: &mut Values<S>) -> &'static Volume<S> {
    use scanray::{Gradient, Reconstruction};
    let volume = Volume::new(*grid(values), classes(values), values.between(0.0, 50.0))
        .with_reconstruction(values.dice.pick(&[Reconstruction::Nearest, Reconstruction::Trilinear]))
        .with_samples(values.dice.pick(&[0, 1, 1, 1, 2, 255]))
        .with_gradient(values.dice.pick(&[Gradient::First, Gradient::Second]));
    Box::leak(Box::new(volume.with_faintest(values.between(0.0, 0.01))))
}

/// Answers a hierarchy over a few boxes that need not be those of any scene.
fn hierarchy<S: Rounded>(values: &mut Values<S>) -> &'static dyn Hierarchy<S> {
    if values.dice.one_in(3) {
        return astray(values);
    }
    let count = values.dice.below(4);
    let corners =
        |values: &mut Values<S>| [values.point(), values.point()].map(|place| place.to_array().map(plain));
    let corners: Vec<_> = (0..count).map(|_| corners(values)).collect();
    let usable = corners.as_flattened().as_flattened().iter().all(|value| value.is_finite());
    let boxes = usable.then(|| corners.into_iter().map(Bounds::around).collect::<Vec<_>>());
    match boxes {
        Some(boxes) => sound(values, &boxes),
        None => astray(values),
    }
}

impl<S: Rounded> Shelf<S> {
    pub fn stocked(dice: &mut Dice) -> Self {
        Self {
            bitmaps: &BITMAPS,
            faces: stock::<S, _>(dice, faces),
            outlines: stock(dice, outline),
            facets: stock(dice, facet),
            meshes: stock(dice, mesh),
            grids: stock(dice, grid),
            volumes: stock(dice, volume),
            hierarchies: stock(dice, hierarchy),
        }
    }
}
