//! From poses back to joint values: every solution, or the reason why there is none.

pub mod general;
