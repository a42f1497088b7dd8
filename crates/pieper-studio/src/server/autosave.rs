//! The project file, kept up to date.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::State;

/// Time between two looks.
const PAUSE: Duration = Duration::from_secs(2);

/// Writes the project whenever it has changed, as long as the studio serves.
pub(super) async fn run(state: Arc<State>, file: PathBuf) {
    let mut saved = state.hub.session().project();
    let mut complained = false;
    loop {
        tokio::time::sleep(PAUSE).await;
        let now = state.hub.session().project();
        if now == saved {
            continue;
        }
        match write(&file, &format!("{now:#}\n")) {
            Ok(()) => (saved, complained) = (now, false),
            Err(error) if !complained => {
                complained = true;
                state.hub.session().say(
                    "error",
                    format!(
                        "{}: the project could not be saved: {error}",
                        file.display()
                    ),
                );
                state.hub.wake();
            }
            Err(_) => {}
        }
    }
}

/// In one step: a reader sees the old file or the new one.
fn write(file: &Path, text: &str) -> std::io::Result<()> {
    let beside = file.with_extension("json.new");
    fs::write(&beside, text)?;
    fs::rename(&beside, file)
}
