//! The child process: started, listened to, stopped.

use std::io::{BufRead as _, BufReader, Read};
use std::os::fd::OwnedFd;
use std::os::unix::process::CommandExt as _;
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use command_fds::{CommandFdExt as _, FdMapping};
use rustix::process::{Pid, Signal, kill_process_group};
use serde_json::{Value, json};

use super::{BOOTSTRAP, Python, calls};
use crate::session::Session;

/// How long an interrupted script has to end by itself.
const GRACE: Duration = Duration::from_millis(500);

/// Output beyond this is dropped.
const MOST_OUTPUT: usize = 1 << 20;

/// Output is told in pieces at most this often.
const COALESCE: Duration = Duration::from_millis(50);

/// What a run needs of the studio.
pub(crate) trait Host: Send + Sync + 'static {
    /// Does something with the session, and tells the windows what changed.
    fn with(&self, action: &mut dyn FnMut(&mut Session));
    /// Tells the windows of output: stream and text.
    fn console(&self, stream: &'static str, text: &str);
}

/// A script that runs.
pub(crate) struct Running {
    group: Pid,
    /// Python has started and asked for the script.
    begun: Arc<AtomicBool>,
    stopped: Arc<AtomicBool>,
    /// Wakes a pause.
    alarm: Arc<(Mutex<()>, Condvar)>,
    done: Arc<AtomicBool>,
}

impl Running {
    /// Interrupts the script, and kills its whole group if it goes on.
    pub(crate) fn stop(&self) {
        self.stopped.store(true, Ordering::SeqCst);
        self.alarm.1.notify_all();
        if self.done.load(Ordering::SeqCst) {
            return;
        }
        // Python that still starts would print where it was interrupted, and nothing of the person's is lost with it.
        let is_begun = self.begun.load(Ordering::SeqCst);
        let signal = if is_begun { Signal::INT } else { Signal::KILL };
        let _ = kill_process_group(self.group, signal);
        let (group, done) = (self.group, Arc::clone(&self.done));
        std::thread::spawn(move || {
            std::thread::sleep(GRACE);
            if !done.load(Ordering::SeqCst) {
                let _ = kill_process_group(group, Signal::KILL);
            }
        });
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.stop();
    }
}

/// Looks for a Python 3 and whether it has numpy.
pub(crate) fn find_python() -> Python {
    let probe = "import sys, importlib.util as u; print('%d.%d.%d' % sys.version_info[:3], int(u.find_spec('numpy') is not None), sys.version_info[0])";
    for program in ["python3", "python"] {
        let Ok(output) = Command::new(program)
            .args(["-I", "-c", probe])
            .stdin(Stdio::null())
            .output()
        else {
            continue;
        };
        let text = String::from_utf8_lossy(&output.stdout);
        let words: Vec<&str> = text.split_whitespace().collect();
        if let [version, numpy, "3"] = words[..] {
            return Python {
                program: Some(program.to_owned()),
                version: version.to_owned(),
                numpy: numpy == "1",
            };
        }
    }
    Python {
        program: None,
        version: String::new(),
        numpy: false,
    }
}

/// Starts a script; it goes on in threads of its own.
///
/// # Errors
/// A sentence: no Python, or the system refuses.
pub(crate) fn run(python: &Python, source: String, host: Arc<dyn Host>) -> Result<Running, String> {
    let program = python
        .program
        .as_ref()
        .ok_or("no Python 3 was found on this computer: install one (python3) to run scripts")?;
    let refused = |error: &dyn std::fmt::Display| format!("Python could not be started: {error}");
    let (requests, child_requests) = std::io::pipe().map_err(|error| refused(&error))?;
    let (child_replies, replies) = std::io::pipe().map_err(|error| refused(&error))?;
    let mut command = Command::new(program);
    command
        .args(["-I", "-u", "-c", BOOTSTRAP])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .process_group(0);
    let mappings = [
        (OwnedFd::from(child_requests), 3),
        (OwnedFd::from(child_replies), 4),
    ];
    let mappings = mappings.map(|(parent_fd, child_fd)| FdMapping {
        parent_fd,
        child_fd,
    });
    command
        .fd_mappings(mappings.into())
        .map_err(|error| refused(&error))?;
    let mut child = command.spawn().map_err(|error| refused(&error))?;
    // The command keeps the child's ends of the pipes open: without it they close with the child.
    drop(command);
    let group = i32::try_from(child.id())
        .ok()
        .and_then(Pid::from_raw)
        .ok_or("Python could not be started")?;
    let running = Running {
        group,
        begun: Arc::default(),
        stopped: Arc::default(),
        alarm: Arc::default(),
        done: Arc::default(),
    };
    let (tell, told) = sync_channel(64);
    let outputs = [
        ("out", child.stdout.take().map(boxed)),
        ("err", child.stderr.take().map(boxed)),
    ];
    for (stream, output) in outputs
        .into_iter()
        .filter_map(|(name, output)| Some((name, output?)))
    {
        let tell = tell.clone();
        std::thread::spawn(move || listen(stream, output, &tell));
    }
    drop(tell);
    let console = Arc::clone(&host);
    let (finish, shown) = sync_channel(1);
    std::thread::spawn(move || {
        coalesce(&told, &*console);
        // Nobody waits any more where something the script left behind held its output open.
        let _ = finish.send(());
    });
    let serving = Serving {
        source,
        started: Instant::now(),
        begun: Arc::clone(&running.begun),
        stopped: Arc::clone(&running.stopped),
        alarm: Arc::clone(&running.alarm),
        host,
        shown,
        failed: None,
    };
    let done = Arc::clone(&running.done);
    std::thread::spawn(move || {
        serving.serve(child, group, &done, BufReader::new(requests), replies)
    });
    Ok(running)
}

