//! The SIMD registers: about fifteen one-line operations each.

/// Defines one register type: its operations, [`Real`] and [`Lane`].
macro_rules! register {
    ($(#[$doc:meta])* $name:ident($raw:ty), $n:literal, $feature:literal, $single:ty;
     splat($sx:ident) = $splat:expr;
     load($lp:ident) = $load:expr;
     store($sp:ident, $sv:ident) = $store:expr;
     add($aa:ident, $ab:ident) = $add:expr;
     sub($ua:ident, $ub:ident) = $sub:expr;
     mul($ma:ident, $mb:ident) = $mul:expr;
     div($da:ident, $db:ident) = $div:expr;
     neg($na:ident) = $neg:expr;
     abs($ba:ident) = $abs:expr;
     sqrt($qa:ident) = $sqrt:expr;
     fma($fa:ident, $fb:ident, $fc:ident) = $fma:expr;
     select_le($ca:ident, $cb:ident, $cx:ident, $cy:ident) = $select:expr;
     all_le($la:ident, $lb:ident) = $all:expr;
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        #[repr(transparent)]
        pub struct $name($raw);

        // SAFETY (all blocks of this macro): the operations need the instruction set named in
        // `$feature`. Values of this type are made only inside `Real::call`, and
        // `scalar::isa` calls that only after the processor was asked for the instruction set.
        impl $name {
            #[inline(always)]
            fn array(self) -> [f64; $n] {
                let mut out = [0.0; $n];
                let ($sp, $sv) = (out.as_mut_ptr(), self.0);
                unsafe { $store };
                out
            }
            #[inline(always)]
            fn from_array(x: [f64; $n]) -> Self {
                let $lp = x.as_ptr();
                Self(unsafe { $load })
            }
        }

        impl std::fmt::Debug for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, "{:?}", self.array())
            }
        }

        impl std::ops::Add for $name {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                let ($aa, $ab) = (self.0, other.0);
                Self(unsafe { $add })
            }
        }
        impl std::ops::Sub for $name {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                let ($ua, $ub) = (self.0, other.0);
                Self(unsafe { $sub })
            }
        }
        impl std::ops::Mul for $name {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                let ($ma, $mb) = (self.0, other.0);
                Self(unsafe { $mul })
            }
        }
        impl std::ops::Div for $name {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                let ($da, $db) = (self.0, other.0);
                Self(unsafe { $div })
            }
        }
        impl std::ops::Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let $na = self.0;
                Self(unsafe { $neg })
            }
        }

        impl Real for $name {
            #[inline(always)]
            fn lit($sx: f64) -> Self {
                Self(unsafe { $splat })
            }
            #[inline(always)]
            fn fma(self, a: Self, b: Self) -> Self {
                let ($fa, $fb, $fc) = (self.0, a.0, b.0);
                Self(unsafe { $fma })
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                let $qa = self.0;
                Self(unsafe { $sqrt })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                let $ba = self.0;
                Self(unsafe { $abs })
            }
            #[inline(always)]
            fn select_le(a: Self, b: Self, x: Self, y: Self) -> Self {
                let ($ca, $cb, $cx, $cy) = (a.0, b.0, x.0, y.0);
                Self(unsafe { $select })
            }
            #[inline(always)]
            fn lookup(self, table: &Table) -> Self {
                let mut x = self.array();
                for v in &mut x {
                    *v = table.value(*v);
                }
                Self::from_array(x)
            }
            #[inline(always)]
            fn lookup_2(self, y: Self, grid: &Grid) -> Self {
                let (mut x, y) = (self.array(), y.array());
                for (v, y) in x.iter_mut().zip(y) {
                    *v = grid.value(*v, y);
                }
                Self::from_array(x)
            }
            functions!();
            #[inline(always)]
            fn call<R>(f: impl FnOnce() -> R) -> R {
                #[target_feature(enable = $feature)]
                #[inline(never)]
                fn enter<R>(f: impl FnOnce() -> R) -> R {
                    f()
                }
                // SAFETY: `scalar::isa` has asked the processor for `$feature`.
                unsafe { enter(f) }
            }
        }

        impl Lane for $name {
            const N: usize = $n;
            type Single = $single;
            #[inline(always)]
            fn get(self, l: usize) -> f64 {
                self.array()[l]
            }
            #[inline(always)]
            fn with(self, l: usize, x: f64) -> Self {
                let mut all = self.array();
                all[l] = x;
                Self::from_array(all)
            }
            #[inline(always)]
            fn all_le(a: Self, b: Self) -> bool {
                let ($la, $lb) = (a.0, b.0);
                unsafe { $all }
            }
            #[inline(always)]
            fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
                let mut all = [0.0; $n];
                let mut l = 0;
                while l < $n {
                    all[l] = f(l);
                    l += 1;
                }
                Self::from_array(all)
            }
            #[inline(always)]
            fn load(numbers: &[f64]) -> Self {
                Self::from_array(*numbers.first_chunk().expect("as many numbers as lanes"))
            }
            #[inline(always)]
            fn store(self, numbers: &mut [f64]) {
                *numbers.first_chunk_mut().expect("as many places as lanes") = self.array();
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use crate::scalar::lanes::functions;
    use crate::scalar::{Grid, Lane, Real, Table};
    use std::arch::x86_64::*;

    register! {
        /// Eight lanes, AVX-512.
        Avx512(__m512d), 8, "avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,bmi2", crate::scalar::Fused;
        splat(x) = _mm512_set1_pd(x);
        load(p) = _mm512_loadu_pd(p);
        store(p, v) = _mm512_storeu_pd(p, v);
        add(a, b) = _mm512_add_pd(a, b);
        sub(a, b) = _mm512_sub_pd(a, b);
        mul(a, b) = _mm512_mul_pd(a, b);
        div(a, b) = _mm512_div_pd(a, b);
        neg(a) = _mm512_xor_pd(a, _mm512_set1_pd(-0.0));
        abs(a) = _mm512_abs_pd(a);
        sqrt(a) = _mm512_sqrt_pd(a);
        fma(a, b, c) = _mm512_fmadd_pd(a, b, c);
        select_le(a, b, x, y) = _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b), y, x);
        all_le(a, b) = _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b) == 0xff;
    }

    register! {
        /// Four lanes, AVX2 with fused products.
        Avx2(__m256d), 4, "avx2,fma,bmi2", crate::scalar::Fused;
        splat(x) = _mm256_set1_pd(x);
        load(p) = _mm256_loadu_pd(p);
        store(p, v) = _mm256_storeu_pd(p, v);
        add(a, b) = _mm256_add_pd(a, b);
        sub(a, b) = _mm256_sub_pd(a, b);
        mul(a, b) = _mm256_mul_pd(a, b);
        div(a, b) = _mm256_div_pd(a, b);
        neg(a) = _mm256_xor_pd(a, _mm256_set1_pd(-0.0));
        abs(a) = _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
        sqrt(a) = _mm256_sqrt_pd(a);
        fma(a, b, c) = _mm256_fmadd_pd(a, b, c);
        select_le(a, b, x, y) = _mm256_blendv_pd(y, x, _mm256_cmp_pd::<_CMP_LE_OQ>(a, b));
        all_le(a, b) = _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b)) == 0b1111;
    }

    register! {
        /// Two lanes, SSE2: every x86-64 processor. Products and sums are rounded one by one.
        Sse2(__m128d), 2, "sse2", f64;
        splat(x) = _mm_set1_pd(x);
        load(p) = _mm_loadu_pd(p);
        store(p, v) = _mm_storeu_pd(p, v);
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
        all_le(a, b) = _mm_movemask_pd(_mm_cmple_pd(a, b)) == 0b11;
    }
}
#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512, Sse2};

#[cfg(target_arch = "aarch64")]
mod arm {
    use crate::scalar::lanes::functions;
    use crate::scalar::{Grid, Lane, Real, Table};
    use std::arch::aarch64::*;

    register! {
        /// Two lanes, NEON with fused products: every 64-bit ARM processor.
        Neon(float64x2_t), 2, "neon", crate::scalar::Fused;
        splat(x) = vdupq_n_f64(x);
        load(p) = vld1q_f64(p);
        store(p, v) = vst1q_f64(p, v);
        add(a, b) = vaddq_f64(a, b);
        sub(a, b) = vsubq_f64(a, b);
        mul(a, b) = vmulq_f64(a, b);
        div(a, b) = vdivq_f64(a, b);
        neg(a) = vnegq_f64(a);
        abs(a) = vabsq_f64(a);
        sqrt(a) = vsqrtq_f64(a);
        fma(a, b, c) = vfmaq_f64(c, a, b);
        select_le(a, b, x, y) = vbslq_f64(vcleq_f64(a, b), x, y);
        all_le(a, b) = vminvq_u32(vreinterpretq_u32_u64(vcleq_f64(a, b))) == u32::MAX;
    }
}
#[cfg(target_arch = "aarch64")]
pub use arm::Neon;
