//! JSON Lines: one object in, one object out, in order; a bad line answers for itself alone.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Map, Value};

use crate::error::{Failure, Outcome};
use crate::output;

/// Where a batch comes from and goes to.
#[derive(Args, Clone, Debug)]
pub(crate) struct Files {
    /// JSON Lines to read, one object a line; - for standard input
    #[arg(long, value_name = "FILE")]
    pub(crate) input: Option<String>,

    /// Where the answers go, one object a line; - for standard output
    #[arg(long, value_name = "FILE", default_value = "-", requires = "input")]
    output: String,
}

/// A line longer than this is refused: no joint vector or pose needs it.
const MAX_LINE: u64 = 1 << 20;

/// A request: an object with everything but its `id`, or why there is none.
pub(crate) type Request = Map<String, Value>;

impl Files {
    /// Answers every line; `Negative` if one of them was bad.
    pub(crate) fn answer(
        &self,
        input: &str,
        mut answer: impl FnMut(&Request) -> Result<Map<String, Value>, String>,
    ) -> Result<Outcome, Failure> {
        let (reader, size) = open(input)?;
        let mut reader = BufReader::with_capacity(1 << 16, reader);
        let mut writer = output::open(&self.output)?;
        let mut progress = Progress::new(size);
        let (mut line, mut number, mut outcome) = (Vec::new(), 0_u64, Outcome::Done);
        loop {
            line.clear();
            let read = (&mut reader).take(MAX_LINE).read_until(b'\n', &mut line);
            let read = read.map_err(|error| Failure::file("read", input, &error))? as u64;
            if read == 0 {
                break;
            }
            number += 1;
            progress.advance(read);
            let request = if read == MAX_LINE && !line.ends_with(b"\n") {
                skip_line(&mut reader).map_err(|error| Failure::file("read", input, &error))?;
                Err(format!("a line of at most {MAX_LINE} bytes was expected"))
            } else if line.trim_ascii().is_empty() {
                continue;
            } else {
                parse(&line)
            };
            let (id, result) = match request {
                Ok(request) => {
                    let id = request.get("id").cloned().unwrap_or(Value::Null);
                    (id, answer(&request))
                }
                Err(text) => (Value::Null, Err(text)),
            };
            let mut out = Map::new();
            out.insert("id".to_owned(), id);
            match result {
                Ok(fields) => out.extend(fields),
                Err(text) => {
                    outcome = Outcome::Negative;
                    out.insert("error".to_owned(), format!("line {number}: {text}").into());
                }
            }
            let text = format!("{}\n", Value::Object(out));
            writer
                .write_all(text.as_bytes())
                .map_err(|error| output::written(&self.output, error))?;
        }
        writer
            .flush()
            .map_err(|error| output::written(&self.output, error))?;
        progress.finish();
        Ok(outcome)
    }
}

fn open(input: &str) -> Result<(Box<dyn Read>, Option<u64>), Failure> {
    if input == "-" {
        return Ok((Box::new(io::stdin().lock()), None));
    }
    let file = File::open(input).map_err(|error| Failure::file("read", input, &error))?;
    let metadata = file
        .metadata()
        .map_err(|error| Failure::file("read", input, &error))?;
    if metadata.is_dir() {
        return Err(Failure::input(format!(
            "{input}: a file was expected, this is a folder"
        )));
    }
    Ok((Box::new(file), Some(metadata.len())))
}

fn skip_line(reader: &mut impl BufRead) -> io::Result<()> {
    loop {
        let buffer = reader.fill_buf()?;
        let (used, ended) = match buffer.iter().position(|&byte| byte == b'\n') {
            Some(position) => (position + 1, true),
            None => (buffer.len(), buffer.is_empty()),
        };
        reader.consume(used);
        if ended {
            return Ok(());
        }
    }
}

fn parse(line: &[u8]) -> Result<Request, String> {
    match serde_json::from_slice(line) {
        Ok(Value::Object(request)) => Ok(request),
        Ok(other) => Err(format!("{}: a JSON object was expected", shown(&other))),
        Err(error) => Err(format!("it is no JSON: {error}")),
    }
}

/// A value, shortened to what fits in a message.
pub(crate) fn shown(value: &Value) -> String {
    let text = value.to_string();
    if text.chars().count() > 60 {
        format!("{}...", text.chars().take(60).collect::<String>())
    } else {
        text
    }
}

/// A bar on standard error once the work has taken a second; none if nobody watches.
struct Progress {
    started: Instant,
    done: u64,
    size: Option<u64>,
    bar: Option<ProgressBar>,
}

impl Progress {
    fn new(size: Option<u64>) -> Self {
        Self {
            started: Instant::now(),
            done: 0,
            size,
            bar: None,
        }
    }

    fn advance(&mut self, bytes: u64) {
        self.done += bytes;
        if let Some(bar) = &self.bar {
            bar.set_position(self.done);
        } else if self.started.elapsed() > Duration::from_secs(1) {
            let bar = self
                .size
                .map_or_else(ProgressBar::no_length, ProgressBar::new);
            let style = "{bar:40} {bytes}/{total_bytes} {elapsed} (left: {eta})";
            if let Ok(style) = ProgressStyle::with_template(style) {
                bar.set_style(style);
            }
            self.bar = Some(bar);
        }
    }

    fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
