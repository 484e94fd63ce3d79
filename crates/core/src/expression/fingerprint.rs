//! Values of nodes at random points of two finite fields: two nodes with equal values are one expression.
//!
//! A polynomial or rational identity holds at every point; two different expressions of degree d agree at a
//! random point with a probability of about d/p (Schwartz 1980), so at two points modulo p ≈ 2⁶¹ never.
//! Sine and cosine are the coordinates of a random point on the unit circle, so sin² + cos² = 1 holds too.
//! What has no value in the field (a root, a choice, a table) is a random number that its operands decide.

use super::node::Operation;
use crate::scalar::Elementary;

/// Two primes. Modulo the first 2⁶¹ is 1; modulo the second no two powers of two within the range of doubles
/// are equal.
const P: [u64; 2] = [(1 << 61) - 1, (1 << 61) - 31];

/// The values at two points.
pub type Fingerprint = [u64; 2];

/// Of a node whose operands have the fingerprints `x`.
pub fn of(operation: Operation, x: &[Fingerprint]) -> Fingerprint {
    [at(operation, x, 0), at(operation, x, 1)]
}

/// Of −a.
pub fn negative(x: Fingerprint) -> Fingerprint {
    [minus(x[0], 0), minus(x[1], 1)]
}

/// Whether it stands for zero.
pub fn is_zero(x: Fingerprint) -> bool {
    x == [0, 0]
}

fn at(operation: Operation, x: &[Fingerprint], point: usize) -> u64 {
    let arg = |i: usize| x[i][point];
    let other = || {
        let operands =
            x.iter().fold(hash_operation(operation), |h, f| mix(h ^ mix(f[0]) ^ f[1].rotate_left(17)));
        mix(operands ^ point as u64) % P[point]
    };
    match operation {
        Operation::Constant(bits) if f64::from_bits(bits).is_finite() => {
            constant(f64::from_bits(bits), point)
        }
        Operation::Neg => minus(arg(0), point),
        Operation::Add => (arg(0) + arg(1)) % P[point],
        Operation::Sub => (arg(0) + minus(arg(1), point)) % P[point],
        Operation::Mul => times(arg(0), arg(1), point),
        Operation::Div if x[1].contains(&0) => other(),
        Operation::Div => times(arg(0), inverse(arg(1), point), point),
        Operation::Sin => circle(x[0], point).0,
        Operation::Cos => circle(x[0], point).1,
        Operation::Elementary(Elementary::Tan) => {
            let (s, c) = circle(x[0], point);
            times(s, inverse(c, point), point)
        }
        _ => other(),
    }
}

/// Sine and cosine: t gives the point (2t, 1 − t²)/(1 + t²); −t belongs to −a.
fn circle(angle: Fingerprint, point: usize) -> (u64, u64) {
    if is_zero(angle) {
        return (0, 1);
    }
    let mirrored = negative(angle) < angle;
    let canonical = if mirrored { negative(angle) } else { angle };
    let t = mix(mix(canonical[0]) ^ canonical[1] ^ point as u64) % P[point];
    let square = times(t, t, point);
    let scale = inverse(1 + square, point);
    let s = times(2 * t % P[point], scale, point);
    let c = times((1 + minus(square, point)) % P[point], scale, point);
    (if mirrored { minus(s, point) } else { s }, c)
}

/// A finite double is an integer times a power of two.
fn constant(x: f64, point: usize) -> u64 {
    let bits = x.abs().to_bits();
    let (exponent, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
    let (mantissa, exponent) =
        if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    let scale = power(2, exponent.unsigned_abs(), point);
    let scale = if exponent < 0 { inverse(scale, point) } else { scale };
    let value = times(mantissa, scale, point);
    if x < 0.0 { minus(value, point) } else { value }
}

fn minus(a: u64, point: usize) -> u64 {
    if a == 0 { 0 } else { P[point] - a }
}

fn times(a: u64, b: u64, point: usize) -> u64 {
    // The product in digits of 61 bits: 2⁶¹ is 1 modulo the first prime, and 31 modulo the second.
    let carry = [1, 31][point];
    let mask = u128::from(u64::MAX >> 3);
    let product = u128::from(a) * u128::from(b);
    let once = (product & mask) + carry * (product >> 61);
    let twice = ((once & mask) + carry * (once >> 61)) as u64;
    if twice >= P[point] { twice - P[point] } else { twice }
}

/// aⁿ
fn power(a: u64, n: u64, point: usize) -> u64 {
    let (mut power, mut square, mut exponent) = (1, a % P[point], n);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = times(power, square, point);
        }
        square = times(square, square, point);
        exponent >>= 1;
    }
    power
}

/// 1/a = a^(p − 2), Fermat's little theorem.
fn inverse(a: u64, point: usize) -> u64 {
    power(a, P[point] - 2, point)
}

fn hash_operation(operation: Operation) -> u64 {
    let (kind, which) = match operation {
        Operation::Symbol(n) => (1, n),
        Operation::Lookup(n) => (2, n),
        Operation::Lookup2(n) => (3, n),
        Operation::Elementary(f) => (4, f as u32),
        Operation::Sqrt => (5, 0),
        Operation::Abs => (6, 0),
        Operation::Atan2 => (7, 0),
        Operation::Pow => (8, 0),
        Operation::SelectLe => (9, 0),
        Operation::Lookup3(n) => (11, n),
        Operation::Lookup4(n) => (12, n),
        // A number that is not finite.
        Operation::Constant(bits) => return mix(bits),
        _ => (10, 0),
    };
    mix(kind << 32 | u64::from(which))
}

/// Spreads the bits of a number over all places (Steele, Lea, Flood 2014, SplitMix64).
fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}
