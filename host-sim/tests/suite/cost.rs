//! What pixels cost: counted by the core itself, drawn as a map, told in words.

use crate::desk::{Desk, assert_refused, read, stdout};
use host_sim::bench::{Chip, Row, Snapshot, account};
use host_sim::cost::{Account, Bill, Map, What, bars, count, dearest, heat};
use host_sim::explain::Names;
use host_sim::growth::{Operations, Tally};
use host_sim::picture::trace;
use host_sim::scenes;
use host_sim::shot::{Picture, Shot};
use scanray::Scalar;
use scanray::trace::RayCounts;

const SIZE: [u32; 2] = [40, 30];

fn counted(scene: &str) -> Map {
    let shot = Shot { size: SIZE, ..Shot::new(scenes::find(scene).unwrap()) };
    count(&shot, |_| {}).expect("the gallery can be counted")
}

#[test]
fn the_map_has_every_ray_of_the_picture() {
    for scene in scenes::all() {
        let view = scene.double;
        let rays = trace(view, view.settings, SIZE, |_| {}).expect("the gallery can be drawn").rays;
        let map = counted(view.name);
        let sum = |of: fn(&RayCounts) -> u64| map.pixels.iter().map(|bill| of(&bill.rays)).sum::<u64>();
        let counts = [sum(|r| r.primary), sum(|r| r.shadow), sum(|r| r.reflection), sum(|r| r.refraction)];
        assert_eq!(counts, [rays.primary, rays.shadow, rays.reflection, rays.refraction], "{}", view.name);
    }
}

#[test]
fn a_pixel_that_no_shape_can_reach_costs_the_exposure_of_the_sky() {
    let map = counted("orthographic");
    let rays = RayCounts { primary: 1, ..RayCounts::default() };
    let operations = Operations { products: 3, ..Operations::default() };
    let nothing = Bill { rays, operations, ..Bill::default() };
    assert!(map.pixels.contains(&nothing), "{:?}", map.pixels[0]);
}

#[test]
fn every_ray_through_glass_and_every_light_is_paid_for() {
    let map = counted("glass");
    let plain = map
        .pixels
        .iter()
        .filter(|bill| bill.rays.total() == 1 && bill.shapes > 0)
        .min_by_key(|bill| bill.shapes);
    let glass = map.pixels.iter().max_by_key(|bill| bill.rays.refraction).unwrap();
    let per_ray = glass.operations.total() / glass.rays.total();
    assert!(glass.rays.refraction > 5 && per_ray > 20, "{glass:?}");
    assert!(plain.is_none_or(|plain| plain.operations.total() < glass.operations.total()), "{plain:?}");
    // Whatever bounces may meet any of the seven objects.
    assert!(glass.shapes >= 7 * (glass.rays.reflection + glass.rays.refraction), "{glass:?}");
}

#[test]
fn operations_are_counted_by_kind() {
    let (a, b) = (Tally::from_i32(3), Tally::HALF);
    let before = Tally::by_kind();
    let _ = (a * b + Tally::ONE - a.ratio(b) - Scalar::sqrt(a)).exp_neg() - b.recip();
    let expected = Operations { sums: 4, products: 1, quotients: 2, roots: 1, powers: 1 };
    assert_eq!(Tally::by_kind() - before, expected);
    assert_eq!(expected.total(), 9);
}

fn map_of(rays: &[u64]) -> Map {
    let bill =
        |rays: &u64| Bill { rays: RayCounts { primary: *rays, ..RayCounts::default() }, ..Bill::default() };
    Map { size: [rays.len() as u32, 1], pixels: rays.iter().map(bill).collect(), rows: vec![Bill::default()] }
}

#[test]
fn a_histogram_counts_every_pixel_once() {
    let map = map_of(&[0, 1, 1, 23, 24, 100]);
    let text = bars(&map, What::Rays);
    let counts = text.lines().skip(1).map(|line| {
        let share = line.split(" %").next().unwrap().split_whitespace().rev().nth(1).unwrap();
        share.parse::<usize>().unwrap()
    });
    assert_eq!(counts.sum::<usize>(), 6, "{text}");
    assert!(text.lines().nth(1).unwrap().contains("0 to 8"), "{text}");
    assert!(text.lines().last().unwrap().contains("99 to 107"), "{text}");
}

