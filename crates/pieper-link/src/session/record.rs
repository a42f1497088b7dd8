//! What was asked, sent and measured, and when: one JSON document a line, written by a thread of its own.

use std::fmt;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::mpsc::{SyncSender, TryRecvError, TrySendError, sync_channel};
use std::thread::JoinHandle;
use std::time::{Duration, SystemTime};

use serde_json::{Value, json};

use crate::arm::Arm;
use crate::protocol::Kind;
use crate::protocol::packets::AXES;
use crate::transport::Address;

/// Entries that may wait for the disk: eight seconds of EGM.
const WAITING: usize = 2048;

/// How often they are written.
const PAUSE: Duration = Duration::from_millis(50);

/// A line of a record.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// Something happened.
    Note {
        /// Seconds since the connection was made.
        time: f64,
        /// What.
        text: String,
    },
    /// A set-point went out.
    Sample(Sample),
}

/// Where the arm was sent, and where it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Seconds since the connection was made.
    pub time: f64,
    /// The joints as commanded, radians and metres.
    pub commanded: Vec<f64>,
    /// The joints as last measured.
    pub measured: Vec<f64>,
    /// The time from a set-point to the state that answers it, seconds, where the protocol tells.
    pub latency: Option<f64>,
}

/// A session as it was recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// The robot's name.
    pub robot: String,
    /// The protocol.
    pub protocol: String,
    /// Where the controller was.
    pub address: String,
    /// The joints' names, and whether each is an angle.
    pub joints: Vec<(String, bool)>,
    /// What happened.
    pub entries: Vec<Entry>,
}

/// Why a record cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordError {
    /// The line, from 1.
    pub line: usize,
    /// What was expected.
    pub text: String,
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.text)
    }
}

impl Record {
    /// Reads a record. A last line that was cut off in the middle, as a power cut does, is left out.
    ///
    /// # Errors
    /// [`RecordError`] with the line, and what was expected there.
    pub fn read(text: &str) -> Result<Self, RecordError> {
        let fail = |line: usize, text: &str| RecordError {
            line,
            text: text.to_owned(),
        };
        let mut lines = text.split_inclusive('\n').enumerate();
        let head = lines.next().and_then(|(_, line)| parse(line));
        let head = head
            .filter(|head| head["pieper_link"] == 1)
            .ok_or_else(|| fail(1, "the head of a session's record was expected"))?;
        let text_of = |key: &str| head[key].as_str().unwrap_or_default().to_owned();
        let joints = head["joints"].as_array().into_iter().flatten();
        let joints: Vec<_> = joints
            .map(|joint| {
                let name = joint["name"].as_str().unwrap_or_default().to_owned();
                (name, joint["unit"] == "rad")
            })
            .collect();
        if joints.is_empty() {
            return Err(fail(1, "the joints' names were expected"));
        }
        let mut entries = Vec::new();
        for (index, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
            match parse(line).and_then(|value| entry(&value, joints.len())) {
                Some(entry) => entries.push(entry),
                None if !line.ends_with('\n') => {}
                None => return Err(fail(index + 1, "a sample or a note was expected")),
            }
        }
        Ok(Self {
            robot: text_of("robot"),
            protocol: text_of("protocol"),
            address: text_of("address"),
            joints,
            entries,
        })
    }

    /// The samples alone.
    pub fn samples(&self) -> impl Iterator<Item = &Sample> {
        self.entries.iter().filter_map(|entry| match entry {
            Entry::Sample(sample) => Some(sample),
            Entry::Note { .. } => None,
        })
    }
}

fn parse(line: &str) -> Option<Value> {
    serde_json::from_str(line).ok()
}

fn entry(value: &Value, dof: usize) -> Option<Entry> {
    let time = value["t"].as_f64()?;
    if let Some(text) = value["note"].as_str() {
        let text = text.to_owned();
        return Some(Entry::Note { time, text });
    }
    let joints = |key: &str| -> Option<Vec<f64>> {
        let values: Option<Vec<f64>> = value[key].as_array()?.iter().map(Value::as_f64).collect();
        values.filter(|values| values.len() == dof)
    };
    Some(Entry::Sample(Sample {
        time,
        commanded: joints("commanded")?,
        measured: joints("measured")?,
        latency: value["latency"].as_f64(),
    }))
}

