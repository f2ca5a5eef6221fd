use super::parting::furthest;
use super::{Column, Explanation, LightRay, Node, parting};
use crate::reference::{Lit, Shine, Surface, Vector, Visit};
use crate::word::bits;
use scanray::Dither;
use std::fmt::{self, Display, Formatter};

/// Is how wide a column is: three figures.
const WIDTH: usize = 31;

/// Is a pixel's explanation in words and figures, the numbers in columns beside the reference.
impl Display for Explanation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.heading(f)?;
        for node in &self.tree {
            self.ray(f, node)?;
        }
        writeln!(f, "\nThe pixel")?;
        writeln!(f, "  {}", self.rounding())?;
        self.veil(f)?;
        self.row(f, "light", |column| Some(column.account.light.0.to_vec()))?;
        self.row(f, "in steps", |column| Some(column.levels.clone()))?;
        self.words(f, "in bits", |column| bits(self.shot.panel, column.shown))?;
        self.words(f, "shown", |column| format!("{:?}", column.shown))?;
        self.closing(f)
    }
}

impl Explanation {
    fn heading(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let ([x, y], [columns, rows]) = (self.pixel, self.shot.size);
        let (scene, panel, depth) = (self.shot.scene.name(), self.shot.panel.name(), self.shot.depth);
        writeln!(f, "{scene}: pixel {x},{y} of {columns}x{rows}, depth {depth}, panel {panel}")?;
        write!(f, "{:12}", "")?;
        for column in self.all() {
            write!(f, "{:>WIDTH$}", column.name)?;
        }
        for column in &self.columns {
            write!(f, "{:>11}", format!("{} off", column.name))?;
        }
        writeln!(f)
    }

    /// Says how the pixel's place decides between the two levels beside what is wanted.
    fn rounding(&self) -> String {
        let ([x, y], panel) = (self.pixel, self.shot.panel.name());
        if matches!(self.shot.dither, Dither::Diffused) {
            return format!(
                "is rounded to steps of {panel} with what the pixels to its left were rounded off by"
            );
        }
        let from = 1.0 - f64::from(self.shot.dither.threshold(x, y)) / 65_536.0;
        format!("is rounded up to the next step of {panel} from {from:.3} of one on")
    }

    /// Tells of a ray and all that its surface sends.
    fn ray(&self, f: &mut Formatter<'_>, node: &Node) -> fmt::Result {
        let of = |column: &Column| column.visit(node.place).cloned();
        writeln!(f, "\n{} {}", node.name, self.origin(node))?;
        if node.place == 1 {
            self.offered(f)?;
        }
        self.triple(f, "direction", |column| of(column)?.direction)?;
        self.words(f, "meets", |column| self.met(of(column).as_ref()))?;
        let surface = |column: &Column| of(column)?.surface;
        self.row(f, "distance", |column| Some(vec![surface(column)?.distance]))?;
        self.triple(f, "point", |column| Some(surface(column)?.point))?;
        self.triple(f, "normal", |column| Some(surface(column)?.normal))?;
        self.triple(f, "colour", |column| Some(surface(column)?.ambient?[0]))?;
        self.triple(f, "ambient", |column| Some(surface(column)?.ambient?[1]))?;
        for ray in &node.lights {
            self.light(f, ray, |column| surface(column).as_ref().map(|surface| shine(surface, ray)))?;
        }
        self.triple(f, "sends", |column| Some(of(column)?.sent))?;
        self.triple(f, "weight", |column| Some(of(column)?.weight))?;
        self.triple(f, "gathered", |column| Some(of(column)?.gathered))
    }

    /// Says where a ray comes from.
    fn origin(&self, node: &Node) -> String {
        let from = node.parent.and_then(|parent| self.tree.get(parent)).map_or("", |parent| &parent.name);
        match node.place {
            1 => "sets out from the eye through the middle of the pixel".to_owned(),
            place if place % 2 == 0 => format!("is reflected where {from} ends"),
            _ => format!("is refracted where {from} ends"),
        }
    }

    /// Says which objects the spans of the row leave to the pixel.
    fn offered(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let count = self.shot.scene.double.scene.objects.len();
        for column in &self.columns {
            write!(f, "  in {:7} ", column.name)?;
            match column.offered.as_deref() {
                None => writeln!(
                    f,
                    "it is offered none of {count} objects: no ray is needed for the sky's light"
                )?,
                Some([]) => writeln!(f, "it is offered none of {count} objects")?,
                Some(offered) => {
                    let names = offered.iter().map(|index| self.names.object(Some(usize::from(*index))));
                    let names: Vec<_> = names.collect();
                    writeln!(f, "it is offered {} of {count} objects: {}", offered.len(), names.join(", "))?;
                }
            }
        }
        Ok(())
    }

    fn met(&self, visit: Option<&Visit>) -> String {
        let object = |surface: &Surface| surface.object;
        visit.map_or("-".to_owned(), |visit| self.names.object(visit.surface.as_ref().map(object)).to_owned())
    }

