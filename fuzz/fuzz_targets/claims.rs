//! Any text as claims on two arms, in both notations: checking never panics, every parse error names a place, and there
//! is a verdict for every claim.

#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use pieper::describe::Robot;
use pieper_symbolic::{Arm, Lengths, claims};

static ARM: LazyLock<Arm> = LazyLock::new(|| {
    let arm = "name = 'r'\nconvention = 'standard'\n[parameters]\nl2 = 0.3\n\
               [[joint]]\ntheta = 'pi/2 - q1'\na = 'l2'\n[[joint]]\ntheta = 'q2'\nalpha = 'pi/3'\n[[joint]]\nd = 'q3'\n";
    Arm::new(&Robot::from_toml("r.toml", arm).unwrap(), Lengths::Symbols).unwrap()
});

fuzz_target!(|text: &str| {
    for latex in [false, true] {
        if let Err(error) = claims::check(&ARM, "claims", text, latex) {
            assert!(error.place().is_some() || !error.is_parse(), "{error}");
        }
    }
});
