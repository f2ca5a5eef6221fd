//! Every scene of the gallery, in every number, against the reference.

use host_sim::compare::{Comparison, Figures, Subject};
use host_sim::panel::Panel;
use host_sim::picture::{Film, trace};
use host_sim::reference::Vector;
use host_sim::scenes::HostNumber;
use scanray::gallery::{Gallery, View};
use scanray::{AtEdges, Fixed, Quality, Rgb, Scalar, Shape, Uniform};
use std::sync::LazyLock;

/// Answers what two exact calculations of a picture may differ by.
///
/// Where two triangles of a mesh meet either may be the one that is met: each reaches 1/65536 beyond its edges, and
/// along an edge that is not flat the one is that much nearer.
fn formulas(view: &View<f64>) -> f64 {
    let meshes = view.scene.objects.iter().any(|object| matches!(object.shape, Shape::Mesh(_)));
    if meshes { 1e-6 } else { 1e-9 }
}

static COMPARISONS: LazyLock<Vec<Comparison>> = LazyLock::new(|| {
    let compare = |view: &View<f64>| Comparison::trace(view, view.settings, view.size, |_| {});
    f64::views().iter().map(compare).collect::<Result<_, _>>().expect("the reference knows the gallery")
});

fn film<S: Gallery + HostNumber>(view: &View<S>) -> Film<S> {
    trace(view, view.settings, view.size, |_| {}).expect("the gallery can be drawn")
}

fn figures<S: Gallery + HostNumber>(number: &str) -> Vec<Figures> {
    let figure = |(view, comparison): (&View<S>, &Comparison)| {
        let subject = Subject { scene: view.name, number, panel: Panel::Rgb888 };
        let figures = comparison.figures(subject, &film(view));
        println!("{figures:?}");
        figures
    };
    S::views().iter().zip(&*COMPARISONS).map(figure).collect()
}

#[track_caller]
fn assert_figures<S: Gallery + HostNumber>(number: &str, least_db: f64, most_over_8: f64) {
    for figures in figures::<S>(number) {
        assert!(figures.psnr_db >= least_db, "{figures:?}");
        assert!(figures.over_8 <= most_over_8, "{figures:?}");
        // A mask over everything would hide everything.
        assert!(figures.silhouette < 0.5, "{figures:?}");
    }
}

#[test]
fn every_scene_in_f64_has_the_light_of_the_reference_away_from_silhouettes() {
    for (view, comparison) in f64::views().iter().zip(&*COMPARISONS) {
        let off = comparison.light_difference(&film(view));
        println!("{}: {off:?}", view.name);
        assert!(off.value <= formulas(view), "{}: {off:?}", view.name);
    }
}

#[test]
fn every_scene_in_f32_is_within_60_db_and_one_pixel_in_2000_of_the_reference() {
    assert_figures::<f32>("f32", 60.0, 0.0005);
}

#[test]
fn every_scene_in_fixed_point_is_within_40_db_and_one_pixel_in_200_of_the_reference() {
    assert_figures::<Fixed>("fixed", 40.0, 0.005);
}

/// Answers how many levels of a channel two shown ones lie apart, of `top`.
fn levels_apart(a: u8, b: u8, top: u32) -> u32 {
    (u32::from(a.abs_diff(b)) * top + 127) / 255
}

/// Answers for each channel away from silhouettes how many of the panel's levels it is off.
fn levels_off(comparison: &Comparison, view: &View<f64>, film: &Film<f64>, panel: Panel) -> Vec<u32> {
    let tops = match panel {
        Panel::Rgb565 => [31, 63, 31],
        Panel::Rgb666 => [63; 3],
        Panel::Rgb888 | Panel::Gray8 => [255; 3],
        Panel::Gray4 => [15; 3],
        Panel::Mono => [1; 3],
    };
    let shown = film.on_panel(panel, view.settings.transfer, view.settings.dither);
    let pairs = shown.iter().zip(comparison.on_panel(panel)).zip(&comparison.mask);
    let clear = pairs.filter(|(_, masked)| !**masked).map(|(pair, _)| pair);
    clear.flat_map(|(a, b)| (0..3).map(move |i| levels_apart(a[i], b[i], tops[i]))).collect()
}

#[test]
fn every_panel_shows_the_light_of_the_reference_within_one_level_and_nearly_always_the_same() {
    for (view, comparison) in f64::views().iter().zip(&*COMPARISONS) {
        let film = film(view);
        for panel in Panel::ALL {
            let off = levels_off(comparison, view, &film, panel);
            let different = off.iter().filter(|levels| **levels > 0).count();
            let what = format!("{} on {}: {different} of {} channels", view.name, panel.name(), off.len());
            println!("{what}");
            assert!(off.iter().all(|levels| *levels <= 1), "{what} and one by more than a level");
            // Light that is a level and a threshold to the last digit may go either way.
            assert!(different * 100 <= off.len(), "{what}");
        }
    }
}

/// Is how many rays a side of a pixel takes.
const SIDE: u8 = 3;

/// Answers the size of a picture that takes as many rays as the scene's own with one a pixel.
fn sampled_size<S: Scalar>(view: &View<S>) -> [u32; 2] {
    view.size.map(|side| side / u32::from(SIDE))
}

static SAMPLED: LazyLock<Vec<Comparison>> = LazyLock::new(|| {
    let compare = |view: &View<f64>| {
        Comparison::trace_samples(view, view.settings, sampled_size(view), u32::from(SIDE), |_| {})
    };
    f64::views().iter().map(compare).collect::<Result<_, _>>().expect("the reference knows the gallery")
});

/// Draws each scene with several rays a pixel, beside the reference's picture of as many.
fn sampled<S: Gallery + HostNumber>(
    quality: impl Quality + Sync,
) -> impl Iterator<Item = (&'static View<S>, &'static Comparison, Film<S>)> {
    S::views().iter().zip(&*SAMPLED).map(move |(view, reference)| {
        let film = trace(view, view.settings.with_quality(quality), sampled_size(view), |_| {});
        (view, reference, film.expect("the gallery can be drawn"))
    })
}

#[test]
fn nine_rays_a_pixel_in_f64_have_the_light_of_the_reference() {
    for (view, reference, film) in sampled::<f64>(Uniform(SIDE)) {
        let off = reference.light_difference(&film);
        assert!(off.value <= formulas(view), "{}: {off:?}", view.name);
        // On silhouettes too, but for the few of their rays that rounding turns over; of a relief's outline more,
        // for both look for it in steps, and in steps of their own.
        let share = if view.name == "displaced" { 100 } else { 500 };
        let differs = |(core, oracle): &(&Rgb<f64>, &Vector)| (core.g - oracle.0[1]).abs() > formulas(view);
        let turned = film.light.iter().zip(&reference.reference.light).filter(differs).count();
        println!("{}: {off:?}, {turned} turned over", view.name);
        assert!(turned * share <= film.light.len(), "{}: {turned} of {}", view.name, film.light.len());
    }
}

#[test]
fn several_rays_a_pixel_on_edges_are_within_55_db_of_the_reference_away_from_silhouettes() {
    fn check<S: Gallery + HostNumber>(number: &str) {
        for (view, reference, film) in sampled::<S>(AtEdges(Uniform(SIDE))) {
            let subject = Subject { scene: view.name, number, panel: Panel::Rgb888 };
            let figures = reference.figures(subject, &film);
            println!("{figures:?}");
            assert!(figures.psnr_db >= 55.0, "{figures:?}");
        }
    }
    check::<f32>("f32");
    check::<Fixed>("fixed");
}
