//! Explained pixels: the core's own values, the reference's own values, and what is said of them.

use crate::desk::{Desk, assert_refused, stdout};
use host_sim::compare::Comparison;
use host_sim::explain::{Explanation, parting};
use host_sim::panel::Panel;
use host_sim::picture::trace;
use host_sim::reference::{Account, Shine, Surface, Vector, Visit};
use host_sim::scenes::{self, Entry, HostNumber};
use host_sim::shot::{Number, Shot};
use scanray::{Dither, Fixed, Shape};

/// Is small, so that whole pictures take no time.
const SIZE: [u32; 2] = [64, 48];

/// Answers pixels all over the picture: steps of the golden ratio leave no hole (Weyl 1916).
fn scattered(count: u32) -> impl Iterator<Item = [u32; 2]> {
    let pixels = SIZE[0] * SIZE[1];
    (0..count).map(move |n| (f64::from(n) * 0.618_033_988_75).fract() * f64::from(pixels)).map(|place| {
        let place = place as u32;
        [place % SIZE[0], place / SIZE[0]]
    })
}

fn place([x, y]: [u32; 2]) -> usize {
    (y * SIZE[0] + x) as usize
}

fn shot(scene: Entry) -> Shot {
    Shot { size: SIZE, ..Shot::new(scene) }
}

fn explained(shot: Shot, number: Number, pixel: [u32; 2]) -> Explanation {
    Explanation::new(shot, &[number], pixel).expect("the gallery can be drawn")
}

/// Calls a function with every scene and some of its pixels, explained in a number.
fn everywhere(number: Number, mut judge: impl FnMut(&Explanation)) {
    for scene in scenes::all() {
        for pixel in scattered(12) {
            judge(&explained(shot(scene), number, pixel));
        }
    }
}

fn assert_is_the_picture<S: HostNumber>(number: Number) {
    let (panels, dithers) = (Panel::ALL, [Dither::Ordered, Dither::Diffused, Dither::None]);
    for (i, scene) in scenes::all().enumerate() {
        let view = S::view(&scene);
        let film = trace(view, view.settings, SIZE, |_| {}).expect("the gallery can be drawn");
        for (j, pixel) in scattered(12).enumerate() {
            let (panel, dither) = (panels[(i + j) % panels.len()], dithers[j % dithers.len()]);
            let picture = film.on_panel(panel, view.settings.transfer, dither);
            let explained = explained(Shot { panel, dither, ..shot(scene) }, number, pixel);
            let (column, light) = (&explained.columns[0], film.light[place(pixel)]);
            let light = [light.r, light.g, light.b].map(S::to_f64);
            assert_eq!(column.account.light.0, light, "{} {pixel:?}", view.name);
            assert_eq!(column.shown, picture[place(pixel)], "{} {pixel:?} {panel:?} {dither:?}", view.name);
        }
    }
}

#[test]
fn the_explained_colour_is_the_drawn_one_to_the_bit_in_f32() {
    assert_is_the_picture::<f32>(Number::F32);
}

#[test]
fn the_explained_colour_is_the_drawn_one_to_the_bit_in_fixed_point() {
    assert_is_the_picture::<Fixed>(Number::Fixed);
}

#[test]
fn the_column_of_the_reference_is_the_reference_picture() {
    for scene in scenes::all() {
        let view = scene.double;
        let truth = Comparison::trace(view, view.settings, SIZE, |_| {}).expect("it knows the gallery");
        let shown = truth.on_panel(Panel::Rgb565);
        for pixel in scattered(4) {
            let column = explained(shot(scene), Number::Exact, pixel).reference;
            assert_eq!(column.account.light, truth.reference.light[place(pixel)], "{} {pixel:?}", view.name);
            assert_eq!(column.shown, shown[place(pixel)], "{} {pixel:?}", view.name);
            let stops =
                truth.reference.trails[place(pixel)].iter().map(|stop| (stop.object, stop.lights.clone()));
            let lit = |surface: &Surface| surface.lights.iter().map(|shine| shine.lit().is_some()).collect();
            let surfaces = column.account.visits.iter().filter_map(|visit| visit.surface.as_ref());
            assert!(
                surfaces.map(|surface| (surface.object, lit(surface))).eq(stops),
                "{} {pixel:?}",
                view.name
            );
        }
    }
}