/// What goes to the writing thread. Samples are of fixed size: none of them is allocated.
enum Line {
    Note(Duration, String),
    Sample {
        at: Duration,
        dof: usize,
        commanded: [f64; AXES],
        measured: [f64; AXES],
        latency: Option<Duration>,
    },
}

/// Writes a record while it happens.
pub(super) struct Recorder {
    lines: Option<SyncSender<Line>>,
    thread: Option<JoinHandle<()>>,
    /// Entries that found the disk too slow, since the last one that did not.
    lost: usize,
}

impl Recorder {
    /// Makes the file and writes its head.
    pub(super) fn begin(
        path: &Path,
        arm: &Arm,
        kind: Kind,
        address: &Address,
    ) -> Result<Self, String> {
        let fail = |error: std::io::Error| {
            format!(
                "{}: the session's record could not be written: {error}",
                path.display()
            )
        };
        if let Some(folder) = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
        {
            fs::create_dir_all(folder).map_err(fail)?;
        }
        let mut file = BufWriter::new(File::create(path).map_err(fail)?);
        let started = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
        let joint = |index: usize| {
            let unit = if arm.is_angle(index) { "rad" } else { "m" };
            json!({ "name": arm.joint_name(index), "unit": unit })
        };
        let head = json!({
            "pieper_link": 1,
            "robot": arm.name,
            "protocol": kind.name(),
            "address": address.to_string(),
            "started": started.map_or(0, |time| time.as_secs()),
            "joints": (0..arm.dof()).map(joint).collect::<Value>(),
        });
        writeln!(file, "{head}")
            .and_then(|()| file.flush())
            .map_err(fail)?;
        let (lines, heard) = sync_channel::<Line>(WAITING);
        let thread = std::thread::Builder::new()
            .name("pieper-link-record".to_owned())
            .spawn(move || {
                // It looks now and then instead of waiting: to wake it in every cycle would cost the arm's driver its turn.
                let mut is_open = true;
                while is_open {
                    std::thread::sleep(PAUSE);
                    loop {
                        match heard.try_recv() {
                            // A full disk must not stop the arm's driver: the record ends here, as its reader sees.
                            Ok(line) if writeln!(file, "{}", document(&line)).is_err() => return,
                            Ok(_) => {}
                            Err(error) => {
                                is_open = error == TryRecvError::Empty;
                                break;
                            }
                        }
                    }
                    if file.flush().is_err() {
                        return;
                    }
                }
            })
            .map_err(|error| format!("no thread could be started: {error}"))?;
        Ok(Self {
            lines: Some(lines),
            thread: Some(thread),
            lost: 0,
        })
    }

    pub(super) fn note(&mut self, at: Duration, text: String) {
        self.put(at, Line::Note(at, text));
    }

    pub(super) fn sample(
        &mut self,
        at: Duration,
        commanded: &[f64],
        measured: &[f64],
        latency: Option<Duration>,
    ) {
        let fixed = |values: &[f64]| {
            let mut fixed = [0.0; AXES];
            for (place, value) in fixed.iter_mut().zip(values) {
                *place = *value;
            }
            fixed
        };
        self.put(
            at,
            Line::Sample {
                at,
                dof: commanded.len().min(AXES),
                commanded: fixed(commanded),
                measured: fixed(measured),
                latency,
            },
        );
    }

    fn put(&mut self, at: Duration, line: Line) {
        let Some(lines) = &self.lines else {
            return;
        };
        if self.lost > 0 {
            let text = format!("{} entries were lost: the disk was too slow", self.lost);
            if lines.try_send(Line::Note(at, text)).is_ok() {
                self.lost = 0;
            }
        }
        if let Err(TrySendError::Full(_)) = lines.try_send(line) {
            self.lost += 1;
        }
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        drop(self.lines.take());
        if let Some(thread) = self.thread.take() {
            // A writer that panicked has written what it could.
            let _ = thread.join();
        }
    }
}

fn document(line: &Line) -> Value {
    match line {
        Line::Note(at, text) => json!({ "t": at.as_secs_f64(), "note": text }),
        Line::Sample {
            at,
            dof,
            commanded,
            measured,
            latency,
        } => json!({
            "t": at.as_secs_f64(),
            "commanded": commanded[..*dof],
            "measured": measured[..*dof],
            "latency": latency.map(|latency| latency.as_secs_f64()),
        }),
    }
}
