//! One motor and what it drives.

use super::answer::{OutOfReach, Past, Quantity};
use super::four_bar::FourBar;
use super::sections::Section;
use crate::error::{Error, Result};
use crate::model::{Drive, Limits};

/// A motor and how its value follows from the joints':
/// `motor = offset + ratio * (sum of factors * joints [+ psi(rocker's joint)])`.
///
/// Values are radians (metres for a joint that slides and is driven directly).
///
/// ```
/// use pieper::model::{Drive, Limits};
/// use pieper::transmission::Motor;
/// // An axis counted against the horizontal: joint 3 plus joint 2, 60 motor turns to one of the axis.
/// let term = |variable| Drive { variable, factor: 1.0, offset: 0.0 };
/// let motor = Motor::linear("m3", vec![term(1), term(2)])?.geared(60.0, 0.0)?;
/// // A hobby servo of half a turn, at 90 degrees where the joint is at zero.
/// let servo = Motor::servo("m1", 0, Limits::new(0.0, std::f64::consts::PI)?)?;
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Motor {
    name: String,
    kind: MotorKind,
    terms: Vec<Drive>,
    linkage: Option<Linkage>,
    ratio: f64,
    offset: f64,
    limits: Option<Limits>,
}

/// How a motor is joined to the joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotorKind {
    /// Its value is the joint's.
    Direct,
    /// A weighted sum of joints: gears, belts, parallelograms, wrists whose shafts run through one another.
    Linear,
    /// The crank of a four-bar linkage.
    FourBar,
    /// A servo that turns within a window.
    Servo,
}

impl MotorKind {
    /// The word robot files use; `direct` for a motor without a section of its own.
    pub fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::Linear => "linear",
            Self::FourBar => "four-bar",
            Self::Servo => "servo",
        }
    }
}

/// The four-bar linkage of a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linkage {
    /// The linkage.
    pub four_bar: FourBar,
    /// The stretch in which it works.
    pub section: Section,
    /// The rocker's angle phi, by its joint.
    pub rocker: Drive,
}

impl Motor {
    /// A motor whose value is that of the variable.
    pub fn direct(name: impl Into<String>, variable: usize) -> Self {
        let drive = Drive {
            variable,
            factor: 1.0,
            offset: 0.0,
        };
        Self::of(name.into(), MotorKind::Direct, vec![drive], None)
    }

    /// A motor whose shaft turns with a weighted sum of joints.
    ///
    /// # Errors
    /// A model error for no terms, a joint named twice, or a factor that is zero or not finite.
    pub fn linear(name: impl Into<String>, terms: Vec<Drive>) -> Result<Self> {
        let motor = Self::of(name.into(), MotorKind::Linear, terms, None);
        motor.check_terms()?;
        Ok(motor)
    }

    /// A servo on one joint, which turns within `window` and stands in its middle where the joint is at zero. Another
    /// middle, direction or ratio: [`Motor::geared`].
    ///
    /// # Errors
    /// None today; a servo may come to have demands on its window.
    pub fn servo(name: impl Into<String>, variable: usize, window: Limits) -> Result<Self> {
        let mut motor = Self::direct(name, variable).limited(window);
        motor.kind = MotorKind::Servo;
        motor.offset = f64::midpoint(window.lower(), window.upper());
        Ok(motor)
    }

    /// The crank of a four-bar linkage that drives the joint `rocker` gives the angle of.
    ///
    /// `frame` is the turn of the bar AD against the link the crank's pivot and motor stand on, and `None` if they stand
    /// on the bar's own link. In the paper's arm AD is the upper arm and the pivot stands on link 1, so `frame` is joint
    /// 2: with both angles counted in the sense in which the links turn, the crank's angle over link 1 is
    /// `frame + psi(rocker)`, and a parallelogram makes it the sum of both.
    ///
    /// The linkage works in the section that holds the rocker's angle at the joint value `works_at`.
    ///
    /// # Errors
    /// A model error if the linkage cannot be assembled at `works_at`, if a factor is zero or not finite, or if both
    /// angles are of one joint.
    pub fn four_bar(
        name: impl Into<String>,
        four_bar: FourBar,
        rocker: Drive,
        frame: Option<Drive>,
        works_at: f64,
    ) -> Result<Self> {
        let name = name.into();
        let phi = rocker.factor.mul_add(works_at, rocker.offset);
        let Some(section) = four_bar.section_at(phi) else {
            let text = format!(
                "the four-bar cannot be assembled where it is to work: the rocker's angle there is {:.6} deg",
                phi.to_degrees()
            );
            return Err(Error::model(format!("motor {name}"), text));
        };
        let linkage = Linkage {
            four_bar,
            section,
            rocker,
        };
        let terms = frame.into_iter().collect();
        let motor = Self::of(name, MotorKind::FourBar, terms, Some(linkage));
        motor.check_terms()?;
        Ok(motor)
    }

