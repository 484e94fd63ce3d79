//! The registers of 64-bit ARM.

use crate::scalar::lanes::functions;
use crate::scalar::{Grid, Lane, Real, Table};
use std::arch::aarch64::*;

register! {
    /// Two lanes, NEON with fused products: every 64-bit ARM processor.
    Neon(float64x2_t), 2, "neon", crate::scalar::Fused, None;
    splat(x) = vdupq_n_f64(x);
    load(p) = vld1q_f64(p);
    store(p, v) = vst1q_f64(p, v);
    stream(p, v) = vst1q_f64(p, v), ();
    add(a, b) = vaddq_f64(a, b);
    sub(a, b) = vsubq_f64(a, b);
    mul(a, b) = vmulq_f64(a, b);
    div(a, b) = vdivq_f64(a, b);
    neg(a) = vnegq_f64(a);
    abs(a) = vabsq_f64(a);
    sqrt(a) = vsqrtq_f64(a);
    fma(a, b, c) = vfmaq_f64(c, a, b);
    select_le(a, b, x, y) = vbslq_f64(vcleq_f64(a, b), x, y);
    le(a, b) = {
        let le = vcleq_f64(a, b);
        (vgetq_lane_u64::<0>(le) & 0b01 | vgetq_lane_u64::<1>(le) & 0b10) as u32
    };
}
