//! The scene of `c-ray` (J. Tsiombikas, github.com/jtsiomb/c-ray), in linear levels as there.
//!
//! Its ground is a ball of radius 999. Its axes are left-handed, so the window runs from right to
//! left; it has no half-pixel offset, so the window is shifted by half a pixel of 320 by 240; two
//! of its axes are shorter than the third, and its eye is added to its rays, which moves the window.

super::in_every_number! {
    static OBJECTS: [Object<S>; 4] = [
        Object::new(Shape::Sphere(Sphere::new(v(-1.5, -0.3, -1.0), n(0.7))), 0),
        Object::new(Shape::Sphere(Sphere::new(v(1.5, -0.4, 0.0), n(0.6))), 1),
        Object::new(Shape::Sphere(Sphere::new(v(0.0, -1000.0, 2.0), n(999.0))), 2),
        Object::new(Shape::Sphere(Sphere::new(v(0.0, 0.0, 2.0), n(1.0))), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::matte(rgb(1.0, 0.2, 0.05)).with_specular(Rgb::WHITE, 50).with_mirror(n(0.3)),
        Material::matte(rgb(0.1, 0.85, 1.0)).with_specular(Rgb::WHITE, 50).with_mirror(n(0.4)),
        Material::matte(rgb(0.1, 0.2, 0.6)).with_specular(Rgb::WHITE, 80).with_mirror(n(0.8)),
        Material::matte(rgb(1.0, 0.5, 0.1)).with_specular(Rgb::WHITE, 60).with_mirror(n(0.7)),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-50.0, 100.0, -50.0), Rgb::WHITE),
        Light::point(v(40.0, 40.0, 150.0), Rgb::WHITE),
    ];

    // In the original's measure a ray ends at 1000 ((x / 320 - 0.5) i + (0.65 - y / 240) 3 / 4 j
    // + 8 / pi k) + eye, where i and j are 17 / sqrt(338) long, k is a unit vector, and the eye lies
    // at -17 / sqrt(338) along j and at -331 / sqrt(338) along k.
    const ROOT: f64 = 18.384_776_310_850_235;
    const DEPTH: f64 = (8.0 / core::f64::consts::PI - 0.331 / ROOT) * ROOT / 17.0;
    const HALF_COLUMN: f64 = 0.5 / 320.0;
    const HALF_ROW: f64 = 0.5 / 240.0;
    const WINDOW: Projection<S> = Projection::Frustum {
        left: n(0.5 + HALF_COLUMN),
        right: n(-0.5 + HALF_COLUMN),
        bottom: n((-0.35 + HALF_ROW) * 0.75 - 0.001),
        top: n((0.65 + HALF_ROW) * 0.75 - 0.001),
    };

    /// Three balls on a blue ground.
    pub const VIEW: View<S> = View {
        name: "c-ray",
        about: "three balls on a mirroring ground, after J. Tsiombikas's c-ray: an off-centre window, five levels",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS),
        camera: Camera::new(
            [v(0.0, 6.0, -17.0), v(0.0, -1.0, 0.0), v(0.0, 1.0, 0.0)],
            WINDOW,
            [n(DEPTH), n(1000.0)],
        ),
        settings: Settings::new().with_depth(5).with_transfer(Transfer::Linear),
        size: [320, 240],
    };
}
