//! `pieper info`

mod transmission;

use std::fmt::Write as _;

use clap::Args;
use pieper::describe::dh::{DhTable, Moves};
use pieper::describe::{Expr, Form, Robot};
use pieper::kinematics;
use pieper::model::{Chain, Variable};
use serde_json::{Value, json};

use crate::error::{Failure, Outcome};
use crate::source::Source;
use crate::{json, output, text};

/// Show a robot: table, frames at zero, limits, reach
#[derive(Args)]
#[command(after_help = "Example:\n  pieper info ar3")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// One JSON document
    #[arg(long)]
    json: bool,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let chain = match robot.chain() {
            Err(error) if error.is_missing_value() => None,
            chain => Some(chain?),
        };
        if self.json {
            output::document(&document(&robot, chain.as_ref())?)?;
        } else {
            output::answer(&description(&robot, chain.as_ref())?)?;
        }
        Ok(Outcome::Done)
    }
}

fn document(robot: &Robot, chain: Option<&Chain>) -> Result<Value, Failure> {
    let mut document = json!({
        "name": robot.name,
        "summary": robot.summary,
        "source": robot.source,
        "datasheet": robot.datasheet.iter().map(|(k, v)| (k.clone(), json!(v))).collect::<serde_json::Map<_, _>>(),
        "missing_parameters": robot.missing_parameters(),
    });
    if let Form::Dh(table) = &robot.form {
        document["convention"] = table.convention.name().into();
        document["table"] = table_rows(table)
            .iter()
            .map(|[theta, d, a, alpha]| json!({"theta": theta, "d": d, "a": a, "alpha": alpha}))
            .collect();
    }
    let Some(chain) = chain else {
        return Ok(document);
    };
    document["joints"] = chain.variables().iter().map(joint_document).collect();
    let zero = vec![0.0; chain.dof()];
    let mut frames = Vec::new();
    kinematics::link_poses(chain, &zero, &mut frames)?;
    let named = chain.joints().iter().zip(&frames);
    let named = named.map(|(joint, pose)| (joint.link.clone(), json::pose(pose)));
    document["frames_at_zero"] = Value::Object(named.collect());
    document["tool_at_zero"] = json::pose(&kinematics::tool_pose(chain, &zero)?);
    let reach = kinematics::reach(chain)?;
    let finite = |x: f64| x.is_finite().then_some(x);
    document["reach"] = json!({
        "from_first_axis": finite(reach.from_first_axis),
        "from_base": finite(reach.from_base),
        "at": reach.farthest,
    });
    document["family"] = super::ik::family_document(chain);
    if let Some(drives) = super::motors::of(robot)? {
        document["transmission"] = transmission::document(&drives)?;
    }
    Ok(document)
}

fn joint_document(variable: &Variable) -> Value {
    json!({
        "name": variable.name,
        "kind": format!("{:?}", variable.kind).to_lowercase(),
        "limits": variable.limits.map(|limits| [limits.lower(), limits.upper()]),
        "velocity": variable.velocity,
        "acceleration": variable.acceleration,
    })
}

fn description(robot: &Robot, chain: Option<&Chain>) -> Result<String, Failure> {
    let mut out = format!("{}\n", robot.name);
    if !robot.summary.is_empty() {
        let _ = writeln!(out, "{}", robot.summary);
    }
    match &robot.form {
        Form::Dh(table) => out.push_str(&table_text(table)),
        Form::Screws(table) => {
            let axis = |exprs: &[Expr; 3]| exprs.each_ref().map(ToString::to_string).join(", ");
            let rows = table
                .screws
                .iter()
                .map(|s| vec![s.joint.name.clone(), axis(&s.h), axis(&s.p)]);
            let head = ["joint", "axis h", "point p from the one before"]
                .map(str::to_owned)
                .to_vec();
            let _ = write!(
                out,
                "\nscrew axes\n{}",
                text::listing(&[vec![head], rows.collect()].concat())
            );
        }
        Form::Tree { tree, base, tip } => {
            let (base, tip) = (&tree.links()[*base].name, &tree.links()[*tip].name);
            let (links, joints) = (tree.links().len(), tree.variables().len());
            let _ = writeln!(
                out,
                "\nchain from {base} to {tip}, out of {links} links, {joints} of whose joints move"
            );
        }
    }
    if !robot.parameters.is_empty() {
        let value = |p: &pieper::describe::robot::Parameter| {
            p.value.as_ref().map_or("?".to_owned(), Expr::to_string)
        };
        let rows: Vec<_> = robot
            .parameters
            .iter()
            .map(|p| vec![p.name.clone(), "=".to_owned(), value(p)])
            .collect();
        let _ = write!(out, "\nparameters\n{}", text::listing(&rows));
    }
    match chain {
        Some(chain) => {
            out.push_str(&chain_text(chain)?);
            if let Some(drives) = super::motors::of(robot)? {
                out.push_str(&transmission::text(&drives)?);
            }
        }
        None => {
            let missing = robot.missing_parameters();
            let example: Vec<_> = missing
                .iter()
                .map(|name| format!("--set {name}=0.3"))
                .collect();
            let _ = writeln!(
                out,
                "\nfor numbers, give {}: {}",
                missing.join(", "),
                example.join(" ")
            );
        }
    }
    if !robot.datasheet.is_empty() {
        let rows: Vec<_> = robot
            .datasheet
            .iter()
            .map(|(k, v)| vec![k.clone(), v.clone()])
            .collect();
        let _ = write!(out, "\ndata sheet\n{}", text::listing(&rows));
    }
    if !robot.source.is_empty() {
        let _ = write!(out, "\nsource\n  {}\n", robot.source.replace('\n', "\n  "));
    }
    Ok(out)
}

