use crate::shot::{Quality, Sampling};
use clap::Args;
use scanray::Uniform;

/// Is how many rays a picture takes.
#[derive(Debug, Args)]
pub(super) struct Rays {
    /// How much of the picture is traced
    #[arg(long, default_value = "exact")]
    quality: Quality,
    /// Trace N x N rays a pixel and average their light
    #[arg(long, value_name = "N", value_parser = samples, conflicts_with = "quality")]
    samples: Option<u8>,
    /// Scatter the rays of a pixel: noise in place of false patterns
    #[arg(long, requires = "samples")]
    jitter: bool,
    /// Trace N x N rays only through pixels on an edge, and one through each other
    #[arg(long, requires = "samples")]
    adaptive_samples: bool,
}

impl Rays {
    /// Answers the quality that is asked for.
    pub fn quality(&self) -> Quality {
        let (jittered, at_edges) = (self.jitter, self.adaptive_samples);
        self.samples.map_or(self.quality, |side| Quality::Sampled(Sampling { side, jittered, at_edges }))
    }
}

fn samples(text: &str) -> Result<u8, String> {
    let side = text.parse().ok().filter(|side| (1..=Uniform::MOST).contains(side));
    side.ok_or_else(|| format!("N is a number from 1 to {}, such as 2 for 4 rays a pixel", Uniform::MOST))
}
