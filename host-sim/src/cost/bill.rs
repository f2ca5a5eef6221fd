use super::counted::Counted;
use crate::growth::{Operations, Tally};
use scanray::trace::{Observer, RayCounts, RayKind};

/// Is what a pixel takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bill {
    /// Rays by kind.
    pub rays: RayCounts,
    /// How often a shape was asked whether a ray meets it; a mesh counts once, whatever it asks inside.
    pub shapes: u64,
    /// Operations of the number by kind.
    pub operations: Operations,
    /// Instructions that a chip has executed; none where no chip was asked.
    pub instructions: Option<u64>,
    /// Place of the object that the ray from the eye has met; none for the sky.
    pub sees: Option<u16>,
}

impl Bill {
    /// Answers what is left without what it takes to begin.
    pub(super) fn without(self, begun: &Self) -> Self {
        let operations = self.operations - begun.operations;
        Self { shapes: self.shapes - begun.shapes, operations, ..self }
    }
}

/// Names what of a pixel's bill a map shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// Rays of all kinds.
    Rays,
    /// Shapes asked.
    Shapes,
    /// Operations of the number.
    Operations,
    /// Instructions of a chip.
    Instructions,
}

impl What {
    /// Lists all.
    pub const ALL: [Self; 4] = [Self::Rays, Self::Shapes, Self::Operations, Self::Instructions];

    /// Answers the name, as commands take it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rays => "rays",
            Self::Shapes => "shapes",
            Self::Operations => "operations",
            Self::Instructions => "instructions",
        }
    }

    /// Answers how many of them a bill has.
    pub fn of(self, bill: &Bill) -> u64 {
        match self {
            Self::Rays => bill.rays.total(),
            Self::Shapes => bill.shapes,
            Self::Operations => bill.operations.total(),
            Self::Instructions => bill.instructions.unwrap_or(0),
        }
    }
}

/// Is where this thread's counts stand.
#[derive(Clone, Copy)]
pub(super) struct Stand {
    shapes: u64,
    operations: Operations,
}

impl Stand {
    /// Reads the counts.
    pub fn now() -> Self {
        Self { shapes: Counted::asked(), operations: Tally::by_kind() }
    }

    /// Answers what has come to them since.
    pub fn since(self, watch: Watch) -> Bill {
        let now = Self::now();
        let sees = watch.met.filter(|object| *object != u16::MAX);
        let operations = now.operations - self.operations;
        Bill { rays: watch.rays, shapes: now.shapes - self.shapes, operations, instructions: None, sees }
    }
}

/// Watches the rays of a pixel.
#[derive(Clone, Copy, Default)]
pub(super) struct Watch {
    rays: RayCounts,
    /// What the ray from the eye has met.
    met: Option<u16>,
}

/// Is the number by which observers are told of a volume.
const VOLUME: u16 = u16::MAX - 1;

impl Observer for Watch {
    const SEES_TILES: bool = false;

    fn ray(&mut self, kind: RayKind) {
        self.rays.ray(kind);
    }

    fn met(&mut self, _: u8, object: u16, _: u32) {
        if object != VOLUME {
            self.met = self.met.or(Some(object));
        }
    }
}