fn sum(terms: impl Iterator<Item = Vector>) -> Vector {
    terms.fold(Vector::default(), |sum, term| sum + term)
}

fn furthest(a: Vector, b: Vector) -> f64 {
    (a - b).0.map(f64::abs).into_iter().fold(0.0, f64::max)
}

/// Demands that terms add up: of each surface to what it sends, of all rays to the light; `off` is what a rounding
/// may leave of 1.
fn assert_adds_up(account: &Account, off: f64, name: &str) {
    for Visit { surface, sent, .. } in &account.visits {
        if let Some((surface, [_, ambient])) = surface.as_ref().and_then(|s| Some((s, s.ambient?))) {
            let lights = surface.lights.iter().filter_map(Shine::lit);
            let terms = ambient + sum(lights.map(|lit| lit.sent));
            assert!(furthest(terms, *sent) <= off * (1.0 + sent.norm()), "{name}: {terms:?} is not {sent:?}");
        }
    }
    let gathered = sum(account.visits.iter().map(|visit| visit.weight.filter(visit.sent)));
    let (veil, through) = account.veil.unwrap_or((Vector::default(), 1.0));
    let light = veil + gathered * through;
    let allowed = off * (1.0 + light.norm()) * (1.0 + account.visits.len() as f64);
    assert!(furthest(light, account.light) <= allowed, "{name}: {light:?} is not {:?}", account.light);
}

#[test]
fn the_weighted_terms_of_all_rays_add_up_to_the_light() {
    for (number, off) in [(Number::F32, 3e-7), (Number::Fixed, 5e-6), (Number::Exact, 1e-15)] {
        everywhere(number, |explained| {
            let name = format!("{} {:?} {}", explained.shot.scene.name(), explained.pixel, number.name());
            assert_adds_up(&explained.columns[0].account, off, &name);
            assert_adds_up(&explained.reference.account, 1e-13, &name);
        });
    }
}

fn assert_near(a: Vector, b: Vector, off: f64, name: &str, what: &str) {
    assert!(furthest(a, b) <= off, "{name}: {what}: {a:?}, {b:?}");
}

fn assert_same_visit(own: &Visit, truth: &Visit, off: f64, name: &str) {
    assert_near(own.weight, truth.weight, off, name, "weight");
    assert_near(own.sent, truth.sent, off, name, "sent");
    assert_eq!(own.surface.is_some(), truth.surface.is_some(), "{name}");
    if let (Some(a), Some(b)) = (own.direction, truth.direction) {
        assert_near(a, b, off, name, "direction");
    }
    let (Some(own), Some(truth)) = (&own.surface, &truth.surface) else { return };
    assert_eq!(own.object, truth.object, "{name}");
    assert!((own.distance - truth.distance).abs() <= off * (1.0 + truth.distance), "{name}");
    assert_near(own.point, truth.point, off * (1.0 + truth.point.norm()), name, "point");
    assert_near(own.normal, truth.normal, off, name, "normal");
    for (light, shine) in truth.lights.iter().enumerate() {
        let own = own.lights.get(light).copied().unwrap_or(Shine::Away);
        assert_eq!(own.lit().is_some(), shine.lit().is_some(), "{name}: light {light}");
        if let (Some(a), Some(b)) = (own.lit(), shine.lit()) {
            assert!((a.cosine - b.cosine).abs() <= off, "{name}: cosine");
            for (a, b, what) in [
                (a.arriving, b.arriving, "arriving"),
                (a.diffuse, b.diffuse, "diffuse"),
                (a.highlight, b.highlight, "highlight"),
                (a.sent, b.sent, "light sent"),
            ] {
                assert_near(a, b, off, name, what);
            }
        }
    }
}

