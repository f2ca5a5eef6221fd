//! Spectra become the colours that were published for them.

use scanray::spectrum::{
    A, ALUMINIUM, C, CHART, D65, MAGNESIUM_OXIDE, Spectrum, WHITE, X_BAR, Xyz, Y_BAR, Z_BAR,
};
use scanray::{Fixed, Rgb};

fn array(xyz: Xyz) -> [f64; 3] {
    [xyz.x, xyz.y, xyz.z]
}

#[track_caller]
fn assert_near(found: [f64; 3], expected: [f64; 3], bound: f64) {
    let far = found.iter().zip(expected).any(|(a, b)| (a - b).abs() > bound);
    assert!(!far, "{found:?} is not {expected:?} within {bound}");
}

fn every_fifth_nanometre() -> impl Iterator<Item = u16> {
    (380..=780).step_by(5)
}

#[test]
fn the_illuminants_have_the_colours_of_the_cie() {
    assert_near(array(D65.of_lamp()), [95.047, 100.0, 108.883], 0.01);
    assert_near(array(C.of_lamp()), [98.074, 100.0, 118.232], 0.01);
    assert_near(array(A.of_lamp()), [109.85, 100.0, 35.585], 0.01);
}

#[test]
fn illuminant_a_is_plancks_radiator_to_its_last_digit() {
    // CIE 15:2004, 3.1: 100 (560 / l)^5 (exp(1.435e7 / (2848 560)) - 1) / (exp(1.435e7 / (2848 l)) - 1).
    let radiated = |nm: f64| 1.0 / (nm.powi(5) * ((1.435e7 / (2848.0 * nm)).exp() - 1.0));
    for nm in every_fifth_nanometre() {
        let expected = 100.0 * radiated(f64::from(nm)) / radiated(560.0);
        assert!(
            (A.at(nm) - expected).abs() <= 6e-5 * expected.max(10.0),
            "{nm} nm: {}, {expected}",
            A.at(nm)
        );
    }
}

#[test]
fn the_observer_is_that_of_the_analytic_fit() {
    // C. Wyman, P.-P. Sloan and P. Shirley, JCGT 2 (2), 2013: sums of lobes that are steeper on one side.
    let lobe = |nm: f64, height: f64, mean: f64, steepness: [f64; 2]| {
        let t = (nm - mean) * steepness[usize::from(nm >= mean)];
        height * (-0.5 * t * t).exp()
    };
    for nm in every_fifth_nanometre() {
        let l = f64::from(nm);
        let x = lobe(l, 0.362, 442.0, [0.0624, 0.0374])
            + lobe(l, 1.056, 599.8, [0.0264, 0.0323])
            + lobe(l, -0.065, 501.1, [0.0490, 0.0382]);
        let y = lobe(l, 0.821, 568.8, [0.0213, 0.0247]) + lobe(l, 0.286, 530.9, [0.0613, 0.0322]);
        let z = lobe(l, 1.217, 437.0, [0.0845, 0.0278]) + lobe(l, 0.681, 459.0, [0.0385, 0.0725]);
        assert_near([X_BAR.at(nm), Y_BAR.at(nm), Z_BAR.at(nm)], [x, y, z], 0.03);
    }
}

#[test]
fn white_in_daylight_is_the_white_of_srgb_in_every_number() {
    assert_near(D65.of_lamp().linear_srgb(), [1.0; 3], 1e-3);
    let (float, fixed) = (Rgb::<f32>::from_xyz(D65.of_lamp()), Rgb::<Fixed>::from_xyz(D65.of_lamp()));
    let double = Rgb::<f64>::from_xyz(D65.of_lamp());
    assert_near([float.r, float.g, float.b].map(f64::from), [double.r, double.g, double.b], 1e-7);
    assert_near([fixed.r, fixed.g, fixed.b].map(Fixed::to_f64), [double.r, double.g, double.b], 1e-6);
}

#[test]
fn the_primaries_of_srgb_are_themselves() {
    // The columns of the other matrix of IEC 61966-2-1.
    let columns = [[41.24, 21.26, 1.93], [35.76, 71.52, 11.92], [18.05, 7.22, 95.05]];
    for (i, [x, y, z]) in columns.into_iter().enumerate() {
        let alone = std::array::from_fn(|channel| f64::from(u8::from(channel == i)));
        assert_near(Xyz { x, y, z }.linear_srgb(), alone, 5e-4);
    }
}

#[test]
fn half_of_the_light_is_half_of_the_colour_under_every_lamp() {
    let gray = Spectrum::new(0, 1, &[0.5]);
    for lamp in [A, C, D65] {
        let (half, whole) = (gray.under(&lamp), WHITE.under(&lamp));
        assert_near(array(half), array(whole).map(|part| part / 2.0), 1e-12);
        assert!((whole.y - 100.0).abs() < 1e-12);
    }
}

#[test]
fn without_light_everything_is_black() {
    assert_eq!(array(WHITE.under(&Spectrum::new(0, 1, &[]))), [0.0; 3]);
}

#[test]
fn a_cyan_beyond_the_primaries_is_left_without_red() {
    let cyan = CHART[17].reflectance.under(&D65);
    assert!(cyan.linear_srgb()[0] < -0.02);
    assert_eq!(Rgb::<f64>::from_xyz(cyan).r, 0.0);
}

#[test]
fn a_metal_and_a_ceramic_without_colour_are_grey_in_daylight() {
    for (substance, level, apart) in [(ALUMINIUM, 0.915, 0.012), (MAGNESIUM_OXIDE, 0.98, 1e-3)] {
        assert_near(substance.under(&D65).linear_srgb(), [level; 3], apart);
    }
}

#[test]
fn multiplied_lights_come_near_the_colour_under_another_lamp_as_documented() {
    let worst = |lamp: &Spectrum| {
        let light = lamp.of_lamp().linear_srgb();
        let off = CHART.iter().flat_map(|patch| {
            let (day, there) = (patch.reflectance.under(&D65), patch.reflectance.under(lamp));
            let (day, there) = (day.linear_srgb(), there.linear_srgb());
            std::array::from_fn::<_, 3, _>(|i| (day[i].max(0.0) * light[i] - there[i].max(0.0)).abs())
        });
        off.fold(0.0, f64::max)
    };
    let (daylight, lamplight) = (worst(&C), worst(&A));
    println!("C {daylight:.4}, A {lamplight:.4}");
    assert!((0.005..0.02).contains(&daylight) && (0.1..0.2).contains(&lamplight));
}
