//! The four-bar linkage: a crank drives a rocker through a coupler.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::sections::{self, DeadPoint, Section, Span};
use crate::error::{Error, Result};

/// The four lengths, in any one unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lengths {
    /// AB: turned by the motor, about A.
    pub crank: f64,
    /// BC: joins the ends of crank and rocker.
    pub coupler: f64,
    /// CD: fixed to the driven link, turns about D.
    pub rocker: f64,
    /// AD: from the crank's pivot to the rocker's.
    pub frame: f64,
}

/// On which side of the diagonal AC the crank's end B stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assembly {
    /// B and D on different sides of AC: no two bars cross near the middle of the reach. The usual one.
    Open,
    /// B and D on the same side of AC.
    Crossed,
}

impl Assembly {
    /// The word robot files use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Crossed => "crossed",
        }
    }

    fn sign(self) -> f64 {
        match self {
            Self::Open => 1.0,
            Self::Crossed => -1.0,
        }
    }
}

/// A four-bar linkage in one of its two assemblies.
///
/// In the plane of the linkage, with A at the origin and D on the x axis,
///
/// ```text
/// D = (frame, 0)   C = D + rocker (sin phi, cos phi)   B = crank (cos theta, sin theta)   |BC| = coupler
/// theta = beta2 +- beta1   (open: +, crossed: -)       psi = theta(0) - theta(phi)
/// ```
///
/// beta2 is the angle of AC over AD, beta1 that between AC and AB. The rocker's angle phi is 0 where the rocker is
/// perpendicular to the frame and grows as the diagonal AC does; the crank's angle psi is 0 where phi is (if the linkage
/// can be assembled there; otherwise it is counted from the crank pointing away from D), and grows with phi wherever a
/// parallelogram's does. Source: the ABB paper's drive of joint 3, whose psi0 is [`FourBar::psi0`].
///
/// A pose of either end belongs to at most two poses of the other. Which of them a drive takes is its [`Section`]: the
/// stretch between dead points in which it works.
///
/// ```
/// use pieper::transmission::{Assembly, FourBar, Lengths};
/// let lengths = Lengths { crank: 25.96, coupler: 104.33, rocker: 29.27, frame: 95.0 };
/// let drive = FourBar::new(lengths, Assembly::Open)?;
/// let psi = drive.crank_angle(20_f64.to_radians()).unwrap().to_degrees();
/// assert!((psi - 22.3087692).abs() < 1e-7);
/// assert!(drive.crank_angle(-60_f64.to_radians()).is_none()); // it cannot be assembled
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBar {
    lengths: Lengths,
    assembly: Assembly,
    /// theta where psi is 0.
    theta_zero: f64,
}

/// How far, relative to the sum of the sides, a triangle may miss closing and still be one: roundings of the sides.
const CLOSING: f64 = 8.0 * f64::EPSILON;

impl FourBar {
    /// A linkage of these lengths.
    ///
    /// # Errors
    /// A model error if a length is not a positive number, or if one bar is longer than the others together, so that
    /// the linkage can be assembled nowhere.
    pub fn new(lengths: Lengths, assembly: Assembly) -> Result<Self> {
        let Lengths {
            crank,
            coupler,
            rocker,
            frame,
        } = lengths;
        let bars = [
            ("crank", crank),
            ("coupler", coupler),
            ("rocker", rocker),
            ("frame", frame),
        ];
        for (name, length) in bars {
            if !(length > 0.0 && length.is_finite()) {
                let subject = format!("four-bar, {name} = {length}");
                return Err(Error::model(subject, "a positive length was expected"));
            }
        }
        let total: f64 = bars.iter().map(|bar| bar.1).sum();
        if let Some((name, length)) = bars.iter().find(|bar| 2.0 * bar.1 > total) {
            let others = total - length;
            let text = format!(
                "it can be assembled nowhere: the others together measure {others}, less than that"
            );
            return Err(Error::model(format!("four-bar, {name} = {length}"), text));
        }
        let mut linkage = Self {
            lengths,
            assembly,
            theta_zero: PI,
        };
        if let Some(theta) = linkage.theta(0.0) {
            linkage.theta_zero = theta;
        }
        Ok(linkage)
    }

    /// The lengths.
    pub fn lengths(&self) -> Lengths {
        self.lengths
    }

    /// The assembly.
    pub fn assembly(&self) -> Assembly {
        self.assembly
    }

    /// The paper's psi0: the crank's angle over DA prolonged, where psi is 0.
    pub fn psi0(&self) -> f64 {
        PI - self.theta_zero
    }

