//! The colour chart has the colours that were published for it, in numbers and in the picture.

use embedded_graphics::prelude::Size;
use scanray::gallery::Gallery;
use scanray::spectrum::{C, CHART, D65, Xyz};
use scanray::{Camera, Fixed, Object, Renderer, Rgb, Shape, Workspace};

/// Lists x, y and Y of the chart under illuminant C (McCamy, Marcus and Davidson 1976, table 1).
const MCCAMY: [[f64; 3]; 24] = [
    [0.4002, 0.3504, 0.1005],
    [0.3773, 0.3446, 0.3582],
    [0.247, 0.2514, 0.1933],
    [0.3372, 0.422, 0.1329],
    [0.2651, 0.24, 0.2427],
    [0.2608, 0.343, 0.4306],
    [0.506, 0.407, 0.3005],
    [0.211, 0.175, 0.12],
    [0.4533, 0.3058, 0.1977],
    [0.2845, 0.202, 0.0656],
    [0.38, 0.4887, 0.4429],
    [0.4729, 0.4375, 0.4306],
    [0.1866, 0.1285, 0.0611],
    [0.3046, 0.4782, 0.2339],
    [0.5385, 0.3129, 0.12],
    [0.448, 0.4703, 0.591],
    [0.3635, 0.2325, 0.1977],
    [0.1958, 0.2519, 0.1977],
    [0.3101, 0.3163, 0.9001],
    [0.3101, 0.3163, 0.591],
    [0.3101, 0.3163, 0.362],
    [0.3101, 0.3163, 0.1977],
    [0.3101, 0.3163, 0.09],
    [0.3101, 0.3163, 0.0313],
];

/// Lists the chart's levels in sRGB as its makers print them.
const PRINTED: [[u8; 3]; 24] = [
    [115, 82, 68],
    [194, 150, 130],
    [98, 122, 157],
    [87, 108, 67],
    [133, 128, 177],
    [103, 189, 170],
    [214, 126, 44],
    [80, 91, 166],
    [193, 90, 99],
    [94, 60, 108],
    [157, 188, 64],
    [224, 163, 46],
    [56, 61, 150],
    [70, 148, 73],
    [175, 54, 60],
    [231, 199, 31],
    [187, 86, 149],
    [8, 133, 161],
    [243, 243, 242],
    [200, 200, 200],
    [160, 160, 160],
    [122, 122, 121],
    [85, 85, 85],
    [52, 52, 52],
];

fn array(xyz: Xyz) -> [f64; 3] {
    [xyz.x, xyz.y, xyz.z]
}

/// Answers the levels of linear sRGB in 8 bits (IEC 61966-2-1).
fn levels(light: [f64; 3]) -> [f64; 3] {
    light.map(|light| match light.clamp(0.0, 1.0) {
        light if light <= 0.003_130_8 => 255.0 * 12.92 * light,
        light => 255.0 * (1.055 * light.powf(1.0 / 2.4) - 0.055),
    })
}

/// Answers the largest difference of a channel.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Is how far the levels may be from the makers': these measured another copy in another light and adapted
/// the colours. The blue patch is furthest, by 10.
const MAKERS: f64 = 11.0;

/// Answers X, Y and Z of x, y and Y.
fn tristimulus([x, y, luminance]: [f64; 3]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y].map(|part| 100.0 * luminance * part)
}

/// Answers L*, a* and b* (CIE 15:2004, 8.2.1) in the light of illuminant C.
fn lab([x, y, z]: [f64; 3]) -> [f64; 3] {
    let f = |t: f64| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 };
    let [fx, fy, fz] = [f(x / 98.074), f(y / 100.0), f(z / 118.232)];
    [116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)]
}

#[test]
fn the_chart_has_the_colours_that_mccamy_published_within_a_difference_of_two() {
    for (patch, published) in CHART.iter().zip(MCCAMY) {
        let (found, expected) = (lab(array(patch.reflectance.under(&C))), lab(tristimulus(published)));
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        assert!(off < 2.0, "{}: {found:?} is {off} from {expected:?}", patch.name);
    }
}

#[test]
fn the_chart_in_daylight_has_the_levels_its_makers_print() {
    let mut sum = 0.0;
    for (patch, printed) in CHART.iter().zip(PRINTED) {
        let light = patch.reflectance.under(&D65).linear_srgb();
        let (found, printed) = (levels(light), printed.map(f64::from));
        assert!(apart(found, printed) < MAKERS, "{}: {found:?} is not {printed:?}", patch.name);
        sum += found.iter().zip(printed).map(|(a, b)| (a - b).abs()).sum::<f64>();
    }
    let mean = sum / 72.0;
    assert!(mean < 3.0, "mean difference {mean}");
}

/// Answers the light that comes to the scene's eye from the middle of each patch of a face.
fn seen<S: Gallery>(face: usize) -> Vec<[f64; 3]> {
    let view = S::find("color-chart").unwrap();
    let patches = &view.scene.objects[CHART.len() * face..CHART.len() * (face + 1)];
    let look = |patch: &Object<S>| {
        let Shape::Cuboid(tile) = patch.shape else { panic!("{patch:?} is no patch") };
        let middle = (tile.low + tile.high) * S::HALF;
        // A picture of one pixel, whose ray meets what the camera looks at.
        let camera = Camera::perspective(view.camera.eye, middle, view.camera.up, S::ONE);
        let mut workspace = Workspace::<S, [u8; 2], 0, 1>::new();
        let mut renderer =
            Renderer::new(&view.scene, &camera, Size::new(1, 1), view.settings, &mut workspace).unwrap();
        let mut light = [0.0; 3];
        let take = |_, Rgb { r, g, b }: Rgb<S>| {
            light = [r, g, b].map(|light| f64::from(light.light_bits()) / 16_777_216.0)
        };
        renderer.trace_row(0, 0..1, &mut (), take).unwrap();
        light
    };
    patches.iter().map(look).collect()
}

fn check_daylight<S: Gallery>() {
    for ((patch, printed), light) in CHART.iter().zip(PRINTED).zip(seen::<S>(0)) {
        let found = levels(light);
        assert!(apart(found, printed.map(f64::from)) < MAKERS, "{}: {found:?}", patch.name);
    }
}

#[test]
fn the_picture_shows_the_daylight_wall_in_the_levels_of_the_makers() {
    check_daylight::<f64>();
    check_daylight::<f32>();
    check_daylight::<Fixed>();
}

#[test]
fn the_picture_shows_the_floor_in_the_colours_of_mccamy() {
    let expected = MCCAMY.map(|published| {
        let [x, y, z] = tristimulus(published);
        levels(Xyz { x, y, z }.linear_srgb())
    });
    let found: Vec<_> = seen::<f64>(2).into_iter().map(levels).collect();
    let right =
        found.iter().zip(expected).filter(|(found, expected)| apart(**found, *expected) < 8.0).count();
    // The ball and its shadow are over the others.
    assert!(right >= 18, "{right} of 24: {found:?}");
}
