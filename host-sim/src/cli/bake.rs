use super::bake_args::{BakeArgs, BakedNumber};
use super::look::scene;
use super::{Error, report};
use crate::bake::file::{self, Failure, File};
use crate::bake::source::{Literal, Planted};
use crate::bake::{Accel, meshes, objects};
use crate::files::Disk;
use crate::model::{Options, Plan};
use crate::obj;
use crate::picture::MAX_DEPTH;
use crate::scenes::Entry;
use crate::shot::Refusal;
use embedded_graphics_core::geometry::Size;
use scanray::gallery::View;
use scanray::{Fixed, RenderError, Renderer, Workspace};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Writes a scene as Rust source.
pub(super) fn run(args: &BakeArgs, out: &mut impl Write) -> Result<(), Error> {
    let baked = match args.number {
        BakedNumber::F32 => bake::<f32>(args),
        BakedNumber::Fixed => bake::<Fixed>(args),
    }?;
    let name = Path::new(&args.scene).file_stem().unwrap_or_default();
    let path = args.output.clone().unwrap_or_else(|| PathBuf::from(name).with_extension("rs"));
    if path == Path::new("-") {
        return Ok(out.write_all(baked.text.as_bytes())?);
    }
    std::fs::write(&path, &baked.text).map_err(|error| Error::Write(path.clone(), error))?;
    for (about, say) in &baked.facts {
        report::line(out, about, say)?;
    }
    report::line(out, "flash", baked.bill)?;
    Ok(report::line(out, "file", path.display())?)
}

fn bake<S: Literal>(args: &BakeArgs) -> Result<File, Error> {
    let path = Path::new(&args.scene);
    let (planted, facts) = if obj::is_named(path) {
        let plan = obj::plan(&Disk, path, args.options())?;
        let planted = plan.plant::<S>();
        check(&planted.view).map_err(|error| Error::Render(Refusal::Core(error)))?;
        (planted, facts(&plan))
    } else {
        refuse_options(&args.options())?;
        let entry = scene(&args.scene)?;
        (planted_entry(&entry, args.accel)?, vec![])
    };
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    Ok(file::write(&planted, &file, facts, args.flash)?)
}

/// Makes a scene of the gallery or of a file ready to be written.
fn planted_entry<S: Literal>(entry: &Entry, accel: Option<Accel>) -> Result<Planted<S>, Error> {
    let view = *S::view(entry);
    check(&view).map_err(|error| Error::refused(entry, Refusal::Core(error)))?;
    let grown = meshes::grow(&view, entry.double, accel.unwrap_or_default());
    let planted = Planted { view, grown, tree: None };
    Ok(match accel {
        Some(Accel::None) | None => planted,
        Some(accel) => objects::plant(planted, entry.double, accel),
    })
}

/// Tells whether the core draws a scene in its number.
fn check<S: Literal>(view: &View<S>) -> Result<(), RenderError> {
    let mut workspace = Workspace::<S, [u8; 2], 0, MAX_DEPTH>::new();
    let size = Size::new(view.size[0], view.size[1]);
    Renderer::new(&view.scene, &view.camera, size, view.settings, &mut workspace).map(|_| ())
}

/// Says of a model how it is told, and what of its file is not drawn.
fn facts(plan: &Plan) -> Vec<(&'static str, String)> {
    let [x, y, z] = plan.place.origin;
    let mut facts = vec![(
        "units",
        format!("{} to one of the file, whose ({x}, {y}, {z}) is the origin", plan.place.scale),
    )];
    if plan.corner_error() > 0.0 {
        let (corners, normals) = (plan.corner_error(), plan.packing.normal_error(&plan.pieces));
        facts.push((
            "precision",
            format!("corners within {corners:.2e} of the file's units along each axis, normals within {normals:.2} degrees"),
        ));
    }
    if plan.dropped > 0 {
        facts.push(("left out", format!("{} triangles that have no area", plan.dropped)));
    }
    let clear = plan.model.paints.iter().filter(|paint| paint.lets_light_through);
    facts.extend(clear.map(|paint| {
        (
            "not drawn",
            format!("glass of `{}`: a mesh is a surface without an inside, and is opaque", paint.name),
        )
    }));
    facts
}

/// Refuses options of models for another scene.
fn refuse_options(options: &Options) -> Result<(), Failure> {
    let usual = Options::default();
    let set = [
        ("--smooth", options.smooth != usual.smooth),
        ("--exact", options.exact != usual.exact),
        ("--floor", options.floor != usual.floor),
    ];
    set.into_iter().find(|(_, is_set)| *is_set).map_or(Ok(()), |(option, _)| Err(Failure::NoModel(option)))
}
