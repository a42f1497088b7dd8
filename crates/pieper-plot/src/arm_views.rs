//! The arm itself: its skeleton at each reference position, all to one scale.

mod body;

use crate::axes::SMALL;
use crate::error::{Error, Result, finite};
use crate::figure::Figure;
use crate::font;
use crate::ink::Ink;
use crate::legend::{self, Entry};
use crate::scene::{Form, Rect, Scene, Stroke, Text};
use crate::ticks::ticks;
use crate::view::{Camera, Lens, Vec3, add, norm, thinned};

const WIDTH: f64 = 920.0;
/// The width of a single picture.
const ALONE: f64 = 520.0;
/// Above each picture: its label.
const HEAD: f64 = 34.0;
/// Below each picture: the names of the floor's axes.
const FOOT: f64 = 18.0;
/// Left and right of each picture.
const SIDE: f64 = 10.0;

/// Which motion a joint allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// Turns about its axis; drawn as a cylinder.
    Revolute,
    /// Slides along its axis; drawn as a box.
    Prismatic,
}

/// A joint of the skeleton.
#[derive(Clone, Copy, Debug)]
pub struct ArmJoint {
    /// A point of the axis, best one on a link.
    pub at: [f64; 3],
    /// The axis's direction, of any length but zero.
    pub axis: [f64; 3],
    /// What it allows.
    pub kind: JointKind,
}

/// The frame of the tool.
#[derive(Clone, Copy, Debug)]
pub struct ToolFrame {
    /// The tool's point.
    pub at: [f64; 3],
    /// The unit vectors i, j, k.
    pub axes: [[f64; 3]; 3],
}

/// An arm in one position.
#[derive(Clone, Debug)]
pub struct Arm {
    /// The position's label, such as "0".
    pub label: String,
    /// What else to say of it, such as "t = 0 s"; may be empty.
    pub note: String,
    /// The skeleton's corners from the base to the tool, in metres. Corners between the two ends of
    /// a link's offset (first along its joint's axis, then across) make an arm look like an arm.
    pub points: Vec<[f64; 3]>,
    /// The joints. Of joints at one place, those whose axis runs along the next link are drawn part
    /// of the way along it.
    pub joints: Vec<ArmJoint>,
    /// The tool's frame.
    pub tool: ToolFrame,
}

/// What [`arm_views`] draws.
#[derive(Clone, Debug)]
pub struct ArmViews {
    /// The figure's title.
    pub title: String,
    /// The positions, in order.
    pub arms: Vec<Arm>,
    /// The tool's path, drawn faintly; may be empty.
    pub path: Vec<[f64; 3]>,
}

/// Draws an arm at each of its positions, in small pictures of one scale and one point of view.
///
/// ```
/// use pieper_plot::{Arm, ArmJoint, ArmViews, JointKind, ToolFrame, arm_views};
///
/// let figure = arm_views(&ArmViews {
///     title: "A pendulum".into(),
///     arms: vec![Arm {
///         label: "0".into(),
///         note: String::new(),
///         points: vec![[0.0, 0.0, 0.0], [0.0, 0.0, 0.3], [0.2, 0.0, 0.3]],
///         joints: vec![ArmJoint {
///             at: [0.0, 0.0, 0.3],
///             axis: [0.0, 1.0, 0.0],
///             kind: JointKind::Revolute,
///         }],
///         tool: ToolFrame {
///             at: [0.2, 0.0, 0.3],
///             axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///         },
///     }],
///     path: vec![],
/// })?;
/// # assert!(figure.width() > 0.0);
/// # Ok::<(), pieper_plot::Error>(())
/// ```
///
/// # Errors
///
/// Where there is no arm, an arm has no points, or a number is not finite.
pub fn arm_views(views: &ArmViews) -> Result<Figure> {
    check(views)?;
    let count = views.arms.len();
    let columns = columns(count);
    let width = if count == 1 { ALONE } else { WIDTH };
    let stage = Stage::new(views);
    let cell_width = width / columns as f64;
    let cell_height = HEAD + FOOT + (cell_width - 2.0 * SIDE) * stage.steepness();
    let legend = legend(views, stage.grid);
    let borders = [16.0, width - 16.0];
    let cells = count.div_ceil(columns) as f64 * cell_height;
    let height = cells + legend::height(&legend, borders) + 12.0;
    let mut scene = Scene::new(width, height);
    for (index, arm) in views.arms.iter().enumerate() {
        let (row, column) = (index / columns, index % columns);
        let corner = [column as f64 * cell_width, row as f64 * cell_height];
        let cell = Rect::new(corner[0], corner[1], cell_width, cell_height);
        stage.draw(&mut scene, views, arm, cell);
    }
    legend::draw(&mut scene, &legend, borders, cells + 6.0);
    Ok(Figure::new(&views.title, scene))
}

