//! Pictures of which a pixel takes several rays.

use crate::support::{film, film_rows};
use embedded_graphics::geometry::Size;
use scanray::gallery::{Gallery, View};
use scanray::render::Quality;
use scanray::trace::{Observer, RayCounts};
use scanray::*;

/// Is a view of some objects that a camera looks straight at, a pixel of the picture one unit wide: column
/// x of row y covers x to x + 1 to the right and y to y + 1 downward.
fn flat_view<'a, S: Scalar>(
    objects: &'a [Object<S>],
    materials: &'a [Material<S>],
    [columns, rows]: [u8; 2],
) -> (Scene<'a, S>, Camera<S>) {
    let [half_width, half_height] = [columns, rows].map(|n| S::from_i32(i32::from(n)) * S::HALF);
    let eye = Vec3::new(half_width, -half_height, S::ZERO);
    let ahead = Vec3::new(half_width, -half_height, -S::ONE);
    let up = Vec3::new(S::ZERO, S::ONE, S::ZERO);
    let camera = Camera::orthographic(eye, ahead, up, half_height + half_height);
    (Scene::new(objects, materials, &[]).with_sky(Sky::Solid(Rgb::BLACK)), camera)
}

fn whites<S: Scalar>() -> [Material<S>; 1] {
    [Material::flat(Rgb::WHITE)]
}

#[test]
fn a_flat_picture_is_unchanged_to_the_bit() {
    fn check<S: Scalar>(shade: Rgb<S>) {
        let wall = Plane::new(Vec3::new(S::ZERO, S::ZERO, -S::ONE), Vec3::new(S::ZERO, S::ZERO, S::ONE));
        let (objects, materials) = ([Object::new(Shape::Plane(wall), 0)], [Material::flat(shade)]);
        let (scene, camera) = flat_view(&objects, &materials, [9, 4]);
        let check = |light: Vec<Rgb<S>>| assert!(light.iter().all(|light| *light == shade), "{light:?}");
        for n in 1..=8 {
            check(film(&scene, &camera, [9, 4], Settings::new().with_quality(Uniform(n)), &mut ()));
            check(film(&scene, &camera, [9, 4], Settings::new().with_quality(Jittered(n)), &mut ()));
            check(film(&scene, &camera, [9, 4], Settings::new().with_quality(AtEdges(Uniform(n))), &mut ()));
        }
    }
    check(Rgb::new(0.123_f32, 0.4567, 0.999));
    check(Rgb::from_f64(0.123, 0.4567, 0.999));
    check(Rgb::new(0.123_f64, 0.4567, 0.999));
}

/// Answers the shares of pixels in a row of three that a white box covers from column 1 + `covered` on.
fn shares(covered: f32, quality: impl Quality) -> Vec<f32> {
    let low = Vec3::new(1.0 + covered, -9.0, -3.0);
    let objects = [Object::new(Shape::Cuboid(Cuboid::new(low, Vec3::new(9.0, 9.0, -2.0))), 0)];
    let materials = whites();
    let (scene, camera) = flat_view(&objects, &materials, [3, 1]);
    let light = film(&scene, &camera, [3, 1], Settings::new().with_quality(quality), &mut ());
    light.iter().map(|light| light.r).collect()
}

#[test]
fn a_half_covered_pixel_is_half_as_bright() {
    for n in [2, 4, 6, 8] {
        assert_eq!(shares(0.5, Uniform(n)), [0.0, 0.5, 1.0], "{n}");
        assert_eq!(shares(0.5, Jittered(n)), [0.0, 0.5, 1.0], "{n}");
        assert_eq!(shares(0.5, AtEdges(Uniform(n))), [0.0, 0.5, 1.0], "{n}");
    }
    // Of three squares in a row one and a half is covered: the middle of the middle one decides.
    assert_eq!(shares(0.45, Uniform(3))[1], 2.0 / 3.0);
    assert_eq!(shares(0.55, Uniform(3))[1], 1.0 / 3.0);
}

