//! The z-buffer against the reference, and `scanray approaches` as a user meets it.

use embedded_graphics_core::geometry::Size;
use host_sim::compare::Comparison;
use host_sim::scenes;
use host_sim::shot::{Approach, Number, Shot};
use scanray::gallery::{Gallery, View};
use scanray::{RasterRenderer, RasterWorkspace, Rgb};
use std::process::Command;

/// Is what two exact calculations may differ by.
const FORMULAS: f64 = 1e-9;

/// Answers the linear light that the z-buffer finds, `None` for a scene that it does not know.
fn rasterized(view: &View<f64>) -> Option<Vec<Rgb<f64>>> {
    let [columns, rows] = view.size;
    let mut workspace = RasterWorkspace::<f64, 320>::new();
    let size = Size::new(columns, rows);
    let mut renderer =
        RasterRenderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace).ok()?;
    let mut light = vec![];
    for y in 0..rows {
        renderer.shade_row(y, &mut (), |_, found| light.push(found)).ok()?;
    }
    Some(light)
}

/// A pixel is compared where the reference sees every light arrive: what a surface turns away from, and what lies
/// in shadow, it does not tell apart.
#[test]
fn in_f64_it_has_the_light_of_the_reference_where_nothing_is_shadowed_or_mirrored() {
    let (mut scenes, mut compared) = (0, 0);
    for view in f64::views() {
        let Some(light) = rasterized(view) else { continue };
        scenes += 1;
        let settings = view.settings.with_depth(0);
        let truth = Comparison::trace(view, settings, view.size, |_| {}).expect("the reference knows it");
        let lights = view.scene.lights.len();
        let clear = |i: &usize| {
            let all = truth.reference.trails[*i].iter().all(|stop| stop.lights == vec![true; lights]);
            all && !truth.mask[*i]
        };
        let pixels: Vec<usize> = (0..light.len()).filter(clear).collect();
        let off = |i: &usize| {
            let (found, truth) = (light[*i], truth.reference.light[*i].0);
            let channels = [found.r, found.g, found.b].into_iter().zip(truth);
            channels.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let worst = pixels.iter().map(off).fold(0.0, f64::max);
        println!("{}: {worst:e} in {} pixels", view.name, pixels.len());
        assert!(worst <= FORMULAS, "{}: off by {worst}", view.name);
        compared += pixels.len();
    }
    // In the scene of spots hardly a pixel is lit by all.
    assert!(compared > 100_000, "only {compared} pixels are compared");
    assert!(scenes >= 10, "the z-buffer knows {scenes} scenes only");
}

#[test]
fn a_shot_can_be_taken_by_either_approach() {
    let shot =
        Shot { size: [48, 36], ..Shot::new(scenes::find("z-buffer").expect("a scene of the gallery")) };
    for number in [Number::F32, Number::Fixed, Number::Exact] {
        let by = |approach| Shot { number, approach, ..shot }.take(|_| {}).expect("it can be drawn");
        let (traced, rasterized) = (by(Approach::Trace), by(Approach::Raster));
        assert!(traced.rays.is_some() && traced.fragments.is_none());
        assert!(rasterized.rays.is_none() && rasterized.fragments >= Some(48 * 36));
        let same = traced.picture.pixels.iter().zip(&rasterized.picture.pixels).filter(|(a, b)| a == b);
        let same = same.count();
        assert!((48 * 36 / 2..48 * 36).contains(&same), "shadows, and nothing else: {same} alike");
    }
}

#[test]
fn the_command_draws_both_side_by_side_and_tells_what_each_has_done() {
    let desk = std::env::temp_dir().join(format!("scanray-approaches-{}", std::process::id()));
    std::fs::create_dir_all(&desk).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_scanray"));
    let output = command.args(["approaches", "--size", "60x40"]).current_dir(&desk).output().unwrap();
    let size = image::image_dimensions(desk.join("z-buffer-approaches.png")).unwrap();
    std::fs::remove_dir_all(&desk).unwrap();
    assert!(output.status.success(), "{output:?}");
    assert_eq!(size, (2 * 60 + 12, 40 + 18));
    let text = String::from_utf8(output.stdout).unwrap();
    for word in ["2,400 rays from the eye", "depths tested", "no ray at all", "z-buffer-approaches.png"] {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
}
