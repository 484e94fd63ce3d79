//! Laws of the scalars.

mod block;
mod dual;
mod elementary;
mod elementary_slopes;
mod grid;
mod lanes;
mod lattice;
mod spline;
mod table;
mod trigonometry;

/// Repeatable random numbers (Steele, Lea, Flood 2014: SplitMix64).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Equal bit for bit; what is not a number has no bits worth comparing.
pub fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// How many representable numbers lie from `a` to `b`.
pub fn ulps(a: f64, b: f64) -> u64 {
    let place = |x: f64| {
        let bits = x.to_bits() as i64;
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    if a.is_nan() || b.is_nan() { u64::MAX * u64::from(!same(a, b)) } else { place(a).abs_diff(place(b)) }
}
