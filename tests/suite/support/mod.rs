//! What several tests share.

pub mod damage;
pub mod motion;
pub mod positions;
pub mod schemas;
pub mod seed;
