//! The transmission, for `pieper info`.

use std::fmt::Write as _;

use pieper::Result;
use pieper::transmission::{Linkage, Motor, Ratios, Span, Transmission};
use serde_json::{Value, json};

use crate::text;

/// One object for each motor.
pub(super) fn document(transmission: &Transmission) -> Result<Value> {
    let zero = vec![0.0; transmission.dof()];
    let ratios = ratios_at_zero(transmission)?;
    let motor = |(index, motor): (usize, &Motor)| {
        let by_joints = ratios.as_ref().map(|ratios| {
            let row = ratios.motors_by_joints().row(index);
            row.iter().copied().collect::<Vec<f64>>()
        });
        let mut document = json!({
            "name": motor.name(),
            "kind": motor.kind().name(),
            "ratio": motor.ratio(),
            "offset": motor.offset(),
            "limits": motor.limits().map(|limits| [limits.lower(), limits.upper()]),
            "by_joints_at_zero": by_joints,
        });
        if let Some(linkage) = motor.linkage() {
            document["four_bar"] = linkage_document(linkage);
        }
        document
    };
    let motors: Vec<Value> = transmission.all().iter().enumerate().map(motor).collect();
    let ranges: Result<Vec<Value>> = (0..transmission.dof())
        .map(|joint| Ok(json!(transmission.range(joint, &zero)?.map(ends))))
        .collect();
    Ok(json!({"motors": motors, "joint_ranges_at_zero": ranges?}))
}

/// JSON has no infinity: null for an end that is none.
fn ends(span: Span) -> [Option<f64>; 2] {
    [span.lower, span.upper].map(|end| end.is_finite().then_some(end))
}

fn linkage_document(linkage: &Linkage) -> Value {
    let four_bar = &linkage.four_bar;
    let lengths = four_bar.lengths();
    let dead_points = four_bar
        .dead_points()
        .into_iter()
        .map(|point| json!({"phi": point.phi, "psi": point.psi, "where": point.rest.in_line()}));
    json!({
        "crank": lengths.crank,
        "coupler": lengths.coupler,
        "rocker": lengths.rocker,
        "frame": lengths.frame,
        "assembly": four_bar.assembly().name(),
        "psi0": four_bar.psi0(),
        "reach": four_bar.reach().into_iter().map(ends).collect::<Vec<_>>(),
        "dead_points": dead_points.collect::<Vec<_>>(),
        "works": {"phi": ends(linkage.section.phi()), "psi": ends(linkage.section.psi())},
        "ratio_at_zero": four_bar.ratio(linkage.rocker.offset).filter(|ratio| ratio.is_finite()),
    })
}

fn ratios_at_zero(transmission: &Transmission) -> Result<Option<Ratios>> {
    let mut ratios = Ratios::zeros(transmission.dof());
    let zero = vec![0.0; transmission.dof()];
    let answer = transmission.ratios(&zero, &mut ratios)?;
    Ok(answer.is_ok().then_some(ratios))
}

/// For a person: angles in degrees.
pub(super) fn text(transmission: &Transmission) -> Result<String> {
    let head = ["motor", "kind", "value", "limits (deg)"].map(str::to_owned);
    let mut rows = vec![head.to_vec()];
    for motor in transmission.all() {
        let limits = motor.limits().map_or("-".to_owned(), |limits| {
            let [lower, upper] = [limits.lower(), limits.upper()].map(f64::to_degrees);
            format!("{lower:.2} to {upper:.2}")
        });
        rows.push(vec![
            motor.name().to_owned(),
            motor.kind().name().to_owned(),
            equation(motor),
            limits,
        ]);
    }
    let mut out = format!("\ntransmission (angles in deg)\n{}", text::listing(&rows));
    for motor in transmission.all() {
        if let Some(linkage) = motor.linkage() {
            out.push_str(&linkage_text(motor.name(), linkage));
        }
    }
    let zero = vec![0.0; transmission.dof()];
    let mut rows = Vec::new();
    for joint in 0..transmission.dof() {
        let name = format!("q{}", joint + 1);
        match transmission.range(joint, &zero)? {
            Some(span) if span.lower.is_finite() || span.upper.is_finite() => {
                rows.push(vec![name, degrees(span)]);
            }
            Some(_) => {}
            None => rows.push(vec![name, "nowhere".to_owned()]),
        }
    }
    if !rows.is_empty() {
        let _ = write!(
            out,
            "\nwhat the drives leave each joint while the others stand at zero (deg)\n{}",
            text::listing(&rows)
        );
    }
    Ok(out)
}

