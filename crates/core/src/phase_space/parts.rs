//! A state by its parts.

/// The parts of a state x, or of its rate.
#[derive(Clone, Copy, Debug)]
pub struct Parts<P> {
    /// Position of the body origin: three numbers.
    pub position: P,
    /// Angles or a quaternion: three or four numbers.
    pub orientation: P,
    /// Velocity of the body origin in body or world axes: three numbers.
    pub velocity: P,
    /// Angular velocity or rates of the orientation: three or four numbers.
    pub turning: P,
    /// The auxiliary states of the laws, whatever is left.
    pub auxiliary: P,
}

/// How many numbers those parts have that may have three or four.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    pub orientation: usize,
    pub turning: usize,
}

impl Sizes {
    /// With a place for whatever any state has.
    pub const LARGEST: Self = Self { orientation: 4, turning: 4 };

    /// How many numbers the rigid body's state has.
    #[inline(always)]
    pub const fn rigid(self) -> usize {
        6 + self.orientation + self.turning
    }
}

impl<'a, T> Parts<&'a [T]> {
    /// The parts of a state.
    #[inline(always)]
    pub fn of(x: &'a [T], sizes: Sizes) -> Self {
        let (position, x) = x.split_at(3);
        let (orientation, x) = x.split_at(sizes.orientation);
        let (velocity, x) = x.split_at(3);
        let (turning, auxiliary) = x.split_at(sizes.turning);
        Self { position, orientation, velocity, turning, auxiliary }
    }

    /// Writes the numbers of the rigid body passed through `f`.
    #[inline(always)]
    pub fn convert<U>(self, to: Parts<&mut [U]>, f: impl Fn(T) -> U)
    where
        T: Copy,
    {
        convert(self.position, to.position, &f);
        convert(self.orientation, to.orientation, &f);
        convert(self.velocity, to.velocity, &f);
        convert(self.turning, to.turning, &f);
    }
}

impl<'a, T> Parts<&'a mut [T]> {
    /// The parts of a state that is written.
    #[inline(always)]
    pub fn of_mut(x: &'a mut [T], sizes: Sizes) -> Self {
        let (position, x) = x.split_at_mut(3);
        let (orientation, x) = x.split_at_mut(sizes.orientation);
        let (velocity, x) = x.split_at_mut(3);
        let (turning, auxiliary) = x.split_at_mut(sizes.turning);
        Self { position, orientation, velocity, turning, auxiliary }
    }
}

/// Writes three or four numbers passed through `f`: as many as both sides have.
///
/// Written out, for a loop of unknown length would be a call.
#[inline(always)]
pub fn convert<T: Copy, U>(from: &[T], to: &mut [U], f: impl Fn(T) -> U) {
    to[0] = f(from[0]);
    to[1] = f(from[1]);
    to[2] = f(from[2]);
    if let (Some(x), Some(y)) = (from.get(3), to.get_mut(3)) {
        *y = f(*x);
    }
}
