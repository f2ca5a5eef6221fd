use crate::reference::{Account, Lit, Shine, Surface, Vector, Visit};
use scanray::math::Scalar;
use scanray::trace::{Observer, RayKind, Step};
use scanray::{Rgb, Vec3};

/// Takes down the steps in which the core works out one pixel, as `f64` holds them exactly.
#[derive(Debug, Default)]
pub(super) struct Watcher {
    pub account: Account,
    /// The objects that the ray from the eye was asked against; none if there was no need for the ray.
    pub offered: Option<Vec<u16>>,
    /// The rays to lights, in the order in which they were sent.
    pub asked: Vec<Asked>,
    /// Levels of the rays of the account.
    levels: Vec<u8>,
    /// Whether the ray sent last goes through glass.
    refracted: bool,
}

/// Is a ray to a light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    /// Place of the ray that has met the surface.
    pub place: u64,
    /// The object that it leaves.
    pub object: usize,
    pub light: usize,
    pub origin: Vector,
    pub direction: Vector,
    pub distance: f64,
}

fn vector<S: Scalar>(v: Vec3<S>) -> Vector {
    Vector(v.to_array().map(S::to_f64))
}

fn color<S: Scalar>(c: Rgb<S>) -> Vector {
    Vector([c.r, c.g, c.b].map(S::to_f64))
}

impl Watcher {
    /// Answers the place in the tree of a ray that is taken down next.
    ///
    /// Trees are followed depth first, so that its parent is the last ray of the level above.
    fn place(&self, level: u8) -> u64 {
        let parent = self.levels.iter().rposition(|above| level.checked_sub(1) == Some(*above));
        let parent = parent.and_then(|parent| self.account.visits.get(parent));
        parent.map_or(1, |parent| 2 * parent.place + u64::from(self.refracted))
    }

    fn visit(&mut self, level: u8, direction: Vector, weight: Vector, surface: Option<Surface>) {
        let (place, direction, nothing) = (self.place(level), Some(direction), Vector::default());
        self.levels.push(level);
        let visit = Visit { place, direction, weight, surface, sent: nothing, gathered: nothing };
        self.account.visits.push(visit);
    }

    fn surface(&mut self) -> Option<&mut Surface> {
        self.account.visits.last_mut()?.surface.as_mut()
    }

    /// Says what a light does to the surface met last; those not spoken of shine elsewhere.
    fn shine(&mut self, light: u16, shine: Shine) {
        let Some(surface) = self.surface() else { return };
        let light = usize::from(light);
        if surface.lights.len() <= light {
            surface.lights.resize(light + 1, Shine::Away);
        }
        surface.lights[light] = shine;
    }

    fn ask(&mut self, light: u16, origin: Vector, direction: Vector, distance: f64) {
        self.shine(light, Shine::Blocked);
        let Some(visit) = self.account.visits.last() else { return };
        let object = visit.surface.as_ref().map_or(usize::MAX, |surface| surface.object);
        let (place, light) = (visit.place, usize::from(light));
        self.asked.push(Asked { place, object, light, origin, direction, distance });
    }

    fn take<S: Scalar>(&mut self, step: Step<'_, S>) {
        match step {
            Step::SetsOut { candidates, .. } => {
                self.offered = Some(candidates.named.iter().copied().chain(candidates.rest).collect());
            }
            Step::Veiled { color: veil, transparency } => {
                self.account.veil = Some((color(veil), transparency.to_f64()));
            }
            Step::Meets { level, object, distance, surface, direction, weight } => {
                let (point, normal) = (vector(surface.point), vector(surface.normal));
                let (object, distance) = (usize::from(object), distance.to_f64());
                let surface = Surface { object, distance, point, normal, ambient: None, lights: vec![] };
                self.visit(level, vector(direction), color(weight), Some(surface));
            }
            Step::Leaves { level, direction, weight } => {
                self.visit(level, vector(direction), color(weight), None);
            }
            Step::Ambient { color: of, light } => {
                if let Some(surface) = self.surface() {
                    surface.ambient = Some([of, light].map(color));
                }
            }
            Step::Asks { light, ray, distance } => {
                self.ask(light, vector(ray.origin), vector(ray.direction), distance.to_f64());
            }
            Step::Lit { light, arriving, cosine, diffuse, highlight, sent } => {
                let [arriving, diffuse, highlight, sent] = [arriving, diffuse, highlight, sent].map(color);
                let cosine = cosine.to_f64();
                self.shine(light, Shine::Lit(Lit { arriving, cosine, diffuse, highlight, sent }));
            }
            Step::Sends { light, gathered } => {
                if let Some(visit) = self.account.visits.last_mut() {
                    (visit.sent, visit.gathered) = (color(light), color(gathered));
                }
            }
            // The weights of both rays are told again when they have met something; other steps are none of ours.
            _ => {}
        }
    }
}

impl Observer for Watcher {
    const SEES_TILES: bool = false;

    fn ray(&mut self, kind: RayKind) {
        if kind != RayKind::Shadow {
            self.refracted = kind == RayKind::Refraction;
        }
    }

    fn step<'c, S: Scalar>(&mut self, _: u8, step: impl FnOnce() -> Step<'c, S>) {
        self.take(step());
    }
}
