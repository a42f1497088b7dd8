//! One picture without a person: the page itself draws it in a browser without a window, and hands it back.

use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use tokio::sync::oneshot;

/// Browsers that can do it, as they are called.
const BROWSERS: [&str; 5] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
];

/// How long the browser has.
pub(super) const PATIENCE: Duration = Duration::from_secs(60);

/// A picture that is waited for.
#[derive(Default)]
pub(super) struct Waiting(Mutex<Option<oneshot::Sender<Vec<u8>>>>);

impl Waiting {
    /// Begins to wait.
    pub(super) fn begin(&self) -> oneshot::Receiver<Vec<u8>> {
        let (tell, told) = oneshot::channel();
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(tell);
        told
    }

    /// Whether the picture was waited for.
    pub(super) fn arrive(&self, picture: Vec<u8>) -> bool {
        let waiting = self.0.lock().unwrap_or_else(PoisonError::into_inner).take();
        waiting.is_some_and(|tell| tell.send(picture).is_ok())
    }
}

/// A browser without a window that has opened an address; it ends with this.
pub(super) struct Browser {
    child: Child,
    profile: std::path::PathBuf,
}

impl Browser {
    /// # Errors
    /// A sentence with the remedy: no browser is installed.
    pub(super) fn open(url: &str, [width, height]: [u32; 2]) -> Result<Self, String> {
        let profile = std::env::temp_dir().join(format!("pieper-studio-{}", std::process::id()));
        for program in BROWSERS {
            let started = Command::new(program)
                .args([
                    "--headless",
                    "--no-sandbox",
                    "--no-first-run",
                    "--disable-background-networking",
                    "--disable-component-update",
                    "--disable-sync",
                ])
                .args([
                    "--use-gl=angle",
                    "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader",
                ])
                .arg(format!("--window-size={width},{height}"))
                .arg(format!("--user-data-dir={}", profile.display()))
                .arg("--remote-debugging-port=0")
                .arg(url)
                .stdin(Stdio::null())
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn();
            if let Ok(child) = started {
                return Ok(Self { child, profile });
            }
        }
        Err(format!(
            "a picture is drawn by a browser, and none of {} was found: install one, as in apt-get install chromium",
            BROWSERS.join(", ")
        ))
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = std::fs::remove_dir_all(&self.profile);
    }
}
