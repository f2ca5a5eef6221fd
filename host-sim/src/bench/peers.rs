//! What other ray tracers for small machines take for their own pictures.

/// Is a ray tracer whose scene is in the gallery, with executed instructions a pixel of the whole frame with
/// colour packing at 320x240, one ray a pixel, built with the flags that suit it best (single precision,
/// fast-math).
pub struct Peer {
    /// The scene, by the gallery's name.
    pub scene: &'static str,
    /// Its public name.
    pub name: &'static str,
    /// Instructions a pixel on a Cortex-M4F, in `f32`.
    pub m4f: u32,
    /// Instructions a pixel on a Cortex-M3.
    pub m3: u32,
    /// Instructions a pixel on a Cortex-M0+.
    pub m0: u32,
}

/// Lists them.
pub const PEERS: [Peer; 5] = [
    Peer { scene: "tinyraytracer", name: "ssloy/tinyraytracer, f32", m4f: 1_444, m3: 36_381, m0: 72_354 },
    Peer { scene: "tinyraytracer", name: "ssloy/tinyraytracer, Q16.16", m4f: 10_120, m3: 10_112, m0: 37_228 },
    Peer { scene: "c-ray", name: "jtsiomb/c-ray, f32", m4f: 1_446, m3: 40_998, m0: 85_503 },
    Peer { scene: "playdate", name: "aras-p/demo-pd-cranktheworld", m4f: 157, m3: 4_678, m0: 9_179 },
    Peer {
        scene: "business-card",
        name: "the business-card ray tracer, 1 ray",
        m4f: 550,
        m3: 14_787,
        m0: 30_251,
    },
];

impl Peer {
    /// Answers the instructions a pixel on a chip.
    pub fn on(&self, chip: &str) -> u32 {
        match chip {
            "m4f" => self.m4f,
            "m3" => self.m3,
            _ => self.m0,
        }
    }

    /// Finds the fastest tracer of a scene on a chip.
    pub fn fastest(scene: &str, chip: &str) -> Option<&'static Self> {
        PEERS.iter().filter(|peer| peer.scene == scene).min_by_key(|peer| peer.on(chip))
    }
}
