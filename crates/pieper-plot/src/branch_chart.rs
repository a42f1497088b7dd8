//! Alternatives over time: a small panel for each joint, all motions in it, the chosen one in front.

use crate::axes::Axes;
use crate::error::{Error, Result, finite};
use crate::figure::Figure;
use crate::ink::Ink;
use crate::legend::{self, Entry};
use crate::scene::{Point, Rect, Scene, Stroke};
use crate::ticks::{level_ticks, range, ticks};

const WIDTH: f64 = 920.0;
const RIGHT: f64 = 14.0;
const PANEL: f64 = 170.0;
const ABOVE: f64 = 16.0;
const BELOW: f64 = 22.0;
/// Under the last row of panels: the name of the time axis.
const LAST: f64 = 30.0;
/// Half the size of the cross where a motion ends.
const CROSS: f64 = 4.2;

/// A motion of all joints.
#[derive(Clone, Debug)]
pub struct BranchLine {
    /// Moments in seconds, in ascending order.
    pub times: Vec<f64>,
    /// For each joint one value for each moment.
    pub values: Vec<Vec<f64>>,
    /// Whether it is drawn in front.
    pub is_chosen: bool,
    /// Whether it ends with a cross.
    pub dies: bool,
}

/// What [`branch_chart`] draws.
#[derive(Clone, Debug)]
pub struct BranchChart {
    /// The figure's title.
    pub title: String,
    /// Name and unit of each joint, such as `("q₁", "°")`.
    pub joints: Vec<(String, String)>,
    /// The motions.
    pub lines: Vec<BranchLine>,
    /// The range of times shown; wider if a motion needs it.
    pub times: [f64; 2],
}

/// Draws all motions along a path, a panel for each joint.
///
/// ```
/// use pieper_plot::{BranchChart, BranchLine, branch_chart};
///
/// let line = |sign: f64, is_chosen| BranchLine {
///     times: vec![0.0, 1.0],
///     values: vec![vec![0.0, sign * 40.0]],
///     is_chosen,
///     dies: !is_chosen,
/// };
/// let figure = branch_chart(&BranchChart {
///     title: "Two ways".into(),
///     joints: vec![("q₁".into(), "°".into())],
///     lines: vec![line(1.0, true), line(-1.0, false)],
///     times: [0.0, 2.0],
/// })?;
/// assert_eq!(figure.title(), "Two ways");
/// # Ok::<(), pieper_plot::Error>(())
/// ```
///
/// # Errors
///
/// Where there is nothing to draw, a number is not finite, times do not ascend, or a motion has not one list of values
/// for each joint and one value for each moment.
pub fn branch_chart(chart: &BranchChart) -> Result<Figure> {
    check(chart)?;
    let count = chart.joints.len();
    let columns = if count < 4 {
        count
    } else {
        count.div_ceil(2).min(3)
    };
    let rows = count.div_ceil(columns);
    let moments = chart.lines.iter().flat_map(|line| line.times.iter());
    let times = range(moments.chain(&chart.times).copied());
    let room = 0.02 * (times[1] - times[0]);
    let times = [times[0] - room, times[1] + room];
    let cell = WIDTH / columns as f64;
    let borders = [16.0, WIDTH - 16.0];
    let legend = legend(chart);
    let top = legend::height(&legend, borders) + 4.0;
    let step = ABOVE + PANEL + BELOW;
    let mut scene = Scene::new(WIDTH, top + rows as f64 * step + LAST);
    legend::draw(&mut scene, &legend, borders, 0.0);
    for (index, (name, unit)) in chart.joints.iter().enumerate() {
        let values = chart
            .lines
            .iter()
            .flat_map(|line| line.values[index].iter());
        let [low, high] = range(values.copied());
        let room = 0.07 * (high - low);
        let [low, high] = [low - room, high + room];
        let value_ticks = ticks(low, high, 5, unit);
        let left = cell * (index % columns) as f64 + Axes::gutter(&value_ticks);
        let area = Rect::new(
            left,
            top + ABOVE + step * (index / columns) as f64,
            cell * (index % columns + 1) as f64 - RIGHT - left,
            PANEL,
        );
        let axes = Axes::new(area, times, [low, high]);
        let time_ticks = level_ticks(times, 6, "s", area.width);
        scene.open(name);
        axes.ground(&mut scene, &time_ticks, &value_ticks);
        axes.label_y(&mut scene, &value_ticks, &format!("{name}, {unit}"));
        let is_lowest = index + columns >= count;
        axes.label_x(
            &mut scene,
            &time_ticks,
            if is_lowest { "Time, s" } else { "" },
        );
        // The chosen motion last, over all others.
        for is_chosen in [false, true] {
            for line in chart
                .lines
                .iter()
                .filter(|line| line.is_chosen == is_chosen)
            {
                draw(&mut scene, &axes, line, index);
            }
        }
        scene.close();
    }
    Ok(Figure::new(&chart.title, scene))
}

fn check(chart: &BranchChart) -> Result<()> {
    if chart.joints.is_empty() || chart.lines.is_empty() {
        return Err(Error::input("lines", "at least one motion was expected"));
    }
    finite("times", &chart.times)?;
    for (number, line) in chart.lines.iter().enumerate() {
        let subject = format!("motion {number}");
        finite(&subject, &line.times)?;
        if !line.times.is_sorted() || line.times.is_empty() {
            return Err(Error::input(
                subject,
                "moments in ascending order were expected",
            ));
        }
        let fits = line
            .values
            .iter()
            .all(|list| list.len() == line.times.len());
        if line.values.len() != chart.joints.len() || !fits {
            let text = "a value for each joint and moment was expected";
            return Err(Error::input(subject, text));
        }
        finite(&subject, line.values.iter().flatten())?;
    }
    Ok(())
}

fn stroke(is_chosen: bool) -> Stroke {
    match is_chosen {
        true => Stroke::solid(Ink::Path, 2.6),
        false => Stroke::solid(Ink::Axis, 1.1),
    }
}

fn draw(scene: &mut Scene, axes: &Axes, line: &BranchLine, joint: usize) {
    let places = line.times.iter().zip(&line.values[joint]);
    let points: Vec<Point> = places.map(|(&t, &v)| axes.at([t, v])).collect();
    let end = points[points.len() - 1];
    let points = match points.len() > 1 {
        true => crate::view::thinned(&points),
        false => vec![[end[0] - 3.0, end[1]], end],
    };
    scene.polyline(points, stroke(line.is_chosen));
    if line.dies {
        cross(scene, end, line.is_chosen);
    }
}

fn cross(scene: &mut Scene, [x, y]: Point, is_chosen: bool) {
    let stroke = Stroke::solid(Ink::ToolX, if is_chosen { 2.6 } else { 1.8 });
    for side in [CROSS, -CROSS] {
        scene.line([x - CROSS, y - side], [x + CROSS, y + side], stroke);
    }
}

fn legend(chart: &BranchChart) -> Vec<Entry<'static>> {
    let line = |is_chosen: bool, name: &str| {
        Entry::new(34.0, name, move |scene, x, y| {
            scene.line([x, y], [x + 34.0, y], stroke(is_chosen));
        })
    };
    let mut entries = Vec::new();
    if chart.lines.iter().any(|line| line.is_chosen) {
        entries.push(line(true, "followed"));
    }
    if chart.lines.iter().any(|line| !line.is_chosen) {
        entries.push(line(false, "the other branches"));
    }
    if chart.lines.iter().any(|line| line.dies) {
        entries.push(Entry::new(12.0, "here a branch ends", |scene, x, y| {
            cross(scene, [x + 6.0, y], false);
        }));
    }
    entries
}
