//! The formulas of an arm's kinematics: derived by the library's own kernel, checked against print, generated as code.
//!
//! A crate of its own for its dependency weight (exact rationals) and because the library's users rarely need it.
//!
//! Everything rests on [`Poly`]: polynomials in the sines and cosines of joint variables, in named lengths and named
//! angles, with exact rational coefficients and the roots of 2 and 3 (the sines of all multiples of 15 degrees). The
//! one relation `s^2 = 1 - c^2` per angle gives each a canonical form, which decides equality.

pub mod number;

pub mod names;

pub mod poly;

mod angle;
mod table;

pub mod transform;

pub mod arm;

pub mod basis;

pub mod form;

pub mod print;

pub mod jacobian;

pub mod determinant;

pub mod sheet;

pub mod inverse;

pub mod code;

pub mod derive;

pub mod claims;

pub use arm::{Arm, Lengths};
pub use poly::Poly;
