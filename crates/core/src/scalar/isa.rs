//! Which instruction set this machine has, asked once.

use std::sync::OnceLock;

/// An instruction set that the kernel is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Isa {
    /// What every machine of this architecture has; products and sums are rounded one by one.
    Baseline,
    /// NEON (64-bit ARM).
    Neon,
    /// AVX2 with fused products.
    Avx2,
    /// AVX-512.
    Avx512,
}

impl Isa {
    /// The best instruction set of this machine.
    pub fn detect() -> Self {
        static BEST: OnceLock<Isa> = OnceLock::new();
        *BEST.get_or_init(|| Self::available().into_iter().max().unwrap_or(Self::Baseline))
    }

    /// All instruction sets that this machine has.
    pub fn available() -> Vec<Self> {
        let mut all = vec![Self::Baseline];
        #[cfg(target_arch = "aarch64")]
        all.push(Self::Neon);
        #[cfg(target_arch = "x86_64")]
        {
            let avx2 = is_x86_feature_detected!("avx2")
                && is_x86_feature_detected!("fma")
                && is_x86_feature_detected!("bmi2");
            if avx2 {
                all.push(Self::Avx2);
            }
            if avx2
                && is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512bw")
            {
                all.push(Self::Avx512);
            }
        }
        all
    }
}

/// Runs `$body` with `$L` bound to the type of one number whose results are those of one lane of `$isa`.
///
/// `$isa` must be in `Isa::available()`; the body enters it by `$L::call`.
macro_rules! with_scalar {
    ($isa:expr, $L:ident => $body:expr) => {
        match $isa {
            $crate::scalar::isa::Isa::Baseline => {
                type $L = f64;
                $body
            }
            #[cfg(target_arch = "x86_64")]
            $crate::scalar::isa::Isa::Avx512 => {
                type $L = $crate::scalar::Fused512;
                $body
            }
            _ => {
                type $L = $crate::scalar::Fused;
                $body
            }
        }
    };
}

/// Runs `$body` with `$L` bound to the register type of `$isa`.
///
/// `$isa` must be in `Isa::available()`; the body enters it by `$L::call`.
macro_rules! with_lanes {
    ($isa:expr, $L:ident => $body:expr) => {
        match $isa {
            #[cfg(target_arch = "x86_64")]
            $crate::scalar::isa::Isa::Avx512 => {
                type $L = $crate::scalar::Avx512;
                $body
            }
            #[cfg(target_arch = "x86_64")]
            $crate::scalar::isa::Isa::Avx2 => {
                type $L = $crate::scalar::Avx2;
                $body
            }
            #[cfg(target_arch = "aarch64")]
            $crate::scalar::isa::Isa::Neon => {
                type $L = $crate::scalar::Neon;
                $body
            }
            _ => {
                #[cfg(target_arch = "x86_64")]
                type $L = $crate::scalar::Sse2;
                #[cfg(not(target_arch = "x86_64"))]
                type $L = f64;
                $body
            }
        }
    };
}

pub(crate) use {with_lanes, with_scalar};