/// Rays that the core leaves out as too faint have no counterpart; away from silhouettes all others have.
#[test]
fn in_f64_every_step_is_the_references_away_from_silhouettes() {
    let mut compared = 0;
    for scene in scenes::all() {
        let view = scene.double;
        let truth = Comparison::trace(view, view.settings, SIZE, |_| {}).expect("it knows the gallery");
        // Normals bend with the place, the more the smaller what they belong to: 1e-9 of a place is 1e-6 of them.
        let meshes = view.scene.objects.iter().any(|object| matches!(object.shape, Shape::Mesh(_)));
        let off = if meshes { 1e-5 } else { 1e-6 };
        for pixel in scattered(24).filter(|pixel| !truth.mask[place(*pixel)]) {
            let explained = explained(shot(scene), Number::Exact, pixel);
            for own in &explained.columns[0].account.visits {
                let name = format!("{} {pixel:?}, ray {}", view.name, own.place);
                let truth = explained.reference.visit(own.place).unwrap_or_else(|| panic!("{name}"));
                assert_same_visit(own, truth, off, &name);
                compared += 1;
            }
        }
    }
    assert!(compared > 300, "{compared} rays compared");
}

fn mirrored() -> Explanation {
    let scene = scenes::find("three-spheres").unwrap();
    explained(Shot::new(scene), Number::F32, [160, 120])
}

#[test]
fn rays_are_named_as_in_drawings_of_their_tree() {
    let explained = mirrored();
    let names: Vec<&str> = explained.tree.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["R1", "R2"]);
    assert_eq!(explained.tree[1].parent, Some(0));
    let glass = explained_glass();
    let child = |of: usize| glass.tree.iter().filter(move |node| node.parent == Some(of));
    let names: Vec<&str> = child(0).map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["R2", "T1"]);
    let lights: Vec<&str> =
        glass.tree.iter().flat_map(|node| &node.lights).map(|light| light.name.as_str()).collect();
    let expected: Vec<String> = (1..=lights.len()).map(|n| format!("L{n}")).collect();
    assert_eq!(lights, expected);
}

fn explained_glass() -> Explanation {
    explained(Shot::new(scenes::find("glass").unwrap()), Number::Fixed, [120, 110])
}

#[test]
fn only_objects_whose_span_holds_the_pixel_are_offered() {
    let explained = mirrored();
    assert_eq!(explained.columns[0].offered, Some(vec![0, 2]));
    let sky = explained_at("playdate", [2, 2]);
    let text = sky.to_string();
    assert!(text.contains("the sky"), "{text}");
}

fn explained_at(scene: &str, pixel: [u32; 2]) -> Explanation {
    explained(Shot::new(scenes::find(scene).unwrap()), Number::F32, pixel)
}

#[test]
fn the_step_that_is_off_is_named() {
    let explained = mirrored();
    let right = &explained.columns[0];
    assert_eq!(parting(&explained, right).step, None);
    let step = |change: fn(&mut Visit)| {
        let mut wrong = right.clone();
        change(&mut wrong.account.visits[1]);
        parting(&explained, &wrong).step.expect("it is off").what
    };
    assert_eq!(step(|visit| visit.weight = visit.weight * 1.2), "R2: what of its light reaches the eye");
    let wrong = step(|visit| {
        visit.surface.as_mut().unwrap().object = 3;
        visit.sent = visit.sent * 0.5;
    });
    assert!(wrong.starts_with("R2: it meets 3 (") && wrong.contains("in the reference 0 ("), "{wrong}");
    let dark = step(|visit| visit.surface.as_mut().unwrap().lights[0] = Shine::Blocked);
    assert_eq!(dark, "L2 at R2: point light 0");
    let bright = step(|visit| {
        let [color, light] = visit.surface.as_ref().unwrap().ambient.unwrap();
        visit.surface.as_mut().unwrap().ambient = Some([color, light * 2.0]);
    });
    assert_eq!(bright, "R2: ambient light");
    let mut short = right.clone();
    short.account.visits.truncate(1);
    assert_eq!(parting(&explained, &short).step.unwrap().what, "R2: no such ray is sent");
}

/// Answers the words behind a heading in an explanation's text.
fn said<'t>(text: &'t str, heading: &str) -> &'t str {
    let mut lines = text.lines().filter_map(|line| line.trim_start().strip_prefix(heading));
    lines.next().unwrap_or_else(|| panic!("no {heading:?} in {text}")).trim_start()
}

