//! The door: copies a scene's plain data out of the core's types. Nothing is calculated here.

use super::cone::Cone;
use super::description::{
    Bump, Camera, Description, Light, Material, Model, Object, Output, Projection, Rounding, Shape, Sky,
    Texture, Unknown, Volume,
};
use super::displaced::Displaced;
use super::field::Field;
use super::glass::{Glass, Turning};
use super::groups::groups;
use super::mesh::{Corners, Mesh, Normals};
use super::raster::{Image, Raster};
use super::smooth::Smooth;
use super::vector::Vector;
use crate::panel::Panel;
use std::sync::Arc;

fn vector(v: &scanray::Vec3<f64>) -> Vector {
    Vector([v.x, v.y, v.z])
}

fn light(c: &scanray::Rgb<f64>) -> Vector {
    Vector([c.r, c.g, c.b])
}

fn raster(bitmap: &scanray::Bitmap) -> Arc<Raster> {
    let [columns, rows] = bitmap.size();
    let row = |row: u32| (0..columns).map(|column| bitmap.texel([column, row])).collect();
    Arc::new(Raster { rows: (0..rows).map(row).collect() })
}

fn image(image: &scanray::Image<f64>) -> Image {
    let smooth = is_smooth(image.filter);
    Image { raster: raster(&image.bitmap), per_unit: image.per_unit, smooth }
}

fn is_smooth(filter: scanray::Filter) -> bool {
    match filter {
        scanray::Filter::Nearest => false,
        scanray::Filter::Bilinear => true,
    }
}

fn bump(bump: &scanray::Bump<f64>) -> Result<Bump, Unknown> {
    match bump.relief {
        scanray::Relief::Heights(height) => Ok(Bump::Heights { image: image(&bump.image), height }),
        scanray::Relief::Normals => Ok(Bump::Normals { image: image(&bump.image) }),
        _ => Err(Unknown("relief")),
    }
}

fn mesh(mesh: &scanray::Mesh<f64>) -> Mesh {
    let corners = match &mesh.corners {
        scanray::Corners::Exact(places) => Corners::Exact(places.iter().map(vector).collect()),
        scanray::Corners::Quantized { low, sides, steps } => {
            Corners::Steps { low: vector(low), sides: vector(sides), steps }
        }
    };
    let normals = match &mesh.normals {
        scanray::Normals::Flat => Normals::Flat,
        scanray::Normals::Exact(normals) => Normals::Exact(normals.iter().map(vector).collect()),
        scanray::Normals::Octahedral(points) => Normals::Octahedron(points),
    };
    Mesh { triangles: mesh.triangles, corners, normals, coordinates: mesh.texture }
}

fn field(grid: &scanray::Grid<f64>, gradient: scanray::Gradient) -> Field {
    let [columns, rows, slices] = grid.voxels.sides();
    let row = |j, k| (0..columns).map(|i| f64::from(grid.voxels.value([i, j, k]))).collect();
    let samples = (0..slices).map(|k| (0..rows).map(|j| row(j, k)).collect()).collect();
    let first_order = match gradient {
        scanray::Gradient::First => true,
        scanray::Gradient::Second => false,
    };
    Field { samples: Arc::new(samples), low: vector(&grid.low), spacing: vector(&grid.spacing), first_order }
}

fn volume(volume: &scanray::Volume<f64>) -> Volume {
    let class =
        |class: &scanray::Class<f64>| (f64::from(class.value), light(&class.color), f64::from(class.opacity));
    let nearest = match volume.reconstruction {
        scanray::Reconstruction::Nearest => true,
        scanray::Reconstruction::Trilinear => false,
    };
    Volume {
        field: field(&volume.grid, volume.gradient),
        classes: volume.classes.iter().map(class).collect(),
        density: volume.density,
        nearest,
        samples: u32::from(volume.samples),
        faintest: volume.faintest,
    }
}

