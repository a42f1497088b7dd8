//! `pieper studio`, as far as a terminal sees it.

use std::io::{BufRead as _, BufReader};
use std::net::TcpListener;
use std::process::{Child, Command, Stdio};

use crate::support::pieper;

/// A started studio, stopped at the end.
struct Started(Child);

impl Drop for Started {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn first_line(arguments: &[&str]) -> (Started, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_pieper"))
        .args(arguments)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap())
        .read_line(&mut line)
        .unwrap();
    (Started(child), line)
}

#[test]
fn the_first_line_is_the_address() {
    let (_studio, line) = first_line(&["studio", "--no-open"]);
    let rest = line.trim().strip_prefix("http://127.0.0.1:").unwrap();
    let (port, token) = rest.split_once("/#token=").unwrap();
    assert!(port.parse::<u16>().is_ok() && token.len() == 32, "{line}");
    assert!(std::net::TcpStream::connect(("127.0.0.1", port.parse().unwrap())).is_ok());
}

#[test]
fn what_stands_in_the_way_is_said() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let ended = pieper(&["studio", "ar3", "--no-open", "--port", &port]);
    assert_eq!(ended.code, 3);
    assert!(ended.stderr.contains("--port"), "{}", ended.stderr);
    let ended = pieper(&["studio", "six-axis", "--no-open"]);
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("d1"), "{}", ended.stderr);
    assert_eq!(pieper(&["studio", "r2d2", "--no-open"]).code, 2);
}