    /// The same motor behind a gear: `ratio` motor turns for one of the shaft, negative if it turns the other way, and
    /// the value `offset` where the shaft is at zero.
    ///
    /// # Errors
    /// A model error for a ratio that is zero, or a number that is not finite.
    pub fn geared(mut self, ratio: f64, offset: f64) -> Result<Self> {
        if ratio == 0.0 || !ratio.is_finite() || !offset.is_finite() {
            let text = format!(
                "ratio {ratio}, offset {offset}: finite numbers were expected, the ratio not zero"
            );
            return Err(Error::model(format!("motor {}", self.name), text));
        }
        (self.ratio, self.offset) = (ratio, offset);
        Ok(self)
    }

    /// The same motor with limits of its value.
    #[must_use]
    pub fn limited(mut self, limits: Limits) -> Self {
        self.limits = Some(limits);
        self
    }

    /// The motor's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How it is joined to the joints.
    pub fn kind(&self) -> MotorKind {
        self.kind
    }

    /// The joints in its sum, with their factors; of a four-bar, the frame's.
    pub fn terms(&self) -> &[Drive] {
        &self.terms
    }

    /// The four-bar linkage, if it has one.
    pub fn linkage(&self) -> Option<&Linkage> {
        self.linkage.as_ref()
    }

    /// Motor turns for one of the shaft.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// The value where the shaft is at zero.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// The range of its value: a servo's window.
    pub fn limits(&self) -> Option<Limits> {
        self.limits
    }

    /// The variables its value depends on, each once.
    pub fn variables(&self) -> impl Iterator<Item = usize> {
        let rocker = self.linkage.as_ref().map(|linkage| linkage.rocker.variable);
        self.terms.iter().map(|term| term.variable).chain(rocker)
    }

    fn of(name: String, kind: MotorKind, terms: Vec<Drive>, linkage: Option<Linkage>) -> Self {
        Self {
            name,
            kind,
            terms,
            linkage,
            ratio: 1.0,
            offset: 0.0,
            limits: None,
        }
    }

    fn check_terms(&self) -> Result<()> {
        let error = |text: String| Err(Error::model(format!("motor {}", self.name), text));
        let rocker = self.linkage.as_ref().map(|linkage| &linkage.rocker);
        for term in self.terms.iter().chain(rocker) {
            let number = term.variable + 1;
            if term.factor == 0.0 || !term.factor.is_finite() || !term.offset.is_finite() {
                return error(format!(
                    "joint {number} enters with the factor {}: finite numbers were expected, the factor not zero",
                    term.factor
                ));
            }
            if self.variables().filter(|&v| v == term.variable).count() > 1 {
                return error(format!("joint {number} enters twice"));
            }
        }
        if self.variables().next().is_none() {
            return error("it drives no joint".to_owned());
        }
        Ok(())
    }

    /// The shaft's angle without the linkage's part, `skip` left out.
    pub(super) fn sum(&self, q: &[f64], skip: Option<usize>) -> f64 {
        let terms = self.terms.iter();
        terms
            .filter(|term| Some(term.variable) != skip)
            .map(|term| term.displacement(q))
            .sum()
    }

    /// The factor with which the variable enters the sum; 0 if it does not.
    pub(super) fn factor(&self, variable: usize) -> f64 {
        let term = self.terms.iter().find(|term| term.variable == variable);
        term.map_or(0.0, |term| term.factor)
    }

    pub(super) fn is_rocker(&self, variable: usize) -> bool {
        self.linkage
            .as_ref()
            .is_some_and(|linkage| linkage.rocker.variable == variable)
    }

