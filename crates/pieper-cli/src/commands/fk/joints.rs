//! Joint values as people and programs give them.

use pieper::describe::{Form, Robot};
use pieper::model::{Chain, Tree};
use pieper::transmission::Transmission;
use serde_json::Value;

use crate::batch::shown;
use crate::commands::motors;
use crate::error::Failure;

/// Values for the chain, and for the whole tree if the robot has one.
pub(super) struct Joints {
    /// One for each variable of the chain.
    pub(super) chain: Vec<f64>,
    /// One for each variable of the tree; joints off the chain stand at zero unless they were given.
    pub(super) tree: Vec<f64>,
}

/// From `--q`: numbers separated by commas or spaces.
pub(super) fn from_text(
    robot: &Robot,
    chain: &Chain,
    text: &str,
    deg: bool,
) -> Result<Joints, Failure> {
    let values = numbers("--q", text)?;
    from_list(robot, chain, values, deg).map_err(|text| Failure::input(format!("--q: {text}")))
}

/// From `--motors`: the joint values, or why no joint values belong to them.
pub(super) fn from_motor_text(
    robot: &Robot,
    chain: &Chain,
    text: &str,
    deg: bool,
) -> Result<Result<Joints, String>, Failure> {
    let values = numbers("--motors", text)?;
    let joints = from_motors(robot, chain, &robot.transmission()?, values, deg);
    joints.map_err(|text| Failure::input(format!("--motors: {text}")))
}

/// From a request's `motors`: as [`from_motor_text`].
pub(super) fn from_motor_json(
    robot: &Robot,
    chain: &Chain,
    drives: Option<&Transmission>,
    motors: &Value,
    deg: bool,
) -> Result<Joints, String> {
    let list = motors
        .as_array()
        .and_then(|list| list.iter().map(Value::as_f64).collect());
    let values: Vec<f64> = list.ok_or_else(|| {
        format!(
            "\"motors\" = {}: a list of numbers was expected",
            shown(motors)
        )
    })?;
    match drives {
        None => from_list(robot, chain, values, deg),
        Some(drives) => from_motors(robot, chain, drives, values, deg)?,
    }
    .map_err(|text| format!("\"motors\": {text}"))
}

fn from_motors(
    robot: &Robot,
    chain: &Chain,
    drives: &Transmission,
    mut values: Vec<f64>,
    deg: bool,
) -> Result<Result<Joints, String>, String> {
    for (index, value) in values.iter_mut().enumerate() {
        if deg && motors::is_angle(drives, index) {
            *value = value.to_radians();
        }
    }
    let mut q = vec![0.0; chain.dof()];
    let found = drives.joints(&values, &mut q);
    match found.map_err(|error| error.to_string())? {
        Ok(()) => from_list(robot, chain, q, false).map(Ok),
        Err(answer) => Ok(Err(answer.to_string())),
    }
}

/// Numbers separated by commas or spaces.
fn numbers(flag: &str, text: &str) -> Result<Vec<f64>, Failure> {
    let parts = text
        .split([',', ' '])
        .map(str::trim)
        .filter(|part| !part.is_empty());
    let mut values = Vec::new();
    for part in parts {
        let value = part.parse::<f64>().ok().filter(|value| value.is_finite());
        let text = || Failure::input(format!("{flag}: {part:?}: a finite number was expected"));
        values.push(value.ok_or_else(text)?);
    }
    Ok(values)
}

/// From a request's `q`: a list, or an object of joint names.
pub(super) fn from_json(
    robot: &Robot,
    chain: &Chain,
    q: &Value,
    deg: bool,
) -> Result<Joints, String> {
    match q {
        Value::Array(list) => {
            let number = |value: &Value| {
                value
                    .as_f64()
                    .ok_or_else(|| format!("\"q\": {}: a number was expected", shown(value)))
            };
            from_list(
                robot,
                chain,
                list.iter().map(number).collect::<Result<_, _>>()?,
                deg,
            )
        }
        Value::Object(named) => {
            let pairs = named.iter().map(|(name, value)| match value.as_f64() {
                Some(number) => Ok((name.as_str(), number)),
                None => Err(format!(
                    "\"q\": {name} = {}: a number was expected",
                    shown(value)
                )),
            });
            from_names(robot, chain, pairs.collect::<Result<_, _>>()?, deg)
        }
        other => Err(format!(
            "\"q\" = {}: a list or an object of joint names was expected",
            shown(other)
        )),
    }
}

