use std::fmt;

/// Is the bytes of a scene's data, by kind.
///
/// Lists of things that hold addresses are counted as this computer has them, with addresses of 64 bits: on a
/// device they are smaller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bill {
    /// Numbers of the corners of triangles.
    pub triangles: usize,
    /// Corners of meshes, with their texture coordinates.
    pub corners: usize,
    /// Normals of meshes.
    pub normals: usize,
    /// The meshes themselves.
    pub meshes: usize,
    /// Hierarchies over triangles and objects.
    pub hierarchies: usize,
    /// Corners of polygons and smooth triangles.
    pub outlines: usize,
    /// Objects.
    pub objects: usize,
    /// Materials.
    pub materials: usize,
    /// Lights.
    pub lights: usize,
    /// Texels.
    pub images: usize,
    /// Values of voxels, with the extremes of their blocks.
    pub voxels: usize,
    /// The grids of voxels, the volume and its classes.
    pub volumes: usize,
    /// How many triangles there are in meshes.
    pub triangle_count: usize,
    /// How many corners there are in meshes.
    pub corner_count: usize,
    /// How many voxels there are.
    pub voxel_count: usize,
}

impl Bill {
    /// Lists what there is of each kind, as it is called, and its bytes.
    pub fn items(&self) -> impl Iterator<Item = (&'static str, usize)> {
        let items = [
            ("triangles", self.triangles),
            ("corners", self.corners),
            ("normals", self.normals),
            ("meshes", self.meshes),
            ("hierarchies", self.hierarchies),
            ("outlines", self.outlines),
            ("objects", self.objects),
            ("materials", self.materials),
            ("lights", self.lights),
            ("images", self.images),
            ("voxels", self.voxels),
            ("volumes", self.volumes),
        ];
        items.into_iter().filter(|(_, bytes)| *bytes > 0)
    }

    /// Answers the sum in bytes.
    pub fn total(&self) -> usize {
        self.items().map(|(_, bytes)| bytes).sum()
    }
}

impl fmt::Display for Bill {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let items: Vec<String> = self.items().map(|(kind, bytes)| format!("{kind} {bytes}")).collect();
        write!(f, "{} bytes = {}", self.total(), items.join(" + "))
    }
}
