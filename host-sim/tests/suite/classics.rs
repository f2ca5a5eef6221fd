//! The classic scenes are the pictures that their own programs draw.

use host_sim::panel::Panel;
use host_sim::picture::trace;
use scanray::gallery::Gallery;
use scanray::{Dither, Fixed};
use std::path::Path;

/// Answers the PSNR of a view against the picture of its own program, of 8 bits a channel.
fn psnr<S: Gallery + Send + Sync>(name: &str) -> f64 {
    let view = S::find(name).expect("a scene of the gallery");
    let film = trace(view, view.settings, view.size, |_| ()).expect("the gallery can be drawn");
    let drawn = film.on_panel(Panel::Rgb888, view.settings.transfer, Dither::None).concat();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/classics/{name}.png"));
    let classic = image::open(&file).expect("the picture is there").to_rgb8();
    assert_eq!([classic.width(), classic.height()], view.size);
    let squares = classic.iter().zip(&drawn).map(|(a, b)| (f64::from(*a) - f64::from(*b)).powi(2));
    let mean = squares.sum::<f64>() / drawn.len() as f64;
    10.0 * (255.0 * 255.0 / mean).log10()
}

#[test]
fn tinyraytracer_is_what_its_own_program_draws() {
    let found = [psnr::<f32>("tinyraytracer"), psnr::<Fixed>("tinyraytracer"), psnr::<f64>("tinyraytracer")];
    assert!(found.iter().all(|psnr| *psnr >= 40.0), "{found:.1?} dB");
}

#[test]
fn c_ray_is_what_its_own_program_draws() {
    let found = [psnr::<f32>("c-ray"), psnr::<Fixed>("c-ray"), psnr::<f64>("c-ray")];
    assert!(found.iter().all(|psnr| *psnr >= 45.0), "{found:.1?} dB");
}
