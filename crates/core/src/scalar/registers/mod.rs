//! The SIMD registers: about fifteen one-line operations each.

/// Defines one register type: its operations, [`Real`] and [`Lane`].
macro_rules! register {
    ($(#[$doc:meta])* $name:ident($raw:ty), $n:literal, $feature:literal, $single:ty, $machine:expr;
     splat($sx:ident) = $splat:expr;
     load($lp:ident) = $load:expr;
     store($sp:ident, $sv:ident) = $store:expr;
     stream($tp:ident, $tv:ident) = $stream:expr, $settle:expr;
     add($aa:ident, $ab:ident) = $add:expr;
     sub($ua:ident, $ub:ident) = $sub:expr;
     mul($ma:ident, $mb:ident) = $mul:expr;
     div($da:ident, $db:ident) = $div:expr;
     neg($na:ident) = $neg:expr;
     abs($ba:ident) = $abs:expr;
     sqrt($qa:ident) = $sqrt:expr;
     fma($fa:ident, $fb:ident, $fc:ident) = $fma:expr;
     select_le($ca:ident, $cb:ident, $cx:ident, $cy:ident) = $select:expr;
     le($la:ident, $lb:ident) = $le:expr;
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
            const MACHINE: Option<$crate::scalar::Machine> = $machine;
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
                // Not through memory: a processor waits there for the small write to end before the large read.
                let mut places = [0.0; $n];
                let mut i = 0;
                while i < $n {
                    places[i] = i as f64;
                    i += 1;
                }
                let away = (Self::from_array(places) - Self::lit(l as f64)).abs();
                Self::select_le(away, Self::zero(), Self::lit(x), self)
            }
            #[inline(always)]
            fn le(a: Self, b: Self) -> u32 {
                let ($la, $lb) = (a.0, b.0);
                unsafe { $le }
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
            #[inline(always)]
            fn stream(self, numbers: &mut [f64]) {
                let places: &mut [f64; $n] = numbers.first_chunk_mut().expect("as many places as lanes");
                let ($tp, $tv) = (places.as_mut_ptr(), self.0);
                if $tp.addr() % size_of::<Self>() == 0 {
                    unsafe { $stream }
                } else {
                    *places = self.array();
                }
            }
            #[inline(always)]
            fn settle() {
                $settle
            }
        }
    };
}

#[cfg(target_arch = "aarch64")]
mod arm;
#[cfg(target_arch = "x86_64")]
mod x86;

#[cfg(target_arch = "aarch64")]
pub use arm::Neon;
#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512, Fused, Fused512, Sse2};
