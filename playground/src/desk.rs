//! The desk: a scene lies on it, and what is asked of it is done.

use crate::account::Account;
use crate::answer::{Answer, Choices, Frame, Heat, Opened, by_kind};
use crate::fault::Fault;
use crate::look::{Look, MOST_PIXELS, QUALITIES, dither_word};
use crate::request::Request;
use crate::{heat, opening, walk};
use host_sim::bake::file;
use host_sim::bake::source::{Literal, Planted};
use host_sim::bake::{Accel, meshes};
use host_sim::dither::Method;
use host_sim::files::Handed;
use host_sim::panel::Panel;
use host_sim::picture::MAX_DEPTH;
use host_sim::scene_file::{SceneFile, describe, write};
use host_sim::scenes::{self, Entry};
use host_sim::shot::{Approach, Number, Picture, Refusal, Shot};
use scanray::{Fixed, Uniform};
use std::mem;

/// Lists the numbers that firmware computes in.
const OF_FIRMWARE: [Number; 2] = [Number::F32, Number::Fixed];

/// Holds the open scene, the files that were handed over and the picture drawn last.
#[derive(Debug, Default)]
pub struct Desk {
    scene: Option<Entry>,
    /// What was handed over and has no name yet.
    handed: Vec<u8>,
    files: Handed,
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

    /// Takes what a file holds; the next request says its name.
    pub fn hand(&mut self, bytes: Vec<u8>) {
        self.handed = bytes;
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
            Request::Take { name } => self.take(name),
            Request::Read { name } => Ok(self.open(opening::read(&name, &self.files)?)),
            Request::Write { text, file, of } => Ok(self.open(opening::write(text, file, of, &self.files)?)),
            Request::Text => self.text(),
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
            file: scene.file.map_or_else(|| opening::text_name(view.name), SceneFile::file_name),
            notes: scene.file.map_or(&[][..], SceneFile::notes).iter().map(ToString::to_string).collect(),
            size: view.size,
            depth: shot.depth,
            dither: dither_word(&shot),
            reach: walk::reach(view),
        })
    }

    fn take(&mut self, name: String) -> Result<Answer, Fault> {
        let bytes = mem::take(&mut self.handed);
        let count = bytes.len();
        self.files.take(name.clone(), bytes).map_err(|_| Fault::TooMuch(name))?;
        Ok(Answer::Taken(count))
    }

    /// Answers the text of the scene: that of its file, if it has one.
    fn text(&self) -> Result<Answer, Fault> {
        let scene = self.scene()?;
        let written = || write(&describe(scene.double)?).map_err(|error| Fault::Words(error.to_string()));
        Ok(Answer::Text(scene.file.map_or_else(written, |file| Ok(file.text().to_owned()))?))
    }

    fn frame(&mut self, look: &Look) -> Result<Answer, Fault> {
        let scene = self.scene()?;
        let shot = look.shot(scene)?;
        let drawn = shot.draw(|_| ()).map_err(|refusal| match (refusal, scene.file) {
            (Refusal::Core(error), Some(file)) => Fault::Text(Box::new(file.explain(error))),
            (refusal, _) => Fault::Refused(refusal),
        })?;
        self.show(&drawn.picture.pixels);
        self.shown = Some((shot, drawn.picture));
        Ok(Answer::Frame(Frame {
            size: shot.size,
            rays: drawn.rays.map(by_kind),
            fragments: drawn.fragments,
        }))
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
        let text = match OF_FIRMWARE.into_iter().find(|known| known.name() == number) {
            Some(Number::Fixed) => bake::<Fixed>(&scene),
            Some(_) => bake::<f32>(&scene),
            None => return Err(Fault::UnknownWord("number of firmware", number.to_owned())),
        };
        Ok(Answer::Text(text?))
    }
}

fn bake<S: Literal>(scene: &Entry) -> Result<String, Fault> {
    let view = *S::view(scene);
    let planted = Planted { view, grown: meshes::grow(&view, scene.double, Accel::default()), tree: None };
    Ok(file::write(&planted, &format!("{}.ron", view.name), vec![], None)?.text)
}

fn choices() -> Choices {
    Choices {
        scenes: scenes::all().map(|entry| entry.name()).collect(),
        numbers: Number::ALL.map(Number::name).to_vec(),
        of_firmware: OF_FIRMWARE.map(Number::name).to_vec(),
        approaches: Approach::ALL.map(Approach::name).to_vec(),
        panels: Panel::ALL.map(Panel::name).to_vec(),
        qualities: QUALITIES.to_vec(),
        dithers: Method::ALL.map(Method::name).to_vec(),
        most_pixels: MOST_PIXELS,
        most_bytes: Handed::MOST_BYTES,
        most_depth: MAX_DEPTH,
        most_rays: Uniform::MOST,
        walk: [walk::PARTS, walk::AROUND, walk::NOTCHES],
        heat: heat::COLORS.to_vec(),
    }
}
