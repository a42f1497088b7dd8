//! Quantities over time: one panel below the other on a common time axis.

use crate::axes::{Axes, SMALL};
use crate::error::{Error, Result, finite};
use crate::figure::Figure;
use crate::font;
use crate::ink::{self, Ink};
use crate::labels;
use crate::legend::{self, Entry};
use crate::scene::{Form, Point, Rect, Scene, Stroke, Text};
use crate::ticks::{range, ticks};

const WIDTH: f64 = 920.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 20.0;
/// The strip over the first panel that holds the labels of marks.
const STRIP: f64 = 26.0;
const BETWEEN: f64 = 18.0;
const BELOW: f64 = 48.0;
/// Distance between a line's markers. Lines take turns in it, so that markers of lines that
/// coincide stand side by side.
const MARKER_SPACING: f64 = 168.0;

const DASHES: [&[f64]; 6] = [
    &[],
    &[9.0, 4.0],
    &[3.0, 2.5],
    &[11.0, 3.0, 2.5, 3.0],
    &[6.0, 2.5],
    &[1.5, 2.0, 6.0, 2.0],
];

/// One quantity over time.
#[derive(Clone, Debug)]
pub struct Series {
    /// The name in the legend.
    pub name: String,
    /// One value for each of the chart's times.
    pub values: Vec<f64>,
}

impl Series {
    /// A series of values, one for each of the chart's times.
    pub fn new(name: impl Into<String>, values: Vec<f64>) -> Self {
        let name = name.into();
        Self { name, values }
    }
}

/// Quantities of one kind: one panel of a chart.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What is shown, such as "Joint angle".
    pub name: String,
    /// Its unit, such as "°", "mm" or "rad/s"; degrees get ticks at 30, 45, 90.
    pub unit: String,
    /// The lines.
    pub series: Vec<Series>,
}

impl Panel {
    /// A panel of lines that share a unit.
    pub fn new(name: impl Into<String>, unit: impl Into<String>, series: Vec<Series>) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
            series,
        }
    }
}

/// A moment with a label.
#[derive(Clone, Debug)]
pub struct TimeMark {
    /// The label, such as the number of a reference position.
    pub label: String,
    /// When, in seconds.
    pub time: f64,
}

/// What [`time_chart`] draws.
#[derive(Clone, Debug)]
pub struct TimeChart {
    /// The figure's title.
    pub title: String,
    /// The moments of the samples in seconds, in ascending order.
    pub times: Vec<f64>,
    /// The panels, from top to bottom.
    pub panels: Vec<Panel>,
    /// Moments to point out, across all panels.
    pub marks: Vec<TimeMark>,
}

/// Draws quantities over time.
///
/// Lines differ by colour, dashes and markers. Marks that stand too close share a label.
///
/// ```
/// use pieper_plot::{Panel, Series, TimeChart, TimeMark, time_chart};
///
/// let figure = time_chart(&TimeChart {
///     title: "Joints".into(),
///     times: vec![0.0, 0.5, 1.0],
///     panels: vec![
///         Panel::new("Angle", "°", vec![Series::new("q₁", vec![0.0, 45.0, 90.0])]),
///         Panel::new("Travel", "mm", vec![Series::new("q₂", vec![0.0, 10.0, 40.0])]),
///     ],
///     marks: vec![TimeMark { label: "1".into(), time: 1.0 }],
/// })?;
/// assert_eq!(figure.title(), "Joints");
/// # Ok::<(), pieper_plot::Error>(())
/// ```
///
/// # Errors
///
/// Where there is nothing to draw, a number is not finite, times do not ascend, or a series has not
/// one value per time.
pub fn time_chart(chart: &TimeChart) -> Result<Figure> {
    check(chart)?;
    let times = padded(
        range(
            chart
                .times
                .iter()
                .copied()
                .chain(chart.marks.iter().map(|m| m.time)),
        ),
        0.015,
    );
    let panel_height = if chart.panels.len() == 1 {
        330.0
    } else {
        210.0
    };
    let strip = if chart.marks.is_empty() { 0.0 } else { STRIP };
    let mut top = 0.0;
    let mut areas = Vec::new();
    for (index, panel) in chart.panels.iter().enumerate() {
        top += legend_height(panel) + if index == 0 { strip } else { 0.0 };
        areas.push(Rect::new(LEFT, top, WIDTH - LEFT - RIGHT, panel_height));
        top += panel_height + BETWEEN;
    }
    let mut scene = Scene::new(WIDTH, top - BETWEEN + BELOW);
    for (index, (panel, area)) in chart.panels.iter().zip(&areas).enumerate() {
        let axes = Axes::new(*area, times, values_range(panel));
        let place = Place {
            legend: area.top - legend_height(panel) - if index == 0 { strip } else { 0.0 },
            last: index + 1 == areas.len(),
        };
        draw_panel(&mut scene, chart, panel, &axes, place);
    }
    if let Some(first) = areas.first() {
        draw_mark_labels(&mut scene, chart, &Axes::new(*first, times, [0.0, 1.0]));
    }
    Ok(Figure::new(&chart.title, scene))
}

