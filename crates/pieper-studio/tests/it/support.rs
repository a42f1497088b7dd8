//! A studio that listens, and plain HTTP.

use std::io::{Read as _, Write as _};
use std::net::TcpStream;

use pieper_studio::{Arm, Command, Options, Session, Studio};
use serde_json::Value;

pub(crate) fn arm(id: &str) -> Arm {
    let robot = pieper_robots::find(id).unwrap().robot();
    Arm::new(id, robot, &|_| Err("no files here".to_owned())).unwrap()
}

pub(crate) fn session(id: &str) -> Session {
    Session::new(arm(id))
}

/// Does a command given as JSON.
pub(crate) fn apply(session: &mut Session, command: Value) -> Result<Value, String> {
    let command: Command = serde_json::from_value(command).map_err(|error| error.to_string())?;
    session.apply(command)
}

/// A studio that serves until the test process ends.
pub(crate) struct Served {
    pub(crate) port: u16,
    pub(crate) token: String,
}

pub(crate) fn serve(id: &str) -> Served {
    let (tell, told) = std::sync::mpsc::channel();
    let arm = arm(id);
    // Its own thread from the start: a test may be inside a runtime already.
    std::thread::spawn(move || {
        let studio = Studio::bind(Session::new(arm), &Options::default()).unwrap();
        tell.send(studio.url()).unwrap();
        studio.serve()
    });
    let url = told.recv().unwrap();
    let rest = url.strip_prefix("http://127.0.0.1:").unwrap();
    let (port, token) = rest.split_once("/#token=").unwrap();
    Served {
        port: port.parse().unwrap(),
        token: token.to_owned(),
    }
}

impl Served {
    /// Sends a request as written, with `\n` for line ends, and gives the whole answer.
    pub(crate) fn raw(&self, request: &str) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream
            .set_read_timeout(Some(std::time::Duration::from_secs(2)))
            .unwrap();
        stream
            .write_all(request.replace('\n', "\r\n").as_bytes())
            .unwrap();
        let mut answer = Vec::new();
        let mut part = [0; 4096];
        // An upgraded connection stays open: the head is enough.
        while let Ok(count @ 1..) = stream.read(&mut part) {
            answer.extend(&part[..count]);
            if answer.starts_with(b"HTTP/1.1 101") {
                break;
            }
        }
        String::from_utf8_lossy(&answer).into_owned()
    }

    /// The status of a request with these headers.
    pub(crate) fn status(&self, first: &str, headers: &[String], body: &str) -> u16 {
        let mut request = format!(
            "{first} HTTP/1.1\nConnection: close\nContent-Length: {}\n",
            body.len()
        );
        for header in headers {
            request += header;
            request.push('\n');
        }
        let answer = self.raw(&format!("{request}\n{body}"));
        answer
            .split(' ')
            .nth(1)
            .and_then(|code| code.parse().ok())
            .unwrap_or(0)
    }
}
