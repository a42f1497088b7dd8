//! `pieper robots`

use clap::Args;
use serde_json::json;

use crate::error::{Failure, Outcome};
use crate::{output, text};

/// Example: pieper robots
#[derive(Args)]
pub(crate) struct Arguments {
    /// One JSON document
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robots = pieper_robots::ALL
            .iter()
            .map(|built_in| (built_in.id, built_in.robot()));
        if self.json {
            let list = robots.map(|(id, robot)| {
                let (name, summary, parameters) = (&robot.name, &robot.summary, robot.missing_parameters());
                json!({"id": id, "name": name, "summary": summary, "missing_parameters": parameters})
            });
            output::document(&list.collect())?;
        } else {
            let rows: Vec<Vec<String>> = robots
                .map(|(id, robot)| vec![id.to_owned(), robot.summary])
                .collect();
            output::answer(&text::listing(&rows))?;
        }
        Ok(Outcome::Done)
    }
}
