//! One arm's links, joints and tool, the far ones first.

use std::f64::consts::TAU;

use super::{Arm, JointKind};
use crate::axes::SMALL;
use crate::ink::Ink;
use crate::scene::{Point, Scene, Stroke, Text};
use crate::view::{Lens, Vec3, add, cross, dot, norm, unit};

/// The length of the tool's axes in radii of a joint.
pub(super) const TOOL: f64 = 5.5;

/// Something to draw, and how near the eye it is.
enum Part {
    Link(Vec3, Vec3),
    Joint(Vec3, Vec3, JointKind),
}

pub(super) fn draw(scene: &mut Scene, lens: &Lens, arm: &Arm, radius: f64) {
    let up = [0.0, 0.0, 1.0];
    let base = arm.points[0];
    prism(
        scene,
        lens,
        &Prism::new(
            add(base, up, 0.15 * radius),
            up,
            2.2 * radius,
            0.15 * radius,
            40,
        ),
        [Ink::Link, Ink::Link],
    );
    let mut parts: Vec<(f64, Part)> = Vec::new();
    for (index, ends) in arm.points.windows(2).enumerate() {
        let along = add(ends[1], ends[0], -1.0);
        // The first link stands on the base plate: its round end must not hang below it.
        let lift = if index == 0 {
            (0.8 * radius / norm(along).max(1e-12)).min(0.5)
        } else {
            0.0
        };
        let link = Part::Link(add(ends[0], along, lift), ends[1]);
        parts.push((lens.camera.depth(add(ends[0], along, 0.5)), link));
    }
    for (index, joint) in arm.joints.iter().enumerate() {
        let Some(axis) = unit(joint.axis) else {
            continue;
        };
        let at = place(arm, index, axis, radius);
        // A joint is thicker than the links that meet in it, so it covers their ends.
        let links = arm
            .points
            .windows(2)
            .filter(|ends| touches(ends, at, radius));
        let depth = links
            .map(|ends| {
                lens.camera
                    .depth(add(ends[0], add(ends[1], ends[0], -1.0), 0.5))
            })
            .fold(lens.camera.depth(at), f64::max);
        parts.push((depth + 1e-3 * radius, Part::Joint(at, axis, joint.kind)));
    }
    parts.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, part) in parts {
        match part {
            Part::Link(from, to) => link(scene, lens, from, to, radius),
            Part::Joint(at, axis, JointKind::Revolute) => {
                let form = Prism::new(at, axis, radius, 1.25 * radius, 28);
                prism(scene, lens, &form, [Ink::Joint, Ink::Cap]);
            }
            Part::Joint(at, axis, JointKind::Prismatic) => {
                let form = Prism::new(at, axis, 1.3 * radius, 1.8 * radius, 4);
                prism(scene, lens, &form, [Ink::Slider, Ink::SliderCap]);
            }
        }
    }
    tool(scene, lens, arm, radius);
}

/// Where a joint is drawn: joints that share a place move along the link they turn or slide, one
/// behind the other, and the first joint stands on the base plate, not in it.
fn place(arm: &Arm, index: usize, axis: Vec3, radius: f64) -> Vec3 {
    let at = arm.joints[index].at;
    let same = |point: &Vec3| norm(add(*point, at, -1.0)) < 0.5 * radius;
    let Some(link) = arm
        .points
        .iter()
        .rposition(same)
        .and_then(|corner| arm.points.get(corner + 1))
        .map(|next| add(*next, at, -1.0))
    else {
        return at;
    };
    let runs_along = |axis: Vec3| match (unit(axis), unit(link)) {
        (Some(axis), Some(link)) => dot(axis, link).abs() > 0.99,
        _ => false,
    };
    if !runs_along(axis) {
        return at;
    }
    let here = || {
        arm.joints
            .iter()
            .enumerate()
            .filter(|(_, other)| same(&other.at))
    };
    let moved = || here().filter(|(_, other)| runs_along(other.axis));
    let rank = moved().filter(|(other, _)| *other < index).count() as f64;
    // Joints that stay keep the corner to themselves.
    let free: f64 = if here().count() > moved().count() {
        3.2
    } else {
        0.0
    };
    let stand = if same(&arm.points[0]) { 1.5 } else { 0.0 };
    let share = (free.max(stand) + 3.2 * rank) * radius / norm(link);
    let most = (rank + 1.0) / (moved().count() as f64 + 1.0);
    add(at, link, share.min(most))
}

