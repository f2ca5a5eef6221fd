use scanray::{Model, Object, Scene, Shape, Sky};

/// Answers the cargo features of the core that a scene needs; the core says which these are when one is
/// missing.
pub fn features(scene: &Scene<'_, f64>) -> String {
    let shapes = scene.objects.iter().any(|Object { shape, .. }| {
        let always =
            matches!(shape, Shape::Sphere(_) | Shape::Plane(_) | Shape::Triangle(_) | Shape::Cuboid(_));
        !always && !matches!(shape, Shape::Mesh(_) | Shape::Isosurface(_))
    });
    let meshes = scene.objects.iter().any(|object| matches!(object.shape, Shape::Mesh(_)));
    let materials = || scene.materials.iter();
    let images = matches!(scene.sky, Sky::Cube(_))
        || scene.objects.iter().any(|object| matches!(object.shape, Shape::Displaced(_)))
        || materials().any(|material| material.texture.image().is_some() || material.bump.is_some());
    let glass = materials().any(|material| material.glass.is_some());
    let models = materials().any(|material| !matches!(material.model, Model::Flat | Model::Phong));
    let volumes = scene.volume.is_some()
        || scene.objects.iter().any(|object| matches!(object.shape, Shape::Isosurface(_)));
    let needs = [
        ("shapes", shapes),
        ("images", images),
        ("glass", glass),
        ("models", models),
        ("meshes", meshes),
        ("volumes", volumes),
    ];
    let named: Vec<_> = needs.iter().filter(|(_, needed)| *needed).map(|(name, _)| *name).collect();
    named.join(",")
}