/// How many pictures stand side by side: as large as they can be without a nearly empty last row.
fn columns(count: usize) -> usize {
    match count {
        0..=4 => count,
        5 | 6 | 9 => 3,
        _ => 4,
    }
}

fn check(views: &ArmViews) -> Result<()> {
    if views.arms.is_empty() {
        return Err(Error::input("arms", "at least one position was expected"));
    }
    finite("path", views.path.as_flattened())?;
    for arm in &views.arms {
        let subject = format!("arm {}", arm.label);
        if arm.points.is_empty() {
            return Err(Error::input(subject, "at least one point was expected"));
        }
        finite(&subject, arm.points.as_flattened())?;
        finite(
            &subject,
            arm.tool.at.iter().chain(arm.tool.axes.as_flattened()),
        )?;
        for joint in &arm.joints {
            finite(&subject, joint.at.iter().chain(&joint.axis))?;
        }
    }
    Ok(())
}

/// What all pictures share: the space they show and the sizes in it.
struct Stage {
    /// Corners of the space above the floor.
    low: Vec3,
    high: Vec3,
    /// What has to be in the picture: all that is drawn anywhere, and the floor.
    seen: Vec<Vec3>,
    /// The radius of a joint.
    radius: f64,
    /// The distance of the floor's lines.
    grid: f64,
}

impl Stage {
    fn new(views: &ArmViews) -> Self {
        let points = || {
            let arms = views.arms.iter().flat_map(|arm| arm.points.iter());
            arms.chain(&views.path).copied()
        };
        let [mut low, mut high] = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for point in points() {
            low = [0, 1, 2].map(|k| low[k].min(point[k]));
            high = [0, 1, 2].map(|k| high[k].max(point[k]));
        }
        let bases = views.arms.iter().map(|arm| arm.points[0][2]);
        low[2] = bases.fold(low[2], f64::min);
        let size = norm(add(high, low, -1.0));
        let size = if size < 1e-9 { 0.1 } else { size };
        let radius = 0.022 * size;
        // Room for joints, the base plate and the tool's axes.
        let room = 3.0 * radius;
        for k in 0..2 {
            low[k] -= room;
            high[k] += room;
        }
        let floor = [
            [low[0], low[1]],
            [high[0], low[1]],
            [high[0], high[1]],
            [low[0], high[1]],
        ];
        let mut seen: Vec<Vec3> = floor.map(|[x, y]| [x, y, low[2]]).to_vec();
        for point in points() {
            seen.extend([add(point, [0.0, 0.0, room], 1.0), point]);
        }
        for arm in &views.arms {
            seen.extend(
                arm.tool
                    .axes
                    .map(|axis| add(arm.tool.at, axis, 1.25 * body::TOOL * radius)),
            );
        }
        let widest = (high[0] - low[0]).max(high[1] - low[1]);
        Self {
            low,
            high,
            seen,
            radius,
            grid: ticks(0.0, widest, 8, "").step,
        }
    }

    /// Height over width of a picture.
    fn steepness(&self) -> f64 {
        let [x, y] = Camera::axonometric().extent(&self.seen);
        ((y[1] - y[0]) / (x[1] - x[0])).clamp(0.5, 1.6)
    }

    fn draw(&self, scene: &mut Scene, views: &ArmViews, arm: &Arm, cell: Rect) {
        scene.open(format!("position {}", arm.label));
        let area = Rect::new(
            cell.left + SIDE,
            cell.top + HEAD,
            cell.width - 2.0 * SIDE,
            cell.height - HEAD - FOOT,
        );
        let lens = Lens::fit(Camera::axonometric(), &self.seen, &area);
        self.floor(scene, &lens);
        let shadow: Vec<Vec3> = arm
            .points
            .iter()
            .map(|p| [p[0], p[1], self.low[2]])
            .collect();
        let width = self.radius * lens.scale * 1.1;
        scene.polyline(lens.line(&shadow), Stroke::solid(Ink::Shadow, width));
        if views.path.len() > 1 {
            let path = thinned(&lens.line(&views.path));
            scene.polyline(path, Stroke::solid(Ink::Hidden, 1.4));
        }
        body::draw(scene, &lens, arm, self.radius);
        label(scene, arm, cell);
        scene.close();
    }

