//! A model as a scene of the core, in every number.

use super::piece::{Packing, Piece, pieces};
use super::place::Place;
use super::smooth::smooth;
use super::{Model, mesh, view};
use crate::bake::source::{Literal, Planted};
use crate::bake::steps::Steps;
use crate::bake::{Accel, Bounds};
use crate::scene_file::value::point;
use crate::scenes::Entry;
use scanray::gallery::View;
use scanray::{Light, Material, Object, Plane, Scene, Settings, Shape};

/// Is how a model is to be drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The angle in degrees up to which edges without normals are rounded; none are if there is none.
    pub smooth: Option<f64>,
    /// Whether corners and normals are told as they are.
    pub exact: bool,
    /// Whether it stands on a floor.
    pub floor: bool,
    /// The hierarchy over its triangles.
    pub accel: Accel,
}

/// Is a model cut into meshes, ready for each number.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The model, in the units in which it is drawn.
    pub model: Model,
    /// Its meshes.
    pub pieces: Vec<Piece>,
    /// How corners are told.
    pub packing: Packing,
    /// How many triangles are left out because they have no area.
    pub dropped: usize,
    /// How it was moved and scaled.
    pub place: Place,
    options: Options,
}

impl Plan {
    /// Moves, scales, smooths and cuts a model; `None` for one without a triangle that has an area.
    pub fn new(mut model: Model, options: Options) -> Option<Self> {
        let place = Place::of(&model.bounds());
        place.apply(&mut model);
        if let Some(degrees) = options.smooth {
            smooth(&mut model, degrees);
        }
        let packing =
            if options.exact { Packing::Exact } else { Packing::Packed(Steps::over(&model.bounds())) };
        let (pieces, dropped) = pieces(&model, &packing);
        (!pieces.is_empty()).then_some(Self { model, pieces, packing, dropped, place, options })
    }

    /// Answers how far off corners are at most, in the file's units.
    pub fn corner_error(&self) -> f64 {
        match self.packing {
            Packing::Packed(grid) => grid.error() / self.place.scale,
            Packing::Exact => 0.0,
        }
    }

    /// Makes the scene in a number; it stays in memory as long as the program runs.
    pub fn plant<S: Literal>(&self) -> Planted<S> {
        let grown: Vec<_> =
            self.pieces.iter().map(|piece| mesh::grow(piece, &self.packing, self.options.accel)).collect();
        let places = self.pieces.iter().map(|piece| piece.material as u16);
        let mut objects: Vec<Object<S>> = grown
            .iter()
            .zip(places)
            .map(|(grown, place)| Object::new(Shape::Mesh(grown.mesh), place))
            .collect();
        let mut materials: Vec<Material<S>> =
            self.model.paints.iter().map(|paint| paint.in_number()).collect();
        if self.options.floor {
            let floor = Plane::new(point([0.0; 3]), point([0.0, 1.0, 0.0]));
            objects.push(Object::new(Shape::Plane(floor), materials.len() as u16));
            materials.push(Material::matte(view::gray(0.6)));
        }
        let lights: Vec<Light<S>> = vec![view::light()];
        let scene = Scene::new(objects.leak(), materials.leak(), lights.leak())
            .with_ambient(view::ambient())
            .with_sky(view::sky());
        let camera = view::camera(&self.bounds());
        let about = format!("a model of {} triangles", self.triangles()).leak();
        let name = self.model.name.clone().leak();
        let view = View { name, about, scene, camera, settings: Settings::new(), size: view::SIZE };
        Planted { view, grown, tree: None }
    }

    /// Answers the box around the model.
    fn bounds(&self) -> Bounds {
        self.model.bounds()
    }

    /// Counts the triangles that are drawn.
    pub fn triangles(&self) -> usize {
        self.pieces.iter().map(|piece| piece.triangles.len()).sum()
    }
}

/// Makes the scene that commands take of a model, in every number.
pub fn entry(plan: &Plan) -> Entry {
    fn kept<S: Literal>(plan: &Plan) -> &'static View<S> {
        Box::leak(Box::new(plan.plant().view))
    }
    Entry { float: kept(plan), fixed: kept(plan), double: kept(plan), file: None }
}
