//! `pieper link map`

use std::fs;
use std::io::{BufRead as _, BufReader, Read};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use clap::Args;
use pieper::describe::drives::{CouplingExpr, MotorExpr};
use pieper::describe::{Expr, Robot};
use pieper_link::matching::{Ends, Match};
use pieper_link::{Arm, Kind, Phase, Session};

use super::line::Line;
use super::live;
use crate::error::{Failure, Outcome};
use crate::output;

/// Match servos to joints at their extreme positions
#[derive(Args)]
#[command(after_help = "\
Example, with `pieper link simulate servo --tcp 7005` running:
  pieper link map --robot abb-paper --to tcp:127.0.0.1:7005 --protocol servo --out my-arm.toml --arm

For each joint in turn: drive its servo to one end of the joint, and type at which angle the joint is; then to the other end. From both \
follow the servo's centre, its direction and its ratio, which are written into the robot file as the servo's window.
  +5 or -5    turn the servo by so many degrees
  90          turn it to so many degrees
  = -42       the joint is at this angle now (degrees)
  skip        leave this joint as it is
  quit        stop, and write nothing
More than two angles of a joint make it more accurate, and show how well they agree; an empty line goes on to the next joint.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    line: Line,

    /// The robot file to write
    #[arg(long, value_name = "FILE.toml")]
    out: PathBuf,

    /// Arm the controller: the servos move as you type
    #[arg(long)]
    arm: bool,
}

/// What hobby servos turn, degrees.
const WINDOW: [f64; 2] = [0.0, 180.0];

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        live::catch_interrupts();
        if !self.arm {
            return Err(Failure::input(
                "the servos move while they are matched: --arm says that they may",
            ));
        }
        let kind = self.line.protocol.unwrap_or(Kind::Servo);
        if !matches!(kind, Kind::Servo | Kind::Packets) {
            return Err(Failure::input(format!(
                "--protocol {kind}: servos are matched over servo or packets"
            )));
        }
        let mut robot = self.line.which.source(kind).robot()?;
        let arm = Arm::of(&robot)?;
        let servos = Arc::new(arm.with_bare_servos()?);
        let connected = self.line.connect_as(kind, &servos, 0.25)?;
        let session = &connected.session;
        session.arm().map_err(|refusal| Failure::World(refusal.0))?;
        let typed = typed(std::io::stdin());
        let mut found = Vec::new();
        for joint in 0..arm.dof() {
            if !arm.is_angle(joint) {
                continue;
            }
            match self.joint(session, &arm, joint, &typed)? {
                Next::Found(ends) => found.push((joint, ends)),
                Next::Skip => {}
                Next::Quit => {
                    output::note("nothing was written");
                    return Ok(Outcome::Negative);
                }
            }
        }
        // The servos hold where they are, whatever the answer.
        let _ = session.disarm();
        for (joint, ends) in &found {
            set(&mut robot, &arm, *joint, ends);
        }
        let text = robot.to_toml()?;
        fs::write(&self.out, text)
            .map_err(|error| Failure::file("written", self.out.display(), &error))?;
        output::answer(&format!(
            "{} joints matched, written to {}\n",
            found.len(),
            self.out.display()
        ))?;
        Ok(Outcome::Done)
    }

    fn joint(
        &self,
        session: &Session,
        arm: &Arm,
        joint: usize,
        typed: &Receiver<String>,
    ) -> Result<Next, Failure> {
        let name = arm.joint_name(joint);
        output::note(&format!(
            "{name}: drive it to one end, and type = and its angle"
        ));
        let mut ends = Ends::default();
        loop {
            let servo = servo(session, joint)?;
            output::note(&format!("{name}: servo at {servo:.0} deg >"));
            let line = next_line(session, typed)?;
            let Some(line) = line else {
                return Ok(Next::Quit);
            };
            match Typed::read(&line) {
                Some(Typed::Turn { to, is_relative }) => {
                    let to = if is_relative { servo + to } else { to };
                    turn(session, joint, to)?;
                }
                Some(Typed::At(angle)) => {
                    ends.add(angle.to_radians(), servo.to_radians());
                    match ends.solve() {
                        None => output::note("now drive it to the other end"),
                        Some(of) => output::note(&shown(&of)),
                    }
                }
                Some(Typed::Skip) => return Ok(Next::Skip),
                Some(Typed::Quit) => return Ok(Next::Quit),
                Some(Typed::Next) => match ends.solve() {
                    Some(of) => return Ok(Next::Found(of)),
                    None => output::warning(
                        "two different angles are needed; skip leaves this joint as it is",
                    ),
                },
                None => output::warning(&format!(
                    "{line}: +5, 90, = -42, skip, quit or an empty line were expected"
                )),
            }
        }
    }
}

