//! A head as a scanner sees it, made up: voxels of air, fat, muscle and bone.

use crate::volume::Voxels;

/// Is the values, the left side of the head at low x, the neck at low y, the face at high z.
pub(super) const HEAD: Voxels = Voxels::new([48, 60, 56], include_bytes!("images/head_48x60x56.voxels"))
    .with_blocks(include_bytes!("images/head_48x60x56.blocks"));
