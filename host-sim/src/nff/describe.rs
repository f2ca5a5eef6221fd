//! From a scene of this format to the description that every command takes.

use super::fill::Palette;
use super::note::{Note, Notes, What};
use super::scene::{Light, Object, Scene, Shape, View};
use super::{face, round};
use crate::scene_file::camera::{Camera, Projection};
use crate::scene_file::material::Material;
use crate::scene_file::names::names;
use crate::scene_file::place::{Part, Places};
use crate::scene_file::read::MAX_COUNT;
use crate::scene_file::settings::{Settings, Transfer};
use crate::scene_file::sky::Sky;
use crate::scene_file::value::{Color, Point, UP, unless};
use crate::scene_file::{Description, Mistake, Reason, light, shape};
use scanray::Scalar;
use std::mem;

/// Is how many mirrors and surfaces of glass light may have met: rays to a depth of 5, of which that of the eye
/// is the first, as the databases are measured.
pub const DEPTH: u8 = 4;

/// Describes a scene that was read from a text; answers where the parts of the description stand in it, and
/// what it has not as the file says.
///
/// # Errors
/// That there are more shapes in it than the core can number.
pub fn describe(
    scene: &Scene,
    places: &Places,
    text: &str,
) -> Result<(Description, Places, Vec<Note>), Mistake> {
    let palette = Palette::of(&scene.fills);
    let mut draft = Draft { places, notes: Notes::on(text), palette, objects: vec![], found: Places::new() };
    for (index, object) in scene.objects.iter().enumerate() {
        draft.add(index, object)?;
    }
    let materials = draft.materials();
    let Draft { notes, objects, mut found, .. } = draft;
    let kept = |(part, _): &(&Part, _)| matches!(part, Part::Camera | Part::Sky | Part::Light(_));
    found.extend(places.iter().filter(kept).map(|(part, place)| (*part, place.clone())));
    found.extend(places.get(&Part::Camera).map(|place| (Part::Size, place.clone())));
    let description = Description {
        about: String::new(),
        size: scene.view.resolution,
        camera: camera(&scene.view),
        settings: Settings { depth: Some(DEPTH), transfer: Some(Transfer::Linear), ..Settings::default() },
        sky: Some(Sky::Solid { color: Color(scene.background) }),
        ambient: None,
        materials,
        lights: lights(&scene.lights),
        objects,
        volume: None,
    };
    Ok((description, found, notes.all()))
}

/// Is a description that is being made.
struct Draft<'a> {
    /// Where the scene's parts stand.
    places: &'a Places,
    notes: Notes,
    palette: Palette<'a>,
    objects: Vec<(shape::Shape, u16)>,
    /// Where the description's parts stand.
    found: Places,
}

impl Draft<'_> {
    /// Adds what an object becomes.
    fn add(&mut self, index: usize, object: &Object) -> Result<(), Mistake> {
        let place = self.places.get(&Part::Object(index)).cloned().unwrap_or_default();
        let mut note = |what| self.notes.add(what, place.start);
        let shapes: Vec<_> = match &object.shape {
            Shape::Sphere { center, radius } => {
                round::sphere(*center, *radius, &mut note).into_iter().collect()
            }
            Shape::Cone { ends, radii } => round::cone(*ends, *radii, &mut note).into_iter().collect(),
            Shape::Polygon(corners) => face::polygon(corners, &mut note),
            Shape::Patch(corners) => face::patch(corners, &mut note),
        };
        let body = matches!(object.shape, Shape::Sphere { .. });
        if !body && self.palette.lets_light_through(object.fill) {
            note(What::Opaque);
        }
        if self.objects.len() + shapes.len() > MAX_COUNT {
            return Err(Mistake { reason: Reason::TooMany(MAX_COUNT), place: Some(place) });
        }
        for shape in shapes {
            self.found.insert(Part::Object(self.objects.len()), place.clone());
            self.objects.push((shape, self.palette.material(object.fill, body)));
        }
        Ok(())
    }

    /// Makes the list of materials.
    fn materials(&mut self) -> Vec<(String, Material)> {
        let (materials, fills): (Vec<_>, Vec<_>) = mem::take(&mut self.palette.materials).into_iter().unzip();
        for (material, fill) in fills.into_iter().enumerate() {
            let place = self.places.get(&Part::Material(fill)).cloned().unwrap_or_default();
            if self.palette.is_too_bright(fill) {
                self.notes.add(What::Bright, place.start);
            }
            self.found.insert(Part::Material(material), place);
        }
        names(&materials).into_iter().zip(materials).collect()
    }
}

/// Makes a camera of a viewpoint.
fn camera(View { from, at, up, angle, hither, resolution: [_, rows] }: &View) -> Camera {
    Camera {
        eye: *from,
        center: *at,
        up: unless(UP, direction(*up)),
        projection: Projection::Perspective { fovy: between_edges(*angle, *rows) },
        near: unless(f64::ZERO, *hither),
        far: None,
    }
}

/// Answers the angle between the edges of a picture of so many rows, from that between the middles of its first
/// and its last row: their tangents are as the number of rows to the number of rows less one.
fn between_edges(angle: f64, rows: u32) -> f64 {
    let rows = f64::from(rows);
    if rows > 1.0 {
        2.0 * ((0.5 * angle.to_radians()).tan() * (rows / (rows - 1.0))).atan().to_degrees()
    } else {
        angle
    }
}

/// Answers a direction with its largest component 1: fixed point has no room for a long one.
fn direction(direction: Point) -> Point {
    let largest = direction.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    if largest > 0.0 { direction.map(|c| c / largest) } else { direction }
}

/// Makes lights; those without a colour are white, of the intensity 1 over the root of their number, which the
/// databases' own programs give to renderers that do not choose one.
fn lights(lights: &[Light]) -> Vec<light::Light> {
    let usual = 1.0 / (lights.len() as f64).sqrt();
    let light = |light: &Light| light::Light::Point {
        position: light.position,
        color: Color(light.color.unwrap_or([usual; 3])),
    };
    lights.iter().map(light).collect()
}