fn check(chart: &TimeChart) -> Result<()> {
    let count = chart.times.len();
    if count == 0 {
        return Err(Error::input("times", "at least one moment was expected"));
    }
    finite("times", &chart.times)?;
    if !chart.times.is_sorted() {
        return Err(Error::input(
            "times",
            "moments in ascending order were expected",
        ));
    }
    if chart.panels.iter().all(|panel| panel.series.is_empty()) {
        return Err(Error::input("panels", "at least one series was expected"));
    }
    for series in chart.panels.iter().flat_map(|panel| &panel.series) {
        let subject = format!("series {}", series.name);
        if series.values.len() != count {
            let message = format!(
                "{count} values were expected, {} were given",
                series.values.len()
            );
            return Err(Error::input(subject, message));
        }
        finite(&subject, &series.values)?;
    }
    for mark in &chart.marks {
        finite(&format!("time of mark {}", mark.label), [&mark.time])?;
    }
    Ok(())
}

fn padded([low, high]: [f64; 2], share: f64) -> [f64; 2] {
    let room = (high - low) * share;
    [low - room, high + room]
}

fn values_range(panel: &Panel) -> [f64; 2] {
    let values = panel.series.iter().flat_map(|series| series.values.iter());
    padded(range(values.copied()), 0.06)
}

/// Where a panel stands among the others.
struct Place {
    /// The upper edge of its legend.
    legend: f64,
    /// Whether it carries the time axis.
    last: bool,
}

fn draw_panel(scene: &mut Scene, chart: &TimeChart, panel: &Panel, axes: &Axes, place: Place) {
    scene.open(&panel.name);
    let time_ticks = ticks(axes.x.values[0], axes.x.values[1], 12, "s");
    let rows = (axes.area.height / 32.0) as usize;
    let value_ticks = ticks(axes.y.values[0], axes.y.values[1], rows, &panel.unit);
    axes.ground(scene, &time_ticks, &value_ticks);
    axes.label_y(scene, &value_ticks, &with_unit(&panel.name, &panel.unit));
    if place.last {
        axes.label_x(scene, &time_ticks, "Time, s");
    }
    for mark in &chart.marks {
        let x = axes.x.at(mark.time);
        let stroke = Stroke::dashed(Ink::Muted, 1.0, &[4.0, 3.0]);
        scene.line([x, axes.area.top], [x, axes.area.bottom()], stroke);
    }
    for (index, series) in panel.series.iter().enumerate() {
        let points = chart.times.iter().zip(&series.values);
        let points: Vec<Point> = points.map(|(&t, &v)| axes.at([t, v])).collect();
        scene.polyline(thinned(&points), stroke(index));
    }
    // Markers after all lines, so that no line hides the marker of another.
    for (index, series) in panel.series.iter().enumerate() {
        let turn = (index as f64 + 0.5) / panel.series.len() as f64;
        let mut x = axes.area.left + turn * MARKER_SPACING;
        while x < axes.area.right() {
            if let Some(y) = value_at(&chart.times, &series.values, axes, x) {
                marker(scene, [x, y], index);
            }
            x += MARKER_SPACING;
        }
    }
    legend::draw(scene, &legend(panel), BORDERS, place.legend);
    scene.close();
}

fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name}, {unit}")
    }
}

/// The height of the line at the place `x`, where the line reaches.
fn value_at(times: &[f64], values: &[f64], axes: &Axes, x: f64) -> Option<f64> {
    let after = times.iter().position(|&time| axes.x.at(time) >= x)?;
    let before = after.checked_sub(1)?;
    let [a, b] = [before, after].map(|k| axes.at([times[k], values[k]]));
    let share = (x - a[0]) / (b[0] - a[0]);
    Some(a[1] + share * (b[1] - a[1]))
}

/// Leaves out what no eye can see, so that long recordings stay small files: of the points in a
/// column half a pixel wide the first, the lowest, the highest and the last are kept.
fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let column = |point: &Point| (2.0 * point[0]).floor();
    for run in points.chunk_by(|a, b| column(a) == column(b)) {
        if run.len() <= 4 {
            kept.extend(run);
            continue;
        }
        let by_height = |a: &usize, b: &usize| run[*a][1].total_cmp(&run[*b][1]);
        let lowest = (0..run.len()).min_by(by_height);
        let highest = (0..run.len()).max_by(by_height);
        let mut chosen = [Some(0), lowest, highest, Some(run.len() - 1)];
        chosen.sort_unstable();
        kept.extend(chosen.into_iter().flatten().map(|index| run[index]));
        kept.dedup();
    }
    // A line needs two ends; one moment is drawn as a short dash.
    if let [only] = kept[..] {
        return vec![[only[0] - 4.0, only[1]], [only[0] + 4.0, only[1]]];
    }
    kept
}

