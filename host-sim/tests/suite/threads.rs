//! A picture does not depend on how many threads trace it.

use embedded_graphics::prelude::Size;
use host_sim::picture::{Film, MAX_DEPTH, pool, trace};
use host_sim::scenes::{self, Entry, HostNumber};
use scanray::trace::RayCounts;
use scanray::{AtEdges, Exact, Fixed, Jittered, Quality, Renderer, Workspace};
use std::num::NonZeroUsize;
use std::sync::mpsc;

/// Is a size that no number of equal bands fills.
const SIZE: [u32; 2] = [83, 61];

fn film<S: HostNumber>(entry: &Entry, threads: usize, quality: impl Quality + Send + Sync) -> Film<S> {
    let view = S::view(entry);
    let pool = pool(NonZeroUsize::new(threads)).expect("a few threads can be had");
    let settings = view.settings.with_quality(quality);
    pool.install(|| trace(view, settings, SIZE, |_| ())).expect("the gallery can be drawn")
}

/// Traces row after row with one workspace, as a device does.
fn film_of_a_device<S: HostNumber>(entry: &Entry, quality: impl Quality) -> Film<S> {
    let view = S::view(entry);
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let canvas = Size::new(SIZE[0], SIZE[1]);
    let settings = view.settings.with_quality(quality);
    let mut renderer = Renderer::new(&view.scene, &view.camera, canvas, settings, &mut workspace)
        .expect("the gallery can be drawn");
    let (mut light, mut rays) = (vec![], RayCounts::default());
    for y in 0..SIZE[1] {
        let row = renderer.trace_row(y, 0..SIZE[0], &mut rays, |_, color| light.push(color));
        row.expect("the row exists");
    }
    Film { size: SIZE, light, rays }
}

fn assert_same_on_any_number_of_threads<S: HostNumber>(quality: impl Quality + Send + Sync) {
    for entry in scenes::all() {
        let alone = film_of_a_device::<S>(&entry, quality);
        for threads in [1, 2, 3, 8] {
            let together = film::<S>(&entry, threads, quality);
            let what = format!("{} on {threads} threads", entry.name());
            assert!(alone.light == together.light, "{what}");
            assert_eq!((alone.rays, alone.size), (together.rays, together.size), "{what}");
        }
    }
}

#[test]
fn the_same_film_in_f32_whatever_the_number_of_threads() {
    assert_same_on_any_number_of_threads::<f32>(Exact);
}

#[test]
fn the_same_film_in_fixed_point_whatever_the_number_of_threads() {
    assert_same_on_any_number_of_threads::<Fixed>(Exact);
}

#[test]
fn scattered_rays_are_the_same_whatever_the_number_of_threads() {
    assert_same_on_any_number_of_threads::<f32>(Jittered(2));
    assert_same_on_any_number_of_threads::<Fixed>(AtEdges(Jittered(2)));
}

#[test]
fn each_row_is_told_once() {
    let view = f32::view(&scenes::find("simple").expect("it is in the gallery"));
    let (tell, told) = mpsc::channel();
    trace(view, view.settings, SIZE, move |y| tell.send(y).expect("someone listens"))
        .expect("it can be drawn");
    let mut rows: Vec<u32> = told.iter().collect();
    rows.sort_unstable();
    assert!(rows.into_iter().eq(0..61));
}

#[test]
fn a_picture_without_pixels_is_refused() {
    let view = f32::view(&scenes::find("simple").expect("it is in the gallery"));
    for size in [[0, 5], [5, 0], [0, 0]] {
        assert!(trace(view, view.settings, size, |_| ()).is_err(), "{size:?}");
    }
}