/// Answers the share of the pixel in column x of row y that lies below the line `depth = rise x + start`.
fn share_below([x, y]: [f64; 2], rise: f64, start: f64) -> f64 {
    // The share of a column at x is the line's depth in the pixel cut to 0 and 1; this is its integral.
    let sum = |t: f64| {
        if t < 0.0 {
            0.0
        } else if t < 1.0 {
            t * t / 2.0
        } else {
            t - 0.5
        }
    };
    let depth = |x: f64| rise * x + start - y;
    1.0 - (sum(depth(x + 1.0)) - sum(depth(x))) / rise
}

/// Answers the largest error of a pixel's share along edges of many angles.
fn worst_share(quality: impl Quality) -> f64 {
    let materials = whites();
    let mut worst = 0.0_f64;
    for (rise, start) in
        [(0.05, 7.7), (0.2, 5.3), (0.61, 3.1), (1.0, 0.27), (1.9, -4.4), (7.3, -40.2), (-0.37, 9.9)]
    {
        // A white triangle fills all that is below the line.
        let on_line = |x: f64| Vec3::new(x, -(rise * x + start), -2.0);
        let far_below = Vec3::new(8.0, -200.0, -2.0);
        let corner = Triangle::new(on_line(-60.0), on_line(60.0), far_below);
        let objects = [Object::new(Shape::Triangle(corner), 0)];
        let (scene, camera) = flat_view(&objects, &materials, [16, 16]);
        let light = film(&scene, &camera, [16, 16], Settings::new().with_quality(quality), &mut ());
        for (i, light) in light.iter().enumerate() {
            let exact = share_below([(i % 16) as f64, (i / 16) as f64], rise, start);
            worst = worst.max((light.r - exact).abs());
        }
    }
    worst
}

#[test]
fn an_edge_of_any_angle_covers_its_share_of_each_pixel() {
    assert!(worst_share(Exact) > 0.45);
    for n in 1..=8 {
        let side = f64::from(n);
        let [uniform, jittered] = [worst_share(Uniform(n)), worst_share(Jittered(n))];
        println!("{n}: {uniform:.3} {jittered:.3} {:.3}", worst_share(AtEdges(Uniform(n))));
        assert!(uniform <= 1.0 / side, "{uniform} of {n} x {n}");
        assert!(jittered <= 2.0 / side, "{jittered} of {n} x {n}");
        assert!(worst_share(AtEdges(Uniform(n))) <= f64::max(1.0 / side, 0.125), "{n} x {n}");
    }
    assert!(worst_share(Uniform(8)) < 0.05);
}

#[test]
fn even_samples_are_the_mean_of_the_larger_picture() {
    fn check<S: Gallery>(to_f64: fn(S) -> f64, bound: f64) {
        for view in S::views() {
            let size = [30, 22];
            let large = of_view(view, size.map(|side| 3 * side), Exact, &mut ());
            let sampled = of_view(view, size, Uniform(3), &mut ());
            let mut off = 0;
            for (i, light) in sampled.iter().enumerate() {
                let corner = 3 * (i / 30) * 90 + 3 * (i % 30);
                let nine = (0..9).map(|k| large[corner + k / 3 * 90 + k % 3]);
                let mean = nine.map(|light| to_f64(light.g)).sum::<f64>() / 9.0;
                off += usize::from((to_f64(light.g) - mean).abs() > bound);
            }
            // A ray that grazes an edge may be rounded to either side.
            assert!(off * 100 <= sampled.len(), "{}: {off} of {}", view.name, sampled.len());
        }
    }
    check::<f32>(f64::from, 1e-4);
    check::<Fixed>(Fixed::to_f64, 1e-3);
    check::<f64>(|n| n, 1e-9);
}

fn of_view<S: Scalar>(
    view: &View<S>,
    size: [u32; 2],
    quality: impl Quality,
    observer: &mut impl Observer,
) -> Vec<Rgb<S>> {
    film(&view.scene, &view.camera, size, view.settings.with_quality(quality), observer)
}

