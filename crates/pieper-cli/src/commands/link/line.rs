//! Which controller, and the session with it.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use clap::Args;
use pieper_link::transport::Address;
use pieper_link::{Arm, Kind, Options, Session, records};

use crate::error::Failure;
use crate::output;
use crate::source::Source;

/// How long a controller may take to answer: boards that reset when their port is opened take two seconds.
const ANSWER: Duration = Duration::from_secs(4);

/// How long each protocol is tried when none is named.
const PROBE: Duration = Duration::from_millis(1500);

/// Protocols that are tried on a serial line, the ones that are sure of themselves first.
const PROBED: [Kind; 5] = [Kind::Packets, Kind::Ros, Kind::Ar4, Kind::Ar3, Kind::Servo];

/// The arm of a link, which may be left to the protocol.
#[derive(Args, Clone, Debug)]
#[command(mut_arg("robot", |robot| robot.long("robot").required(false).default_value("").hide_default_value(true)
    .help("The arm: a built-in name or a file (default: the one that the protocol is made for)")))]
pub(super) struct Which {
    #[command(flatten)]
    source: Source,
}

impl Which {
    /// The arm, for a protocol.
    pub(super) fn arm(&self, kind: Kind) -> Result<Arc<Arm>, Failure> {
        Ok(Arc::new(Arm::of(&self.source(kind).robot()?)?))
    }

    /// The source of the arm, for a protocol.
    pub(super) fn source(&self, kind: Kind) -> Source {
        let mut source = self.source.clone();
        if source.robot.is_empty() {
            kind.robot().clone_into(&mut source.robot);
        }
        source
    }
}

/// A controller on a line.
#[derive(Args, Clone, Debug)]
pub(super) struct Line {
    /// Where the controller is: /dev/ttyACM0, COM3, /dev/ttyUSB0@57600, tcp:HOST:PORT, or udp:PORT for EGM
    #[arg(long, value_name = "ADDRESS")]
    pub(super) to: Option<Address>,

    /// What it speaks: ar4, ar3, ros, servo, egm, packets (default: each is tried; EGM for udp)
    #[arg(long, value_name = "KIND")]
    pub(super) protocol: Option<Kind>,

    #[command(flatten)]
    pub(super) which: Which,

    /// EGM: send poses of the tool, for a program that runs EGMRunPose
    #[arg(long)]
    poses: bool,

    /// Where the session is recorded (default: a folder of its own, see `pieper link log`)
    #[arg(long, value_name = "FILE.jsonl")]
    record: Option<PathBuf>,
}

/// A session that has heard from its controller.
pub(super) struct Connected {
    pub(super) session: Session,
    pub(super) arm: Arc<Arm>,
    pub(super) kind: Kind,
    pub(super) address: Address,
    pub(super) record: PathBuf,
}

impl Line {
    /// The protocol for what is computed without a controller.
    pub(super) fn kind(&self) -> Kind {
        let by_address = match self.to {
            Some(Address::Udp(_)) => Kind::Egm,
            _ => Kind::Ar4,
        };
        self.protocol.unwrap_or(by_address)
    }

    /// Connects and waits until the controller has told where the arm is.
    pub(super) fn connect(&self, share: f64) -> Result<Connected, Failure> {
        let address = self.address()?;
        let named = match (self.protocol, &address) {
            (Some(kind), _) => Some(kind),
            (None, Address::Udp(_)) => Some(Kind::Egm),
            (None, _) => None,
        };
        match named {
            Some(kind) => self.connect_as(kind, &self.which.arm(kind)?, share),
            None => self.probe(&address, share),
        }
    }

    /// Connects an arm of one's own making.
    pub(super) fn connect_as(
        &self,
        kind: Kind,
        arm: &Arc<Arm>,
        share: f64,
    ) -> Result<Connected, Failure> {
        let connected = self.open(&self.address()?, kind, arm, share)?;
        self.wait(connected)
    }

    fn address(&self) -> Result<Address, Failure> {
        self.to.clone().ok_or_else(|| {
            Failure::input("--to ADDRESS was expected: `pieper link list` shows the serial ports")
        })
    }

    fn wait(&self, connected: Connected) -> Result<Connected, Failure> {
        let patience = match connected.kind {
            // The controller's own program has to be started by somebody.
            Kind::Egm => ANSWER * 5,
            _ => ANSWER,
        };
        let waited = connected.session.wait_connected(patience);
        waited.map_err(|text| Failure::World(format!("{}: {text}", connected.address)))?;
        Ok(connected)
    }

    fn open(
        &self,
        address: &Address,
        kind: Kind,
        arm: &Arc<Arm>,
        share: f64,
    ) -> Result<Connected, Failure> {
        let arm = Arc::clone(arm);
        let record = match &self.record {
            Some(path) => path.clone(),
            None => records::new(kind),
        };
        let options = Options {
            share,
            poses: self.poses,
            record: Some(record.clone()),
        };
        let session = Session::connect(address, kind, Arc::clone(&arm), &options);
        Ok(Connected {
            session: session.map_err(Failure::World)?,
            arm,
            kind,
            address: address.clone(),
            record,
        })
    }

    /// Tries one protocol after the other.
    fn probe(&self, address: &Address, share: f64) -> Result<Connected, Failure> {
        for kind in PROBED {
            output::note(&format!("trying {kind} ..."));
            let connected = self.open(address, kind, &self.which.arm(kind)?, share)?;
            if connected.session.wait_connected(PROBE).is_ok() {
                return Ok(connected);
            }
            // What was heard of the wrong protocol is no session worth keeping.
            drop(connected.session);
            if self.record.is_none() {
                let _ = std::fs::remove_file(&connected.record);
            }
        }
        Err(Failure::World(format!(
            "{address}: no controller answered to any protocol: is it on, is this its port? --protocol names one, and waits longer"
        )))
    }
}
