//! The studio without a browser: what a session does, and what its server lets in.

// Tests may unwrap, and so may their helper functions, which clippy.toml's exception does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod scripts;
mod security;
mod session;
mod socket;
mod support;