#[test]
fn the_rounding_that_is_told_makes_the_bits_that_are_told() {
    // 25, 50 and 25 in channels of 5, 6 and 5 bits.
    let text = mirrored().to_string();
    assert!(said(&text, "in bits").starts_with("11001 110010 11001  "), "{text}");
    let scene = scenes::find("still-life").unwrap();
    for (panel, channels) in [(Panel::Rgb565, 3), (Panel::Gray4, 1), (Panel::Mono, 1)] {
        for pixel in scattered(24) {
            let shot = Shot { panel, dither: Dither::Ordered, ..shot(scene) };
            let text = explained(shot, Number::F32, pixel).to_string();
            let rule = said(&text, "is rounded up to the next step of");
            let from: f64 = rule.split_whitespace().nth(2).unwrap().parse().unwrap();
            let bits = said(&text, "in bits").split_whitespace();
            let bits: Vec<_> = bits.take(channels).map(|bits| u8::from_str_radix(bits, 2).unwrap()).collect();
            let steps = said(&text, "in steps").split_whitespace().take(channels);
            for (step, level) in steps.map(|step| step.parse::<f64>().unwrap()).zip(bits) {
                let up = (step.fract() - from).abs() < 0.002
                    || f64::from(level) == step.floor() + f64::from(step.fract() > from);
                assert!(up, "{pixel:?} {panel:?}: {step} from {from} is {level}");
            }
        }
    }
    let shot = Shot { dither: Dither::Diffused, ..shot(scene) };
    assert!(explained(shot, Number::F32, [9, 9]).to_string().contains("to its left"));
}

#[test]
fn a_drawn_tree_has_every_ray_once_and_a_line_to_each_from_its_parent() {
    let explained = explained_glass();
    let (dot, svg) = (explained.dot(), explained.svg());
    let rays = explained.columns[0].account.visits.len();
    assert!(rays > 20, "{rays}");
    assert_eq!(dot.matches("weight").count(), rays);
    assert_eq!(dot.matches(" -> R").count() + dot.matches(" -> T").count(), rays - 1);
    assert_eq!(svg.matches("rx=\"6\"").count(), rays);
    assert_eq!(svg.matches("<circle").count(), dot.matches("shape=ellipse").count());
    let lines = rays - 1 + svg.matches("<circle").count();
    assert_eq!(svg.matches("<line").count(), lines);
    for node in &explained.tree {
        assert_eq!(svg.matches(&format!(">{}</text>", node.name)).count(), 1, "{}", node.name);
    }
}

#[test]
fn a_pixel_is_explained_on_the_command_line() {
    let desk = Desk::new("explain");
    let output = desk.run("explain mirror-levels 165 130 --svg tree.svg --size 320x240");
    assert!(output.status.success(), "{output:?}");
    let text = stdout(&output);
    for word in
        ["R1 sets out", "R2 is reflected where R1 ends", "L1 to", "oracle", "fixed off", "steps of rgb565"]
    {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
    assert_eq!(desk.files(), ["tree.svg"]);
    let only = stdout(&desk.run("explain mirror-levels 165 130 --number fixed"));
    assert!(only.contains("fixed off") && !only.contains("f32"), "{only}");
    let dot = stdout(&desk.run("explain glass 120 110 --dot"));
    assert!(dot.starts_with("digraph \"glass 120,110 in f32\" {") && dot.ends_with("}\n"), "{dot}");
}

#[test]
fn what_cannot_be_explained_is_refused_with_a_way_out() {
    let desk = Desk::new("explain-wrong");
    assert_refused(&desk, "explain simple 240 0", &["no pixel 240,0 in 240x240", "count from 0"]);
    assert_refused(&desk, "explain simple 0 48 --size 64x48", &["no pixel 0,48 in 64x48", "--size"]);
    assert_refused(&desk, "explain simpel 0 0", &["did you mean 'simple'"]);
    assert_refused(&desk, "explain simple", &["<X>"]);
    assert_refused(&desk, "explain simple 0 0 --dither floyd", &["ordered", "diffused"]);
    assert_refused(&desk, "explain simple 0 0 --number oracle", &["f32, fixed and exact"]);
    assert_refused(&desk, "explain simple 0 0 --svg no/such/place.svg", &["no/such/place.svg"]);
    assert_eq!(desk.files(), [""; 0]);
}