fn touches(ends: &[Vec3], at: Vec3, radius: f64) -> bool {
    let along = add(ends[1], ends[0], -1.0);
    let length = norm(along).max(1e-12);
    let share = (dot(along, add(at, ends[0], -1.0)) / (length * length)).clamp(0.0, 1.0);
    norm(add(at, add(ends[0], along, share), -1.0)) < radius
}

fn link(scene: &mut Scene, lens: &Lens, from: Vec3, to: Vec3, radius: f64) {
    let line = vec![lens.at(from), lens.at(to)];
    let width = 1.15 * radius * lens.scale;
    scene.polyline(line.clone(), Stroke::solid(Ink::Edge, width + 1.8));
    scene.polyline(line, Stroke::solid(Ink::Link, width));
}

/// A cylinder (of many sides) or a box (of four).
struct Prism {
    near: Vec<Vec3>,
    far: Vec<Vec3>,
}

impl Prism {
    fn new(at: Vec3, axis: Vec3, radius: f64, half: f64, sides: u32) -> Self {
        let helper = if axis[2].abs() < 0.9 {
            [0.0, 0.0, 1.0]
        } else {
            [1.0, 0.0, 0.0]
        };
        let across = unit(cross(axis, helper)).unwrap_or([1.0, 0.0, 0.0]);
        let other = cross(axis, across);
        let ring = |end: f64| {
            let center = add(at, axis, end);
            let corner = |k: u32| {
                let (sin, cos) = (TAU * (f64::from(k) + 0.5) / f64::from(sides)).sin_cos();
                add(add(center, across, radius * cos), other, radius * sin)
            };
            (0..sides).map(corner).collect()
        };
        Self {
            near: ring(half),
            far: ring(-half),
        }
    }
}

fn prism(scene: &mut Scene, lens: &Lens, prism: &Prism, [side, cap]: [Ink; 2]) {
    let depth = |ring: &[Vec3]| ring.iter().map(|&p| lens.camera.depth(p)).sum::<f64>();
    let [near, far] = if depth(&prism.near) >= depth(&prism.far) {
        [&prism.near, &prism.far]
    } else {
        [&prism.far, &prism.near]
    };
    let edge = Some(Stroke::solid(Ink::Edge, 0.9));
    let mut all = lens.line(near);
    all.extend(lens.line(far));
    scene.polygon(hull(all), side, edge);
    scene.polygon(lens.line(near), cap, edge);
}

/// The convex hull, by Andrew's monotone chain.
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let half = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..]
                && (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) <= 0.0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut lower = half(&mut points.iter().copied());
    lower.extend(half(&mut points.iter().rev().copied()));
    lower
}

/// The tool's axes, the far ones first.
fn tool(scene: &mut Scene, lens: &Lens, arm: &Arm, radius: f64) {
    let frame = &arm.tool;
    let inks = [Ink::ToolX, Ink::ToolY, Ink::ToolZ];
    let mut axes: Vec<(Vec3, Ink, &str)> = frame
        .axes
        .into_iter()
        .zip(inks)
        .zip(["i", "j", "k"])
        .map(|((axis, ink), name)| (axis, ink, name))
        .collect();
    axes.sort_by(|a, b| lens.camera.depth(a.0).total_cmp(&lens.camera.depth(b.0)));
    let from = lens.at(frame.at);
    for (axis, ink, name) in axes {
        let to = lens.at(add(frame.at, axis, TOOL * radius));
        scene.line(from, to, Stroke::solid(Ink::Paper, 4.4));
        scene.line(from, to, Stroke::solid(ink, 2.6));
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy);
        // An axis that points at the eye is a dot.
        if length > 4.0 {
            let at = [to[0] + 8.0 * dx / length, to[1] + 8.0 * dy / length];
            scene.text(
                Text::centered(at, name, SMALL)
                    .ink(ink)
                    .bold()
                    .halo(Ink::Paper),
            );
        }
    }
    scene.disc(from, 2.6, Ink::Text, Some(Stroke::solid(Ink::Paper, 0.8)));
}
