//! The argument ROBOT: a built-in name or a file, with its parameters.

use std::fs;
use std::path::Path;

use clap::Args;
use pieper::describe::{Expr, Robot, urdf, xacro};
use pieper::model::Tree;

use crate::error::Failure;
use crate::files::{Files, Meshes};

/// Files above this size are refused before they are read: no arm's description is that large.
const MAX_BYTES: u64 = 64 << 20;

/// Which robot.
#[derive(Args, Clone, Debug)]
pub(crate) struct Source {
    /// A built-in name (`pieper robots` lists them), or a .toml, .urdf or .xacro file
    #[arg(value_name = "ROBOT")]
    pub(crate) robot: String,

    /// Set a parameter of the robot file, as in --set d1=0.4 --set "a2=350 mm"
    #[arg(long = "set", value_name = "NAME=VALUE", value_delimiter = ',')]
    set: Vec<String>,

    /// URDF: the link the chain starts at (default: the root)
    #[arg(long, value_name = "LINK", help_heading = "URDF and xacro")]
    base: Option<String>,

    /// URDF: the link the chain ends at (default: the likeliest tool)
    #[arg(long, value_name = "LINK", help_heading = "URDF and xacro")]
    tip: Option<String>,

    /// Where a package lies, as in --package ur_description=../ur_description (repeatable)
    #[arg(long, value_name = "NAME=FOLDER", help_heading = "URDF and xacro")]
    package: Vec<String>,

    /// A xacro argument, as in --arg ur_type=ur5e (repeatable)
    #[arg(long, value_name = "NAME=VALUE", help_heading = "URDF and xacro")]
    arg: Vec<String>,
}

impl Source {
    /// The robot, its parameters set.
    pub(crate) fn robot(&self) -> Result<Robot, Failure> {
        let robot = match pieper_robots::find(&self.robot) {
            Some(built_in) => built_in.robot(),
            None => self.read()?,
        };
        let mut values = Vec::new();
        for (name, value) in pairs("--set", &self.set)? {
            let expr = Expr::parse(value);
            let expr = expr.map_err(|e| Failure::input(format!("--set {name}={value}: {e}")))?;
            values.push((name, expr));
        }
        Ok(robot.with_parameters(values)?)
    }

    /// The name that it was asked for by.
    pub(crate) fn name(&self) -> &str {
        &self.robot
    }

    /// Where the meshes lie that its description names.
    pub(crate) fn meshes(&self) -> Result<Meshes, Failure> {
        let path = Path::new(&self.robot);
        Ok(Meshes::new(path, Files::new(path, &self.package)?))
    }

    fn read(&self) -> Result<Robot, Failure> {
        let path = Path::new(&self.robot);
        let extension = path
            .extension()
            .and_then(|e| e.to_str())
            .unwrap_or_default()
            .to_ascii_lowercase();
        match extension.as_str() {
            "toml" => self.robot_file(path),
            "urdf" => self.of_tree(urdf::read(&self.robot, &read_text(path)?)?),
            "xacro" => {
                let arguments = pairs("--arg", &self.arg)?;
                let files = Files::new(path, &self.package)?;
                self.of_tree(xacro::read(
                    &self.robot,
                    &read_text(path)?,
                    &arguments,
                    &files,
                )?)
            }
            _ if path.exists() => Err(Failure::input(format!(
                "{}: a robot is read from a .toml, .urdf or .xacro file",
                self.robot
            ))),
            _ => Err(self.unknown()),
        }
    }

    /// A robot file, which may name a URDF to take a chain out of.
    fn robot_file(&self, path: &Path) -> Result<Robot, Failure> {
        let files = Files::new(path, &self.package)?;
        Ok(Robot::from_toml_with(
            &self.robot,
            &read_text(path)?,
            &files,
        )?)
    }

    fn of_tree(&self, tree: Tree) -> Result<Robot, Failure> {
        Ok(Robot::of_tree(
            tree,
            self.base.as_deref(),
            self.tip.as_deref(),
        )?)
    }

    fn unknown(&self) -> Failure {
        let distance = |id: &str| edit_distance(&self.robot.to_ascii_lowercase(), id);
        let nearest = pieper_robots::ALL
            .iter()
            .map(|robot| robot.id)
            .min_by_key(|id| distance(id));
        let hint = match nearest.filter(|id| distance(id) <= 2) {
            Some(id) => format!("did you mean {id}?"),
            None => "`pieper robots` lists the built-in ones".to_owned(),
        };
        Failure::input(format!(
            "{}: neither a built-in robot nor a file; {hint}",
            self.robot
        ))
    }
}

/// `NAME=VALUE` arguments, taken apart.
fn pairs<'a>(flag: &str, settings: &'a [String]) -> Result<Vec<(&'a str, &'a str)>, Failure> {
    let pair = |setting: &'a String| match setting.split_once('=') {
        // xacro's own command line writes NAME:=VALUE.
        Some((name, value)) => Ok((name.trim_end_matches(':').trim(), value.trim())),
        None => Err(Failure::input(format!(
            "{flag} {setting}: NAME=VALUE was expected"
        ))),
    };
    settings.iter().map(pair).collect()
}

/// A text file, if it is one and not absurdly large.
pub(crate) fn read_text(path: &Path) -> Result<String, Failure> {
    let name = path.display();
    let metadata = fs::metadata(path).map_err(|error| Failure::file("read", &name, &error))?;
    if metadata.len() > MAX_BYTES {
        let megabytes = MAX_BYTES >> 20;
        return Err(Failure::input(format!(
            "{name}: a file of at most {megabytes} MiB was expected"
        )));
    }
    fs::read_to_string(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::InvalidData => {
            Failure::input(format!("{name}: text in UTF-8 was expected"))
        }
        _ => Failure::file("read", &name, &error),
    })
}

/// The number of single-character changes between two short names.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replace = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replace.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
