//! Scenes ready to draw: `static`, in every number, the same in flash and on a host.
//!
//! ```
//! use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
//! use scanray::{Renderer, Workspace, gallery};
//!
//! let view = &gallery::float::SIMPLE;
//! let mut workspace = Workspace::<f32, Rgb565, 240, 5>::new();
//! let mut renderer = Renderer::new(
//!     &view.scene, &view.camera, Size::new(240, 240), view.settings, &mut workspace)?;
//! let mut row = [Rgb565::BLACK; 240];
//! renderer.render_row(120, &mut row)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::camera::Camera;
use crate::math::Scalar;
use crate::render::Settings;
use crate::scene::Scene;

/// Defines the same items once for each number, in the modules `float`, `fixed` and `double`.
///
/// Inside, `S` is the number, `n` makes one of a literal, `v` a vector, `rgb` a colour and `gray`
/// a grey.
macro_rules! in_every_number {
    ($($items:tt)*) => {
        /// The scene in `f32`.
        pub mod float {
            type S = f32;
            const fn n(value: f64) -> S { value as f32 }
            $crate::gallery::with_makers! { $($items)* }
        }
        /// The scene in fixed point.
        pub mod fixed {
            type S = $crate::math::Fixed;
            const fn n(value: f64) -> S { S::new(value) }
            $crate::gallery::with_makers! { $($items)* }
        }
        /// The scene in `f64`.
        pub mod double {
            type S = f64;
            const fn n(value: f64) -> S { value }
            $crate::gallery::with_makers! { $($items)* }
        }
    };
}

macro_rules! with_makers {
    ($($items:tt)*) => {
        #[allow(unused_imports, reason = "no scene uses everything")]
        use $crate::{camera::*, brdf::CookTorrance, environment::*, gallery::View, glass::*, light::*, material::*,
            math::{Vec3, cosine},
            output::*, render::Settings, scene::*, shape::*, spectrum, texture::*, color::Rgb};
        #[allow(dead_code, reason = "no scene uses everything")]
        const fn v(x: f64, y: f64, z: f64) -> Vec3<S> { Vec3::new(n(x), n(y), n(z)) }
        #[allow(dead_code, reason = "no scene uses everything")]
        const fn rgb(r: f64, g: f64, b: f64) -> Rgb<S> { Rgb::new(n(r), n(g), n(b)) }
        #[allow(dead_code, reason = "no scene uses everything")]
        const fn gray(level: f64) -> Rgb<S> { rgb(level, level, level) }
        $($items)*
    };
}

use {in_every_number, with_makers};

mod bump;
mod business_card;
mod c_ray;
mod color_chart;
mod displaced;
mod environment;
mod first_light;
mod glass;
mod images;
mod knot;
mod material_table;
mod meshes;
mod mirror_levels;
mod orthographic;
mod playdate;
mod simple;
mod smooth;
mod spots;
mod stars;
mod still_life;
mod teapot;
mod textured;
mod three_spheres;
mod tinyraytracer;
mod z_buffer;

/// Is a scene with the camera and settings that show it best.
#[derive(Clone, Copy, Debug)]
pub struct View<S: Scalar + 'static> {
    /// Name, as commands take it.
    pub name: &'static str,
    /// What it shows and where it comes from, in a sentence or two.
    pub about: &'static str,
    /// What there is to see.
    pub scene: Scene<'static, S>,
    /// Where it is seen from.
    pub camera: Camera<S>,
    /// How the picture is made.
    pub settings: Settings<S>,
    /// Columns and rows of the usual picture.
    pub size: [u32; 2],
}

/// Is a number in which the gallery can be had.
pub trait Gallery: Scalar {
    /// Answers all views, in the order in which they are best looked at.
    fn views() -> &'static [View<Self>];

    /// Finds a view by its name.
    fn find(name: &str) -> Option<&'static View<Self>> {
        Self::views().iter().find(|view| view.name == name)
    }
}

macro_rules! gallery_of {
    ($module:ident, $number:ty, $about:literal) => {
        #[doc = $about]
        pub mod $module {
            pub use super::bump::$module::VIEW as BUMP;
            pub use super::business_card::$module::VIEW as BUSINESS_CARD;
            pub use super::c_ray::$module::VIEW as C_RAY;
            pub use super::color_chart::$module::VIEW as COLOR_CHART;
            pub use super::displaced::$module::VIEW as DISPLACED;
            pub use super::environment::$module::VIEW as ENVIRONMENT;
            pub use super::first_light::$module::VIEW as FIRST_LIGHT;
            pub use super::glass::$module::VIEW as GLASS;
            pub use super::knot::$module::VIEW as KNOT;
            pub use super::material_table::$module::VIEW as MATERIAL_TABLE;
            pub use super::mirror_levels::$module::VIEW as MIRROR_LEVELS;
            pub use super::orthographic::$module::VIEW as ORTHOGRAPHIC;
            pub use super::playdate::$module::VIEW as PLAYDATE;
            pub use super::simple::$module::VIEW as SIMPLE;
            pub use super::smooth::$module::VIEW as SMOOTH;
            pub use super::spots::$module::VIEW as SPOTS;
            pub use super::stars::$module::VIEW as STARS;
            pub use super::still_life::$module::VIEW as STILL_LIFE;
            pub use super::teapot::$module::VIEW as TEAPOT;
            pub use super::textured::$module::VIEW as TEXTURED;
            pub use super::three_spheres::$module::VIEW as THREE_SPHERES;
            pub use super::tinyraytracer::$module::VIEW as TINYRAYTRACER;
            pub use super::z_buffer::$module::VIEW as Z_BUFFER;

            /// Lists the gallery; a constant that takes one of it links that scene alone.
            pub static VIEWS: &[super::View<$number>] = &[
                SIMPLE,
                FIRST_LIGHT,
                MIRROR_LEVELS,
                GLASS,
                ORTHOGRAPHIC,
                MATERIAL_TABLE,
                SPOTS,
                THREE_SPHERES,
                TINYRAYTRACER,
                C_RAY,
                BUSINESS_CARD,
                PLAYDATE,
                STARS,
                STILL_LIFE,
                SMOOTH,
                Z_BUFFER,
                TEAPOT,
                KNOT,
                TEXTURED,
                BUMP,
                DISPLACED,
                ENVIRONMENT,
                COLOR_CHART,
            ];
        }

        impl Gallery for $number {
            fn views() -> &'static [View<Self>] {
                $module::VIEWS
            }
        }
    };
}

gallery_of!(float, f32, "The gallery in `f32`, for chips with a floating-point unit.");
gallery_of!(fixed, crate::math::Fixed, "The gallery in fixed point, for chips without one.");
gallery_of!(double, f64, "The gallery in `f64`, for measuring on a host.");
