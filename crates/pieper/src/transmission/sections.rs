//! Where a four-bar linkage can stand, its dead points, and the stretches between them.

use std::f64::consts::{PI, TAU};

use super::four_bar::{FourBar, Lengths, side, wrapped};

/// A closed range of angles; infinite ends where there is no end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The lower end.
    pub lower: f64,
    /// The upper end.
    pub upper: f64,
}

/// What comes to rest at a dead point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rest {
    /// Crank and coupler are in line: the rocker is at the end of its reach, dpsi/dphi is infinite.
    Rocker,
    /// Coupler and rocker are in line: the crank is at the end of its reach, dpsi/dphi is zero.
    Crank,
}

impl Rest {
    /// The two bars that are in line there, in words.
    pub fn in_line(self) -> &'static str {
        match self {
            Self::Rocker => "crank and coupler are in line",
            Self::Crank => "coupler and rocker are in line",
        }
    }
}

/// A dead point: two bars in line, one end of the linkage at rest while the other moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeadPoint {
    /// The rocker's angle.
    pub phi: f64,
    /// The crank's angle.
    pub psi: f64,
    /// What rests.
    pub rest: Rest,
}

/// A stretch of a linkage between two dead points: phi and psi belong to each other one to one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    linkage: FourBar,
    /// The ends by phi; `None` if rocker and crank both turn round without a dead point.
    ends: Option<[DeadPoint; 2]>,
    /// The side of DB on which C stands.
    side: f64,
}

/// How near, as a sine, the end of a reach may come to a right angle and still mean it: a parallelogram's lengths, rounded,
/// make a change point there and no way past it.
const CHANGE_POINT: f64 = 1e-12;

/// An angle past a section's end by less than this is at the end: the roundings of a sum of angles.
const SLACK: f64 = 1e-12;

impl Section {
    /// The ends in the order of phi; `None` if rocker and crank both turn round.
    pub fn ends(&self) -> Option<[DeadPoint; 2]> {
        self.ends
    }

    /// The rocker's range.
    pub fn phi(&self) -> Span {
        match self.ends {
            None => Span::EVERYWHERE,
            Some([lower, upper]) => Span {
                lower: lower.phi,
                upper: upper.phi,
            },
        }
    }

    /// The crank's range.
    pub fn psi(&self) -> Span {
        match self.ends {
            None => Span::EVERYWHERE,
            Some([one, other]) => Span {
                lower: one.psi.min(other.psi),
                upper: one.psi.max(other.psi),
            },
        }
    }

    /// The copy of the rocker's angle by whole turns that lies in the section; otherwise the end it misses least.
    ///
    /// # Errors
    /// The dead point, and by how much the angle lies past it.
    pub fn place(&self, phi: f64) -> Result<f64, (DeadPoint, f64)> {
        let Some([lower, upper]) = self.ends else {
            return Ok(phi);
        };
        let middle = f64::midpoint(lower.phi, upper.phi);
        let copy = match phi >= lower.phi && phi <= upper.phi {
            true => phi,
            false => phi + TAU * ((middle - phi) / TAU).round(),
        };
        if copy < lower.phi - SLACK {
            Err((lower, lower.phi - copy))
        } else if copy > upper.phi + SLACK {
            Err((upper, copy - upper.phi))
        } else {
            Ok(copy.clamp(lower.phi, upper.phi))
        }
    }

    /// The crank's angle at the rocker's.
    ///
    /// # Errors
    /// As [`Section::place`].
    pub fn crank_angle(&self, phi: f64) -> Result<f64, (DeadPoint, f64)> {
        let phi = self.place(phi)?;
        match self.ends {
            Some([lower, _]) if phi == lower.phi => Ok(lower.psi),
            Some([_, upper]) if phi == upper.phi => Ok(upper.psi),
            _ => Ok(self.linkage.crank_angle(phi).unwrap_or(f64::NAN)),
        }
    }