    /// The crank's angle psi at the rocker's angle phi; `None` where the linkage cannot be assembled.
    ///
    /// Continuous in phi, over whole turns too.
    pub fn crank_angle(&self, phi: f64) -> Option<f64> {
        Some(self.theta_zero - self.theta(phi)?)
    }

    /// The rocker's angles at the crank's angle psi, with the assembly that each belongs to; `None` where the linkage
    /// cannot be assembled. In (-pi, pi]; the two are equal at a dead point.
    ///
    /// The first has C to the left of DB, with A to D pointing right; the second has it to the right.
    pub fn rocker_angles(&self, psi: f64) -> Option<[(f64, Assembly); 2]> {
        let one = self.rocker_angle(psi, 1.0)?;
        let other = self.rocker_angle(psi, -1.0)?;
        Some([one, other].map(|phi| (wrapped(phi), self.assembly_of(phi, psi))))
    }

    /// The velocity ratio dpsi/dphi at the rocker's angle phi; `None` where the linkage cannot be assembled.
    ///
    /// From the closed loop: `-(BC . C') / (BC . B')`, primes by phi and theta. Zero where coupler and rocker are in
    /// line, infinite where crank and coupler are: its dead points.
    pub fn ratio(&self, phi: f64) -> Option<f64> {
        let Lengths { crank, rocker, .. } = self.lengths;
        let [_, b, c, _] = self.points(phi)?;
        let (sin_phi, cos_phi) = phi.sin_cos();
        let (bc_x, bc_y) = (c[0] - b[0], c[1] - b[1]);
        let by_phi = rocker * (bc_x * cos_phi - bc_y * sin_phi);
        let by_theta = crank * (bc_y * (b[0] / crank) - bc_x * (b[1] / crank));
        // |BC|^2 = const: by_phi dphi = by_theta dtheta, and psi falls as theta grows.
        Some(-by_phi / by_theta)
    }

    /// How the crank's angle psi grows with each length, crank, coupler, rocker and frame, while the rocker's angle phi stays; `None`
    /// where the linkage cannot be assembled. Infinite at the rocker's dead points.
    ///
    /// From the closed loop, as [`FourBar::ratio`]: `|BC|^2 = coupler^2` by each length over the same by theta; less what it is at phi = 0,
    /// where psi is 0 whatever the lengths are.
    ///
    /// ```
    /// use pieper::transmission::{Assembly, FourBar, Lengths};
    /// let parallelogram = Lengths { crank: 0.2, coupler: 0.5, rocker: 0.2, frame: 0.5 };
    /// let rates = FourBar::new(parallelogram, Assembly::Open)?.rates(0.3).unwrap();
    /// assert!((0.2 * rates[0] + 0.5 * rates[1] + 0.2 * rates[2] + 0.5 * rates[3]).abs() < 1e-12); // its size is no matter
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn rates(&self, phi: f64) -> Option<[f64; 4]> {
        let here = self.theta_rates(phi)?;
        let zero = self.theta_rates(0.0).unwrap_or([0.0; 4]);
        Some(std::array::from_fn(|k| zero[k] - here[k]))
    }

    /// How theta grows with each length.
    fn theta_rates(&self, phi: f64) -> Option<[f64; 4]> {
        let Lengths { crank, coupler, .. } = self.lengths;
        let [_, b, c, _] = self.points(phi)?;
        let (sin_phi, cos_phi) = phi.sin_cos();
        let (bc_x, bc_y) = (c[0] - b[0], c[1] - b[1]);
        let along_b = [b[0] / crank, b[1] / crank];
        // Halves of the derivatives of |BC|^2 - coupler^2.
        let by_theta = crank * (bc_x * along_b[1] - bc_y * along_b[0]);
        let by = [
            -(bc_x * along_b[0] + bc_y * along_b[1]),
            -coupler,
            bc_x * sin_phi + bc_y * cos_phi,
            bc_x,
        ];
        Some(by.map(|by| -by / by_theta))
    }

    /// The points A, B, C, D in the linkage's plane; `None` where it cannot be assembled.
    pub fn points(&self, phi: f64) -> Option<[[f64; 2]; 4]> {
        let (sin, cos) = self.theta(phi)?.sin_cos();
        let Lengths { crank, frame, .. } = self.lengths;
        Some([
            [0.0, 0.0],
            [crank * cos, crank * sin],
            self.c(phi),
            [frame, 0.0],
        ])
    }

    /// Where the rocker can stand: spans of phi, two at most, the same for both assemblies. One without ends if the
    /// rocker turns round.
    pub fn reach(&self) -> Vec<Span> {
        sections::reach(self)
    }

