use super::description::{Description, Light, Material, Model, Sky, Texture};
use super::reflection::{Way, angle};
use super::shape::Ray;
use super::trail::{Stop, Trail};
use super::vector::Vector;

/// Names the surface a ray starts on: the object and its part.
type Left = Option<(usize, u8)>;

/// Is where a ray ends.
struct Arrival {
    object: usize,
    part: u8,
    point: Vector,
}

/// Is the place whose light is asked for.
struct Place<'a> {
    material: &'a Material,
    color: Vector,
    point: Vector,
    /// Unit length, on the viewer's side.
    normal: Vector,
    to_eye: Vector,
    left: (usize, u8),
}

impl Light {
    /// Answers the vector to the light, of its own length, and how far along it shadows reach.
    fn seen_from(&self, point: Vector) -> (Vector, f64, Vector) {
        match *self {
            Self::Point { position, color } => (position - point, 1.0, color),
            Self::Directional { toward, color } => (toward, f64::INFINITY, color),
            Self::Spot { position, color, .. } => (position - point, 1.0, color * self.share(point)),
        }
    }

    /// Answers the share of its light that a lamp sends to a point: none outside of its cone.
    fn share(&self, point: Vector) -> f64 {
        let Self::Spot { position, axis, cutoff, falloff, .. } = *self else { return 1.0 };
        let off = angle(axis, point - position);
        if off <= cutoff.acos() { off.cos().powf(f64::from(falloff)) } else { 0.0 }
    }
}

impl Description {
    /// Answers the first thing a ray meets that `counts`; the first listed of equally near ones.
    fn first(&self, ray: &Ray, left: Left, counts: impl Fn(f64) -> bool) -> Option<Arrival> {
        let roots = self.objects.iter().enumerate().flat_map(|(object, o)| {
            let part = left.filter(|(index, _)| *index == object).map(|(_, part)| part);
            o.shape.roots_ahead(ray, part).into_iter().map(move |root| (object, root))
        });
        let seen = roots.filter(|(_, root)| counts(root.t));
        // `min_by` keeps the first of equals.
        let (object, root) = seen.min_by(|(_, a), (_, b)| a.t.total_cmp(&b.t))?;
        Some(Arrival { object, part: root.part, point: ray.point(root.t) })
    }

    /// Answers what comes along a ray from the eye, of which only what `counts` is looked at.
    pub(super) fn seen_along(&self, ray: &Ray, counts: impl Fn(Vector) -> bool) -> (Vector, Trail) {
        let mut trail = Trail::new();
        let arrival = self.first(ray, None, |t| counts(ray.point(t)));
        let light = self.light_of(ray, arrival, self.depth, &mut trail);
        (light * self.exposure, trail)
    }

    /// Answers the light from where a ray ends, with so many mirrors to go.
    fn light_of(&self, ray: &Ray, arrival: Option<Arrival>, mirrors: u8, trail: &mut Trail) -> Vector {
        let Some(Arrival { object, part, point }) = arrival else { return self.sky_light(ray.direction) };
        let shape = &self.objects[object].shape;
        let material = &self.objects[object].material;
        let normal = shape.normal(point, part);
        let normal = if normal.inner(ray.direction) > 0.0 { -normal } else { normal };
        let (color, tile) = material.texture.look(shape.texture_coordinates(point, part));
        let to_eye = -ray.direction.unit();
        let place = Place { material, color, point, normal, to_eye, left: (object, part) };
        let reached: Vec<bool> = self
            .lights
            .iter()
            .map(|light| material.model != Model::Flat && self.reaches(light, &place))
            .collect();
        let direct = self.direct_light(&place, &reached);
        trail.push(Stop { object, part, tile, lights: reached });
        if material.mirror > 0.0 && mirrors > 0 {
            let along = normal.inner(ray.direction);
            let onward = Ray { start: point, direction: ray.direction - normal * (2.0 * along) };
            let arrival = self.first(&onward, Some((object, part)), |_| true);
            direct + self.light_of(&onward, arrival, mirrors - 1, trail) * material.mirror
        } else {
            direct
        }
    }

    /// Tells whether a light shines on the visible side of a place and nothing stands between.
    fn reaches(&self, light: &Light, place: &Place<'_>) -> bool {
        let (direction, end, _) = light.seen_from(place.point);
        let ray = Ray { start: place.point, direction };
        let faces = place.normal.inner(direction) > 0.0 && light.share(place.point) > 0.0;
        faces && self.first(&ray, Some(place.left), |t| t < end).is_none()
    }

    /// Sums `Ia kd ka + l kd (n.L) + l ks f`, of the model's factor f, over the lights that reach the place.
    fn direct_light(&self, place: &Place<'_>, reached: &[bool]) -> Vector {
        if place.material.model == Model::Flat {
            return place.color;
        }
        let ambient = self.ambient.filter(place.color) * place.material.ambient;
        let reaching = self.lights.iter().zip(reached).filter(|(_, reached)| **reached);
        reaching.map(|(light, _)| place.reflected(light)).fold(ambient, |sum, light| sum + light)
    }

    fn sky_light(&self, direction: Vector) -> Vector {
        match self.sky {
            Sky::Solid(color) => color,
            Sky::Gradient { up, nadir, zenith } => {
                let share = (1.0 + direction.unit().inner(up)) / 2.0;
                nadir + (zenith - nadir) * share
            }
        }
    }
}

impl Place<'_> {
    /// Answers the diffuse and specular reflection of an unblocked light.
    fn reflected(&self, light: &Light) -> Vector {
        let (direction, _, color) = light.seen_from(self.point);
        let to_light = direction.unit();
        let cosine = self.normal.inner(to_light);
        let way = Way { normal: self.normal, to_light, to_eye: self.to_eye };
        color.filter(self.color * cosine + self.material.specular * self.material.shine(&way))
    }
}

impl Texture {
    /// Answers the colour at texture coordinates, and the tile if there are tiles.
    fn look(&self, [u, v]: [f64; 2]) -> (Vector, Option<[i64; 2]>) {
        match *self {
            Self::Solid(color) => (color, None),
            Self::Checker { even, odd, per_unit } => {
                let tile = [u, v].map(|coordinate| (coordinate * per_unit).floor() as i64);
                let color = if (tile[0] + tile[1]).rem_euclid(2) == 0 { even } else { odd };
                (color, Some(tile))
            }
        }
    }
}