    /// Tells of a ray to a light and what is sent of that light.
    fn light(
        &self,
        f: &mut Formatter<'_>,
        ray: &LightRay,
        shine: impl Fn(&Column) -> Option<Shine>,
    ) -> fmt::Result {
        let word = |column: &Column| match shine(column) {
            None => "-".to_owned(),
            Some(Shine::Away) => "is on the other side".to_owned(),
            Some(Shine::Blocked) => self.blocked(column, ray),
            Some(Shine::Lit(_)) => "arrives".to_owned(),
        };
        writeln!(f, "  {} to {}", ray.name, self.names.light(ray.light))?;
        self.words(f, "  it", word)?;
        let lit = |column: &Column| shine(column).and_then(|shine| shine.lit().copied());
        self.triple(f, "  arriving", |column| Some(lit(column)?.arriving))?;
        self.row(f, "  cosine", |column| Some(vec![lit(column)?.cosine]))?;
        self.triple(f, "  diffuse", |column| Some(lit(column)?.diffuse))?;
        self.triple(f, "  highlight", |column| Some(lit(column)?.highlight))?;
        self.triple(f, "  sends", |column| lit(column).map(|Lit { sent, .. }| sent))
    }

    /// Says what stands before a light, where that is known.
    fn blocked(&self, column: &Column, ray: &LightRay) -> String {
        let holder = self.tree.iter().find(|node| node.lights.contains(ray)).map(|node| node.place);
        let known = |(place, light, _): &&(u64, usize, usize)| Some(*place) == holder && *light == ray.light;
        let blocker = column.blockers.iter().find(known).map(|(.., object)| *object);
        blocker
            .map_or("is blocked".to_owned(), |object| format!("behind {}", self.names.object(Some(object))))
    }

    fn veil(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.triple(f, "volume", |column| column.account.veil.map(|(color, _)| color))?;
        self.row(f, "lets through", |column| column.account.veil.map(|(_, through)| vec![through]))
    }

    /// Says where the numbers part from the reference.
    fn closing(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let panel = self.shot.panel.name();
        writeln!(f)?;
        for column in &self.columns {
            let parting = parting(self, column);
            let apart = format!("the colours end {:.3} steps of {panel} apart", parting.apart);
            match parting.step {
                None => writeln!(f, "{}: no step is off by a step of the panel; {apart}.", column.name)?,
                Some(first) => {
                    let (name, steps) = (column.name, first.steps);
                    writeln!(
                        f,
                        "{name}: first off by more than a step of the panel, {steps:.1}, in {}; {apart}.",
                        first.what
                    )?;
                }
            }
        }
        Ok(())
    }

    fn triple(
        &self,
        f: &mut Formatter<'_>,
        about: &str,
        of: impl Fn(&Column) -> Option<Vector>,
    ) -> fmt::Result {
        self.row(f, about, |column| Some(of(column)?.0.to_vec()))
    }

    /// Writes figures in columns, and how far the numbers' are from the reference's; nothing where nobody has any.
    fn row(
        &self,
        f: &mut Formatter<'_>,
        about: &str,
        of: impl Fn(&Column) -> Option<Vec<f64>>,
    ) -> fmt::Result {
        let cells: Vec<Option<Vec<f64>>> = self.all().map(of).collect();
        if cells.iter().all(Option::is_none) {
            return Ok(());
        }
        write!(f, "  {about:<12}")?;
        for cell in &cells {
            let text: String = cell.iter().flatten().map(|value| format!(" {}", figure(*value))).collect();
            write!(f, "{:>WIDTH$}", if cell.is_some() { &text } else { "-" })?;
        }
        let (truth, numbers) = cells.split_last().unwrap_or((&None, &[]));
        for cell in numbers {
            let off = cell.as_ref().zip(truth.as_ref()).map_or("-".to_owned(), |(a, b)| off(a, b));
            write!(f, "{off:>11}")?;
        }
        writeln!(f)
    }

    fn words(&self, f: &mut Formatter<'_>, about: &str, of: impl Fn(&Column) -> String) -> fmt::Result {
        write!(f, "  {about:<12}")?;
        for column in self.all() {
            let text: String = of(column).chars().take(WIDTH - 2).collect();
            write!(f, "{text:>WIDTH$}")?;
        }
        writeln!(f)
    }
}

fn shine(surface: &Surface, ray: &LightRay) -> Shine {
    surface.lights.get(ray.light).copied().unwrap_or(Shine::Away)
}

/// Writes a value in nine places, with as many decimals as they leave.
fn figure(value: f64) -> String {
    let decimals = match value.abs() {
        ..9.9999995 => 6,
        ..99.999995 => 5,
        ..999.99995 => 4,
        _ => 3,
    };
    format!("{value:9.decimals$}")
}

/// Writes the largest distance of two lists of values.
fn off(a: &[f64], b: &[f64]) -> String {
    let most = furthest(a, b);
    if most == 0.0 { "0".to_owned() } else { format!("{most:.0e}") }
}
