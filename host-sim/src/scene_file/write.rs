//! Writes a description as a scene file one likes to read: a section a part, a line a thing.

use super::description::Description;
use super::outline::options;
use super::settings::Settings;
use super::shape::Shape;
use super::sky::Sky;
use ron::ser::PrettyConfig;
use serde::Serialize;
use std::fmt::{self, Write};

/// Is an object as a file has it.
#[derive(Serialize)]
struct Object<'a> {
    shape: &'a Shape,
    material: &'a str,
}

/// Writes the text of a scene file.
///
/// # Errors
/// None that a description which was read, or made of a view, could cause.
pub fn write(description: &Description) -> ron::Result<String> {
    let Description { about, size, camera, settings, sky, ambient, materials, lights, objects, volume } =
        description;
    let mut file = Layout { text: HEAD.to_owned() };
    file.part("about", &line(about)?)?;
    file.part("size", &line(size)?)?;
    file.part("camera", &block(camera)?)?;
    if *settings != Settings::default() {
        file.part("settings", &block(settings)?)?;
    }
    if let Some(sky) = sky {
        let written = if let Sky::Cube { .. } = sky { block(sky) } else { line(sky) };
        file.part("sky", &written?)?;
    }
    if let Some(ambient) = ambient {
        file.part("ambient", &line(ambient)?)?;
    }
    let named = materials.iter().map(|(name, material)| Ok(line(name)? + ": " + &line(material)?));
    file.list("What objects are made of, by name.", ["materials: {", "}"], named)?;
    file.list("Where light comes from.", ["lights: [", "]"], lights.iter().map(line))?;
    let object = |index| write_object(description, index).unwrap_or_else(|| Ok(String::new()));
    file.list("What there is to see.", ["objects: [", "]"], (0..objects.len()).map(object))?;
    if let Some(volume) = volume {
        file.text.push_str("\n    // What it is seen through.\n");
        file.part("volume", &block(volume)?)?;
    }
    Ok(file.text + ")\n")
}

/// Writes an object as its file has it, on one line; `None` if there is no such object.
pub fn write_object(description: &Description, index: usize) -> Option<ron::Result<String>> {
    let (shape, material) = description.objects.get(index)?;
    let material = description.materials.get(usize::from(*material)).map_or("", |(name, _)| name);
    Some(line(&Object { shape, material }))
}

/// Is how every file begins.
const HEAD: &str = "// A scene for scanray; docs/scene-format.md says what it may hold.\nScene(\n";

/// Is the text so far.
struct Layout {
    text: String,
}

impl Layout {
    /// Writes a field of the scene.
    fn part(&mut self, name: &str, value: &str) -> fmt::Result {
        writeln!(self.text, "    {name}: {value},")
    }

    /// Writes a list of the scene, a line each; nothing if it is empty.
    fn list(
        &mut self,
        comment: &str,
        [begin, end]: [&str; 2],
        items: impl ExactSizeIterator<Item = ron::Result<String>>,
    ) -> ron::Result<()> {
        if items.len() == 0 {
            return Ok(());
        }
        write!(self.text, "\n    // {comment}\n    {begin}\n")?;
        for item in items {
            writeln!(self.text, "        {},", item?)?;
        }
        Ok(writeln!(self.text, "    {end},")?)
    }
}

/// Writes a value on one line.
fn line(value: &(impl Serialize + ?Sized)) -> ron::Result<String> {
    pretty(value, 0)
}

/// Writes a value with each of its fields on a line.
fn block(value: &impl Serialize) -> ron::Result<String> {
    Ok(pretty(value, 1)?.replace('\n', "\n    "))
}

fn pretty(value: &(impl Serialize + ?Sized), depth: usize) -> ron::Result<String> {
    let config = PrettyConfig::new().depth_limit(depth).new_line("\n").escape_strings(false);
    options().to_string_pretty(value, config)
}
