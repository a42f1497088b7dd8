//! Any text as a table of measurements of an arm with a servo and a four-bar: reading it never panics, every error names the file, and
//! what reads is calibrated, or refused in words.

#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use pieper::calibration::{Calibration, Groups, Model};
use pieper::describe::{Robot, measurements_from_csv};
use pieper::transmission::Transmission;

static MODEL: LazyLock<(Model, Transmission)> = LazyLock::new(|| {
    let arm = "name = 'r'\nconvention = 'standard'\n\
               [[joint]]\ntheta = 'q1'\na = 0.3\n[[joint]]\ntheta = 'q2'\na = 0.2\n[[joint]]\nname = 'x'\nd = 'q3'\n\
               [[transmission]]\nkind = 'servo'\nmotor = 'm1'\njoint = 'q1'\n\
               [[transmission]]\nkind = 'four-bar'\nmotor = 'm2'\ncrank = 0.03\ncoupler = 0.3\nrocker = 0.04\nframe = 0.3\nrocker_angle = 'q2'\n";
    let robot = Robot::from_toml("r.toml", arm).unwrap();
    let groups = Groups { a: true, theta: true, drive: true, base: true, ..Groups::NONE };
    (Model::of(&robot, groups).unwrap(), robot.transmission().unwrap())
});

fuzz_target!(|text: &str| {
    let (model, transmission) = &*MODEL;
    let measurements = match measurements_from_csv("m.csv", text, model.chain(), transmission) {
        Ok(measurements) => measurements,
        Err(error) => return assert!(error.place().is_some(), "{error}"),
    };
    // A fit takes its time.
    if measurements.len() > 12 {
        return;
    }
    if let Ok(outcome) = Calibration::new(model.clone(), measurements).and_then(Calibration::run) {
        assert!(outcome.estimates.iter().all(|estimate| estimate.value.is_finite()));
    }
});
