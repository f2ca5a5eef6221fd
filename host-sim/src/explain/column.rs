use super::watcher::{Asked, Watcher};
use crate::picture::MAX_DEPTH;
use crate::reference::{Account, Description, Output, Unknown, Vector, Visit, account, shown, wanted};
use crate::scenes::HostNumber;
use crate::shot::{Number, Refusal, Shot};
use embedded_graphics_core::geometry::Size;
use scanray::gallery::View;
use scanray::ray::{Interval, Ray};
use scanray::{Dither, Fixed, Intersect, RenderError, Renderer, Rgb, Scalar, Sky, Vec3, Workspace};

/// Is a pixel as one number, or the reference, works it out.
#[derive(Clone, Debug)]
pub struct Column {
    /// The number's name.
    pub name: &'static str,
    /// Every ray with what it brings.
    pub account: Account,
    /// What the panel's channels are to show before they are rounded, in the panel's steps.
    pub levels: Vec<f64>,
    /// What the panel shows, in 8 bits a channel.
    pub shown: [u8; 3],
    /// The objects that the ray from the eye was asked against; none if there was no need for the ray, and of
    /// the reference, which asks all.
    pub offered: Option<Vec<u16>>,
    /// Place of the ray, light and an object that stands between, wherever one does.
    pub blockers: Vec<(u64, usize, usize)>,
}

impl Column {
    /// Works out a pixel of a shot in a number.
    ///
    /// # Errors
    /// What keeps the core from drawing the view, or a thing that the reference has no formula for.
    pub fn new(shot: &Shot, number: Number, pixel: [u32; 2]) -> Result<Self, Refusal> {
        match number {
            Number::F32 => Ok(watch::<f32>(shot, number, pixel)?),
            Number::Fixed => Ok(watch::<Fixed>(shot, number, pixel)?),
            Number::Exact => Ok(watch::<f64>(shot, number, pixel)?),
            Number::Oracle => Ok(consult(shot, pixel)?),
        }
    }

    /// Finds the ray in a place of the tree.
    pub fn visit(&self, place: u64) -> Option<&Visit> {
        self.account.visits.iter().find(|visit| visit.place == place)
    }
}

/// Answers how many pixels to the left have a say in how one is rounded.
fn before(shot: &Shot, x: u32) -> u32 {
    if matches!(shot.dither, Dither::Diffused) { x } else { 0 }
}

/// Watches the core at a pixel.
fn watch<S: HostNumber>(shot: &Shot, number: Number, [x, y]: [u32; 2]) -> Result<Column, RenderError> {
    let view = shot.view::<S>();
    let size = Size::new(shot.size[0], shot.size[1]);
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let mut renderer = Renderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace)?;
    let (mut watcher, mut light) = (Watcher::default(), Rgb::BLACK);
    let mut row = vec![[0; 3]; (x - before(shot, x)) as usize];
    let mut levels = |light| row.push(shot.panel.levels(light, shot.transfer));
    // Row and column exist: whoever asks has seen to it.
    let _ = renderer.trace_row(y, 0..before(shot, x), &mut (), |_, light| levels(light));
    let _ = renderer.trace_row(y, x..x + 1, &mut watcher, |_, found| {
        light = found;
        levels(found);
    });
    let wanted = row.last().copied().unwrap_or_default();
    let steps = |(level, top): (&u32, &u8)| f64::from(*level) / 65_536.0 * f64::from(*top);
    let levels = wanted.iter().zip(shot.panel.tops()).map(steps).collect();
    let shown = shot.panel.round_row(row.into_iter(), shot.dither, y).last().copied().unwrap_or_default();
    let blockers = watcher.asked.iter().filter_map(|asked| {
        let blocked = blocker(&view, asked)?;
        Some((asked.place, asked.light, blocked))
    });
    let blockers = blockers.collect();
    let Watcher { mut account, offered, .. } = watcher;
    account.light = vector(light);
    if account.visits.is_empty() {
        account.visits.extend(unasked(&view));
    }
    Ok(Column { name: number.name(), account, levels, shown, offered, blockers })
}

fn vector<S: Scalar>(light: Rgb<S>) -> Vector {
    Vector([light.r, light.g, light.b].map(S::to_f64))
}

/// Answers the sky where no object is offered to the pixel: its light needs no ray.
fn unasked<S: Scalar>(view: &View<S>) -> Option<Visit> {
    let Sky::Solid(sent) = view.scene.sky else { return None };
    let (weight, gathered) = (Rgb::gray(view.settings.exposure), Rgb::gray(view.settings.exposure) * sent);
    let [weight, sent, gathered] = [weight, sent, gathered].map(vector);
    Some(Visit { place: 1, direction: None, weight, surface: None, sent, gathered })
}

/// Finds an object before a light: the first in the scene's list but for the one that the ray leaves, else that.
fn blocker<S: HostNumber>(view: &View<S>, asked: &Asked) -> Option<usize> {
    let round = |v: Vector| Vec3::from_array(v.0.map(S::round));
    let ray = Ray::new(round(asked.origin), round(asked.direction));
    let interval = Interval::new(S::ZERO, S::round(asked.distance));
    let objects = view.scene.objects.iter().enumerate();
    let others = objects.filter(|(index, _)| *index != asked.object);
    let mut before = others.filter(|(_, object)| object.shape.occludes(&ray, &interval));
    let leaving = || {
        let object = view.scene.objects.get(asked.object)?;
        object.shape.intersect_leaving(&ray, &interval).map(|_| asked.object)
    };
    before.next().map(|(index, _)| index).or_else(leaving)
}

/// Asks the reference about a pixel.
fn consult(shot: &Shot, [x, y]: [u32; 2]) -> Result<Column, Refusal> {
    let view = shot.view::<f64>();
    // The reference leaves the check of what it is given to the core.
    view.scene.check().map_err(RenderError::from)?;
    view.camera.frame(shot.size[0], shot.size[1]).map_err(RenderError::from)?;
    let (account, row) = told(shot, &view, [x, y])?;
    let output = Output::copy(shot.panel, shot.transfer, shot.dither);
    let channels = shot.panel.tops().len();
    let levels = wanted(output, account.light)[..channels].to_vec();
    let shown = shown(output, &row, y);
    let name = Number::Oracle.name();
    Ok(Column { name, account, levels, shown, offered: None, blockers: vec![] })
}

/// Answers the reference's account of a pixel, and the lights of the row up to it as far as they have a say.
fn told(shot: &Shot, view: &View<f64>, [x, y]: [u32; 2]) -> Result<(Account, Vec<Vector>), Unknown> {
    let description = Description::copy(&view.scene, &view.camera, &view.settings)?;
    let light = |x| account(&description, shot.size, [x, y]).light;
    let account = account(&description, shot.size, [x, y]);
    let mut row = vec![Vector::default(); (x - before(shot, x)) as usize];
    row.extend((0..before(shot, x)).map(light));
    row.push(account.light);
    Ok((account, row))
}
