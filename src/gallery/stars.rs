//! The same self-crossing outline by two rules, before mountains of a concave one.

super::in_every_number! {
    const POINTS: [[f64; 2]; 5] =
        [[0.0, 1.0], [-0.587785, -0.809017], [0.951057, 0.309017], [-0.951057, 0.309017], [0.587785, -0.809017]];

    /// Makes a pentagram that stands on two of its points, turned by an angle of this cosine and sine.
    const fn star(x: f64, z: f64, cosine: f64, sine: f64) -> [Vec3<S>; 5] {
        let mut corners = [v(0.0, 0.0, 0.0); 5];
        let mut i = 0;
        while i < 5 {
            let [along, up] = POINTS[i];
            corners[i] = v(x + 1.15 * along * cosine, 1.15 * (up + 0.809017), z - 1.15 * along * sine);
            i += 1;
        }
        corners
    }

    static HOLLOW: [Vec3<S>; 5] = star(-1.3, 0.0, 0.96, -0.28);
    static FULL: [Vec3<S>; 5] = star(1.3, 0.0, 1.0, 0.0);
    static MOUNTAINS: [Vec3<S>; 12] = [
        v(-40.0, -1.0, -30.0), v(40.0, -1.0, -30.0), v(40.0, 3.2, -30.0), v(21.0, 5.4, -30.0),
        v(13.5, 3.0, -30.0), v(8.0, 4.4, -30.0), v(3.0, 2.6, -30.0), v(-3.5, 5.5, -30.0),
        v(-8.5, 3.8, -30.0), v(-12.0, 4.8, -30.0), v(-22.0, 2.6, -30.0), v(-40.0, 5.0, -30.0),
    ];
    static OBJECTS: [Object<S>; 4] = [
        Object::new(Shape::Plane(Plane::new(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0))), 0),
        Object::new(Shape::Polygon(Polygon::new(&HOLLOW, v(-0.28, 0.0, 0.96), FillRule::OddEven)), 1),
        Object::new(Shape::Polygon(Polygon::new(&FULL, v(0.0, 0.0, 1.0), FillRule::Winding)), 2),
        Object::new(Shape::Polygon(Polygon::new(&MOUNTAINS, v(0.0, 0.0, 1.0), FillRule::OddEven)), 3),
    ];
    static MATERIALS: [Material<S>; 4] = [
        Material::matte(rgb(0.26, 0.24, 0.3)).with_mirror(n(0.3)),
        Material::matte(rgb(0.95, 0.6, 0.1)).with_specular(gray(0.4), 30),
        Material::matte(rgb(0.85, 0.1, 0.15)).with_specular(gray(0.4), 30),
        Material::flat(rgb(0.05, 0.045, 0.12)),
    ];
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-7.0, 6.5, 6.5), rgb(1.0, 0.85, 0.7)),
        Light::directional(v(0.5, 0.6, 0.8), rgb(0.08, 0.09, 0.15)),
    ];

    /// Two pentagrams side by side.
    pub const VIEW: View<S> = View {
        name: "stars",
        about: "one self-crossing outline by the odd-even and by the winding rule, and concave mountains",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(rgb(0.1, 0.11, 0.16))
            .with_sky(Sky::Gradient {
                up: v(0.0, 1.0, 0.0),
                nadir: rgb(0.95, 0.35, 0.08),
                zenith: rgb(0.06, 0.09, 0.45),
            }),
        camera: Camera::perspective(v(0.3, 2.5, 6.6), v(0.2, 0.95, 0.0), v(0.0, 1.0, 0.0), n(38.0)),
        settings: Settings::new().with_depth(1),
        size: [320, 240],
    };
}
