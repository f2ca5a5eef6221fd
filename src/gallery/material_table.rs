//! The table of materials of the lecture on reflection: each by three models, under daylight.
//!
//! Its lamp is the illuminant D65, which is the white of sRGB. The index of the first two, which are no
//! dielectrics, is their exponent, as in the table: 200 and 50.

super::in_every_number! {
    const fn ball(x: f64, step: f64, material: u16) -> Object<S> {
        Object::new(Shape::Sphere(Sphere::new(v(2.2 * x, 1.0 + 1.2 * step, -2.3 * step), n(1.0))), material)
    }
    const fn stair(step: f64) -> Object<S> {
        let (top, front) = (1.2 * step, -2.3 * step + 1.15);
        Object::new(Shape::Cuboid(Cuboid::new(v(-4.2, top - 1.2, front - 2.3), v(4.2, top, front))), 9)
    }
    static OBJECTS: [Object<S>; 12] = [
        ball(-1.0, 2.0, 0),
        ball(0.0, 2.0, 1),
        ball(1.0, 2.0, 2),
        ball(-1.0, 1.0, 3),
        ball(0.0, 1.0, 4),
        ball(1.0, 1.0, 5),
        ball(-1.0, 0.0, 6),
        ball(0.0, 0.0, 7),
        ball(1.0, 0.0, 8),
        stair(0.0),
        stair(1.0),
        stair(2.0),
    ];

    const ALUMINIUM: Material<S> =
        Material::matte(gray(0.6)).with_specular(gray(0.4), 200).with_ambient(n(0.0));
    const RED: Material<S> = Material::matte(rgb(0.9, 0.2, 0.2)).with_specular(Rgb::WHITE, 50);
    const CERAMIC: Material<S> =
        Material::matte(gray(0.333)).with_specular(gray(0.667), 58).with_ambient(n(0.0));
    const fn facets(index: f64) -> Model<S> {
        Model::CookTorrance(CookTorrance::new(n(0.35), n(index)))
    }
    static MATERIALS: [Material<S>; 10] = [
        ALUMINIUM.with_model(facets(200.0)),
        ALUMINIUM.with_model(Model::BlinnPhong),
        ALUMINIUM,
        RED.with_model(facets(50.0)),
        RED.with_model(Model::BlinnPhong),
        RED,
        CERAMIC.with_model(facets(1.8)),
        CERAMIC.with_model(Model::BlinnPhong),
        CERAMIC,
        Material::matte(rgb(0.10, 0.14, 0.2)),
    ];
    static LIGHTS: [Light<S>; 1] = [Light::point(v(-9.0, 14.0, 14.0), Rgb::WHITE)];

    /// Nine balls on stairs.
    pub const VIEW: View<S> = View {
        name: "material-table",
        about: "aluminium, a red and magnesium oxide, from the back, by Cook and Torrance, Blinn and Phong, from the left",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.15))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: rgb(0.25, 0.32, 0.42),
                zenith: rgb(0.02, 0.03, 0.06),
            }),
        camera: Camera::perspective(v(0.0, 7.0, 13.0), v(0.0, 1.75, -1.6), v(0.0, 1.0, 0.0), n(32.0)),
        settings: Settings::new(),
        size: [320, 240],
    };
}