    /// The dead points of this assembly, in the order of phi, each with phi in a span of [`FourBar::reach`].
    pub fn dead_points(&self) -> Vec<DeadPoint> {
        sections::dead_points(self)
    }

    /// The stretch between dead points that holds the rocker's angle phi; `None` where it cannot be assembled.
    ///
    /// At a dead point, the one on either side of it.
    pub fn section_at(&self, phi: f64) -> Option<Section> {
        sections::at(self, phi)
    }

    /// Where C stands.
    pub(super) fn c(&self, phi: f64) -> [f64; 2] {
        let (sin, cos) = phi.sin_cos();
        let Lengths { rocker, frame, .. } = self.lengths;
        [rocker.mul_add(sin, frame), rocker * cos]
    }

    /// The angle DAB.
    fn theta(&self, phi: f64) -> Option<f64> {
        let [x, y] = self.c(phi);
        let Lengths { crank, coupler, .. } = self.lengths;
        let beta1 = angle_opposite(coupler, x.hypot(y), crank)?;
        Some(self.beta2(phi) + self.assembly.sign() * beta1)
    }

    /// The angle of AC over AD, continuous in phi.
    pub(super) fn beta2(&self, phi: f64) -> f64 {
        let Lengths { rocker, frame, .. } = self.lengths;
        let (sin, cos) = phi.sin_cos();
        if frame >= rocker {
            return (rocker * cos).atan2(rocker.mul_add(sin, frame));
        }
        // C goes round A: the turn of DC, and a part within a right angle.
        FRAC_PI_2 - phi + (-frame * cos).atan2(frame.mul_add(sin, rocker))
    }

    /// The rocker's angle at psi, with C on the side `side` (+1 left, -1 right) of DB.
    pub(super) fn rocker_angle(&self, psi: f64, side: f64) -> Option<f64> {
        let Lengths {
            crank,
            coupler,
            rocker,
            frame,
        } = self.lengths;
        let (sin, cos) = (self.theta_zero - psi).sin_cos();
        let (x, y) = (crank.mul_add(cos, -frame), crank * sin);
        let angle = angle_opposite(coupler, x.hypot(y), rocker)?;
        Some(FRAC_PI_2 - y.atan2(x) - side * angle)
    }

    /// The side of DB on which C stands: +1 left, -1 right.
    pub(super) fn side(&self, phi: f64) -> Option<f64> {
        let [_, b, c, d] = self.points(phi)?;
        Some(side(d, b, c))
    }

    fn assembly_of(&self, phi: f64, psi: f64) -> Assembly {
        let (sin, cos) = (self.theta_zero - psi).sin_cos();
        match side([0.0, 0.0], self.c(phi), [cos, sin]) {
            s if s > 0.0 => Assembly::Open,
            s if s < 0.0 => Assembly::Crossed,
            _ => self.assembly,
        }
    }

    /// psi for a theta known up to whole turns, the copy next to `near`.
    pub(super) fn psi_near(&self, theta: f64, near: f64) -> f64 {
        let psi = self.theta_zero - theta;
        psi + TAU * ((near - psi) / TAU).round()
    }

    pub(super) fn is_open(&self) -> bool {
        self.assembly == Assembly::Open
    }
}

/// The sign of the turn from `from`-`to` to `from`-`point`.
pub(super) fn side(from: [f64; 2], to: [f64; 2], point: [f64; 2]) -> f64 {
    let (u, v) = (
        [to[0] - from[0], to[1] - from[1]],
        [point[0] - from[0], point[1] - from[1]],
    );
    let cross = u[0] * v[1] - u[1] * v[0];
    if cross == 0.0 { 0.0 } else { cross.signum() }
}

/// The angle of a triangle opposite the side `z`, between `x` and `y`; `None` if they make no triangle.
///
/// By half the angle (Kahan): as exact for a flat triangle as for a square one, where the arc cosine loses half its digits.
fn angle_opposite(z: f64, x: f64, y: f64) -> Option<f64> {
    let closing = -CLOSING * (x + y + z);
    let (over, under, rest) = (z - (x - y), z + (x - y), (x + y) - z);
    if over < closing || under < closing || rest < closing {
        return None;
    }
    let sine = (over.max(0.0) * under.max(0.0)).sqrt();
    let cosine = (rest.max(0.0) * (x + y + z)).sqrt();
    Some(2.0 * sine.atan2(cosine))
}

/// The same angle in (-pi, pi].
pub(super) fn wrapped(angle: f64) -> f64 {
    let turned = angle - TAU * (angle / TAU).round();
    if turned <= -PI { PI } else { turned }
}
