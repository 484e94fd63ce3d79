//! The registers of x86-64.

use crate::scalar::lanes::functions;
use crate::scalar::{Grid, Lane, Machine, Real, Table};
use std::arch::x86_64::*;

register! {
    /// Eight lanes, AVX-512.
    Avx512(__m512d), 8, "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,bmi2", Fused512, Some(Machine::Zmm);
    splat(x) = _mm512_set1_pd(x);
    load(p) = _mm512_loadu_pd(p);
    store(p, v) = _mm512_storeu_pd(p, v);
    // A register is a cache line, and written whole it need not be read first.
    // SAFETY: the fence is older than the instruction set.
    stream(p, v) = _mm512_stream_pd(p, v), unsafe { _mm_sfence() };
    add(a, b) = _mm512_add_pd(a, b);
    sub(a, b) = _mm512_sub_pd(a, b);
    mul(a, b) = _mm512_mul_pd(a, b);
    div(a, b) = _mm512_div_pd(a, b);
    neg(a) = _mm512_xor_pd(a, _mm512_set1_pd(-0.0));
    abs(a) = _mm512_abs_pd(a);
    sqrt(a) = _mm512_sqrt_pd(a);
    fma(a, b, c) = _mm512_fmadd_pd(a, b, c);
    select_le(a, b, x, y) = _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b), y, x);
    le(a, b) = u32::from(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b));
}

register! {
    /// Four lanes, AVX2 with fused products.
    Avx2(__m256d), 4, "avx2,fma,bmi2", Fused, Some(Machine::Ymm);
    splat(x) = _mm256_set1_pd(x);
    load(p) = _mm256_loadu_pd(p);
    store(p, v) = _mm256_storeu_pd(p, v);
    stream(p, v) = _mm256_storeu_pd(p, v), ();
    add(a, b) = _mm256_add_pd(a, b);
    sub(a, b) = _mm256_sub_pd(a, b);
    mul(a, b) = _mm256_mul_pd(a, b);
    div(a, b) = _mm256_div_pd(a, b);
    neg(a) = _mm256_xor_pd(a, _mm256_set1_pd(-0.0));
    abs(a) = _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
    sqrt(a) = _mm256_sqrt_pd(a);
    fma(a, b, c) = _mm256_fmadd_pd(a, b, c);
    select_le(a, b, x, y) = _mm256_blendv_pd(y, x, _mm256_cmp_pd::<_CMP_LE_OQ>(a, b));
    le(a, b) = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b)) as u32;
}

/// One number with fused products, held twice.
///
/// A single run on these types is bit for bit the same run as in one lane of a register with fused products. As an
/// `f64` it would be, too, had not the compiler the habit of joining numbers that it finds side by side into
/// vectors, in formulas whose next line wants them apart.
macro_rules! single {
    ($(#[$doc:meta])* $name:ident, $feature:literal) => {
        register! {
            $(#[$doc])*
            $name(__m128d), 1, $feature, Self, Some(Machine::Xmm);
            splat(x) = _mm_set1_pd(x);
            load(p) = _mm_load1_pd(p);
            store(p, v) = _mm_store_sd(p, v);
            stream(p, v) = _mm_store_sd(p, v), ();
            add(a, b) = _mm_add_pd(a, b);
            sub(a, b) = _mm_sub_pd(a, b);
            mul(a, b) = _mm_mul_pd(a, b);
            div(a, b) = _mm_div_pd(a, b);
            neg(a) = _mm_xor_pd(a, _mm_set1_pd(-0.0));
            abs(a) = _mm_andnot_pd(_mm_set1_pd(-0.0), a);
            sqrt(a) = _mm_sqrt_pd(a);
            fma(a, b, c) = _mm_fmadd_pd(a, b, c);
            select_le(a, b, x, y) = _mm_blendv_pd(y, x, _mm_cmp_pd::<_CMP_LE_OQ>(a, b));
            le(a, b) = _mm_comile_sd(a, b) as u32;
        }
    };
}
single! {
    /// One number with fused products.
    Fused, "avx2,fma,bmi2"
}
single! {
    /// The same with the 32 registers of AVX-512.
    Fused512, "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,bmi2"
}

register! {
    /// Two lanes, SSE2: every x86-64 processor. Products and sums are rounded one by one.
    Sse2(__m128d), 2, "sse2", f64, None;
    splat(x) = _mm_set1_pd(x);
    load(p) = _mm_loadu_pd(p);
    store(p, v) = _mm_storeu_pd(p, v);
    stream(p, v) = _mm_storeu_pd(p, v), ();
    add(a, b) = _mm_add_pd(a, b);
    sub(a, b) = _mm_sub_pd(a, b);
    mul(a, b) = _mm_mul_pd(a, b);
    div(a, b) = _mm_div_pd(a, b);
    neg(a) = _mm_xor_pd(a, _mm_set1_pd(-0.0));
    abs(a) = _mm_andnot_pd(_mm_set1_pd(-0.0), a);
    sqrt(a) = _mm_sqrt_pd(a);
    fma(a, b, c) = _mm_add_pd(_mm_mul_pd(a, b), c);
    select_le(a, b, x, y) = {
        let le = _mm_cmple_pd(a, b);
        _mm_or_pd(_mm_and_pd(le, x), _mm_andnot_pd(le, y))
    };
    le(a, b) = _mm_movemask_pd(_mm_cmple_pd(a, b)) as u32;
}
