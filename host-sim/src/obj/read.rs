//! A file and its libraries as a model.

use super::library::{GRAY, Library};
use super::survey::{Run, Survey, survey};
use super::wrong::{Mistake, Reason};
use crate::files::{Disk, Files, Open};
use crate::model::{Corner, Model, Options, Paint, Part, Plan};
use std::collections::HashMap;
use std::io::Read;
use std::path::Path;
use tobj::LoadOptions;

/// Is the largest file that is read, in bytes; all libraries of a file together are no larger.
pub const MAX_BYTES: u64 = 1 << 26;

/// Reads a file, its libraries and their images.
///
/// # Errors
/// The first mistake in any of them.
pub fn read(files: &dyn Files, path: &Path) -> Result<Model, Mistake> {
    parse_beside(path, &text(files, path)?, &mut |library| text(files, library), files)
}

/// Reads the text of a file, and of the libraries that it names; their images are on the disk.
///
/// # Errors
/// The first mistake in any of them.
pub fn parse(
    path: &Path,
    text: &str,
    library_text: &mut dyn FnMut(&Path) -> Result<String, Mistake>,
) -> Result<Model, Mistake> {
    parse_beside(path, text, library_text, &Disk)
}

fn parse_beside(
    path: &Path,
    text: &str,
    library_text: &mut dyn FnMut(&Path) -> Result<String, Mistake>,
    files: &dyn Files,
) -> Result<Model, Mistake> {
    let survey = survey(path, text)?;
    let mut library = Library::default();
    let mut room = MAX_BYTES;
    let folder = path.parent().unwrap_or(Path::new(""));
    for (name, line) in &survey.libraries {
        let library_path = folder.join(name.replace('\\', "/"));
        let text = library_text(&library_path).map_err(|mistake| match mistake.reason {
            // Whose library is missing is told by the line that names it.
            Reason::Io(error) => Reason::Library(name.clone(), error).at(path, *line),
            _ => mistake,
        })?;
        // One file may be named in many ways, and is read each time.
        let left = room.checked_sub(text.len() as u64);
        let too_many = Reason::TooMany { what: "bytes in its libraries", most: MAX_BYTES as usize };
        room = left.ok_or_else(|| too_many.at(path, *line))?;
        library.read(files, &library_path, &text)?;
    }
    for Run { material, line, .. } in &survey.runs {
        if let Some(name) = material.as_ref().filter(|name| library.find(name).is_none()) {
            let known = library.materials.iter().map(|material| &*material.name);
            return Err(Reason::unknown(name, known).at(path, *line));
        }
    }
    let parts = parts(&survey, &library).map_err(|error| Reason::Reader(error).of(path))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Ok(model(name, parts, library))
}

/// Reads the triangles of a text and leaves out what it says of materials.
///
/// # Errors
/// The first mistake in it.
pub fn surfaces(path: &Path, text: &str) -> Result<Vec<[Corner; 3]>, Mistake> {
    let of_material = |line: &str| matches!(line.split_whitespace().next(), Some("mtllib" | "usemtl"));
    // An empty line in the place of one left out: mistakes are told with the file's own numbers.
    let plain = text.lines().map(|line| if of_material(line) { "" } else { line });
    let text = plain.collect::<Vec<_>>().join("\n");
    let model = parse(path, &text, &mut |_| Ok(String::new()))?;
    Ok(model.parts.into_iter().flat_map(|part| part.triangles).collect())
}

/// Reads a file as text; letters that are not UTF-8 stand in names only, and become others.
fn text(files: &dyn Files, path: &Path) -> Result<String, Mistake> {
    let mut bytes = vec![];
    let open = files.open(path).map_err(|error| Reason::Io(error).of(path))?;
    let Open { content, .. } = open.ok_or_else(|| Reason::NotAFile.of(path))?;
    let read = content.take(MAX_BYTES + 1).read_to_end(&mut bytes);
    read.map_err(|error| Reason::Io(error).of(path))?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Reason::TooLarge(MAX_BYTES).of(path));
    }
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Lists the triangles by the places of their materials in the library; without one, the place behind the
/// last.
fn parts(survey: &Survey, library: &Library) -> Result<Vec<Part>, tobj::LoadError> {
    let options =
        LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..LoadOptions::default() };
    let names = library.materials.iter().enumerate().map(|(place, material)| (material.name.clone(), place));
    let names: HashMap<String, usize> = names.collect();
    let text = format!("mtllib all\n{}", survey.text);
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
        Ok((library.materials.clone(), names.clone()))
    })?;
    let mut parts: Vec<Part> = vec![];
    // Where the part of a material is: files change the material up to 65536 times.
    let mut places: HashMap<usize, usize> = HashMap::new();
    let runs = survey.runs.iter().filter(|run| run.corners > 0);
    for (model, run) in models.iter().zip(runs) {
        let material = model.mesh.material_id.unwrap_or(library.materials.len());
        let triangles = triangles(&model.mesh, run);
        let place = *places.entry(material).or_insert(parts.len());
        match parts.get_mut(place) {
            Some(part) => part.triangles.extend(triangles),
            None => parts.push(Part { material, triangles }),
        }
    }
    Ok(parts)
}

/// Lists the triangles of faces; of normals and texture coordinates that are not given at each corner there
/// are none.
fn triangles(mesh: &tobj::Mesh, run: &Run) -> Vec<[Corner; 3]> {
    fn at<const N: usize>(list: &[f64], indices: &[u32], corner: usize) -> Option<[f64; N]> {
        list.as_chunks().0.get(*indices.get(corner)? as usize).copied()
    }
    let corner = |number: usize| Corner {
        place: at(&mesh.positions, &mesh.indices, number).unwrap_or_default(),
        normal: at(&mesh.normals, &mesh.normal_indices, number).filter(|_| run.smooth == run.corners),
        texture: at(&mesh.texcoords, &mesh.texcoord_indices, number).filter(|_| run.textured == run.corners),
    };
    (0..mesh.indices.len() / 3).map(|triangle| [0, 1, 2].map(|i| corner(3 * triangle + i))).collect()
}

/// Makes a model of the materials that have triangles.
fn model(name: String, parts: Vec<Part>, library: Library) -> Model {
    let mut paints = vec![];
    let parts = parts.into_iter().map(|part| {
        let plain = || Paint { name: "plain".to_owned(), color: GRAY, ..Paint::default() };
        paints.push(library.paints.get(part.material).cloned().unwrap_or_else(plain));
        Part { material: paints.len() - 1, ..part }
    });
    let parts = parts.collect();
    Model { name, parts, paints }
}

/// Reads a file and makes it ready to be drawn.
///
/// # Errors
/// The first mistake in it, or that it has no triangle with an area.
pub fn plan(files: &dyn Files, path: &Path, options: Options) -> Result<Plan, Mistake> {
    Plan::new(read(files, path)?, options).ok_or(Reason::Nothing.of(path))
}
