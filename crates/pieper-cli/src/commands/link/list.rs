//! `pieper link list`

use clap::Args;
use pieper_link::{Kind, transport};
use serde_json::{Value, json};

use crate::error::{Failure, Outcome};
use crate::{output, text};

/// List the serial ports and the protocols
#[derive(Args)]
pub(crate) struct Arguments {
    /// One JSON document
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let ports = transport::list().map_err(Failure::World)?;
        if self.json {
            let protocol = |kind: &Kind| json!({ "name": kind.name(), "summary": kind.summary(), "robot": kind.robot() });
            let port = |(path, what): &(String, String)| json!({ "path": path, "what": what });
            output::document(&json!({
                "ports": ports.iter().map(port).collect::<Value>(),
                "protocols": Kind::ALL.iter().map(protocol).collect::<Value>(),
            }))?;
            return Ok(Outcome::Done);
        }
        let mut out = String::from("Serial ports\n");
        match ports.is_empty() {
            true => out.push_str("  none: is the controller plugged in and on?\n"),
            false => {
                let rows = ports.into_iter().map(|(path, what)| vec![path, what]);
                out.push_str(&text::listing(&rows.collect::<Vec<_>>()));
            }
        }
        out.push_str("Protocols\n");
        let rows = Kind::ALL.iter().map(|kind| {
            vec![
                kind.name().to_owned(),
                kind.robot().to_owned(),
                kind.summary().to_owned(),
            ]
        });
        out.push_str(&text::listing(&rows.collect::<Vec<_>>()));
        output::answer(&out)?;
        Ok(Outcome::Done)
    }
}
