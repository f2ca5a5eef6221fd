//! Scenes as Rust source: `static` data that a `no_std` program which depends on `scanray` compiles as it is.
//!
//! What is written is the core's own scene, number by number, so that the program draws the very picture that
//! was drawn here. Numbers are written such that they are read back to the same bits ([`Literal`]).

mod grown;
mod layout;
mod literal;
mod material;
mod mesh;
mod picture;
mod pool;
mod shape;
mod surroundings;
mod tree;
mod unwritable;
mod volume;

pub use grown::Grown;
pub use layout::Layout;
pub use literal::Literal;
pub use unwritable::Unwritable;

use super::{Bill, Tree};
use pool::Pool;
use scanray::Object;
use scanray::gallery::View;

/// Is a scene as source.
#[derive(Clone, Debug)]
pub struct Source {
    /// The items, without what stands above them.
    pub items: String,
    /// The bytes of its data.
    pub bill: Bill,
}

/// Is a scene in a number with the hierarchies of its meshes and of its objects.
#[derive(Clone, Debug)]
pub struct Planted<S: Literal> {
    /// The scene.
    pub view: View<S>,
    /// Its meshes.
    pub grown: Vec<Grown<S>>,
    /// The hierarchy over its objects, if it has one.
    pub tree: Option<Tree<S>>,
}

impl<S: Literal> Planted<S> {
    /// Writes the scene.
    ///
    /// # Errors
    /// The first thing that there is no source for.
    pub fn write(&self) -> Result<Source, Unwritable> {
        let mut pool = Pool::new(&self.grown);
        let (mut layout, mut bill) = (Layout::default(), Bill::default());
        self.write_view(&mut pool, &mut layout)?;
        self.write_lists(&mut pool, &mut layout, &mut bill)?;
        if let Some(tree) = &self.tree {
            bill.hierarchies += tree.bytes();
            tree::write(tree, "TREE", &mut layout);
        }
        if let Some(volume) = self.view.scene.volume {
            volume::write(volume, &mut pool, &mut layout, &mut bill);
        }
        pool.write(&mut layout, &mut bill);
        Ok(Source { items: layout.text, bill })
    }

    /// Writes what a program names: the scene, its camera and settings.
    fn write_view(&self, pool: &mut Pool<'_, S>, layout: &mut Layout) -> Result<(), Unwritable> {
        let View { scene, camera, settings, size, .. } = &self.view;
        let (name, ambient) = (S::NAME, S::color(scene.ambient));
        let mut faces = Layout::default();
        let sky = surroundings::sky(&scene.sky, pool, &mut faces).ok_or(Unwritable::Sky)?;
        let tree = if self.tree.is_some() { "\n    .with_hierarchy(&TREE)" } else { "" };
        let volume = if scene.volume.is_some() { "\n    .with_volume(&VOLUME)" } else { "" };
        let item = format!(
            "pub static SCENE: Scene<'static, {name}> = Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)\n    \
             .with_ambient({ambient})\n    .with_sky({sky}){tree}{volume}"
        );
        layout.item("Is what there is to see.", &item);
        let camera = surroundings::camera(camera).ok_or(Unwritable::Camera)?;
        layout.item("Is where it is seen from.", &format!("pub const CAMERA: Camera<{name}> = {camera}"));
        let settings = surroundings::settings(settings).ok_or(Unwritable::Settings)?;
        layout.item(
            "Is how the picture is made.",
            &format!("pub const SETTINGS: Settings<{name}> = {settings}"),
        );
        layout.item(
            "Is the columns and rows of the usual picture.",
            &format!("pub const SIZE: [u32; 2] = {size:?}"),
        );
        layout.text.push_str(&faces.text);
        Ok(())
    }

    fn write_lists(
        &self,
        pool: &mut Pool<'_, S>,
        layout: &mut Layout,
        bill: &mut Bill,
    ) -> Result<(), Unwritable> {
        let scene = &self.view.scene;
        bill.objects += size_of_val(scene.objects);
        bill.materials += size_of_val(scene.materials);
        bill.lights += size_of_val(scene.lights);
        let kind = |name: &str| format!("{name}<{}>", S::NAME);
        let objects = each(scene.objects, Unwritable::Object, |object| object_in(object, pool))?;
        layout.list("OBJECTS", &kind("Object"), &objects);
        let materials = each(scene.materials, Unwritable::Material, |it| material::material(it, pool))?;
        layout.list("MATERIALS", &kind("Material"), &materials);
        let lights = each(scene.lights, Unwritable::Light, surroundings::light)?;
        layout.list("LIGHTS", &kind("Light"), &lights);
        Ok(())
    }
}

fn object_in<S: Literal>(object: &Object<S>, pool: &mut Pool<'_, S>) -> Option<String> {
    Some(format!("Object::new({}, {})", shape::shape(&object.shape, pool)?, object.material))
}

/// Writes everything in a list, or names the first thing that there is no source for.
fn each<T>(
    list: &[T],
    unwritable: fn(usize) -> Unwritable,
    mut write: impl FnMut(&T) -> Option<String>,
) -> Result<Vec<String>, Unwritable> {
    list.iter().enumerate().map(|(index, thing)| write(thing).ok_or(unwritable(index))).collect()
}
