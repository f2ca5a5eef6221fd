//! The playground: the core in a web page, served on this computer or written to a folder for any web server.
//!
//! [`build`] makes the core for browsers, [`site`] gathers what a browser asks for, [`server`] hands it out.

pub mod build;
mod fault;
pub mod server;
pub mod site;

pub use fault::Fault;
pub use server::Server;
pub use site::Site;
