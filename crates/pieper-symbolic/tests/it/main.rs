//! The formulas against the library's numbers.

// Tests may unwrap, and so may their helper functions, which clippy.toml's exception does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod claims;
mod code;
mod inverses;
mod numbers;
mod print;