    fn floor(&self, scene: &mut Scene, lens: &Lens) {
        let (low, high) = (self.low, self.high);
        let at = |x: f64, y: f64| lens.at([x, y, low[2]]);
        let corners = vec![
            at(low[0], low[1]),
            at(high[0], low[1]),
            at(high[0], high[1]),
            at(low[0], high[1]),
        ];
        scene.polygon(corners, Ink::Wall, Some(Stroke::solid(Ink::Grid, 1.0)));
        let lines = |k: usize| {
            let first = (low[k] / self.grid).ceil() as i64;
            let last = (high[k] / self.grid).floor() as i64;
            (first..=last).map(|n| n as f64 * self.grid)
        };
        let stroke = Stroke::solid(Ink::Grid, 0.8);
        for x in lines(0) {
            scene.line(at(x, low[1]), at(x, high[1]), stroke);
        }
        for y in lines(1) {
            scene.line(at(low[0], y), at(high[0], y), stroke);
        }
        self.name_edges(scene, lens);
    }

    /// Names the axes of the base along the near edges of the floor.
    fn name_edges(&self, scene: &mut Scene, lens: &Lens) {
        let (low, high) = (self.low, self.high);
        let corner = [high[0], low[1], low[2]];
        for (axis, side, name) in [(0, 1.0, "x₀"), (1, -1.0, "y₀")] {
            let [mut from, mut to] = [corner; 2];
            (from[axis], to[axis]) = (low[axis], high[axis]);
            let [from, to] = [lens.at(from), lens.at(to)];
            let length = (to[0] - from[0]).hypot(to[1] - from[1]);
            let way = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
            let middle = [(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0];
            let beside = |along: f64| {
                [
                    middle[0] + along * way[0] - side * 11.0 * way[1].abs(),
                    middle[1] + along * way[1] + 11.0 * way[0],
                ]
            };
            let stroke = Stroke::solid(Ink::Muted, 1.0);
            let [tail, tip] = [beside(2.0), beside(22.0)];
            let back = |across: f64| {
                [
                    tip[0] - 5.0 * way[0] - across * way[1],
                    tip[1] - 5.0 * way[1] + across * way[0],
                ]
            };
            scene.line(tail, tip, stroke);
            scene.polyline(vec![back(2.6), tip, back(-2.6)], stroke);
            scene.text(Text::centered(beside(-8.0), name, SMALL).ink(Ink::Muted));
        }
    }
}

fn label(scene: &mut Scene, arm: &Arm, cell: Rect) {
    let [left, middle] = [cell.left + 12.0, cell.top + 14.0];
    let name = font::fit(&arm.label, SMALL, cell.width / 2.0);
    let width = (font::bold_width(&name, SMALL) + 10.0).max(20.0);
    let frame = Rect::new(left, middle - 10.0, width, 20.0);
    let rim = Stroke::solid(Ink::Muted, 1.0);
    scene.shape(Form::Rect(frame, 10.0), Some(Ink::Paper), Some(rim));
    scene.text(Text::centered(frame.center(), name, SMALL).bold());
    let at = [frame.right() + 7.0, middle + font::HALF_DIGIT * SMALL];
    let note = font::fit(&arm.note, SMALL, cell.right() - at[0] - 4.0);
    scene.text(Text::new(at, note, SMALL).ink(Ink::Muted));
}

fn legend(views: &ArmViews, grid: f64) -> Vec<Entry<'static>> {
    let line = |ink: Ink, name: &str| {
        let stroke = Stroke::solid(ink, 2.6);
        Entry::new(24.0, name, move |scene, x, y| {
            scene.line([x, y], [x + 24.0, y], stroke)
        })
    };
    let mut entries = vec![
        line(Ink::ToolX, "i, tool x"),
        line(Ink::ToolY, "j, tool y"),
        line(Ink::ToolZ, "k, tool z"),
    ];
    if views.path.len() > 1 {
        entries.push(line(Ink::Hidden, "path of the tool"));
    }
    let joints = || views.arms.iter().flat_map(|arm| &arm.joints);
    if joints().any(|joint| joint.kind == JointKind::Prismatic) {
        let disc = |ink: Ink, name: &str| {
            let rim = Stroke::solid(Ink::Edge, 0.9);
            Entry::new(10.0, name, move |scene, x, y| {
                scene.disc([x + 5.0, y], 5.0, ink, Some(rim))
            })
        };
        entries.push(disc(Ink::Joint, "joint that turns"));
        entries.push(disc(Ink::Slider, "joint that slides"));
    }
    let squares = if grid < 1.0 {
        format!("floor squares {} mm", (grid * 1e6).round() / 1e3)
    } else {
        format!("floor squares {grid} m")
    };
    entries.push(Entry::new(22.0, squares, square));
    entries
}

/// A sample of the floor.
fn square(scene: &mut Scene, x: f64, y: f64) {
    let corners = vec![
        [x, y + 1.0],
        [x + 13.0, y + 5.0],
        [x + 22.0, y],
        [x + 9.0, y - 4.0],
    ];
    scene.polygon(corners, Ink::Wall, Some(Stroke::solid(Ink::Axis, 1.0)));
}
