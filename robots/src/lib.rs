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
}
