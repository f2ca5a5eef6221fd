//! Products and sums in steps of 2^-20, narrowed once and saturating: the kernels under [`Fixed`](super::Fixed).
//!
//! A scalar product takes 103 instructions on an M0+ and 14 on an M3, a product 31 and 8. The figures here and in
//! the other kernels are those of `examples/kernels`.
//!
//! A chip that puts long products together of halves calls them; inline they would make an image twice as long.

use super::product::signed;
use core::hint::cold_path;

/// Is how many bits stand behind the point.
pub(super) const FRACTION_BITS: u32 = 20;

const HALF: i64 = 1 << (FRACTION_BITS - 1);

/// Answers the end of the range that has the sign of `n`.
#[inline(always)]
const fn saturated(n: i32) -> i32 {
    i32::MAX ^ (n >> 31)
}

#[inline(always)]
const fn upper(wide: i64) -> i32 {
    (wide >> 32) as i32
}

/// Drops 20 places of `wide`; `overflow` answers for what does not fit.
#[inline(always)]
fn fit(wide: i64, overflow: impl FnOnce() -> i32) -> i32 {
    // The upper word of a number that fits is one of 20 bits.
    if (upper(wide).wrapping_add(1 << 19) as u32) >> 20 == 0 {
        (wide >> FRACTION_BITS) as i32
    } else {
        cold_path();
        overflow()
    }
}

/// Answers `a + b`.
#[inline(always)]
pub(super) fn add(a: i32, b: i32) -> i32 {
    a.checked_add(b).unwrap_or_else(|| {
        cold_path();
        saturated(a)
    })
}

/// Answers `a - b`.
#[inline(always)]
pub(super) fn subtract(a: i32, b: i32) -> i32 {
    a.checked_sub(b).unwrap_or_else(|| {
        cold_path();
        saturated(a)
    })
}

/// Answers `a b` with all its 40 places.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
pub(super) fn multiply_wide(a: i32, b: i32) -> i64 {
    signed(a, b)
}

/// Answers `a b`, rounded down.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
pub(super) fn multiply(a: i32, b: i32) -> i32 {
    let product = signed(a, b);
    fit(product, || saturated(upper(product)))
}

/// Answers `o + a b`, rounded down.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
pub(super) fn add_product(o: i32, a: i32, b: i32) -> i32 {
    let product = signed(a, b);
    add(o, fit(product, || saturated(upper(product))))
}

/// Rounds to the nearest step.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
pub(super) fn narrow(wide: i64) -> i32 {
    fit(wide.wrapping_add(HALF), || saturated(upper(wide)))
}

/// Answers `a d - b c`, rounded.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
pub(super) fn determinant([a, b]: [i32; 2], [c, d]: [i32; 2]) -> i32 {
    // Two products of 2^62 at most, of which only the positive one is that large: no sum can wrap.
    let difference = signed(a, d).wrapping_sub(signed(b, c));
    fit(difference.wrapping_add(HALF), || saturated(upper(difference)))
}

