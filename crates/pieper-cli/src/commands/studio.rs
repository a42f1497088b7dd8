//! `pieper studio`

use std::process::{Command, Stdio};

use clap::Args;
use pieper_studio::{Arm, Options, Studio};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;

/// Show a robot in 3D: sliders, dragging, every inverse solution, motion
#[derive(Args)]
#[command(mut_arg("robot", |robot| robot.required(false).default_value("ar3")), after_help = "\
Examples:
  pieper studio
  pieper studio irb120 --no-open --port 8123

Opens the browser at an address on this computer; the first line of the output is that address. Ctrl+C ends it.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// The port on 127.0.0.1 (default: one that is free)
    #[arg(long, value_name = "N", default_value_t = 0)]
    port: u16,

    /// Do not open a browser
    #[arg(long)]
    no_open: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let meshes = self.source.meshes()?;
        let arm = Arm::new(self.source.name(), robot, &move |uri| meshes.read(uri))
            .map_err(Failure::Input)?;
        let options = Options {
            port: self.port,
            ..Options::default()
        };
        let studio = Studio::bind(arm, &options).map_err(Failure::World)?;
        let url = studio.url();
        output::answer(&format!("{url}\n"))?;
        if !self.no_open {
            open(&url);
        }
        studio.serve().map_err(Failure::World)?;
        Ok(Outcome::Done)
    }
}

/// Asks the desktop to open an address; without a desktop the printed line has to do.
fn open(url: &str) {
    let (program, arguments): (&str, &[&str]) = match std::env::consts::OS {
        "macos" => ("open", &[]),
        "windows" => ("rundll32", &["url.dll,FileProtocolHandler"]),
        _ => ("xdg-open", &[]),
    };
    let mut command = Command::new(program);
    command
        .args(arguments)
        .arg(url)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    if command.spawn().is_err() {
        output::warning("no browser could be opened: open the address above in one");
    }
}