/// The rows as written, the joint variable put back in.
pub(super) fn table_rows(table: &DhTable) -> Vec<[String; 4]> {
    let entry = |(index, row): (usize, &pieper::describe::dh::DhRow)| {
        let moving = row.moving_entry(index).to_string();
        let (theta, d) = match row.moves {
            Moves::Theta => (moving, row.d.to_string()),
            Moves::D => (row.theta.to_string(), moving),
        };
        [theta, d, row.a.to_string(), row.alpha.to_string()]
    };
    table.rows.iter().enumerate().map(entry).collect()
}

fn table_text(table: &DhTable) -> String {
    let mut rows = vec![
        ["row", "theta", "d", "a", "alpha"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for (index, row) in table_rows(table).into_iter().enumerate() {
        rows.push([(index + 1).to_string()].into_iter().chain(row).collect());
    }
    let convention = match table.convention {
        pieper::describe::Convention::Standard => "standard: Rz(theta) Tz(d) Tx(a) Rx(alpha)",
        pieper::describe::Convention::Modified => "modified: Rx(alpha) Tx(a) Rz(theta) Tz(d)",
    };
    format!(
        "\nDenavit-Hartenberg table, {convention}\n{}",
        text::table(&rows)
    )
}

fn chain_text(chain: &Chain) -> Result<String, Failure> {
    let mut rows = vec![
        ["joint", "kind", "lower", "upper", "unit"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for variable in chain.variables() {
        let angular = variable.kind.is_angular();
        let shown = |value: f64| {
            if angular {
                format!("{:.2}", value.to_degrees())
            } else {
                format!("{value:.4}")
            }
        };
        let limits = variable
            .limits
            .map_or(["-".to_owned(), "-".to_owned()], |limits| {
                [shown(limits.lower()), shown(limits.upper())]
            });
        let kind = format!("{:?}", variable.kind).to_lowercase();
        let unit = if angular { "deg" } else { "m" }.to_owned();
        rows.push(
            [
                vec![variable.name.clone(), kind],
                limits.to_vec(),
                vec![unit],
            ]
            .concat(),
        );
    }
    let mut out = format!("\njoints\n{}", text::table(&rows));
    let zero = vec![0.0; chain.dof()];
    let mut poses = Vec::new();
    kinematics::link_poses(chain, &zero, &mut poses)?;
    let head = ["frame", "x", "y", "z", "roll", "pitch", "yaw"]
        .map(str::to_owned)
        .to_vec();
    let mut rows = vec![head];
    let names = chain.joints().iter().map(|joint| joint.link.clone());
    let tool = ("tool".to_owned(), kinematics::tool_pose(chain, &zero)?);
    for (name, pose) in names.zip(poses).chain([tool]) {
        let position = pose.translation.vector.iter().map(|&x| text::number(x));
        let angles =
            pieper::spatial::to_rpy(&pose.rotation).map(|a| format!("{:.3}", a.to_degrees() + 0.0));
        rows.push([name].into_iter().chain(position).chain(angles).collect());
    }
    let _ = write!(
        out,
        "\nframes at zero joint values (m, deg)\n{}",
        text::table(&rows)
    );
    let reach = kinematics::reach(chain)?;
    let metres = |x: f64| {
        if x.is_finite() {
            format!("{x:.4} m")
        } else {
            "without end".to_owned()
        }
    };
    let _ = write!(
        out,
        "\nreach of the tool point\n  from the first axis  {}\n  from the base origin {}\n",
        metres(reach.from_first_axis),
        metres(reach.from_base)
    );
    out.push_str(&super::ik::family_text(chain));
    Ok(out)
}