fn series_ink(index: usize) -> Ink {
    Ink::Series((index % usize::from(ink::SERIES)) as u8)
}

fn stroke(index: usize) -> Stroke {
    Stroke::dashed(series_ink(index), 2.0, DASHES[index % DASHES.len()])
}

fn marker(scene: &mut Scene, [x, y]: Point, index: usize) {
    let ink = series_ink(index);
    let rim = Some(Stroke::solid(Ink::Paper, 1.0));
    let at = |offsets: &[Point]| offsets.iter().map(|[dx, dy]| [x + dx, y + dy]).collect();
    match index % 6 {
        0 => scene.disc([x, y], 4.2, ink, rim),
        1 => scene.polygon(
            at(&[[-3.8, -3.8], [3.8, -3.8], [3.8, 3.8], [-3.8, 3.8]]),
            ink,
            rim,
        ),
        2 => scene.polygon(at(&[[0.0, -5.2], [4.8, 3.6], [-4.8, 3.6]]), ink, rim),
        3 => scene.polygon(
            at(&[[0.0, -5.4], [5.4, 0.0], [0.0, 5.4], [-5.4, 0.0]]),
            ink,
            rim,
        ),
        4 => scene.polygon(at(&[[0.0, 5.2], [4.8, -3.6], [-4.8, -3.6]]), ink, rim),
        _ => scene.disc([x, y], 3.6, Ink::Paper, Some(Stroke::solid(ink, 2.0))),
    }
}

const SAMPLE: f64 = 40.0;

const BORDERS: [f64; 2] = [LEFT, WIDTH - RIGHT];

fn legend(panel: &Panel) -> Vec<Entry<'_>> {
    let entry = |(index, series): (usize, &Series)| {
        let sample = move |scene: &mut Scene, x: f64, y: f64| {
            scene.line([x, y], [x + SAMPLE, y], stroke(index));
            marker(scene, [x + SAMPLE / 2.0, y], index);
        };
        Entry::new(SAMPLE, &series.name, sample).fitted(BORDERS)
    };
    panel.series.iter().enumerate().map(entry).collect()
}

fn legend_height(panel: &Panel) -> f64 {
    legend::height(&legend(panel), BORDERS) + 6.0
}

/// The label of marks that stand close together.
struct Pill {
    places: Vec<f64>,
    labels: Vec<String>,
}

impl Pill {
    fn text(&self) -> String {
        let labels: Vec<&str> = self.labels.iter().map(String::as_str).collect();
        font::fit(&labels::join(&labels), SMALL, 200.0)
    }

    /// The frame around the label, inside the picture.
    fn frame(&self, y: f64) -> Rect {
        let middle = self.places.iter().sum::<f64>() / self.places.len() as f64;
        let width = (font::width(&self.text(), SMALL) + 10.0).max(20.0);
        let middle = middle.clamp(2.0 + width / 2.0, WIDTH - 2.0 - width / 2.0);
        Rect::around([middle, y], width, 20.0)
    }
}

/// The labels of marks, in small frames on the upper ends of their lines.
fn draw_mark_labels(scene: &mut Scene, chart: &TimeChart, axes: &Axes) {
    let y = axes.area.top - 14.0;
    let mut marks: Vec<&TimeMark> = chart.marks.iter().collect();
    marks.sort_by(|a, b| a.time.total_cmp(&b.time));
    let mut pills: Vec<Pill> = Vec::new();
    for mark in marks {
        let mut pill = Pill {
            places: vec![axes.x.at(mark.time)],
            labels: vec![mark.label.clone()],
        };
        // A label that would touch the one before it joins it, which may then touch the next.
        while let Some(last) = pills.pop_if(|last| last.frame(y).right() + 2.0 > pill.frame(y).left)
        {
            pill.places.splice(0..0, last.places);
            pill.labels.splice(0..0, last.labels);
        }
        pills.push(pill);
    }
    for pill in pills {
        let frame = pill.frame(y);
        let rim = Stroke::solid(Ink::Muted, 1.0);
        scene.shape(Form::Rect(frame, 10.0), Some(Ink::Paper), Some(rim));
        scene.text(Text::centered(frame.center(), pill.text(), SMALL).bold());
    }
}
