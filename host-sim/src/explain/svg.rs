use super::{Explanation, LightRay, Node};
use crate::reference::{Shine, Vector};
use std::fmt::Write;

/// Sides of what is drawn, in pixels: of a ray's box, of the circle of a ray to a light.
const BOX: [f64; 2] = [148.0, 92.0];
const RADIUS: f64 = 17.0;
/// Distance of neighbours and of levels, and the margin around all.
const GAP: f64 = 14.0;
const LEVEL: f64 = 168.0;
const MARGIN: f64 = 28.0;
const HEAD: f64 = 66.0;
/// Says what the fields of colour are, and how wide that is.
const LEGEND: &str = "In a box: what the place sends itself, and what the ray brings to the pixel.";
const LEAST_WIDTH: f64 = 470.0;

impl Explanation {
    /// Answers the rays that the column has of which trees are drawn.
    pub(super) fn rays(&self) -> impl Iterator<Item = &Node> {
        self.tree.iter().filter(|node| self.drawn().visit(node.place).is_some())
    }

    /// Answers the rays to lights that leave the end of a ray.
    pub(super) fn light_rays<'e>(&'e self, node: &'e Node) -> impl Iterator<Item = (&'e LightRay, Shine)> {
        let surface = self.drawn().visit(node.place).and_then(|visit| visit.surface.as_ref());
        let shine = move |ray: &LightRay| surface?.lights.get(ray.light).copied();
        let sent = node.lights.iter().filter_map(move |ray| Some((ray, shine(ray)?)));
        sent.filter(|(_, shine)| *shine != Shine::Away)
    }

    /// Draws the tree of rays of the first number as SVG.
    ///
    /// Each ray is a box with its name, what it has met and what of its light reaches the eye, and two fields of
    /// colour: what that place sends itself, and what the ray and all it gives rise to bring to the pixel. Rays to
    /// lights are circles, with a broken line where something stands between.
    pub fn svg(&self) -> String {
        let places = Layout::of(self);
        let [width, height] = places.size;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#16181c\"/>\n\
             <text x=\"{MARGIN}\" y=\"{MARGIN}\" fill=\"#d6dae0\" font-size=\"15\">{}</text>\n\
             <text x=\"{MARGIN}\" y=\"{}\" fill=\"#8a919c\">{LEGEND}</text>\n",
            escaped(&self.title()),
            MARGIN + 20.0,
        );
        for (node, place) in &places.rays {
            let parent = node.parent.and_then(|parent| self.tree.get(parent));
            if let Some(from) = parent.and_then(|parent| places.of_ray(parent)) {
                let start = [from[0], from[1] + BOX[1] / 2.0];
                line(&mut text, start, [place[0], place[1] - BOX[1] / 2.0], hue(node), false);
            }
        }
        for (node, place) in &places.rays {
            self.draw_lights(&mut text, node, *place);
            self.draw_ray(&mut text, node, *place);
        }
        text + "</svg>\n"
    }

    fn draw_ray(&self, text: &mut String, node: &Node, [x, y]: [f64; 2]) {
        let (left, top) = (x - BOX[0] / 2.0, y - BOX[1] / 2.0);
        let [width, height] = BOX;
        let _ = writeln!(
            text,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" rx=\"6\" fill=\"#23262c\" \
             stroke=\"{}\" stroke-width=\"2\"/>",
            hue(node)
        );
        for (line, caption) in self.captions(node).iter().enumerate() {
            let (size, baseline) =
                if line == 0 { (15, top + 20.0) } else { (11, top + 21.0 + 15.0 * line as f64) };
            let _ = writeln!(
                text,
                "<text x=\"{x}\" y=\"{baseline}\" fill=\"#d6dae0\" text-anchor=\"middle\" font-size=\"{size}\">{}</text>",
                escaped(caption)
            );
        }
        let sent = self.drawn().visit(node.place).map_or(Vector::default(), |visit| visit.sent);
        for (place, light, title) in
            [(0.0, sent, "sends itself"), (0.5, self.brought(node), "brings to the pixel")]
        {
            let _ = writeln!(
                text,
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"22\" fill=\"{}\" stroke=\"#16181c\"><title>{title}</title></rect>",
                left + 8.0 + place * (width - 16.0),
                top + height - 30.0,
                (width - 16.0) / 2.0,
                swatch(light)
            );
        }
    }

    fn draw_lights(&self, text: &mut String, node: &Node, [x, y]: [f64; 2]) {
        let rays: Vec<_> = self.light_rays(node).collect();
        let from = x + BOX[0] / 2.0;
        for (i, (ray, shine)) in rays.iter().enumerate() {
            let down = (i as f64 - (rays.len() as f64 - 1.0) / 2.0) * (2.0 * RADIUS + 4.0);
            let (center, lit) = ([from + LIGHTS - RADIUS, y + down], shine.lit());
            line(text, [from, y], [center[0] - RADIUS, center[1]], "#e8c64a", lit.is_none());
            let _ = writeln!(
                text,
                "<circle cx=\"{0}\" cy=\"{1}\" r=\"{RADIUS}\" fill=\"{2}\" stroke=\"#e8c64a\"><title>{3}</title></circle>\n\
                 <text x=\"{0}\" y=\"{4}\" fill=\"{5}\" text-anchor=\"middle\">{6}</text>",
                center[0],
                center[1],
                lit.map_or("#16181c".to_owned(), |lit| swatch(lit.arriving)),
                escaped(self.names.light(ray.light)),
                center[1] + 4.0,
                if lit.is_some() { "#16181c" } else { "#e8c64a" },
                ray.name
            );
        }
    }

    /// Answers what a ray and all it gives rise to bring to the pixel.
    fn brought(&self, node: &Node) -> Vector {
        let below = |place: u64| (0..64).any(|up| place >> up == node.place);
        let visits = self.drawn().account.visits.iter().filter(|visit| below(visit.place));
        visits.fold(Vector::default(), |sum, visit| sum + visit.weight.filter(visit.sent))
    }
}