fn degrees(span: Span) -> String {
    format!(
        "{:.2} to {:.2}",
        span.lower.to_degrees(),
        span.upper.to_degrees()
    )
}

/// The motor's value by the joints, as a formula.
fn equation(motor: &Motor) -> String {
    let mut sum = Sum(String::new());
    let ratio = motor.ratio();
    // A gear of one term, or of 1, needs no brackets.
    let inner = match ratio == 1.0 || (motor.terms().len() == 1 && motor.linkage().is_none()) {
        true => ratio,
        false => 1.0,
    };
    for term in motor.terms() {
        sum.add(inner * term.factor, &format!("q{}", term.variable + 1));
    }
    if motor.linkage().is_some() {
        sum.add(inner, "psi");
    }
    if inner != ratio {
        let inside = std::mem::take(&mut sum.0);
        sum.add(ratio, &format!("({inside})"));
    }
    let offsets: f64 = motor.terms().iter().map(|term| term.offset).sum();
    let constant = ratio.mul_add(offsets, motor.offset());
    sum.add(constant.to_degrees(), "");
    sum.0
}

/// A sum as one writes it.
struct Sum(String);

impl Sum {
    /// Adds `factor * symbol`, or the number alone if there is no symbol.
    fn add(&mut self, factor: f64, symbol: &str) {
        if factor == 0.0 {
            return;
        }
        let sign = match (self.0.is_empty(), factor < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        self.0.push_str(sign);
        let size = clean(factor.abs());
        let _ = match (size == 1.0, symbol.is_empty()) {
            (true, false) => write!(self.0, "{symbol}"),
            (_, true) => write!(self.0, "{size}"),
            (false, false) => write!(self.0, "{size}*{symbol}"),
        };
    }
}

/// Ten decimals: the dust of a conversion to degrees or from millimetres is not shown.
fn clean(value: f64) -> f64 {
    (value * 1e10).round() / 1e10
}

fn linkage_text(name: &str, linkage: &Linkage) -> String {
    let four_bar = &linkage.four_bar;
    let lengths = four_bar.lengths();
    let mut phi = Sum(String::new());
    phi.add(
        linkage.rocker.factor,
        &format!("q{}", linkage.rocker.variable + 1),
    );
    phi.add(linkage.rocker.offset.to_degrees(), "");
    let mut out = format!(
        "\nfour-bar of {name}, {}: crank {}, coupler {}, rocker {}, frame {}\n",
        four_bar.assembly().name(),
        clean(lengths.crank),
        clean(lengths.coupler),
        clean(lengths.rocker),
        clean(lengths.frame)
    );
    let reach: Vec<String> = four_bar.reach().into_iter().map(degrees).collect();
    let mut rows = vec![
        vec!["rocker's angle phi".to_owned(), phi.0],
        vec!["can be assembled for phi".to_owned(), reach.join(", ")],
        vec!["works for phi".to_owned(), degrees(linkage.section.phi())],
        vec!["  and for psi".to_owned(), degrees(linkage.section.psi())],
    ];
    for point in four_bar.dead_points() {
        let [phi, psi] = [point.phi, point.psi].map(f64::to_degrees);
        let what = point.rest.in_line();
        rows.push(vec![
            "dead point".to_owned(),
            format!("phi {phi:.2}, psi {psi:.2}: {what}"),
        ]);
    }
    if let Some(ratio) = four_bar.ratio(linkage.rocker.offset) {
        let joint = linkage.rocker.variable + 1;
        rows.push(vec![
            format!("ratio dpsi/dphi at q{joint} = 0"),
            format!("{ratio:.6}"),
        ]);
    }
    out.push_str(&text::listing(&rows));
    out
}
