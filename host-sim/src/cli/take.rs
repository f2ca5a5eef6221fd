use super::Error;
use super::progress::Progress;
use crate::shot::{Shot, Taken};

/// Traces a picture, with a progress bar if it takes long.
pub(super) fn take(shot: &Shot) -> Result<Taken, Error> {
    let mut progress = Progress::new(u64::from(shot.size[1]), format!("drawing {}", shot.scene.name()));
    shot.take(|_| progress.step()).map_err(|refusal| Error::refused(&shot.scene, refusal))
}
