//! Sets of lanes.

use crate::scalar::Lane;

/// A set of lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lanes(u32);

impl Lanes {
    /// No lane.
    pub const NONE: Self = Self(0);

    /// All lanes of `T`.
    #[inline(always)]
    pub fn all<T: Lane>() -> Self {
        Self((1 << T::N) - 1)
    }
    /// Lane `l` alone.
    #[inline(always)]
    pub const fn one(l: usize) -> Self {
        Self(1 << l)
    }
    /// Whether lane `l` is in the set.
    #[inline(always)]
    pub fn contains(self, l: usize) -> bool {
        self.0 >> l & 1 == 1
    }
    /// Whether no lane is in the set.
    #[inline(always)]
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }
    /// The lanes of both sets.
    #[inline(always)]
    pub fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    /// The lanes that are in both sets.
    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
    /// The lanes of this set that are not in the other.
    #[inline(always)]
    pub fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }
    /// The lanes of the set in rising order.
    #[inline(always)]
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..u32::BITS as usize).take_while(move |l| self.0 >> l != 0).filter(move |l| self.contains(*l))
    }
    /// The lanes where `a <= b`.
    #[inline(always)]
    pub fn where_le<T: Lane>(a: T, b: T) -> Self {
        Self(T::le(a, b))
    }
    /// `x` in the lanes of the set, `y` in the others.
    #[inline(always)]
    pub fn select<T: Lane>(self, x: T, y: T) -> T {
        let inside = T::from_lanes(
            #[inline(always)]
            |l| f64::from(self.0 >> l & 1),
        );
        T::select_le(T::one(), inside, x, y)
    }
}
