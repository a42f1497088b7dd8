//! The motors' limits and the linkages' reach, as ranges of a joint.

use super::Transmission;
use super::motor::{Linkage, Motor};
use super::sections::Span;
use crate::error::{Error, Result};
use crate::model::Drive;

impl Transmission {
    /// How far the drives let one joint move while the others stand still at `q`: limits of motors, windows of servos,
    /// reach of linkages. `None` if there is no such place. The joint's own limits are no matter.
    ///
    /// Of a linkage the copy of the joint's range by whole turns that it works in.
    ///
    /// # Errors
    /// An input error unless there is such a joint and `q` has one finite value for each.
    ///
    /// ```
    /// use pieper::describe::Robot;
    /// let text = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n
    ///     [[transmission]]\nkind = 'servo'\nmotor = 'm1'\njoint = 'q1'\nratio = 2";
    /// let transmission = Robot::from_toml("r.toml", text)?.transmission()?;
    /// let range = transmission.range(0, &[0.0])?.unwrap();
    /// assert_eq!(range.upper, 45_f64.to_radians()); // half of a quarter turn
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn range(&self, joint: usize, q: &[f64]) -> Result<Option<Span>> {
        self.check(q, "joint")?;
        if joint >= self.dof() {
            let text = format!("there are {}", self.dof());
            return Err(Error::input(format!("joint {}", joint + 1), text));
        }
        let mut range = Span::EVERYWHERE;
        for motor in self.all() {
            match allowed(motor, joint, q) {
                Some(span) => {
                    range.lower = range.lower.max(span.lower);
                    range.upper = range.upper.min(span.upper);
                }
                None => return Ok(None),
            }
        }
        Ok((range.lower <= range.upper).then_some(range))
    }
}

/// The joint's range by one motor.
fn allowed(motor: &Motor, joint: usize, q: &[f64]) -> Option<Span> {
    let shaft = motor.limits().map_or(Span::EVERYWHERE, |limits| {
        let end = |value: f64| (value - motor.offset()) / motor.ratio();
        ordered(end(limits.lower()), end(limits.upper()))
    });
    if let Some(linkage) = motor.linkage().filter(|_| motor.is_rocker(joint)) {
        return by_linkage(linkage, shaft, motor.sum(q, None));
    }
    let Some(term) = motor.terms().iter().find(|term| term.variable == joint) else {
        return Some(Span::EVERYWHERE);
    };
    let rest = motor.sum(q, Some(joint)) + motor.psi(q).ok()?;
    Some(through(term, shaft, rest))
}

fn by_linkage(linkage: &Linkage, shaft: Span, frame: f64) -> Option<Span> {
    let psi = linkage.section.psi();
    let (lower, upper) = (
        psi.lower.max(shaft.lower - frame),
        psi.upper.min(shaft.upper - frame),
    );
    if lower > upper {
        return None;
    }
    let phi = |psi: f64, otherwise: f64| match psi.is_finite() {
        true => linkage.section.rocker_angle(psi).unwrap_or(otherwise),
        false => otherwise,
    };
    let span = ordered(phi(lower, f64::NEG_INFINITY), phi(upper, f64::INFINITY));
    Some(through(&linkage.rocker, span, 0.0))
}

/// The joint's range for a range of `rest + offset + factor * joint`.
fn through(drive: &Drive, span: Span, rest: f64) -> Span {
    let end = |value: f64| (value - rest - drive.offset) / drive.factor;
    ordered(end(span.lower), end(span.upper))
}

fn ordered(one: f64, other: f64) -> Span {
    Span {
        lower: one.min(other),
        upper: one.max(other),
    }
}