/// Answers a shape, or what it is made of.
fn shapes(shape: &scanray::Shape<f64>) -> Vec<Shape> {
    let one = match shape {
        scanray::Shape::Sphere(s) => Shape::Sphere { center: vector(&s.center), radius: s.radius },
        scanray::Shape::Plane(p) => Shape::Plane { point: vector(&p.point), normal: vector(&p.normal) },
        scanray::Shape::Triangle(t) => Shape::Triangle { corners: [&t.a, &t.b, &t.c].map(vector) },
        scanray::Shape::Cuboid(c) => Shape::Cuboid { low: vector(&c.low), high: vector(&c.high) },
        scanray::Shape::Polygon(p) => {
            let odd_even = match p.rule {
                scanray::FillRule::OddEven => true,
                scanray::FillRule::Winding => false,
            };
            let vertices = p.vertices.iter().map(vector).collect();
            Shape::Polygon { vertices, normal: vector(&p.normal), odd_even }
        }
        scanray::Shape::Cone(c) => {
            let (ends, radii) = ([&c.base, &c.apex].map(vector), [c.base_radius, c.apex_radius]);
            Shape::Cone(Cone { ends, radii, capped: c.capped })
        }
        scanray::Shape::SmoothTriangle(t) => {
            let [a, b, c] = t.vertices;
            Shape::Smooth(Smooth {
                points: [&a.point, &b.point, &c.point].map(vector),
                normals: [&a.normal, &b.normal, &c.normal].map(vector),
                coordinates: [a.texture, b.texture, c.texture],
            })
        }
        scanray::Shape::Displaced(d) => Shape::Displaced(Displaced {
            center: vector(&d.ball.center),
            radius: d.ball.radius,
            relief: image(&d.relief),
            height: d.height,
        }),
        scanray::Shape::Mesh(whole) => {
            return mesh(whole).facets().into_iter().map(Shape::Smooth).collect();
        }
        scanray::Shape::Isosurface(s) => Shape::Level { field: field(s.grid, s.gradient), level: s.level },
        scanray::Shape::Custom(none) => match *none {},
    };
    vec![one]
}

fn texture(texture: &scanray::Texture<f64>) -> Result<Texture, Unknown> {
    match texture {
        scanray::Texture::Solid(color) => Ok(Texture::Solid(light(color))),
        scanray::Texture::Checker(c) => {
            Ok(Texture::Checker { even: light(&c.even), odd: light(&c.odd), per_unit: c.per_unit })
        }
        scanray::Texture::Vertices(v) => {
            let [a, b, c] = &v.colors;
            Ok(Texture::Vertices([a, b, c].map(light)))
        }
        scanray::Texture::Stripes(s) => {
            Ok(Texture::Stripes { even: light(&s.even), odd: light(&s.odd), per_unit: s.per_unit })
        }
        scanray::Texture::Rings(r) => {
            let (even, odd) = (light(&r.even), light(&r.odd));
            Ok(Texture::Rings { even, odd, center: r.center, per_unit: r.per_unit })
        }
        scanray::Texture::Image(i) => Ok(Texture::Image(image(i))),
        _ => Err(Unknown("texture")),
    }
}

fn glass(glass: &scanray::Glass<f64>) -> Result<Glass, Unknown> {
    let turning = match glass.fresnel {
        scanray::Fresnel::None => Turning::Nothing,
        scanray::Fresnel::Schlick => Turning::Schlick,
        scanray::Fresnel::Exact => Turning::Fresnel,
        _ => return Err(Unknown("glass")),
    };
    let (transmission, index, absorption) = (glass.transmission, glass.index, light(&glass.absorption));
    Ok(Glass { transmission, index, turning, absorption })
}

fn model(model: &scanray::Model<f64>) -> Result<Model, Unknown> {
    match model {
        scanray::Model::Flat => Ok(Model::Flat),
        scanray::Model::Phong => Ok(Model::Phong),
        scanray::Model::BlinnPhong => Ok(Model::BlinnPhong),
        scanray::Model::CookTorrance(facets) => {
            Ok(Model::CookTorrance { roughness: facets.roughness, index: facets.index })
        }
        _ => Err(Unknown("reflection model")),
    }
}

fn material(material: &scanray::Material<f64>) -> Result<Material, Unknown> {
    let (texture, model) = (texture(&material.texture)?, model(&material.model)?);
    let (specular, shininess) = (light(&material.specular), material.shininess);
    let (ambient, mirror) = (material.ambient, material.mirror);
    let glass = material.glass.as_ref().map(glass).transpose()?;
    let bump = material.bump.as_ref().map(bump).transpose()?;
    Ok(Material { texture, bump, model, ambient, specular, shininess, mirror, glass })
}