fn boxed(output: impl Read + Send + 'static) -> Box<dyn Read + Send> {
    Box::new(output)
}

fn listen(
    stream: &'static str,
    mut output: Box<dyn Read + Send>,
    tell: &SyncSender<(&'static str, Vec<u8>)>,
) {
    let mut part = [0; 8192];
    while let Ok(count @ 1..) = output.read(&mut part) {
        if tell.send((stream, part[..count].to_vec())).is_err() {
            return;
        }
    }
}

/// Output in pieces, and no more than a megabyte of it.
fn coalesce(told: &Receiver<(&'static str, Vec<u8>)>, host: &dyn Host) {
    let (mut left, mut is_said) = (MOST_OUTPUT, false);
    let mut waiting: Vec<(&'static str, Vec<u8>)> = Vec::new();
    let mut since = Instant::now();
    let flush = |waiting: &mut Vec<(&'static str, Vec<u8>)>| {
        for (stream, bytes) in waiting.drain(..) {
            host.console(stream, &String::from_utf8_lossy(&bytes));
        }
    };
    loop {
        match told.recv_timeout(COALESCE) {
            Ok((stream, mut bytes)) => {
                let kept = bytes.len().min(left);
                let is_cut = kept < bytes.len();
                bytes.truncate(kept);
                left -= kept;
                match waiting.last_mut() {
                    Some((last, text)) if *last == stream => text.extend(bytes),
                    _ if kept > 0 => waiting.push((stream, bytes)),
                    _ => {}
                }
                if is_cut && !is_said {
                    is_said = true;
                    flush(&mut waiting);
                    host.console(
                        "note",
                        "(the script has written a megabyte: further output is not shown)\n",
                    );
                }
                if since.elapsed() >= COALESCE {
                    flush(&mut waiting);
                    since = Instant::now();
                }
            }
            Err(RecvTimeoutError::Timeout) => flush(&mut waiting),
            Err(RecvTimeoutError::Disconnected) => return flush(&mut waiting),
        }
    }
}

/// Answers one script.
struct Serving {
    source: String,
    started: Instant,
    begun: Arc<AtomicBool>,
    stopped: Arc<AtomicBool>,
    alarm: Arc<(Mutex<()>, Condvar)>,
    host: Arc<dyn Host>,
    /// Says that all output was shown.
    shown: Receiver<()>,
    failed: Option<(Option<u32>, String)>,
}

impl Serving {
    fn serve(
        mut self,
        mut child: Child,
        group: Pid,
        done: &AtomicBool,
        mut requests: impl std::io::BufRead,
        mut replies: impl std::io::Write,
    ) {
        let gesture = format!("script-{}", child.id());
        let mut line = Vec::new();
        loop {
            line.clear();
            // A call is short: a line without end is no call.
            let read = (&mut requests).take(1 << 20).read_until(b'\n', &mut line);
            if !matches!(read, Ok(1..)) || line.last() != Some(&b'\n') {
                break;
            }
            let reply = match self.answer(&line, &gesture) {
                Ok(value) => json!({"value": value}),
                Err(error) => json!({"error": error}),
            };
            if writeln!(replies, "{reply}").is_err() {
                break;
            }
        }
        // It closed its pipe: it has ended, or soon will, or is no script any more.
        let status = wait(&mut child, group);
        // Whatever it has left running in its group ends with it.
        let _ = kill_process_group(group, Signal::KILL);
        done.store(true, Ordering::SeqCst);
        let ended = match (&self.failed, self.stopped.load(Ordering::SeqCst), status) {
            (Some((Some(line), text)), ..) => format!("line {line}: {text}"),
            (Some((None, text)), ..) => text.clone(),
            (None, true, _) => "stopped".to_owned(),
            (None, false, Some(0)) => {
                format!("done in {:.1} s", self.started.elapsed().as_secs_f64())
            }
            (None, false, Some(code)) => format!("ended with code {code}"),
            (None, false, None) => "was killed".to_owned(),
        };
        let failed = self.failed.take();
        // Its last words come before the word that it has ended.
        let _ = self.shown.recv_timeout(GRACE);
        self.host
            .with(&mut |session| session.script_ended(failed.clone(), &ended));
    }

    fn answer(&mut self, line: &[u8], gesture: &str) -> Result<Value, String> {
        let call: Vec<Value> =
            serde_json::from_slice(line).map_err(|error| format!("no call: {error}"))?;
        if self.stopped.load(Ordering::SeqCst) {
            return Err("the script was stopped".to_owned());
        }
        match call.first().and_then(Value::as_str) {
            Some("source") => {
                self.begun.store(true, Ordering::SeqCst);
                Ok(json!(self.source))
            }
            Some("time") => Ok(json!(self.started.elapsed().as_secs_f64())),
            Some("failed") => {
                let line = call
                    .get(1)
                    .and_then(Value::as_u64)
                    .and_then(|line| u32::try_from(line).ok());
                self.failed = Some((
                    line,
                    call.get(2)
                        .and_then(Value::as_str)
                        .unwrap_or_default()
                        .to_owned(),
                ));
                Ok(Value::Null)
            }
            Some("pause") => {
                let wanted = call.get(1).and_then(Value::as_f64).unwrap_or_default();
                self.pause(wanted)?;
                Ok(Value::Null)
            }
            _ => {
                let mut result = Err(String::new());
                self.host
                    .with(&mut |session| result = calls::answer(session, &call, gesture));
                result
            }
        }
    }

    /// Waits, unless it is stopped; the speed of playback scales it.
    fn pause(&self, milliseconds: f64) -> Result<(), String> {
        if !(0.0..=86_400_000.0).contains(&milliseconds) {
            return Err(format!(
                "pause({milliseconds}): from 0 to a day of milliseconds was expected"
            ));
        }
        let mut speed = 1.0;
        self.host.with(&mut |session| speed = session.motion.speed);
        let wanted = Duration::from_secs_f64(milliseconds / 1000.0 / speed);
        let guard = self.alarm.0.lock().unwrap_or_else(PoisonError::into_inner);
        let stopped = || self.stopped.load(Ordering::SeqCst);
        let waited = self
            .alarm
            .1
            .wait_timeout_while(guard, wanted, |()| !stopped());
        drop(waited);
        Ok(())
    }
}

/// Waits for the end of a child that has closed its pipe; kills it where it goes on. Its exit code.
fn wait(child: &mut Child, group: Pid) -> Option<i32> {
    let deadline = Instant::now() + GRACE;
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return status.code(),
            Ok(None) if Instant::now() < deadline => std::thread::sleep(Duration::from_millis(5)),
            _ => break,
        }
    }
    let _ = kill_process_group(group, Signal::KILL);
    child.wait().ok().and_then(|status| status.code())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a window would show.
    #[derive(Default)]
    struct Shown(Mutex<Vec<(&'static str, String)>>);

    impl Host for Shown {
        fn with(&self, _: &mut dyn FnMut(&mut Session)) {}

        fn console(&self, stream: &'static str, text: &str) {
            self.0.lock().unwrap().push((stream, text.to_owned()));
        }
    }

    /// A megabyte and no more, then once a word about it, wherever the pieces happen to end.
    #[test]
    fn output_beyond_a_megabyte_is_cut_with_a_word() {
        for (piece, count, notes) in [(8192, 128, 0), (8192, 200, 1), (8191, 200, 1)] {
            let (tell, told) = sync_channel(count);
            for _ in 0..count {
                tell.send(("out", vec![b'y'; piece])).unwrap();
            }
            drop(tell);
            let shown = Shown::default();
            coalesce(&told, &shown);
            let list = shown.0.into_inner().unwrap();
            let (said, out): (Vec<_>, Vec<_>) =
                list.iter().partition(|(stream, _)| *stream == "note");
            let length: usize = out.iter().map(|(_, text)| text.len()).sum();
            assert_eq!((length, said.len()), (MOST_OUTPUT, notes), "{piece}");
            assert!(notes == 0 || list.last().unwrap().0 == "note", "{piece}");
        }
    }
}