    /// The rocker's angle at the crank's.
    ///
    /// # Errors
    /// The dead point, and by how much the crank's angle lies past it.
    pub fn rocker_angle(&self, psi: f64) -> Result<f64, (DeadPoint, f64)> {
        let Some(ends) = self.ends else {
            return Ok(self.turning_rocker_angle(psi));
        };
        let [low, high] = match ends[0].psi <= ends[1].psi {
            true => ends,
            false => [ends[1], ends[0]],
        };
        if psi < low.psi - SLACK {
            return Err((low, low.psi - psi));
        }
        if psi > high.psi + SLACK {
            return Err((high, psi - high.psi));
        }
        let psi = psi.clamp(low.psi, high.psi);
        if psi == low.psi {
            return Ok(low.phi);
        }
        if psi == high.psi {
            return Ok(high.phi);
        }
        let [lower, upper] = ends.map(|end| end.phi);
        let nearest_end = if psi - low.psi < high.psi - psi {
            low
        } else {
            high
        };
        let phi = self.linkage.rocker_angle(psi, self.side);
        let phi = phi.unwrap_or(nearest_end.phi);
        let middle = f64::midpoint(lower, upper);
        let copy = phi + TAU * ((middle - phi) / TAU).round();
        Ok(copy.clamp(lower, upper))
    }

    /// Where both ends turn round, a turn of one is a turn of the other.
    fn turning_rocker_angle(&self, psi: f64) -> f64 {
        let phi = self.linkage.rocker_angle(psi, self.side);
        let phi = phi.unwrap_or(f64::NAN);
        let psi_at = |phi| self.linkage.crank_angle(phi).unwrap_or(f64::NAN);
        let turn = (psi_at(phi + TAU) - psi_at(phi)).signum();
        phi + turn * TAU * ((psi - psi_at(phi)) / TAU).round()
    }
}

impl Span {
    pub(super) const EVERYWHERE: Self = Self {
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
    };

    /// Whether the angle lies in the span, ends included.
    pub fn contains(&self, angle: f64) -> bool {
        (self.lower..=self.upper).contains(&angle)
    }
}

/// AC lies between |crank - coupler| and crank + coupler: two bounds of sin phi.
pub(super) fn reach(linkage: &FourBar) -> Vec<Span> {
    let Lengths {
        crank,
        coupler,
        rocker,
        frame,
    } = linkage.lengths();
    // (AC^2 - frame^2 - rocker^2) / (2 frame rocker), with the squares' differences in factors.
    let sine = |ac: f64| {
        let near = (ac - frame + rocker) * (ac + frame - rocker);
        near / (2.0 * frame * rocker) - 1.0
    };
    let (low, high) = (sine((crank - coupler).abs()), sine(crank + coupler));
    let bounded = |sine: f64| sine > -1.0 - CHANGE_POINT && sine < 1.0 + CHANGE_POINT;
    let ends = (
        bounded(low).then(|| low.clamp(-1.0, 1.0).asin()),
        bounded(high).then(|| high.clamp(-1.0, 1.0).asin()),
    );
    let span = |lower, upper| Span { lower, upper };
    match ends {
        (None, None) => vec![Span::EVERYWHERE],
        (Some(low), None) => vec![span(low, PI - low)],
        (None, Some(high)) => vec![span(-PI - high, high)],
        (Some(low), Some(high)) => vec![span(low, high), span(PI - high, PI - low)],
    }
}

pub(super) fn dead_points(linkage: &FourBar) -> Vec<DeadPoint> {
    let spans = linkage.reach();
    let mut found = Vec::new();
    for span in &spans {
        if span.lower.is_finite() {
            found.push(rocker_rest(linkage, span.lower));
            found.push(rocker_rest(linkage, span.upper));
        }
    }
    found.extend(crank_rests(linkage, &spans));
    found.sort_by(|a, b| a.phi.total_cmp(&b.phi));
    found
}

/// Crank and coupler in line, to the end of the reach at phi: beta1 is 0 or pi exactly.
fn rocker_rest(linkage: &FourBar, phi: f64) -> DeadPoint {
    let Lengths { crank, coupler, .. } = linkage.lengths();
    let [x, y] = linkage.c(phi);
    let stretched = x.hypot(y) > f64::midpoint((crank - coupler).abs(), crank + coupler);
    let beta1 = match (stretched || crank > coupler, linkage.is_open()) {
        (true, _) => 0.0,
        (false, true) => PI,
        (false, false) => -PI,
    };
    let theta = linkage.beta2(phi) + beta1;
    let near = linkage
        .crank_angle(phi)
        .unwrap_or(linkage.psi_near(theta, 0.0));
    DeadPoint {
        phi,
        psi: linkage.psi_near(theta, near),
        rest: Rest::Rocker,
    }
}

