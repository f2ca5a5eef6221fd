use super::account::{Lit, Notes, Shine, Surface, Visit};
use super::description::{Description, Light, Material, Model};
use super::reflection::{Way, angle};
use super::roots::Ray;
use super::trail::Stop;
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

/// Is a ray's place in the tree of rays.
struct Branch<'m> {
    /// Number in the binary tree, as [`Visit::place`] counts.
    place: u64,
    /// How many levels there are to go.
    levels: u8,
    /// The glass objects around the ray, the outermost first.
    media: &'m [usize],
    /// What of its light reaches the eye, but for what the glass around it absorbs.
    weight: Vector,
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
    pub(super) fn seen_from(&self, point: Vector) -> (Vector, f64, Vector) {
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

    /// Answers what comes along a ray from the eye, of which only what `counts` is looked at: what lies between two
    /// distances, in units of its direction.
    pub(super) fn seen_along(
        &self,
        ray: &Ray,
        counts: impl Fn(Vector) -> bool,
        [near, far]: [f64; 2],
        notes: &mut Notes,
    ) -> Vector {
        let arrival = self.first(ray, None, |t| counts(ray.point(t)));
        let end = arrival.as_ref().map_or(far, |arrival| arrival.way / ray.direction.norm());
        let (media, weight) = (self.media_at(ray), Vector([self.exposure; 3]));
        let root = Branch { place: 1, levels: self.depth, media: &media, weight };
        let mut light = self.light_of(ray, arrival, &root, notes);
        if let Some(volume) = &self.volume {
            let over = |light| volume.over(light, ray, [near.max(0.0), end], &self.lights, self.ambient);
            notes.veil(|| {
                let [black, white] = [0.0, 1.0].map(|light| over(Vector([light; 3])));
                (black * self.exposure, (white - black).0[0])
            });
            light = over(light);
        }
        light * self.exposure
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

    /// Answers the light from where a ray ends.
    fn light_of(
        &self,
        ray: &Ray,
        arrival: Option<Arrival>,
        branch: &Branch<'_>,
        notes: &mut Notes,
    ) -> Vector {
        let Branch { place: number, levels, media, weight } = *branch;
        let direction = ray.direction.unit();
        let Some(Arrival { object, part, point, way }) = arrival else {
            let (sent, gathered) = (self.sky.light(ray.direction), Vector::default());
            notes.visit(|| Visit {
                place: number,
                direction: Some(direction),
                weight,
                surface: None,
                sent,
                gathered,
            });
            return sent;
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
        let flat = material.model == Model::Flat;
        let lights: Vec<Shine> = self
            .lights
            .iter()
            .map(|light| if flat { Shine::Away } else { self.shine(light, &place) })
            .collect();
        let ambient = self.ambient.filter(color) * material.ambient;
        let lit = lights.iter().filter_map(Shine::lit);
        let direct = if flat { color } else { lit.fold(ambient, |sum, lit| sum + lit.sent) };
        let reached = lights.iter().map(|shine| shine.lit().is_some()).collect();
        let weight = weight.filter(left);
        let number_of_object = self.objects[object].number;
        notes.trail.push(Stop { object: number_of_object, part, tile, lights: reached });
        notes.visit(|| {
            let (ambient, gathered) = ((!flat).then_some([color, ambient]), Vector::default());
            let surface = Surface { object: number_of_object, distance: way, point, normal, ambient, lights };
            Visit {
                place: number,
                direction: Some(direction),
                weight,
                surface: Some(surface),
                sent: direct,
                gathered,
            }
        });
        let mut sum = direct;
        if levels > 0 {
            let mut send = |share: f64, direction: Vector, media: &[usize], twin: u64| {
                if share > 0.0 {
                    let onward = Ray { start: point, direction };
                    let arrival = self.first(&onward, Some((object, part)), |_| true);
                    let place = 2 * number + twin;
                    let branch = Branch { place, levels: levels - 1, media, weight: weight * share };
                    sum = sum + self.light_of(&onward, arrival, &branch, notes) * share;
                }
            };
            let mirrored = direction - normal * (2.0 * normal.inner(direction));
            if let Some(glass) = &material.glass {
                let mut onward = media.to_vec();
                onward.retain(|index| *index != object);
                let around = onward.last().and_then(|index| self.objects[*index].material.glass);
                let around = around.map_or(1.0, |glass| glass.index);
                let indices = if inside { [glass.index, around] } else { [around, glass.index] };
                let split = glass.split(direction, normal, indices);
                send(material.mirror + glass.transmission * split.turned, mirrored, media, 0);
                if !inside {
                    onward.push(object);
                }
                if let Some(through) = split.through {
                    send(glass.transmission * (1.0 - split.turned), through, &onward, 1);
                }
            } else {
                send(material.mirror, mirrored, media, 0);
            }
        }
        left.filter(sum)
    }

    /// Answers what a light does to a place: whether it shines on the visible side and nothing stands between.
    fn shine(&self, light: &Light, place: &Place<'_>) -> Shine {
        let (direction, end, _) = light.seen_from(place.point);
        let ray = Ray { start: place.point, direction };
        let faces = place.normal.inner(direction) > 0.0 && light.share(place.point) > 0.0;
        if !faces {
            Shine::Away
        } else if self.first(&ray, Some(place.left), |t| t < end).is_some() {
            Shine::Blocked
        } else {
            Shine::Lit(place.reflected(light))
        }
    }
}

impl Place<'_> {
    /// Answers the diffuse and specular reflection of an unblocked light: `l kd (n.L) + l ks f`, of the model's
    /// factor f.
    fn reflected(&self, light: &Light) -> Lit {
        let (direction, _, arriving) = light.seen_from(self.point);
        let to_light = direction.unit();
        let cosine = self.normal.inner(to_light);
        let way = Way { normal: self.normal, to_light, to_eye: self.to_eye };
        let (diffuse, highlight) = (self.color * cosine, self.material.specular * self.material.shine(&way));
        Lit { arriving, cosine, diffuse, highlight, sent: arriving.filter(diffuse + highlight) }
    }
}
