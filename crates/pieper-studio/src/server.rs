//! HTTP and WebSocket around a session: WIRE.md sections 1 to 3.

mod assets;
mod autosave;
mod controller;
mod hub;
mod picture;
mod routes;
mod scripts;
mod security;
mod share;
mod socket;

use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;

use axum::serve::ListenerExt as _;
use tokio::net::TcpListener;
use tokio::runtime::Runtime;

use crate::session::Session;
use hub::Hub;
use scripts::Scripts;
use security::Keys;

/// How a studio is started.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The port; 0 for one that is free.
    pub port: u16,
    /// A project file to keep up to date, if any.
    pub project: Option<PathBuf>,
}

/// A studio that listens.
pub struct Studio {
    runtime: Runtime,
    listener: TcpListener,
    state: Arc<State>,
    project: Option<PathBuf>,
}

/// What every request sees.
struct State {
    hub: Hub,
    keys: Keys,
    scripts: Scripts,
    picture: picture::Waiting,
    controller: controller::Controller,
}

impl Studio {
    /// Binds the port on this computer only; nothing is served yet.
    ///
    /// # Errors
    /// A sentence: the port is in use (and what to do then), or the system refuses.
    pub fn bind(session: Session, options: &Options) -> Result<Self, String> {
        let runtime =
            Runtime::new().map_err(|error| format!("the studio could not be started: {error}"))?;
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, options.port));
        let listener = runtime.block_on(TcpListener::bind(address)).map_err(|error| match error.kind() {
            std::io::ErrorKind::AddrInUse => format!(
                "port {} is in use, perhaps by another studio: choose one with --port N, or leave --port out for a free one",
                options.port
            ),
            _ => format!("port {}: {error}", options.port),
        })?;
        let port = listener
            .local_addr()
            .map_err(|error| error.to_string())?
            .port();
        let keys =
            Keys::new(port).map_err(|error| format!("no random numbers could be had: {error}"))?;
        let state = Arc::new(State {
            hub: Hub::new(session),
            keys,
            scripts: Scripts::default(),
            picture: picture::Waiting::default(),
            controller: controller::Controller::default(),
        });
        Ok(Self {
            runtime,
            listener,
            state,
            project: options.project.clone(),
        })
    }

    /// The address to open, with its token.
    pub fn url(&self) -> String {
        self.state.keys.url()
    }

    /// Serves until the process ends.
    ///
    /// # Errors
    /// A sentence if the system takes the port away.
    pub fn serve(self) -> Result<(), String> {
        let Self {
            runtime,
            listener,
            state,
            project,
        } = self;
        state.look_for_python();
        runtime.block_on(async {
            let saving = project.map(|file| tokio::spawn(autosave::run(Arc::clone(&state), file)));
            let served = listen(listener, state).await;
            if let Some(saving) = saving {
                saving.abort();
            }
            served
        })
    }

    /// The present view as a PNG file of a size in pixels, drawn by the page in a browser without a window.
    ///
    /// # Errors
    /// A sentence: no browser is installed, or it does not answer.
    pub fn picture(self, size: [u32; 2]) -> Result<Vec<u8>, String> {
        let Self {
            runtime,
            listener,
            state,
            ..
        } = self;
        let [width, height] = size;
        let url = state
            .keys
            .url()
            .replace("/#", &format!("/?frame={width}x{height}#"));
        runtime.block_on(async {
            let told = state.picture.begin();
            let served = tokio::spawn(listen(listener, state));
            let browser = picture::Browser::open(&url, size)?;
            let arrived = tokio::time::timeout(picture::PATIENCE, told).await;
            drop(browser);
            served.abort();
            match arrived {
                Ok(Ok(picture)) => Ok(picture),
                _ => Err("the browser was started and drew no picture within a minute".to_owned()),
            }
        })
    }
}

/// Serves for ever.
async fn listen(listener: TcpListener, state: Arc<State>) -> Result<(), String> {
    let clock = tokio::spawn(hub::run(Arc::clone(&state)));
    let looking = tokio::spawn(controller::run(Arc::clone(&state)));
    // Small messages go at once: held back until the last was acknowledged, a pose would come 40 ms late.
    let listener = listener.tap_io(|stream| {
        let _ = stream.set_nodelay(true);
    });
    let served = axum::serve(listener, routes::router(state)).await;
    clock.abort();
    looking.abort();
    served.map_err(|error| format!("the studio stopped: {error}"))
}
