//! One chart of 24 patches (McCamy, Marcus and Davidson 1976) under three of the CIE's illuminants: D65
//! on the left wall, A on the right one, C on the floor (rows X1 and X2).
//!
//! Each patch is its reflectance under the lamp of its wall, found from spectra at compile time; the lamp
//! of the scene is grey. Its light meets all three faces at the same angle, of cosine 1 / sqrt(3), and is
//! as many times brighter, so that a patch shows its own colour.

super::in_every_number! {
    /// Is how wide and how high a patch is, and how much of that is the edge around it.
    const PATCH: [f64; 2] = [1.0, 1.5];
    const EDGE: f64 = 0.06;
    const THICKNESS: f64 = 0.06;
    /// Is the side of a face: six patches, or four.
    const SIDE: f64 = 6.0;

    const PATCHES: usize = spectrum::CHART.len();
    /// Lists the lamps of the faces; that of the right wall is about half as bright as the other two.
    const LAMPS: [(spectrum::Spectrum, f64); 3] =
        [(spectrum::D65, 1.0), (spectrum::A, 0.55), (spectrum::C, 1.0)];

    const BOARD: usize = 3 * PATCHES;
    const BALL: usize = BOARD + 1;
    const SQRT_3: f64 = 1.732_050_807_568_877_2;

    /// Answers where a patch begins and ends along and across its face.
    const fn extent(patch: usize) -> [[f64; 2]; 2] {
        let (column, row) = ((patch % 6) as f64, (patch / 6) as f64);
        let [left, top] = [column * PATCH[0] + EDGE, row * PATCH[1] + EDGE];
        let [right, bottom] = [left + PATCH[0] - 2.0 * EDGE, top + PATCH[1] - 2.0 * EDGE];
        [[left, right], [top, bottom]]
    }

    /// Answers a patch of a face, seen from in front with the first one at its upper left.
    const fn tile(face: usize, patch: usize) -> Object<S> {
        let [[left, right], [top, bottom]] = extent(patch);
        let (low, high) = match face {
            0 => (v(0.0, SIDE - bottom, SIDE - right), v(THICKNESS, SIDE - top, SIDE - left)),
            1 => (v(left, SIDE - bottom, 0.0), v(right, SIDE - top, THICKNESS)),
            _ => (v(left, 0.0, top), v(right, THICKNESS, bottom)),
        };
        Object::new(Shape::Cuboid(Cuboid::new(low, high)), (face * PATCHES + patch) as u16)
    }

    const fn board(low: Vec3<S>, high: Vec3<S>) -> Object<S> {
        Object::new(Shape::Cuboid(Cuboid::new(low, high)), BOARD as u16)
    }

    const fn objects() -> [Object<S>; BALL + 3] {
        let ball = Sphere::new(v(3.4, 1.16, 3.4), n(1.1));
        let mut objects = [Object::new(Shape::Sphere(ball), BALL as u16); BALL + 3];
        let mut i = 0;
        while i < BOARD {
            objects[i] = tile(i / PATCHES, i % PATCHES);
            i += 1;
        }
        objects[BOARD] = board(v(-0.2, -0.2, -0.2), v(SIDE, 0.0, SIDE));
        objects[BOARD + 1] = board(v(-0.2, 0.0, -0.2), v(0.0, SIDE, SIDE));
        objects[BOARD + 2] = board(v(0.0, 0.0, -0.2), v(SIDE, SIDE, 0.0));
        objects
    }

    const fn materials() -> [Material<S>; BALL + 1] {
        let mirror = Material::matte(Rgb::BLACK).with_specular(gray(0.6), 300).with_mirror(n(0.915));
        let mut materials = [mirror; BALL + 1];
        let mut i = 0;
        while i < BOARD {
            let (lamp, power) = LAMPS[i / PATCHES];
            let xyz = spectrum::CHART[i % PATCHES].reflectance.under(&lamp).scaled(power);
            materials[i] = Material::matte(Rgb::<S>::from_xyz(xyz));
            i += 1;
        }
        materials[BOARD] = Material::matte(gray(0.012));
        materials
    }

    static OBJECTS: [Object<S>; BALL + 3] = objects();
    static MATERIALS: [Material<S>; BALL + 1] = materials();
    static LIGHTS: [Light<S>; 1] = [Light::directional(v(1.0, 1.0, 1.0), gray(SQRT_3))];

    /// A room of three colour charts and a ball that mirrors them.
    pub const VIEW: View<S> = View {
        name: "color-chart",
        about: "a colour chart's spectra under the CIE's D65 (left), A (right) and C (floor), and an aluminium ball",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: rgb(0.01, 0.01, 0.015),
                zenith: rgb(0.45, 0.52, 0.65),
            }),
        camera: Camera::perspective(v(14.4, 11.2, 13.4), v(2.5, 2.12, 2.35), v(0.0, 1.0, 0.0), n(32.5)),
        settings: Settings::new(),
        size: [240, 240],
    };
}