/// Is how far beside a box the circles of its rays to lights reach.
const LIGHTS: f64 = 62.0;

/// Knows where the rays of a tree are drawn: parents above the middle of their children, none on another.
struct Layout<'e> {
    rays: Vec<(&'e Node, [f64; 2])>,
    size: [f64; 2],
}

impl<'e> Layout<'e> {
    fn of(explanation: &'e Explanation) -> Self {
        let nodes: Vec<&Node> = explanation.rays().collect();
        let mut layout = Self { rays: vec![], size: [MARGIN, 0.0] };
        if let Some(root) = nodes.first() {
            layout.put(explanation, &nodes, root, 0);
        }
        layout.size = [(layout.size[0] - GAP + MARGIN).max(LEAST_WIDTH), layout.size[1] + MARGIN];
        layout
    }

    /// Places a ray and all that it gives rise to, from left to right, and answers its place across.
    fn put(&mut self, explanation: &Explanation, nodes: &[&'e Node], node: &'e Node, level: u32) -> f64 {
        let y = HEAD + f64::from(level) * LEVEL + BOX[1] / 2.0 + GAP;
        let children = nodes.iter().filter(|child| child.place / 2 == node.place);
        let across: Vec<f64> = children.map(|child| self.put(explanation, nodes, child, level + 1)).collect();
        let lights = if explanation.light_rays(node).next().is_some() { LIGHTS } else { 0.0 };
        let x = match (across.first(), across.last()) {
            (Some(first), Some(last)) => (first + last) / 2.0,
            _ => self.size[0] + BOX[0] / 2.0,
        };
        self.size[0] = self.size[0].max(x + BOX[0] / 2.0 + lights + GAP);
        self.size[1] = self.size[1].max(y + BOX[1] / 2.0);
        self.rays.push((node, [x, y]));
        x
    }

    fn of_ray(&self, node: &Node) -> Option<[f64; 2]> {
        self.rays.iter().find(|(ray, _)| ray.place == node.place).map(|(_, place)| *place)
    }
}

fn line(text: &mut String, [x, y]: [f64; 2], [to_x, to_y]: [f64; 2], color: &str, broken: bool) {
    let dashes = if broken { " stroke-dasharray=\"4 4\"" } else { "" };
    let _ = writeln!(
        text,
        "<line x1=\"{x}\" y1=\"{y}\" x2=\"{to_x}\" y2=\"{to_y}\" stroke=\"{color}\" stroke-width=\"2\"{dashes}/>"
    );
}

/// Answers the colour in which a ray is drawn: from the eye, reflected, refracted.
fn hue(node: &Node) -> &'static str {
    match node.place {
        1 => "#d6dae0",
        place if place % 2 == 0 => "#5cc8ff",
        _ => "#78dc82",
    }
}

/// Answers a light as a colour of the web, by the sRGB curve (IEC 61966-2-1).
fn swatch(light: Vector) -> String {
    let [r, g, b] = light.0.map(|light| {
        let light = light.clamp(0.0, 1.0);
        let level = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        (level * 255.0).round() as u8
    });
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Makes a text fit between tags.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
