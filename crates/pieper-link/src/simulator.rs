//! Controllers that are not there: for tests, for the studio, and for whoever has no hardware.
//!
//! A [`Device`] is a controller's side of a protocol, pure; [`Served`] runs one on a real socket or pseudo-terminal, in
//! true time. Both misbehave on demand: [`Fault`].

mod ar3;
mod ar4;
mod board;
mod egm;
mod fault;
mod packets;
mod plant;
mod ros;
mod serve;
mod servo;

pub use fault::{Fault, Weather};
pub use plant::{Plant, SimMotor};
pub use serve::{Place, Served};

use std::time::Duration;

use crate::arm::Arm;
use crate::protocol::Kind;

/// A controller's side of a protocol. Times are since it was switched on.
pub trait Device: Send {
    /// Takes bytes from a program; what it answers at once goes to `out`.
    fn receive(&mut self, now: Duration, bytes: &[u8], out: &mut Vec<u8>);

    /// Lets time pass: motors move, and what there is to say goes to `out`.
    fn tick(&mut self, now: Duration, out: &mut Vec<u8>);

    /// How often [`Device::tick`] is to be called.
    fn period(&self) -> Duration;

    /// Does one of the controller's own faults; those of the wire are [`Weather`]'s.
    fn inject(&mut self, now: Duration, fault: Fault);

    /// Where the motors are, radians and metres.
    fn motors(&self) -> Vec<f64>;
}

/// A simulated controller of this kind for this arm, at rest.
///
/// # Errors
/// A sentence where the protocol cannot carry the arm.
pub fn device(kind: Kind, arm: &Arm) -> Result<Box<dyn Device>, String> {
    // The host's own demands hold for the device too.
    kind.host(crate::protocol::Setup {
        motors: arm.motors(),
        poses_of: None,
        nonce: 1,
    })?;
    let motors = plant::motors(arm);
    Ok(match kind {
        Kind::Packets => Box::new(packets::PacketDevice::new(motors)),
        Kind::Ar4 => Box::new(ar4::Ar4Device::new(motors)),
        Kind::Ar3 => Box::new(ar3::Ar3Device::new(motors)),
        Kind::Ros => Box::new(ros::RosDevice::new(motors)),
        Kind::Servo => Box::new(servo::ServoDevice::new(motors)),
        Kind::Egm => Box::new(egm::EgmDevice::new(motors, arm)),
    })
}