fn lamp(lamp: &scanray::Light<f64>) -> Result<Light, Unknown> {
    match lamp {
        scanray::Light::Point { position, color } => {
            Ok(Light::Point { position: vector(position), color: light(color) })
        }
        scanray::Light::Directional { toward, color } => {
            Ok(Light::Directional { toward: vector(toward), color: light(color) })
        }
        scanray::Light::Spot(s) => {
            let (position, axis, color) = (vector(&s.position), vector(&s.axis), light(&s.color));
            Ok(Light::Spot { position, axis, cutoff: s.cutoff, falloff: s.falloff, color })
        }
        _ => Err(Unknown("light")),
    }
}

/// Lists the faces of a cube.
const FACES: [usize; 6] = [0, 1, 2, 3, 4, 5];

fn sky(sky: &scanray::Sky<f64>) -> Result<Sky, Unknown> {
    match sky {
        scanray::Sky::Solid(color) => Ok(Sky::Solid(light(color))),
        scanray::Sky::Gradient { up, nadir, zenith } => {
            Ok(Sky::Gradient { up: vector(up), nadir: light(nadir), zenith: light(zenith) })
        }
        scanray::Sky::Cube(cube) => Ok(Sky::Cube {
            faces: FACES.map(|face| raster(&cube.faces[face])),
            smooth: is_smooth(cube.filter),
        }),
        _ => Err(Unknown("sky")),
    }
}

fn camera(camera: &scanray::Camera<f64>) -> Result<Camera, Unknown> {
    let projection = match camera.projection {
        scanray::Projection::Perspective { fovy } => Projection::Perspective { fovy },
        scanray::Projection::Frustum { left, right, bottom, top } => {
            Projection::Frustum { edges: [left, right, bottom, top] }
        }
        scanray::Projection::Orthographic { height } => Projection::Orthographic { height },
        _ => return Err(Unknown("projection")),
    };
    let [eye, center, up] = [&camera.eye, &camera.center, &camera.up].map(vector);
    Ok(Camera { eye, center, up, projection, near: camera.near, far: camera.far })
}

impl Description {
    /// Copies a scene, a camera and settings.
    ///
    /// # Errors
    /// [`Unknown`] names what the reference cannot draw.
    pub fn copy(
        scene: &scanray::Scene<'_, f64>,
        lens: &scanray::Camera<f64>,
        settings: &scanray::Settings<f64>,
    ) -> Result<Self, Unknown> {
        let object = |(number, o): (usize, &scanray::Object<f64>)| {
            let place = usize::from(o.material);
            let stuff = scene.materials.get(place).ok_or(Unknown("material, missing from the list"))?;
            let stuff = material(stuff)?;
            let object = |shape: Shape| Object { number, shape, material: stuff.clone() };
            Ok(shapes(&o.shape).into_iter().map(object).collect::<Vec<_>>())
        };
        let objects = scene.objects.iter().enumerate().map(object).collect::<Result<Vec<_>, _>>()?.concat();
        Ok(Self {
            groups: groups(&objects),
            objects,
            lights: scene.lights.iter().map(lamp).collect::<Result<_, _>>()?,
            sky: sky(&scene.sky)?,
            ambient: light(&scene.ambient),
            volume: scene.volume.map(volume),
            camera: camera(lens)?,
            depth: settings.depth,
            exposure: settings.exposure,
        })
    }
}

fn channels(panel: Panel) -> ([f64; 3], bool) {
    match panel {
        Panel::Rgb565 => ([31.0, 63.0, 31.0], true),
        Panel::Rgb666 => ([63.0; 3], true),
        Panel::Rgb888 => ([255.0; 3], true),
        Panel::Gray8 => ([255.0; 3], false),
        Panel::Gray4 => ([15.0; 3], false),
        Panel::Mono => ([1.0; 3], false),
    }
}

impl Output {
    /// Copies what says how light becomes a panel's levels.
    pub fn copy(panel: Panel, transfer: scanray::Transfer, dither: scanray::Dither) -> Self {
        let (tops, colored) = channels(panel);
        let srgb = match transfer {
            scanray::Transfer::Srgb => true,
            scanray::Transfer::Linear => false,
        };
        let rounding = match dither {
            scanray::Dither::None => Rounding::Nearest,
            scanray::Dither::Ordered => Rounding::Ordered,
            scanray::Dither::Mask(mask) => Rounding::Mask(mask),
            scanray::Dither::Diffused => Rounding::Diffused,
        };
        Self { tops, colored, srgb, rounding }
    }
}
