//! Vectors and matrices of the three sizes that rigid bodies need, over any [`crate::scalar::Real`].

mod mat3;
mod mat6;
mod rotation;
mod sym3;
mod sym6;
mod vec3;

pub use mat3::Mat3;
pub use mat6::Mat6;
pub use rotation::{
    elementary, is_rotation, multiply, normalized, quaternion_from_rotation, rotation_from_quaternion,
};
pub use sym3::Sym3;
pub use sym6::Sym6;
pub use vec3::{Vec3, basis};
