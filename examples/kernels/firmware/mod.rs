//! What runs on the board: every kernel over the same operands, against the counter.

mod board;
#[path = "../../boards/decimal.rs"]
mod decimal;
mod operands;

use core::{hint::black_box, panic::PanicInfo};

use scanray::math::{Scalar, Wide};
use scanray::{Fixed, ray::Ray};

use self::{board::INSTRUCTIONS_PER_TICK, decimal::Decimal, operands::Operands};

// The interrupt table that the linker script of this target's other board asks for.
#[cfg(not(target_has_atomic = "32"))]
use rp2040_hal as _;

/// Goes over the operands this often, so that a tick is a small part of the time.
const ROUNDS: u32 = 16;

#[cortex_m_rt::entry]
fn main() -> ! {
    board::print(&[b"instructions, fixed point"]);
    measure::<Fixed>();
    // Without the unit, floats are a library's work, which these figures are not about.
    #[cfg(target_abi = "eabihf")]
    {
        board::print(&[b"instructions, f32"]);
        measure::<f32>();
    }
    board::leave(true)
}

/// Prints what each kernel takes in one number.
fn measure<S: Scalar>() {
    let list = Operands::<S>::new();
    let loop_alone = ticks(&list, |o| o.a.x);
    let print = |name: &str, ticks: u32| print_figure(name, ticks.saturating_sub(loop_alone));
    print("add", ticks(&list, |o| o.a.x + o.b.x));
    print("multiply", ticks(&list, |o| o.a.x * o.b.x));
    print("square, wide", ticks(&list, |o| o.a.x.mul_wide(o.a.x)));
    print("multiply, wide", ticks(&list, |o| o.a.x.mul_wide(o.b.x)));
    print("add, wide", ticks(&list, |o| o.w + o.d));
    print("compare, wide", ticks(&list, |o| o.w < o.d));
    print("narrow", ticks(&list, |o| S::narrow(o.w)));
    print("scale", ticks(&list, |o| o.w.scale(7, 640)));
    print("floor", ticks(&list, |o| S::floor(o.w)));
    print("at", ticks(&list, |o| Ray::new(o.a, o.b).at(o.t)));
    print("dot", ticks(&list, |o| o.a.dot(o.b)));
    print("dot, wide", ticks(&list, |o| o.a.dot_wide(o.b)));
    print("cross", ticks(&list, |o| o.a.cross(o.b)));
    print("reflect", ticks(&list, |o| o.a.reflect(o.b)));
    print("normalize", ticks(&list, |o| o.a.normalize()));
    print("square root", ticks(&list, |o| S::sqrt(o.w)));
    print("divide", ticks(&list, |o| S::div(o.w, o.d)));
    print("ratio", ticks(&list, |o| o.a.x.ratio(o.t)));
    print("reciprocal", ticks(&list, |o| o.t.recip()));
    print("32nd power", ticks(&list, |o| o.t.pow_unit(32)));
}

/// Answers the ticks in which `kernel` goes over all operands [`ROUNDS`] times.
#[inline(never)]
fn ticks<S: Scalar, T>(list: &Operands<S>, kernel: impl Fn(&operands::Operand<S>) -> T) -> u32 {
    let start = board::ticks();
    for _ in 0..ROUNDS {
        for operand in &list.all {
            black_box(kernel(black_box(operand)));
        }
    }
    board::ticks().wrapping_sub(start)
}

/// Prints the instructions of one call, to a tenth.
fn print_figure(name: &str, ticks: u32) {
    let tenths = ticks * INSTRUCTIONS_PER_TICK * 10 / (ROUNDS * operands::COUNT);
    let [whole, tenth] = [tenths / 10, tenths % 10].map(Decimal::new);
    board::print(&[name.as_bytes(), b": ", whole.as_bytes(), b".", tenth.as_bytes()]);
}

#[panic_handler]
fn halt(_: &PanicInfo) -> ! {
    board::print(&[b"failed: the firmware panicked"]);
    board::leave(false)
}