#[test]
fn every_pixel_takes_as_many_rays_as_its_pattern_has() {
    for n in 1..=8 {
        for quality in [false, true] {
            let (mut rays, view) = (RayCounts::default(), &gallery::float::PLAYDATE);
            match quality {
                false => of_view(view, [33, 20], Uniform(n), &mut rays),
                true => of_view(view, [33, 20], Jittered(n), &mut rays),
            };
            assert_eq!(rays.primary, 33 * 20 * u64::from(n) * u64::from(n));
        }
    }
}

/// Answers the mean square of the differences of two pictures in levels of 8 bits.
fn error<S: Scalar>(a: &[Rgb<S>], b: &[Rgb<S>]) -> f64 {
    let levels = |light: &Rgb<S>| {
        [light.r, light.g, light.b].map(|n| f64::from(Transfer::Srgb.level(n.light_bits())) / 256.0)
    };
    let squares = a.iter().zip(b).flat_map(|(a, b)| {
        let (a, b) = (levels(a), levels(b));
        (0..3).map(move |i| (a[i] - b[i]).powi(2))
    });
    squares.sum::<f64>() / (3 * a.len()) as f64
}

/// Traces every other row of a picture of 160 x 120 pixels: rows know nothing of each other, and sixty make a mean.
fn every_other_row<S: Scalar>(
    view: &View<S>,
    quality: impl Quality,
    observer: &mut impl Observer,
) -> Vec<Rgb<S>> {
    let settings = view.settings.with_quality(quality);
    film_rows(&view.scene, &view.camera, [160, 120], (0..120).step_by(2), settings, observer)
}

/// Compares every scene, sampled at edges and everywhere, with 8 x 8 samples.
fn edges_are_nearly_as_good_as_all<S: Gallery>() {
    let (mut some, mut all) = (RayCounts::default(), RayCounts::default());
    for view in S::views() {
        let truth = every_other_row(view, Uniform(8), &mut ());
        let exact = error(&every_other_row(view, Exact, &mut ()), &truth);
        let full = error(&every_other_row(view, Uniform(3), &mut all), &truth);
        let edges = error(&every_other_row(view, AtEdges(Uniform(3)), &mut some), &truth);
        println!("{:14} {exact:7.2} {full:6.2} {edges:6.2}", view.name);
        // In squared steps of 8 bits: the errors of one ray a pixel are 20 to 140, of 3 x 3 rays 0.6 to 12.
        assert!(edges < full + 0.5, "{}: {edges} instead of {full}", view.name);
        assert!(8.0 * edges < exact, "{}: {edges}, with one ray {exact}", view.name);
    }
    println!("{some:?} of {all:?}");
    assert!(5 * some.primary < 2 * all.primary, "{some:?} of {all:?}");
}

#[test]
fn sampling_at_edges_takes_two_fifths_of_the_rays_for_nearly_the_same_picture_in_f32() {
    edges_are_nearly_as_good_as_all::<f32>();
}

#[test]
fn sampling_at_edges_takes_two_fifths_of_the_rays_for_nearly_the_same_picture_in_fixed_point() {
    edges_are_nearly_as_good_as_all::<Fixed>();
}

#[test]
fn a_picture_without_edges_takes_one_ray_a_pixel_and_a_level_edge_is_noticed() {
    let materials = whites();
    let rays = |high: f32, rows: u8| {
        let low = Vec3::new(-9.0, -90.0, -3.0);
        let objects = [Object::new(Shape::Cuboid(Cuboid::new(low, Vec3::new(99.0, -high, -2.0))), 0)];
        let (scene, camera) = flat_view(&objects, &materials, [20, rows]);
        let mut count = RayCounts::default();
        let settings = Settings::new().with_quality(AtEdges(Uniform(4)));
        let light = film(&scene, &camera, [20, u32::from(rows)], settings, &mut count);
        (count.primary, light)
    };
    // One ray each, and 16 for the first and the last pixel of each row.
    let ends = 5 * 2 * 16;
    assert_eq!(rays(-50.0, 5).0, 100 + ends);
    // Wherever in its row the edge is, that row is sampled and no other.
    for (high, share) in [(2.1, 1.0), (2.3, 0.75), (2.7, 0.25), (2.9, 0.0)] {
        let (count, light) = rays(high, 5);
        assert_eq!(count, 100 + ends + 18 * 16, "{high}");
        assert!(light[40..60].iter().all(|light| light.r == share), "{high}: {light:?}");
    }
}

