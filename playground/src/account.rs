//! Accounts: what a pixel of a picture is.

use crate::answer::by_kind;
use crate::word::{bits, widths};
use embedded_graphics_core::geometry::Size;
use host_sim::picture::MAX_DEPTH;
use host_sim::scene_file::{describe, write_object};
use host_sim::scenes::HostNumber;
use host_sim::shot::{Number, Picture, Shot};
use scanray::trace::{Observer, RayCounts, RayKind};
use scanray::{Fixed, RenderError, Renderer, Rgb, Workspace};
use serde::Serialize;

/// Is what a pixel is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Account {
    /// Column and row.
    pub at: [u32; 2],
    /// What the panel shows there, in 8 bits a channel.
    pub shown: [u8; 3],
    /// The bits it was sent for it.
    pub bits: String,
    /// What the panel's channels are to show of the light along the ray through its middle, before it is rounded:
    /// 1 is all.
    pub wanted: Vec<f64>,
    /// What that ray meets first.
    pub met: String,
    /// The same in the words of scene files, if it is an object.
    pub words: Option<String>,
    /// Places of the lights that reach it there.
    pub lit: Vec<u16>,
    /// Rays from the eye, to lights, into mirrors, through glass that come of that ray.
    pub rays: [u64; 4],
}

/// Watches one ray and what comes of it.
#[derive(Debug, Default)]
struct Watch {
    rays: RayCounts,
    met: Vec<u16>,
    lit: Vec<u16>,
}

impl Observer for Watch {
    const SEES_TILES: bool = false;

    fn ray(&mut self, kind: RayKind) {
        self.rays.ray(kind);
    }

    fn met(&mut self, _: u8, object: u16, _: u32) {
        self.met.push(object);
    }

    fn lit(&mut self, _: u8, light: u16) {
        // Later ones reach what is seen in mirrors or through glass.
        if self.met.len() == 1 {
            self.lit.push(light);
        }
    }
}

impl Account {
    /// Asks the core about a pixel of a picture that was drawn of a shot; none beyond it.
    ///
    /// # Errors
    /// What keeps the core from drawing it.
    pub fn of(shot: &Shot, picture: &Picture, [x, y]: [u32; 2]) -> Result<Option<Self>, RenderError> {
        let row = picture.pixels.chunks(picture.size[0].max(1) as usize).nth(y as usize);
        let Some(shown) = row.and_then(|row| row.get(x as usize)).copied() else { return Ok(None) };
        let (watch, wanted) = match shot.number {
            Number::Fixed => watch::<Fixed>(shot, [x, y]),
            _ => watch::<f32>(shot, [x, y]),
        }?;
        let object = watch.met.first().copied();
        Ok(Some(Self {
            at: [x, y],
            shown,
            bits: bits(shot.panel, shown),
            wanted,
            met: name(object),
            words: object.and_then(|object| words(shot, usize::from(object))),
            lit: watch.lit,
            rays: by_kind(watch.rays),
        }))
    }
}

fn watch<S: HostNumber>(shot: &Shot, [x, y]: [u32; 2]) -> Result<(Watch, Vec<f64>), RenderError> {
    let view = shot.view::<S>();
    let size = Size::new(shot.size[0], shot.size[1]);
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace)?;
    let (mut watch, mut light) = (Watch::default(), Rgb::BLACK);
    // The row exists.
    let _ = renderer.trace_row(y, x..x + 1, &mut watch, |_, found| light = found);
    let levels = shot.panel.levels(light, shot.transfer);
    let channels = widths(shot.panel).iter().zip(levels);
    Ok((watch, channels.map(|(_, level)| f64::from(level) / 65_536.0).collect()))
}

/// Answers what the core's number of a thing means.
fn name(object: Option<u16>) -> String {
    match object {
        None | Some(u16::MAX) => "the sky".to_owned(),
        Some(index) if index == u16::MAX - 1 => "the volume".to_owned(),
        Some(index) => format!("object {index}"),
    }
}

/// Answers an object in the words of scene files, if there are any.
fn words(shot: &Shot, index: usize) -> Option<String> {
    let description = match shot.scene.file {
        Some(file) => file.drawn().clone(),
        None => describe(shot.scene.double).ok()?,
    };
    write_object(&description, index)?.ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use host_sim::scenes;

    fn account(name: &str, at: [u32; 2]) -> Account {
        let shot = Shot { size: [40, 30], ..Shot::new(scenes::find(name).unwrap()) };
        let picture = shot.take(|_| ()).unwrap().picture;
        Account::of(&shot, &picture, at).unwrap().unwrap()
    }

    #[test]
    fn the_first_corner_of_a_ball_before_a_sky_is_sky_and_asks_no_light() {
        let sky = account("first-light", [0, 0]);
        assert_eq!((sky.met.as_str(), sky.words, sky.rays), ("the sky", None, [1, 0, 0, 0]));
        let ball = account("first-light", [20, 15]);
        assert_eq!(ball.met, "object 0");
        assert!(ball.words.unwrap().contains("Sphere("));
    }

    #[test]
    fn a_pixel_is_told_as_the_picture_has_it() {
        let shot = Shot { size: [40, 30], ..Shot::new(scenes::find("c-ray").unwrap()) };
        let picture = shot.take(|_| ()).unwrap().picture;
        for at in [[0, 0], [11, 7], [39, 29]] {
            let account = Account::of(&shot, &picture, at).unwrap().unwrap();
            assert_eq!(account.shown, picture.pixels[(at[1] * 40 + at[0]) as usize]);
        }
        assert_eq!(Account::of(&shot, &picture, [40, 0]).unwrap(), None);
        assert_eq!(Account::of(&shot, &picture, [0, 30]).unwrap(), None);
    }
}
