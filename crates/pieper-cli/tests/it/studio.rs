//! `pieper studio`, as far as a terminal sees it.

use std::io::{BufRead as _, BufReader};
use std::net::TcpListener;
use std::process::{Child, Command, Stdio};

use crate::support::{Temporary, pieper};

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

#[test]
fn one_view_is_drawn_without_a_person() {
    let folder = Temporary::new();
    let file = folder.path("view.png");
    let ended = pieper(&[
        "studio",
        "irb120",
        "--q",
        "20deg,0.3,0.2,0,40deg,0",
        "--headless-frame",
        &file,
        "--size",
        "320x200",
    ]);
    if ended.code == 3 {
        // Without a browser: the remedy is named.
        assert!(ended.stderr.contains("chromium"), "{}", ended.stderr);
        return;
    }
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let mut reader = png::Decoder::new(BufReader::new(std::fs::File::open(&file).unwrap()))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (320, 200));
    let tones: std::collections::HashSet<u8> = pixels.iter().map(|value| value >> 3).collect();
    assert!(tones.len() > 12, "{} tones", tones.len());
    let ended = pieper(&["studio", "--headless-frame", &file, "--size", "huge"]);
    assert_eq!(ended.code, 2);
}

#[test]
fn a_project_is_opened_and_kept() {
    let folder = Temporary::new();
    let project = folder.file("p.json", "{\"pieper_studio\": 7}");
    let ended = pieper(&["studio", "--no-open", "--project", &project]);
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("p.json"), "{}", ended.stderr);
}