/// Coupler and rocker in line: BD is |rocker - coupler| or rocker + coupler, by which theta and then C are known.
fn crank_rests(linkage: &FourBar, spans: &[Span]) -> Vec<DeadPoint> {
    let Lengths {
        crank,
        coupler,
        rocker,
        frame,
    } = linkage.lengths();
    let mut found = Vec::new();
    // C lies from D towards B, except where the coupler reaches across D.
    let folded = if coupler > rocker { -1.0 } else { 1.0 };
    for (bd, towards) in [((rocker - coupler).abs(), folded), (rocker + coupler, 1.0)] {
        let cosine = 1.0 - (bd - crank + frame) * (bd + crank - frame) / (2.0 * crank * frame);
        // At exactly +-1 all bars are in line: a change point, which ends the reach already.
        if cosine.abs() >= 1.0 - CHANGE_POINT {
            continue;
        }
        for theta in [cosine.acos(), -cosine.acos()] {
            let b = [crank * theta.cos(), crank * theta.sin()];
            let direction = [towards * (b[0] - frame), towards * b[1]];
            let phi = wrapped(direction[0].atan2(direction[1]));
            let is_open = side([0.0, 0.0], linkage.c(phi), b) > 0.0;
            if is_open != linkage.is_open() {
                continue;
            }
            let copies = [phi, phi + TAU, phi - TAU];
            let inside = |phi: &f64| spans.iter().any(|span| span.contains(*phi));
            let Some(phi) = copies.into_iter().find(inside) else {
                continue;
            };
            let near = linkage.crank_angle(phi).unwrap_or(0.0);
            found.push(DeadPoint {
                phi,
                psi: linkage.psi_near(theta, near),
                rest: Rest::Crank,
            });
        }
    }
    found
}

pub(super) fn at(linkage: &FourBar, phi: f64) -> Option<Section> {
    if !phi.is_finite() {
        return None;
    }
    let points = linkage.dead_points();
    let ends = match linkage.reach()[0].lower.is_finite() {
        true => bounded_ends(linkage, &points, phi)?.into(),
        false => round_ends(linkage, &points, phi),
    };
    let middle = ends.map_or(phi, |[lower, upper]: [DeadPoint; 2]| {
        f64::midpoint(lower.phi, upper.phi)
    });
    Some(Section {
        linkage: *linkage,
        ends,
        side: linkage.side(middle)?,
    })
}

/// The ends around phi, by whole turns, of a rocker that does not turn round.
fn bounded_ends(linkage: &FourBar, points: &[DeadPoint], phi: f64) -> Option<[DeadPoint; 2]> {
    let phi = wrapped(phi);
    for span in linkage.reach() {
        for copy in [phi, phi + TAU, phi - TAU] {
            if copy < span.lower - SLACK || copy > span.upper + SLACK {
                continue;
            }
            let copy = copy.clamp(span.lower, span.upper);
            let inside: Vec<DeadPoint> = points
                .iter()
                .filter(|point| span.contains(point.phi))
                .copied()
                .collect();
            let pair = inside.windows(2).find(|pair| copy <= pair[1].phi)?;
            return Some([pair[0], pair[1]]);
        }
    }
    None
}

/// The ends around phi of a rocker that turns round; `None` if the crank does so too.
fn round_ends(linkage: &FourBar, points: &[DeadPoint], phi: f64) -> Option<[DeadPoint; 2]> {
    let phi = wrapped(phi);
    let copy = |point: &DeadPoint, turns: f64| {
        let phi = point.phi + turns * TAU;
        let psi = linkage.crank_angle(phi).unwrap_or(point.psi);
        DeadPoint { phi, psi, ..*point }
    };
    let (first, last) = (points.first()?, points.last()?);
    let after = points.iter().find(|point| point.phi >= phi);
    let before = points.iter().rfind(|point| point.phi < phi);
    Some([
        before.copied().unwrap_or_else(|| copy(last, -1.0)),
        after.copied().unwrap_or_else(|| copy(first, 1.0)),
    ])
}
