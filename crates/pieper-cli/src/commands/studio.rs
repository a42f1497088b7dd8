//! `pieper studio`

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use clap::Args;
use pieper_studio::{Arm, Options, Session, Studio};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::{Source, read_text};

/// Show a robot in 3D: sliders, dragging, every inverse solution, motion
#[derive(Args)]
#[command(mut_arg("robot", |robot| robot.required(false).default_value("ar3")), after_help = "\
Examples:
  pieper studio
  pieper studio irb120 --no-open --port 8123
  pieper studio ur5 --project cell.json
  pieper studio ar3 --q 0.4,0.9,0.9,0,0.6,0 --headless-frame ar3.png

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

    /// Joint values to begin with, as in 0,45deg,pi/2,0,0,0 (radians and metres without a unit)
    #[arg(long, value_name = "Q1,Q2,...", allow_hyphen_values = true)]
    q: Option<String>,

    /// A project file: opened if it is there, and kept up to date
    #[arg(long, value_name = "FILE.json")]
    project: Option<PathBuf>,

    /// Draw one view into a file instead, by a browser without a window (Chromium or Chrome)
    #[arg(long, value_name = "FILE.png")]
    headless_frame: Option<PathBuf>,

    /// The size of that view in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size, requires = "headless_frame")]
    size: [u32; 2],
}

/// Warnings about meshes that the terminal shows.
const TOLD: usize = 3;

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let session = self.session()?;
        let options = Options {
            port: self.port,
            project: self.project.clone(),
        };
        let studio = Studio::bind(session, &options).map_err(Failure::World)?;
        if let Some(file) = &self.headless_frame {
            let picture = studio.picture(self.size).map_err(Failure::World)?;
            fs::write(file, picture)
                .map_err(|error| Failure::file("written", file.display(), &error))?;
            return Ok(Outcome::Done);
        }
        let url = studio.url();
        output::answer(&format!("{url}\n"))?;
        if !self.no_open {
            open(&url);
        }
        studio.serve().map_err(Failure::World)?;
        Ok(Outcome::Done)
    }

    /// The session to begin with: the robot, its posture, the project.
    fn session(&self) -> Result<Session, Failure> {
        let robot = self.source.robot()?;
        let meshes = self.source.meshes()?;
        let arm = Arm::new(self.source.name(), robot, &move |uri| meshes.read(uri))
            .map_err(Failure::Input)?;
        let problems = arm.problems();
        problems
            .iter()
            .take(TOLD)
            .for_each(|text| output::warning(text));
        if problems.len() > TOLD {
            let more = problems.len() - TOLD;
            output::warning(&format!(
                "and {more} more of this kind: the studio's log has all"
            ));
        }
        let mut session = Session::new(arm);
        if let Some(file) = self.project.as_ref().filter(|file| file.exists()) {
            session
                .open(&read_text(file)?)
                .map_err(|error| Failure::input(format!("{}: {error}", file.display())))?;
        }
        if let Some(text) = &self.q {
            session
                .pose(text)
                .map_err(|error| Failure::input(format!("--q: {error}")))?;
        }
        Ok(session)
    }
}

/// `1280x720`
fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once('x')
        .and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides
        .filter(|sides: &[u32; 2]| sides.iter().all(|side| (16..=8192).contains(side)))
        .ok_or_else(|| "WIDTHxHEIGHT was expected, each from 16 to 8192".to_owned())
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