enum Next {
    Found(Match),
    Skip,
    Quit,
}

/// A line that was typed.
enum Typed {
    Turn { to: f64, is_relative: bool },
    At(f64),
    Next,
    Skip,
    Quit,
}

impl Typed {
    fn read(line: &str) -> Option<Self> {
        let number = |text: &str| text.trim().parse().ok().filter(|x: &f64| x.is_finite());
        match line.trim() {
            "" => Some(Self::Next),
            "skip" => Some(Self::Skip),
            "quit" => Some(Self::Quit),
            at if at.starts_with('=') => Some(Self::At(number(&at[1..])?)),
            to => Some(Self::Turn {
                to: number(to)?,
                is_relative: to.starts_with(['+', '-']),
            }),
        }
    }
}

fn shown(of: &Match) -> String {
    format!(
        "centre {:.1} deg, {} , ratio {:.4}, angles agree to {:.2} deg; an empty line goes on",
        of.centre.to_degrees(),
        if of.sign > 0.0 {
            "the same way"
        } else {
            "the other way"
        },
        of.ratio,
        of.residual.to_degrees()
    )
}

fn servo(session: &Session, joint: usize) -> Result<f64, Failure> {
    let status = session.status();
    match (status.phase.is_live(), status.measured) {
        (true, Some(q)) => Ok(q[joint].to_degrees()),
        _ => Err(Failure::World(status.sentence.unwrap_or_default())),
    }
}

/// Turns a servo and waits until it is there.
fn turn(session: &Session, joint: usize, degrees: f64) -> Result<(), Failure> {
    let mut q = session.status().commanded.unwrap_or_default();
    if let Some(place) = q.get_mut(joint) {
        *place = degrees.to_radians();
    }
    if let Err(refusal) = session.set_target(&q) {
        output::warning(&refusal.0);
        return Ok(());
    }
    let mut settled = live::settled();
    loop {
        session.beat();
        let status = session.status();
        if !status.phase.is_live() {
            return Err(Failure::World(status.sentence.unwrap_or_default()));
        }
        if status.phase == Phase::Holding && settled(&status) {
            return Ok(());
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// The next line that is typed; the arm's driver is heard of meanwhile. `None` at the end of the input.
fn next_line(session: &Session, typed: &Receiver<String>) -> Result<Option<String>, Failure> {
    loop {
        session.beat();
        let status = session.status();
        if !status.phase.is_live() {
            return Err(Failure::World(status.sentence.unwrap_or_default()));
        }
        match typed.recv_timeout(Duration::from_millis(60)) {
            Ok(line) => return Ok(Some(line)),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
        }
    }
}

/// Lines of the input, read while the arm's driver must not fall silent.
fn typed(input: impl Read + Send + 'static) -> Receiver<String> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        for line in BufReader::new(input).lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                return;
            }
        }
    });
    receive
}

/// Puts a servo's window into a robot, in the place of what drove the joint.
fn set(robot: &mut Robot, arm: &Arm, joint: usize, of: &Match) {
    let name = arm.transmission.all()[joint].name().to_owned();
    robot.motors.retain(|motor| motor.place != joint);
    let degrees = |value: f64| {
        // A hundredth of a degree is finer than any servo.
        let shown = (value.to_degrees() * 100.0).round() / 100.0;
        Expr::parse(&format!("{shown} deg")).unwrap_or_else(|_| Expr::number(value))
    };
    robot.motors.push(MotorExpr {
        name,
        place: joint,
        coupling: CouplingExpr::Servo {
            joint,
            centre: Some(degrees(of.centre)),
            sign: of.sign,
            ratio: Expr::number((of.ratio * 1e5).round() / 1e5),
            window: WINDOW.map(|end: f64| degrees(end.to_radians())),
        },
    });
}
