//! A skull on a mirror: the surface in the voxels of a head at the value of bone.

super::in_every_number! {
    use crate::gallery::head::HEAD;

    static HEAD_GRID: Grid<S> = Grid::new(HEAD, v(-0.846, -1.14, -0.98), v(0.036, 0.0365, 0.0365));
    static OBJECTS: [Object<S>; 2] = [
        Object::new(Shape::Isosurface(Isosurface::new(&HEAD_GRID, n(175.0))), 0),
        Object::new(Shape::Plane(Plane::new(v(0.0, -0.8, 0.0), v(0.0, 1.0, 0.0))), 1),
    ];
    static MATERIALS: [Material<S>; 2] = [
        Material::matte(rgb(0.85, 0.78, 0.62)).with_specular(gray(0.25), 30),
        Material::matte(rgb(0.12, 0.10, 0.10)).with_mirror(n(0.35)),
    ];
    static LIGHTS: [Light<S>; 3] = [
        Light::point(v(-3.0, 4.0, 4.0), rgb(1.0, 0.92, 0.8)),
        Light::directional(v(1.0, 0.3, 0.1), rgb(0.08, 0.12, 0.2)),
        // Into the eyes.
        Light::directional(v(-0.35, 0.1, 1.0), rgb(0.12, 0.13, 0.16)),
    ];

    /// A skull on a mirror.
    pub const VIEW: View<S> = View {
        name: "isosurface",
        about: "a skull on a mirror: the surface where the voxels of a head have the value of bone",
        scene: Scene::new(&OBJECTS, &MATERIALS, &LIGHTS)
            .with_ambient(gray(0.1))
            .with_sky(Sky::Gradient { up: v(0.0, 1.0, 0.0), nadir: rgb(0.3, 0.3, 0.35), zenith: rgb(0.02, 0.03, 0.06) }),
        camera: Camera::perspective(v(-2.1, 0.55, 4.2), v(0.05, -0.14, 0.0), v(0.0, 1.0, 0.0), n(26.0)),
        settings: Settings::new().with_depth(1),
        size: [240, 240],
    };
}