#[test]
fn the_dearest_pixels_come_first() {
    let names = Names::of(&scenes::find("simple").unwrap());
    let text = dearest(&map_of(&[3, 9, 1, 9, 4]), What::Rays, &names, 3);
    let pixels: Vec<_> = text.lines().skip(1).map(|line| line.split_whitespace().next().unwrap()).collect();
    assert_eq!(pixels, ["1,0", "3,0", "4,0"]);
}

#[test]
fn nothing_is_dark_and_the_dearest_is_bright() {
    let map = map_of(&[0, 5, 10]);
    let page = heat(&map, What::Rays, &Picture::filled([3, 1], [9; 3]));
    // The ends of viridis, as its authors published them.
    let has = |color: [u8; 3]| page.pixels.iter().filter(|pixel| **pixel == color).count();
    assert!(has([68, 1, 84]) >= 4 && has([253, 231, 37]) >= 4 && has([9; 3]) >= 12);
}

#[test]
fn a_scene_is_counted_on_the_command_line() {
    let desk = Desk::new("cost");
    for what in ["rays", "shapes", "operations"] {
        let output = desk.run(&format!("cost glass --size 64x48 --what {what} -o {what}.png"));
        assert!(output.status.success(), "{output:?}");
        let text = stdout(&output);
        for word in ["refracted a pixel", "roots", "asked a pixel", "glass splits it", what, "###"] {
            assert!(text.contains(word), "no {word:?} in {text}");
        }
        assert_eq!(read(&desk.0.join(format!("{what}.png"))).1, [2 * 128 + 36, 26 + 96 + 62]);
    }
    assert!(desk.run("cost --size 8x8").status.success());
    assert_eq!(desk.files(), ["operations.png", "rays.png", "shapes.png", "simple-cost.png"]);
}

#[test]
fn what_a_chip_executes_stands_beside_the_rest() {
    let names = Names::of(&scenes::find("simple").unwrap());
    let mut map = map_of(&[3, 9]);
    assert!(!dearest(&map, What::Rays, &names, 2).contains("instructions"));
    map.charge(&Account { rows: vec![77], pixels: vec![20, 10] });
    assert_eq!(map.rows[0].instructions, Some(77));
    let text = dearest(&map, What::Instructions, &names, 2);
    let pixels: Vec<_> = text.lines().skip(1).map(|line| line.split_whitespace().next().unwrap()).collect();
    assert!(pixels == ["0,0", "1,0"] && text.contains("instructions") && text.contains(" 20 "), "{text}");
}

#[test]
#[ignore = "needs qemu-system-arm and the target thumbv7em-none-eabihf (run by .ci/run)"]
fn the_rows_of_a_chip_add_up_to_the_picture_that_the_bench_measures() {
    let (chip, scene) = (Chip::find("m4f").unwrap(), scenes::find("three-spheres").unwrap());
    let Account { rows, pixels } = account(chip, &scene, scene.double.settings.depth).unwrap();
    let kept = Snapshot::read().unwrap();
    let is_same = |row: &&Row| row.scene == scene.name() && row.chip == chip.name && row.mode == "exact";
    let whole = kept.0.iter().find(is_same).unwrap().instr_per_px;
    // The same scene as source of its own is laid out otherwise in flash, and the bench begins its picture as well.
    let drawn = rows.iter().sum::<u64>() as f64 / pixels.len() as f64;
    assert!((drawn / whole - 1.0).abs() < 0.03, "{drawn} of {whole}");
    // The sky is above; the mirror is in the middle of the picture.
    let [sky, mirror] = [pixels[10], pixels[120 * 320 + 160]];
    assert!(3 * sky < mirror && rows[0] < rows[120], "{sky} {mirror}");
}

#[test]
fn what_cannot_be_counted_is_refused_with_a_way_out() {
    let desk = Desk::new("cost-wrong");
    assert_refused(&desk, "cost simpel", &["did you mean 'simple'"]);
    assert_refused(&desk, "cost --what time", &["rays", "operations"]);
    assert_refused(&desk, "cost --what instructions", &["--chip"]);
    assert_refused(&desk, "cost --chip m4f --size 8x8", &["--size"]);
    assert_refused(&desk, "cost --chip z80", &["m4f, m3, m0+"]);
    assert_refused(&desk, "cost --size 8x8 -o no/such/place.png", &["no/such/place.png", "-o"]);
}
