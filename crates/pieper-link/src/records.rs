//! Where sessions are recorded unless somebody says otherwise.

use std::env;
use std::fs;
use std::path::PathBuf;
use std::time::SystemTime;

use crate::protocol::Kind;

/// The folder of the records: of the user's state, or where the program was started.
pub fn folder() -> PathBuf {
    let set = |name: &str| env::var_os(name).filter(|value| !value.is_empty());
    let state = set("XDG_STATE_HOME")
        .map(PathBuf::from)
        .or_else(|| set("HOME").map(|home| PathBuf::from(home).join(".local/state")))
        .or_else(|| set("LOCALAPPDATA").map(PathBuf::from));
    state.unwrap_or_default().join("pieper/link")
}

/// A name for a new record: rising with time.
pub fn new(kind: Kind) -> PathBuf {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    let millis = now.map_or(0, |time| time.as_millis());
    folder().join(format!("{millis}-{kind}.jsonl"))
}

/// The newest record, if there is one.
pub fn newest() -> Option<PathBuf> {
    let entries = fs::read_dir(folder()).ok()?;
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    paths
        .filter(|path| path.extension().is_some_and(|end| end == "jsonl"))
        .max()
}
