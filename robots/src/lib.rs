//! The built-in robots: one robot file each, embedded.
//!
//! A crate of its own because the program, the studio, the bindings and the tests all read them, and the library
//! itself knows no robot.
//!
//! ```
//! let ar3 = pieper_robots::find("ar3").unwrap().robot();
//! assert_eq!(ar3.chain()?.dof(), 6);
//! # Ok::<(), pieper::Error>(())
//! ```

use pieper::describe::Robot;

/// A built-in robot.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// The name commands know it by.
    pub id: &'static str,
    /// Its robot file.
    pub text: &'static str,
}

impl BuiltIn {
    /// The robot its file describes.
    ///
    /// # Panics
    /// Never for the robots of this crate: a test reads every one.
    #[allow(
        clippy::expect_used,
        reason = "the embedded files are constants that a test has read"
    )]
    pub fn robot(&self) -> Robot {
        let name = format!("robots/{}.toml", self.id);
        Robot::from_toml(&name, self.text).expect("an embedded robot file is valid")
    }
}

/// The built-in robot of that name.
pub fn find(id: &str) -> Option<BuiltIn> {
    ALL.iter().find(|robot| robot.id == id).copied()
}

macro_rules! built_in {
    ($($id:literal)*) => {
        /// Every built-in robot, in the order of a listing.
        pub const ALL: &[BuiltIn] = &[
            $(BuiltIn { id: $id, text: include_str!(concat!("../", $id, ".toml")) }),*
        ];
    };
}

built_in! {
    "ar3"
    "ar3-annin"
    "ar4"
    "ar4-modified"
    "six-axis"
    "gantry"
    "puma560"
    "stanford"
    "irb120"
    "irb140"
    "irb1200"
    "irb1600"
    "irb2400"
    "irb2600"
    "irb4400"
    "irb4600"
    "irb6640"
    "irb6700"
    "crb15000"
    "irb910sc"
    "cobra600"
    "kuka-kr6-r700"
    "kuka-kr10-r1100"
    "kuka-kr16-2"
    "iiwa7"
    "iiwa14"
    "staubli-tx60"
    "staubli-tx2-60"
    "staubli-tx2-60l"
    "staubli-tx2-90"
    "fanuc-lrmate200id"
    "fanuc-m10ia"
    "fanuc-crx5ia"
    "fanuc-crx10ia"
    "fanuc-crx10ia-l"
    "fanuc-crx20ia-l"
    "yaskawa-gp7"
    "yaskawa-gp8"
    "ur3"
    "ur3e"
    "ur5"
    "ur5e"
    "ur10"
    "ur10e"
    "ur16e"
    "ur20"
    "ur30"
    "panda"
    "fr3"
    "jaco2"
    "kinova-gen3"
    "xarm6"
    "xarm7"
    "abb-paper"
}
