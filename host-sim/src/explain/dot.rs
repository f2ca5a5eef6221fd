use super::{Explanation, Node};
use crate::reference::Shine;
use std::fmt::Write;

impl Explanation {
    /// Answers the tree of rays of the first number as a graph in Graphviz's language.
    pub fn dot(&self) -> String {
        let mut text = format!(
            "digraph \"{}\" {{\n  node [shape=box fontname=\"sans-serif\"];\n",
            quoted(&self.title())
        );
        for node in self.rays() {
            let _ =
                writeln!(text, "  {} [label=\"{}\"];", node.name, quoted(&self.captions(node).join("\n")));
            if let Some(parent) = node.parent.and_then(|parent| self.tree.get(parent)) {
                let _ = writeln!(text, "  {} -> {};", parent.name, node.name);
            }
            for (ray, shine) in self.light_rays(node) {
                let (name, light) = (&ray.name, quoted(self.names.light(ray.light)));
                let style = if matches!(shine, Shine::Lit(_)) { "solid" } else { "dashed" };
                let _ = writeln!(text, "  {name} [label=\"{name}\\n{light}\" shape=ellipse];");
                let _ = writeln!(text, "  {} -> {name} [style={style}];", node.name);
            }
        }
        text + "}\n"
    }

    /// Answers what a drawing of the tree is called.
    pub(super) fn title(&self) -> String {
        let [x, y] = self.pixel;
        format!("{} {x},{y} in {}", self.shot.scene.name(), self.drawn().name)
    }

    /// Answers the lines that a drawing writes to a ray: its name, what it meets, its weight.
    pub(super) fn captions(&self, node: &Node) -> [String; 3] {
        let visit = self.drawn().visit(node.place);
        let object = visit.and_then(|visit| visit.surface.as_ref()).map(|surface| surface.object);
        let [r, g, b] = visit.map_or([0.0; 3], |visit| visit.weight.0);
        let weight = match r {
            _ if r != g || g != b => format!("weight {r:.2} {g:.2} {b:.2}"),
            0.0005.. => format!("weight {r:.3}"),
            _ => format!("weight {r:.0e}"),
        };
        [node.name.clone(), self.names.object(object).to_owned(), weight]
    }
}

/// Makes a text fit between quotation marks.
fn quoted(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n")
}