    /// psi at the joint vector; 0 without a linkage.
    pub(super) fn psi(&self, q: &[f64]) -> Result<f64, OutOfReach<'_>> {
        let Some(linkage) = &self.linkage else {
            return Ok(0.0);
        };
        let rocker = &linkage.rocker;
        let phi = rocker.displacement(q);
        linkage.section.crank_angle(phi).map_err(|(end, by)| {
            // In the joint's own terms: its value, and the dead point on the side it missed.
            let past = (by / rocker.factor).copysign(rocker.factor * (end.phi - middle(linkage)));
            OutOfReach {
                motor: self,
                quantity: Quantity::Joint(rocker.variable),
                value: q[rocker.variable],
                past,
                bound: Past::DeadPoint(end.rest),
            }
        })
    }

    /// The motor's value, limits aside.
    pub(super) fn value(&self, q: &[f64]) -> Result<f64, OutOfReach<'_>> {
        let shaft = self.sum(q, None) + self.psi(q)?;
        Ok(self.ratio.mul_add(shaft, self.offset))
    }

    /// An answer if the value lies outside the motor's limits.
    pub(super) fn check_limits(&self, value: f64) -> Result<(), OutOfReach<'_>> {
        let Some(limits) = self.limits.filter(|limits| !limits.contains(value)) else {
            return Ok(());
        };
        let end = value.clamp(limits.lower(), limits.upper());
        // A value that came from a joint at the very limit may miss it by the roundings on the way.
        if (value - end).abs() <= LIMIT_SLACK * (1.0 + self.ratio.abs()) {
            return Ok(());
        }
        Err(OutOfReach {
            motor: self,
            quantity: Quantity::Motor,
            value,
            past: value - end,
            bound: Past::Limit,
        })
    }

    /// The value of the one variable that is not yet known, from the motor's: in `q` all others are.
    pub(super) fn solve(
        &self,
        value: f64,
        variable: usize,
        q: &[f64],
    ) -> Result<f64, OutOfReach<'_>> {
        let shaft = (value - self.offset) / self.ratio;
        if !self.is_rocker(variable) {
            let rest = self.sum(q, Some(variable)) + self.psi(q)?;
            let term = self.terms.iter().find(|term| term.variable == variable);
            let (factor, offset) = term.map_or((1.0, 0.0), |term| (term.factor, term.offset));
            return Ok((shaft - rest - offset) / factor);
        }
        let Some(linkage) = &self.linkage else {
            return Ok(f64::NAN);
        };
        let psi = shaft - self.sum(q, None);
        let phi = linkage.section.rocker_angle(psi);
        let phi = phi.map_err(|(end, by)| OutOfReach {
            motor: self,
            quantity: Quantity::Motor,
            value,
            past: self.ratio * by.copysign(psi - end.psi),
            bound: Past::DeadPoint(end.rest),
        })?;
        Ok((phi - linkage.rocker.offset) / linkage.rocker.factor)
    }

    /// The derivative of the motor's value by the variable; infinite at the rocker's dead point.
    pub(super) fn derivative(&self, variable: usize, q: &[f64]) -> Result<f64, OutOfReach<'_>> {
        let factor = self.factor(variable);
        if !self.is_rocker(variable) {
            return Ok(self.ratio * factor);
        }
        self.psi(q)?;
        let Some(linkage) = &self.linkage else {
            return Ok(f64::NAN);
        };
        let phi = linkage.section.place(linkage.rocker.displacement(q));
        let slope = linkage.four_bar.ratio(phi.unwrap_or(f64::NAN));
        Ok(self.ratio * linkage.rocker.factor * slope.unwrap_or(f64::INFINITY))
    }

    /// The answer that the linkage stands at a dead point.
    pub(super) fn at_dead_point(&self, q: &[f64]) -> Option<OutOfReach<'_>> {
        let linkage = self.linkage.as_ref()?;
        let ends = linkage.section.ends()?;
        let phi = linkage.section.place(linkage.rocker.displacement(q)).ok()?;
        let near = |end: &&super::DeadPoint| (end.phi - phi).abs() <= DEAD;
        let end = ends.iter().find(near)?;
        Some(OutOfReach {
            motor: self,
            quantity: Quantity::Joint(linkage.rocker.variable),
            value: q[linkage.rocker.variable],
            past: 0.0,
            bound: Past::DeadPoint(end.rest),
        })
    }
}

/// Roundings of a motor's value at its limit, per unit of the ratio: angles of a few turns.
const LIMIT_SLACK: f64 = 1e-12;

/// Nearer than this to a dead point a linkage has no ratio: half the digits of an angle are lost there.
const DEAD: f64 = 1e-8;

fn middle(linkage: &Linkage) -> f64 {
    let span = linkage.section.phi();
    f64::midpoint(span.lower, span.upper)
}