fn tree_of(robot: &Robot) -> Option<&Tree> {
    match &robot.form {
        Form::Tree { tree, .. } => Some(tree),
        _ => None,
    }
}

fn from_list(
    robot: &Robot,
    chain: &Chain,
    mut values: Vec<f64>,
    deg: bool,
) -> Result<Joints, String> {
    let Some(tree) = tree_of(robot) else {
        to_radians(&mut values, chain.variables(), deg);
        chain
            .check_joint_values(&values)
            .map_err(|error| error.to_string())?;
        return Ok(Joints {
            chain: values,
            tree: Vec::new(),
        });
    };
    if values.len() == tree.variables().len() && values.len() != chain.dof() {
        to_radians(&mut values, tree.variables(), deg);
        return Ok(Joints {
            chain: chain_part(tree, chain, &values),
            tree: values,
        });
    }
    to_radians(&mut values, chain.variables(), deg);
    chain
        .check_joint_values(&values)
        .map_err(|error| error.to_string())?;
    let mut whole = vec![0.0; tree.variables().len()];
    for (variable, &value) in chain.variables().iter().zip(&values) {
        if let Some(index) = tree
            .variables()
            .iter()
            .position(|v| v.name == variable.name)
        {
            whole[index] = value;
        }
    }
    Ok(Joints {
        chain: values,
        tree: whole,
    })
}

fn chain_part(tree: &Tree, chain: &Chain, whole: &[f64]) -> Vec<f64> {
    let value = |name: &str| {
        tree.variables()
            .iter()
            .position(|v| v.name == name)
            .map_or(0.0, |i| whole[i])
    };
    chain
        .variables()
        .iter()
        .map(|variable| value(&variable.name))
        .collect()
}

fn to_radians(values: &mut [f64], variables: &[pieper::model::Variable], deg: bool) {
    for (value, variable) in values.iter_mut().zip(variables) {
        if deg && variable.kind.is_angular() {
            *value = value.to_radians();
        }
    }
}

/// By name: every joint of the chain, and for trees any other joint. `q1`..`qn` name a table's joints as well.
fn from_names(
    robot: &Robot,
    chain: &Chain,
    named: Vec<(&str, f64)>,
    deg: bool,
) -> Result<Joints, String> {
    let tree = tree_of(robot);
    let variables = tree.map_or(chain.variables(), Tree::variables);
    let mut values: Vec<Option<f64>> = vec![None; variables.len()];
    for (name, value) in named {
        let by_name = variables.iter().position(|variable| variable.name == name);
        let by_number = || {
            name.strip_prefix('q')?
                .parse::<usize>()
                .ok()?
                .checked_sub(1)
        };
        match by_name
            .or_else(by_number)
            .filter(|index| *index < variables.len())
        {
            Some(index) => values[index] = Some(value),
            None if tree
                .is_some_and(|tree| tree.joints().iter().any(|joint| joint.name == name)) => {}
            None => {
                let names: Vec<_> = variables
                    .iter()
                    .map(|variable| variable.name.as_str())
                    .collect();
                return Err(format!(
                    "\"q\": {name} is no joint; the joints are {}",
                    names.join(", ")
                ));
            }
        }
    }
    let is_missing = |variable: &&pieper::model::Variable| {
        let index = variables.iter().position(|v| v.name == variable.name);
        index.is_none_or(|index| values[index].is_none())
    };
    if let Some(missing) = chain.variables().iter().find(is_missing) {
        return Err(format!("\"q\": a value of {} was expected", missing.name));
    }
    let mut whole: Vec<f64> = values.iter().map(|value| value.unwrap_or(0.0)).collect();
    to_radians(&mut whole, variables, deg);
    match tree {
        Some(tree) => Ok(Joints {
            chain: chain_part(tree, chain, &whole),
            tree: whole,
        }),
        None => Ok(Joints {
            chain: whole,
            tree: Vec::new(),
        }),
    }
}
