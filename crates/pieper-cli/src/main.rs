//! The program `pieper`.
fn main() {}
