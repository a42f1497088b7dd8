//! The program as its users meet it: commands in, text, files and exit codes out.

// Tests may unwrap, and so may their helper functions, which clippy.toml's exception does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod calibrate;
mod fk;
mod ik_questions;
mod link;
mod run;
mod run_paths;
mod studio;
mod support;
mod symbolic;
mod transmission;