/// Answers the scalar product, rounded.
#[inline(always)]
pub(super) fn dot([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> i32 {
    dot_of_components(ax, ay, az, bx, by, bz)
}

#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
fn dot_of_components(ax: i32, ay: i32, az: i32, bx: i32, by: i32, bz: i32) -> i32 {
    let [x, y, z] = [signed(ax, bx), signed(ay, by), signed(az, bz)];
    // Three products of 2^62 may wrap round once, which leaves a number far too large to fit all the same.
    let sum = x.wrapping_add(y).wrapping_add(z).wrapping_add(HALF);
    fit(sum, || saturated((upper(x) >> 2) + (upper(y) >> 2) + (upper(z) >> 2)))
}

/// Answers the scalar product with all its 40 places.
#[inline(always)]
pub(super) fn dot_wide([ax, ay, az]: [i32; 3], [bx, by, bz]: [i32; 3]) -> i64 {
    dot_wide_of_components(ax, ay, az, bx, by, bz)
}

#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
fn dot_wide_of_components(ax: i32, ay: i32, az: i32, bx: i32, by: i32, bz: i32) -> i64 {
    let [x, y, z] = [signed(ax, bx), signed(ay, by), signed(az, bz)];
    let quarter = (upper(x) >> 2) + (upper(y) >> 2) + (upper(z) >> 2);
    // A quarter of the sum, at most three too small, tells whether the sum fits.
    if (quarter.wrapping_add(1 << 29) as u32) < (1 << 30) - 3 {
        x.wrapping_add(y).wrapping_add(z)
    } else {
        cold_path();
        // Opposite signs first: their sum fits.
        let (second, third) = if (x ^ y) < 0 { (y, z) } else { (z, y) };
        x.saturating_add(second).saturating_add(third)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EDGES: [i32; 11] =
        [0, 1, -1, 1 << 20, -(1 << 20), 1 << 25, 0x5a82_7999, i32::MAX, -i32::MAX, i32::MIN, 0x3fff_ffff];

    fn clamp(wide: i128) -> i32 {
        wide.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }

    fn triples() -> impl Iterator<Item = [i32; 3]> + Clone {
        EDGES.into_iter().flat_map(|a| EDGES.into_iter().flat_map(move |b| EDGES.map(|c| [a, b, c])))
    }

    fn pairs() -> impl Iterator<Item = ([i32; 3], [i32; 3])> {
        let [first, second] = if cfg!(miri) { [41, 97] } else { [1, 7] };
        triples().step_by(first).flat_map(move |a| triples().step_by(second).map(move |b| (a, b)))
    }

    #[test]
    fn sums_and_products_saturate_at_the_end_they_pass() {
        for (a, b) in EDGES.iter().flat_map(|a| EDGES.map(|b| (*a, b))) {
            let [p, q] = [i128::from(a), i128::from(b)];
            assert_eq!(add(a, b), clamp(p + q), "{a} + {b}");
            assert_eq!(subtract(a, b), clamp(p - q), "{a} - {b}");
            assert_eq!(multiply(a, b), clamp((p * q) >> 20), "{a} * {b}");
            assert_eq!(narrow(multiply_wide(a, b)), clamp((p * q + (1 << 19)) >> 20), "{a} * {b}");
        }
        assert_eq!([narrow(i64::MAX), narrow(i64::MIN)], [i32::MAX, i32::MIN]);
        assert_eq!(narrow(i64::MAX - (1 << 19)), i32::MAX);
    }

    #[test]
    fn sums_of_products_saturate_at_the_end_they_pass() {
        for [o, a, b] in triples() {
            let product = clamp((i128::from(a) * i128::from(b)) >> 20);
            assert_eq!(add_product(o, a, b), o.saturating_add(product), "{o} + {a} * {b}");
        }
        for (a, b) in pairs() {
            let product = |i: usize, j: usize| i128::from(a[i]) * i128::from(b[j]);
            let sum = product(0, 0) + product(1, 1) + product(2, 2);
            assert_eq!(dot(a, b), clamp((sum + (1 << 19)) >> 20), "{a:?} . {b:?}");
            let minor = product(0, 1) - product(1, 0);
            assert_eq!(
                determinant([a[0], a[1]], [b[0], b[1]]),
                clamp((minor + (1 << 19)) >> 20),
                "{a:?}, {b:?}"
            );
        }
    }

    #[test]
    fn wide_sums_of_products_saturate() {
        for (a, b) in pairs() {
            let exact: i128 = (0..3).map(|i| i128::from(a[i]) * i128::from(b[i])).sum();
            let fitting = exact.clamp(i64::MIN.into(), i64::MAX.into());
            assert_eq!(i128::from(dot_wide(a, b)), fitting, "{a:?} . {b:?}");
        }
    }
}
