//! Charts of the orientation: angles of the twelve sequences, and the unit quaternion. (2.2)–(2.6), section 4

mod angles;
mod quaternion;
mod sequence;

pub use angles::{AngleChart, angular_velocity_skew, partial_rotations};
pub use quaternion::{angular_velocity, quaternion_rate, quaternion_second_rate};
pub use sequence::Sequence;
