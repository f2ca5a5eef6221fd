use super::description::{Description, Light, Material, Model};
use super::reflection::{Way, angle};
use super::roots::Ray;
use super::trail::{Stop, Trail};
use super::vector::Vector;

/// Names the surface a ray starts on: the object and its part.
type Left = Option<(usize, u8)>;

/// Is where a ray ends.
struct Arrival {
    object: usize,
    part: u8,
    point: Vector,
    /// How far the ray has come.
    way: f64,
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
        let near = self.groups.iter().filter(|group| group.may_be_met(ray));
        let roots = near.flat_map(|group| group.members.clone()).flat_map(|object| {
            let o = &self.objects[object];
            let part = left.filter(|(index, _)| *index == object).map(|(_, part)| part);
            o.shape.roots_ahead(ray, part).into_iter().map(move |root| (object, root))
        });
        let seen = roots.filter(|(_, root)| counts(root.t));
        // `min_by` keeps the first of equals.
        let (object, root) = seen.min_by(|(_, a), (_, b)| a.t.total_cmp(&b.t))?;
        let (point, way) = (ray.point(root.t), root.t * ray.direction.inner(ray.direction).sqrt());
        Some(Arrival { object, part: root.part, point, way })
    }

    /// Answers what comes along a ray from the eye, of which only what `counts` is looked at.
    pub(super) fn seen_along(&self, ray: &Ray, counts: impl Fn(Vector) -> bool) -> (Vector, Trail) {
        let mut trail = Trail::new();
        let arrival = self.first(ray, None, |t| counts(ray.point(t)));
        let light = self.light_of(ray, arrival, self.depth, &self.media_at(ray), &mut trail);
        (light * self.exposure, trail)
    }

    /// Lists the glass objects around the start of a ray, the outermost first: those whose surface
    /// the ray passes an odd number of times.
    fn media_at(&self, ray: &Ray) -> Vec<usize> {
        let roots = |index: &usize| self.objects[*index].shape.roots_ahead(ray, None);
        let first = |index: &usize| roots(index).iter().map(|root| root.t).fold(f64::INFINITY, f64::min);
        let glass = |index: &usize| self.objects[*index].material.glass.is_some();
        let mut around: Vec<usize> =
            (0..self.objects.len()).filter(glass).filter(|index| roots(index).len() % 2 == 1).collect();
        around.sort_by(|a, b| first(b).total_cmp(&first(a)));
        around
    }

    /// Answers the light from where a ray ends, with so many levels to go; `media` lists the glass
    /// objects around it, the outermost first.
    fn light_of(
        &self,
        ray: &Ray,
        arrival: Option<Arrival>,
        levels: u8,
        media: &[usize],
        trail: &mut Trail,
    ) -> Vector {
        let Some(Arrival { object, part, point, way }) = arrival else {
            return self.sky.light(ray.direction);
        };
        let left = media.last().and_then(|index| self.objects[*index].material.glass);
        let left = left.map_or(Vector([1.0; 3]), |glass| glass.left_after(way));
        let shape = &self.objects[object].shape;
        let material = &self.objects[object].material;
        let outward = shape.normal(point, part);
        let inside = outward.inner(ray.direction) > 0.0;
        let coordinates = shape.texture_coordinates(point, part);
        let (color, tile) = material.texture.look(coordinates);
        let to_eye = -ray.direction.unit();
        let (lit_at, mut normal) = shape.lit(ray, point, part);
        if let Some(bump) = &material.bump {
            let side = outward.inner(normal).signum();
            let smooth = normal * side;
            let turned = bump.turned(smooth, shape.derivatives(point, part, smooth), coordinates);
            normal = (turned * side).turned_to(to_eye);
        }
        let point = lit_at;
        let place = Place { material, color, point, normal, to_eye, left: (object, part) };
        let reached: Vec<bool> = self
            .lights
            .iter()
            .map(|light| material.model != Model::Flat && self.reaches(light, &place))
            .collect();
        let direct = self.direct_light(&place, &reached);
        trail.push(Stop { object: self.objects[object].number, part, tile, lights: reached });
        let mut sum = direct;
        if levels > 0 {
            let mut send = |weight: f64, direction: Vector, media: &[usize]| {
                if weight > 0.0 {
                    let onward = Ray { start: point, direction };
                    let arrival = self.first(&onward, Some((object, part)), |_| true);
                    sum = sum + self.light_of(&onward, arrival, levels - 1, media, trail) * weight;
                }
            };
            let direction = ray.direction.unit();
            let mirrored = direction - normal * (2.0 * normal.inner(direction));
            if let Some(glass) = &material.glass {
                let mut onward = media.to_vec();
                onward.retain(|index| *index != object);
                let around = onward.last().and_then(|index| self.objects[*index].material.glass);
                let around = around.map_or(1.0, |glass| glass.index);
                let indices = if inside { [glass.index, around] } else { [around, glass.index] };
                let split = glass.split(direction, normal, indices);
                send(material.mirror + glass.transmission * split.turned, mirrored, media);
                if !inside {
                    onward.push(object);
                }
                if let Some(through) = split.through {
                    send(glass.transmission * (1.0 - split.turned), through, &onward);
                }
            } else {
                send(material.mirror, mirrored, media);
            }
        }
        left.filter(sum)
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
