//! Numbers of an arm that may be wrong, and which of them are looked for.

use crate::error::{Error, Result};

/// What kind of number a parameter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Joint offsets.
    Theta,
    /// Shifts along the joint axes.
    D,
    /// Lengths of links.
    A,
    /// Twists of links.
    Alpha,
    /// Hayati's turn about y, between nearly parallel axes.
    Beta,
    /// Turns of the joint for one of its value.
    Gear,
    /// Of what drives the joints: gears, couplings, four-bar lengths, servo windows.
    Drive,
    /// The arm's place in the measuring device's frame.
    Base,
    /// The tool in the last frame.
    Tool,
    /// Of the measurement: the place of an anchor, a plane, a contact.
    Set,
}

/// Which groups are estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "as in Group")]
pub struct Groups {
    pub theta: bool,
    pub d: bool,
    pub a: bool,
    pub alpha: bool,
    pub beta: bool,
    pub gear: bool,
    pub drive: bool,
    pub base: bool,
    pub tool: bool,
}

impl Groups {
    /// None.
    pub const NONE: Self = Self {
        theta: false,
        d: false,
        a: false,
        alpha: false,
        beta: false,
        gear: false,
        drive: false,
        base: false,
        tool: false,
    };

    /// The table, the base and the tool; not the gears.
    pub const USUAL: Self = Self {
        theta: true,
        d: true,
        a: true,
        alpha: true,
        beta: true,
        gear: false,
        drive: false,
        base: true,
        tool: true,
    };

    /// By names separated by commas: theta, d, a, alpha, beta, gear, drive, base, tool.
    ///
    /// # Errors
    /// An input error that names the word and the choices.
    pub fn parse(text: &str) -> Result<Self> {
        let mut groups = Self::NONE;
        for word in text
            .split(',')
            .map(str::trim)
            .filter(|word| !word.is_empty())
        {
            let flag = match word {
                "theta" => &mut groups.theta,
                "d" => &mut groups.d,
                "a" => &mut groups.a,
                "alpha" => &mut groups.alpha,
                "beta" => &mut groups.beta,
                "gear" => &mut groups.gear,
                "drive" => &mut groups.drive,
                "base" => &mut groups.base,
                "tool" => &mut groups.tool,
                _ => {
                    let text = "theta, d, a, alpha, beta, gear, drive, base or tool was expected";
                    return Err(Error::input(format!("parameters: {word}"), text));
                }
            };
            *flag = true;
        }
        Ok(groups)
    }

    pub(super) fn has(self, group: Group) -> bool {
        match group {
            Group::Theta => self.theta,
            Group::D => self.d,
            Group::A => self.a,
            Group::Alpha => self.alpha,
            Group::Beta => self.beta,
            Group::Gear => self.gear,
            Group::Drive => self.drive,
            Group::Base => self.base,
            Group::Tool => self.tool,
            Group::Set => true,
        }
    }
}

/// What a number measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Radians.
    Angle,
    /// Metres.
    Length,
    /// One for one.
    Ratio,
}

/// A number that may be wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// `theta1`, `d1`, `a1`, `alpha1`, `beta1`, `gear1`, `base.x`, `tool.roll`, `m3.crank`, ...
    pub name: String,
    /// Its kind.
    pub group: Group,
    /// What it measures.
    pub unit: Unit,
    /// The description's value.
    pub nominal: f64,
    /// How far from it the true value may be: the scale in which parameters are compared.
    pub spread: f64,
}
