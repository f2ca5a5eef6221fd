//! An icosahedron twice: flat, and lit by the normals of the ball around it.

super::in_every_number! {
    /// Are the sides of a golden rectangle with a diagonal of 2.
    const SHORT: f64 = 0.525731112119;
    const LONG: f64 = 0.850650808352;
    const CORNERS: [[f64; 3]; 12] = [
        [-SHORT, 0.0, LONG], [SHORT, 0.0, LONG], [-SHORT, 0.0, -LONG], [SHORT, 0.0, -LONG],
        [0.0, LONG, SHORT], [0.0, LONG, -SHORT], [0.0, -LONG, SHORT], [0.0, -LONG, -SHORT],
        [LONG, SHORT, 0.0], [-LONG, SHORT, 0.0], [LONG, -SHORT, 0.0], [-LONG, -SHORT, 0.0],
    ];
    const FACES: [[usize; 3]; 20] = [
        [0, 1, 4], [0, 4, 9], [9, 4, 5], [4, 8, 5], [4, 1, 8], [8, 1, 10], [8, 10, 3], [5, 8, 3], [5, 3, 2],
        [2, 3, 7], [7, 3, 10], [7, 10, 6], [7, 6, 11], [11, 6, 0], [0, 6, 1], [6, 10, 1], [9, 11, 0],
        [9, 2, 11], [9, 5, 2], [7, 11, 2],
    ];

    /// Answers a corner of the solid that lies on its first face, turned about the upright axis.
    const fn corner(i: usize) -> [f64; 3] {
        let [x, y, z] = CORNERS[i];
        let (y, z) = (-0.356822089773 * y - 0.934172358963 * z, 0.934172358963 * y - 0.356822089773 * z);
        [0.92 * x + 0.391918359 * z, y, 0.92 * z - 0.391918359 * x]
    }

    const fn place([x, y, z]: [f64; 3], center: f64) -> Vec3<S> {
        v(center + x, 0.7946545 + y, z)
    }

    const fn color([x, y, z]: [f64; 3]) -> Rgb<S> {
        rgb(0.5 + 0.45 * x, 0.4 - 0.35 * z, 0.5 + 0.45 * y)
    }

    const fn vertex(i: usize, texture: [f64; 2]) -> Vertex<S> {
        let [x, y, z] = corner(i);
        Vertex::new(place([x, y, z], 1.15), v(x, y, z), [n(texture[0]), n(texture[1])])
    }

    const fn smooth() -> [[Vertex<S>; 3]; 20] {
        let mut faces = [[vertex(0, [0.0, 0.0]); 3]; 20];
        let mut i = 0;
        while i < 20 {
            let [a, b, c] = FACES[i];
            faces[i] = [vertex(a, [0.0, 0.0]), vertex(b, [1.0, 0.0]), vertex(c, [0.0, 1.0])];
            i += 1;
        }
        faces
    }

    const fn objects() -> [Object<S>; 41] {
        let table = Cone::cylinder(v(0.0, -0.25, 0.0), v(0.0, 0.0, 0.0), n(2.9));
        let mut objects = [Object::new(Shape::Cone(table), 20); 41];
        let mut i = 0;
        while i < 20 {
            let [a, b, c] = FACES[i];
            let [a, b, c] = [place(corner(a), -1.15), place(corner(b), -1.15), place(corner(c), -1.15)];
            objects[2 * i] = Object::new(Shape::Triangle(Triangle::new(a, b, c)), i as u16);
            objects[2 * i + 1] = Object::new(Shape::SmoothTriangle(SmoothTriangle::new(&SMOOTH[i])), i as u16);
            i += 1;
        }
        objects
    }

    const fn materials() -> [Material<S>; 21] {
        let mut materials = [Material::matte(rgb(0.24, 0.17, 0.13)).with_mirror(n(0.25)); 21];
        let mut i = 0;
        while i < 20 {
            let [a, b, c] = FACES[i];
            let colors = Vertices::new(color(corner(a)), color(corner(b)), color(corner(c)));
            materials[i] = Material::textured(Texture::Vertices(colors)).with_specular(gray(0.5), 30);
            i += 1;
        }
        materials
    }

    static SMOOTH: [[Vertex<S>; 3]; 20] = smooth();
    static OBJECTS: [Object<S>; 41] = objects();
    static MATERIALS: [Material<S>; 21] = materials();
    static LIGHTS: [Light<S>; 2] = [
        Light::point(v(-4.0, 6.0, 5.0), gray(0.85)),
        Light::directional(v(0.8, 0.4, 0.6), rgb(0.1, 0.12, 0.18)),
    ];

    /// A flat icosahedron and a smooth one.
    pub const VIEW: View<S> = View {
        name: "smooth",
        about: "an icosahedron flat and with interpolated normals, its colours mixed between the corners",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.15))
            .with_sky(Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: rgb(0.28, 0.36, 0.52), zenith: rgb(0.02, 0.04, 0.16) }),
        camera: Camera::perspective(v(0.0, 2.4, 6.4), v(0.0, 0.65, 0.0), v(0.0, 1.0, 0.0), n(34.0)),
        settings: Settings::new().with_depth(1),
        size: [320, 240],
    };
}
