use super::trail::Trail;
use super::vector::Vector;

/// Tells how the light of a pixel comes about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Account {
    /// Linear light after exposure.
    pub light: Vector,
    /// The rays of the tree, each before those that it gives rise to.
    pub visits: Vec<Visit>,
    /// Light that a volume before all of it sends, exposed, and the share of the light behind that comes through.
    pub veil: Option<(Vector, f64)>,
}

/// Is a ray of the tree with what it has met.
#[derive(Clone, Debug, PartialEq)]
pub struct Visit {
    /// Place in the binary tree: 1 for the ray from the eye; of place n the reflected ray has 2n and the
    /// refracted one 2n + 1.
    pub place: u64,
    /// Where the ray goes, unit length, where that had to be known.
    pub direction: Option<Vector>,
    /// What of its light reaches the eye, exposed.
    pub weight: Vector,
    /// The surface it has met; none for the sky.
    pub surface: Option<Surface>,
    /// What the surface or the sky sends itself.
    pub sent: Vector,
    /// What has reached the eye of this ray and all before it.
    pub gathered: Vector,
}

/// Is a place on an object, with the light it reflects.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Place of the object in the scene's list.
    pub object: usize,
    /// Distance from where the ray started.
    pub distance: f64,
    /// The place that is lit.
    pub point: Vector,
    /// Unit length, on the viewer's side.
    pub normal: Vector,
    /// What is reflected of white ambient light, and what is sent of the scene's; none of a flat colour.
    pub ambient: Option<[Vector; 2]>,
    /// For each light what it does here; a list shorter than that of the scene leaves out those after it.
    pub lights: Vec<Shine>,
}

/// Is what a light does to a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shine {
    /// It shines on the other side, or past it.
    Away,
    /// Something stands between.
    Blocked,
    /// It arrives.
    Lit(Lit),
}

/// Is what a surface reflects of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit {
    /// Light that arrives.
    pub arriving: Vector,
    /// Cosine between the normal and the way to the light.
    pub cosine: f64,
    /// Share that is reflected diffusely.
    pub diffuse: Vector,
    /// Share that the highlight sends to the viewer.
    pub highlight: Vector,
    /// What is sent of it.
    pub sent: Vector,
}

impl Shine {
    /// Answers what arrives, if anything.
    pub fn lit(&self) -> Option<&Lit> {
        if let Self::Lit(lit) = self { Some(lit) } else { None }
    }
}

/// Is what is written down while a tree of rays is followed: what it met, and the account if it is asked for.
#[derive(Default)]
pub(super) struct Notes {
    pub trail: Trail,
    account: Option<Account>,
}

impl Notes {
    /// Makes notes that keep an account too.
    pub fn with_account() -> Self {
        Self { trail: Trail::new(), account: Some(Account::default()) }
    }

    /// Takes down a ray, if an account is kept, and sums up what is gathered.
    pub fn visit(&mut self, visit: impl FnOnce() -> Visit) {
        if let Some(account) = &mut self.account {
            let visit = visit();
            account.light = account.light + visit.weight.filter(visit.sent);
            account.visits.push(Visit { gathered: account.light, ..visit });
        }
    }

    /// Takes down a volume, if an account is kept.
    pub fn veil(&mut self, veil: impl FnOnce() -> (Vector, f64)) {
        if let Some(account) = &mut self.account {
            account.veil = Some(veil());
        }
    }

    /// Answers the account of a pixel of this light; an empty one if none was kept.
    pub fn into_account(self, light: Vector) -> Account {
        Account { light, ..self.account.unwrap_or_default() }
    }
}
