//! The desk: a scene lies on it, and what is asked of it is done.

use crate::account::Account;
use crate::answer::{Answer, Choices, Frame, Heat, Opened, by_kind};
use crate::fault::Fault;
use crate::look::{Look, MOST_PIXELS, NUMBERS, QUALITIES, dither_word};
use crate::request::Request;
use crate::{heat, walk};
use host_sim::bake::file;
use host_sim::bake::source::{Literal, Planted};
use host_sim::bake::{Accel, meshes};
use host_sim::dither::Method;
use host_sim::panel::Panel;
use host_sim::picture::MAX_DEPTH;
use host_sim::scene_file::{Description, SceneFile, describe, write};
use host_sim::scenes::{self, Entry};
use host_sim::shot::{Number, Picture, Shot};
use scanray::{Fixed, Uniform};
use std::path::Path;

/// Holds the open scene and the picture drawn last.
#[derive(Debug, Default)]
pub struct Desk {
    scene: Option<Entry>,
    shown: Option<(Shot, Picture)>,
    pixels: Vec<u8>,
}

impl Desk {
    /// Does what is asked.
    pub fn ask(&mut self, request: &[u8]) -> Answer {
        let request = serde_json::from_slice(request).map_err(Fault::Request);
        let done = request.and_then(|request| self.serve(request));
        done.unwrap_or_else(|fault| Answer::Fault(fault.to_string()))
    }

    /// Answers the pixels of the picture asked for last: red, green, blue and 255 of each, row by row from the top.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// Does what is asked.
    ///
    /// # Errors
    /// What keeps it from being done; the open scene stays.
    pub fn serve(&mut self, request: Request) -> Result<Answer, Fault> {
        match request {
            Request::Choices => Ok(Answer::Choices(choices())),
            Request::Open { name } => Ok(self.open(scenes::find(&name).ok_or(Fault::UnknownScene(name))?)),
            Request::Write { text, of } => Ok(self.open(scenes::keep(read(text, of)?))),
            Request::Text => {
                let text = write(&self.description()?).map_err(|error| Fault::Words(error.to_string()))?;
                Ok(Answer::Text(text))
            }
            Request::Frame { look } => self.frame(&look),
            Request::Heat { look } => self.heat(&look),
            Request::Pixel { at } => self.pixel(at),
            Request::Source { number } => self.source(&number),
        }
    }

    fn scene(&self) -> Result<Entry, Fault> {
        self.scene.ok_or(Fault::NoScene)
    }

    fn open(&mut self, scene: Entry) -> Answer {
        let (view, shot) = (scene.double, Shot::new(scene));
        (self.scene, self.shown) = (Some(scene), None);
        Answer::Opened(Opened {
            name: view.name,
            about: view.about,
            size: view.size,
            depth: shot.depth,
            dither: dither_word(&shot),
            reach: walk::reach(view),
        })
    }

    fn description(&self) -> Result<Description, Fault> {
        let scene = self.scene()?;
        Ok(scene.file.map_or_else(|| describe(scene.double), |file| Ok(file.description().clone()))?)
    }

    fn frame(&mut self, look: &Look) -> Result<Answer, Fault> {
        let scene = self.scene()?;
        let shot = look.shot(scene)?;
        let drawn = match shot.number {
            Number::Fixed => shot.draw_in::<Fixed>(|_| ()),
            _ => shot.draw_in::<f32>(|_| ()),
        };
        let drawn = drawn.map_err(|error| match scene.file {
            Some(file) => Fault::Text(Box::new(file.explain(error))),
            None => Fault::Refused(error),
        })?;
        self.show(&drawn.pixels);
        self.shown = Some((shot, Picture { size: shot.size, pixels: drawn.pixels }));
        Ok(Answer::Frame(Frame { size: shot.size, rays: by_kind(drawn.rays) }))
    }

    fn heat(&mut self, look: &Look) -> Result<Answer, Fault> {
        let shot = look.shot(self.scene()?)?;
        let counts = heat::count(&shot)?;
        let range = heat::range(&counts);
        let colors: Vec<[u8; 3]> = counts.iter().map(|count| heat::color(*count, range)).collect();
        self.show(&colors);
        Ok(Answer::Heat(Heat { size: shot.size, range, total: counts.iter().sum() }))
    }

    fn show(&mut self, colors: &[[u8; 3]]) {
        self.pixels.clear();
        self.pixels.extend(colors.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]));
    }

    fn pixel(&self, at: [u32; 2]) -> Result<Answer, Fault> {
        let (shot, picture) = self.shown.as_ref().ok_or(Fault::NoSuchPixel(at))?;
        Ok(Answer::Pixel(Account::of(shot, picture, at)?.ok_or(Fault::NoSuchPixel(at))?))
    }

    fn source(&self, number: &str) -> Result<Answer, Fault> {
        let scene = self.scene()?;
        let text = match NUMBERS.into_iter().find(|known| known.name() == number) {
            Some(Number::Fixed) => bake::<Fixed>(&scene),
            Some(_) => bake::<f32>(&scene),
            None => return Err(Fault::UnknownWord("number", number.to_owned())),
        };
        Ok(Answer::Text(text?))
    }
}

/// Reads the text of a scene that may name the files of one of the gallery.
fn read(text: String, of: Option<String>) -> Result<SceneFile, Fault> {
    let (stem, known) = match of {
        Some(name) => {
            let view = scenes::find(&name).ok_or_else(|| Fault::UnknownScene(name.clone()))?.double;
            let known = describe(view)?.name_files(&name);
            (name, known)
        }
        None => ("scene".to_owned(), vec![]),
    };
    let path = format!("{stem}.ron");
    Ok(SceneFile::parse_beside(Path::new(&path), text.into_bytes(), &known)?)
}

fn bake<S: Literal>(scene: &Entry) -> Result<String, Fault> {
    let view = *S::view(scene);
    let planted = Planted { view, grown: meshes::grow(&view, scene.double, Accel::default()), tree: None };
    Ok(file::write(&planted, &format!("{}.ron", view.name), vec![], None)?.text)
}

fn choices() -> Choices {
    Choices {
        scenes: scenes::all().map(|entry| entry.name()).collect(),
        numbers: NUMBERS.map(Number::name).to_vec(),
        panels: Panel::ALL.map(Panel::name).to_vec(),
        qualities: QUALITIES.to_vec(),
        dithers: Method::ALL.map(Method::name).to_vec(),
        most_pixels: MOST_PIXELS,
        most_depth: MAX_DEPTH,
        most_rays: Uniform::MOST,
        walk: [walk::PARTS, walk::AROUND, walk::NOTCHES],
        heat: heat::COLORS.to_vec(),
    }
}
