//! Projects for boards: what `scanray new` writes is complete, builds for its chip, and draws what the host computes.

mod built;
mod project;
mod refusals;
mod run;
mod wires;