#[test]
fn a_row_comes_out_the_same_in_any_order_and_in_parts() {
    fn check<Q: Quality>(quality: Q) {
        let view = &gallery::fixed::BUSINESS_CARD;
        let size = Size::new(70, 50);
        let mut workspace = Workspace::<Fixed, [u8; 2], 0, 5>::new();
        let settings = view.settings.with_quality(quality);
        let mut renderer =
            Renderer::new(&view.scene, &view.camera, size, settings, &mut workspace).expect("a good view");
        let whole = of_view(view, [70, 50], quality, &mut ());
        for y in [49, 3, 20, 21, 0] {
            for columns in [0..70, 0..1, 69..70, 11..12, 12..40, 33..71] {
                let mut row = vec![];
                renderer
                    .trace_row(y, columns.clone(), &mut (), |x, light| row.push((x, light)))
                    .expect("a row");
                assert_eq!(row.len(), columns.end.min(70) as usize - columns.start as usize);
                for (x, light) in row {
                    assert_eq!(light, whole[(y * 70 + x) as usize], "{x}, {y} of {columns:?}");
                }
            }
        }
    }
    check(Uniform(2));
    check(Jittered(3));
    check(AtEdges(Jittered(2)));
}

#[test]
fn scattered_places_turn_false_stripes_to_noise() {
    // White bars a third of a pixel wide, every 0.53 pixels: evenly spaced rays see stripes 9 pixels wide.
    let bars: Vec<Object> = (0..121_u8)
        .map(|i| {
            let left = f32::from(i) * 0.53;
            let bar = Cuboid::new(Vec3::new(left, -99.0, -3.0), Vec3::new(left + 0.265, 99.0, -2.0));
            Object::new(Shape::Cuboid(bar), 0)
        })
        .collect();
    let materials = whites();
    let (scene, camera) = flat_view(&bars, &materials, [64, 16]);
    // Means of columns, in which noise goes out and stripes remain.
    let ripple = |light: Vec<Rgb>| {
        let mean = |x: usize| (0..16).map(|y| f64::from(light[64 * y + x].r)).sum::<f64>() / 16.0;
        (0..64).map(|x| (mean(x) - 0.5).abs()).sum::<f64>() / 64.0
    };
    let even = ripple(film(&scene, &camera, [64, 16], Settings::new().with_quality(Uniform(2)), &mut ()));
    let random = ripple(film(&scene, &camera, [64, 16], Settings::new().with_quality(Jittered(2)), &mut ()));
    println!("{even} {random}");
    assert!(3.0 * random < even, "{random} of {even}");
}

#[test]
fn no_samples_and_too_many_are_refused() {
    let (materials, size) = (whites::<f32>(), Size::new(4, 4));
    let (scene, camera) = flat_view(&[], &materials, [4, 4]);
    let mut workspace = Workspace::<f32, [u8; 2], 0, 1>::new();
    for side in [0, 9, 255] {
        let settings = Settings::new().with_quality(AtEdges(Jittered(side)));
        let refused = Renderer::new(&scene, &camera, size, settings, &mut workspace).err();
        assert_eq!(refused, Some(RenderError::Samples { side, most: 8 }));
        let settings = Settings::new().with_quality(Uniform(side));
        let refused = Renderer::new(&scene, &camera, size, settings, &mut workspace).err();
        assert_eq!(refused, Some(RenderError::Samples { side, most: 8 }));
    }
    let text = RenderError::Samples { side: 9, most: 8 }.to_string();
    assert_eq!(text, "a pixel takes 1 x 1 to 8 x 8 samples, not 9 x 9");
}
