//! Quantities over time: one panel below the other on a common time axis.

mod line;
mod marks;

use crate::axes::Axes;
use crate::error::{Error, Result, finite};
use crate::figure::Figure;
use crate::ink::Ink;
use crate::legend::{self, Entry};
use crate::scene::{Point, Rect, Scene, Stroke};
use crate::ticks::{Ticks, level_ticks, range, ticks};

const WIDTH: f64 = 920.0;
const LEAST_LEFT: f64 = 72.0;
const RIGHT: f64 = 20.0;
/// The strip over the first panel that holds the labels of marks.
const STRIP: f64 = 26.0;
const BETWEEN: f64 = 18.0;
const BELOW: f64 = 48.0;
/// Distance between a line's markers. Lines take turns in it, so that markers of lines that
/// coincide stand side by side.
const MARKER_SPACING: f64 = 168.0;

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
    chart_along(chart, "Time, s")
}

/// As [`time_chart`], along something else than time: the number of a measurement, a distance.
///
/// # Errors
///
/// As [`time_chart`].
pub fn chart_along(chart: &TimeChart, axis: &str) -> Result<Figure> {
    check(chart)?;
    let moments = chart.times.iter().copied();
    let moments = moments.chain(chart.marks.iter().map(|mark| mark.time));
    let times = padded(range(moments), 0.015);
    let panel_height = if chart.panels.len() == 1 {
        330.0
    } else {
        210.0
    };
    let strip = if chart.marks.is_empty() { 0.0 } else { STRIP };
    let gutters = chart
        .panels
        .iter()
        .map(|panel| Axes::gutter(&value_ticks(panel, panel_height)));
    let left = gutters.fold(LEAST_LEFT, f64::max);
    let borders = [left, WIDTH - RIGHT];
    let mut top = 0.0;
    let mut areas = Vec::new();
    for (index, panel) in chart.panels.iter().enumerate() {
        top += legend_height(panel, borders) + if index == 0 { strip } else { 0.0 };
        areas.push(Rect::new(left, top, WIDTH - RIGHT - left, panel_height));
        top += panel_height + BETWEEN;
    }
    let mut scene = Scene::new(WIDTH, top - BETWEEN + BELOW);
    for (index, (panel, area)) in chart.panels.iter().zip(&areas).enumerate() {
        let axes = Axes::new(*area, times, values_range(panel));
        let place = Place {
            legend: area.top - legend_height(panel, borders) - if index == 0 { strip } else { 0.0 },
            axis: (index + 1 == areas.len()).then_some(axis),
        };
        draw_panel(&mut scene, chart, panel, &axes, place);
    }
    if let Some(first) = areas.first() {
        marks::draw(&mut scene, chart, &Axes::new(*first, times, [0.0, 1.0]));
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
struct Place<'a> {
    /// The upper edge of its legend.
    legend: f64,
    /// The name of the axis, if it carries it.
    axis: Option<&'a str>,
}

fn value_ticks(panel: &Panel, height: f64) -> Ticks {
    let [low, high] = values_range(panel);
    ticks(low, high, (height / 32.0) as usize, &panel.unit)
}

fn draw_panel(scene: &mut Scene, chart: &TimeChart, panel: &Panel, axes: &Axes, place: Place<'_>) {
    scene.open(&panel.name);
    let time_ticks = level_ticks(axes.x.values, 12, "s", axes.area.width);
    let value_ticks = value_ticks(panel, axes.area.height);
    axes.ground(scene, &time_ticks, &value_ticks);
    axes.label_y(scene, &value_ticks, &with_unit(&panel.name, &panel.unit));
    if let Some(axis) = place.axis {
        axes.label_x(scene, &time_ticks, axis);
    }
    for mark in &chart.marks {
        let x = axes.x.at(mark.time);
        let stroke = Stroke::dashed(Ink::Muted, 1.0, &[4.0, 3.0]);
        scene.line([x, axes.area.top], [x, axes.area.bottom()], stroke);
    }
    for (index, series) in panel.series.iter().enumerate() {
        let points = chart.times.iter().zip(&series.values);
        let points: Vec<Point> = points.map(|(&t, &v)| axes.at([t, v])).collect();
        scene.polyline(line::thinned(&points), line::stroke(index));
    }
    // Markers after all lines, so that no line hides the marker of another.
    for (index, series) in panel.series.iter().enumerate() {
        let turn = (index as f64 + 0.5) / panel.series.len() as f64;
        let mut x = axes.area.left + turn * MARKER_SPACING;
        while x < axes.area.right() {
            if let Some(y) = line::value_at(&chart.times, &series.values, axes, x) {
                line::marker(scene, [x, y], index);
            }
            x += MARKER_SPACING;
        }
    }
    let borders = [axes.area.left, axes.area.right()];
    legend::draw(scene, &legend(panel, borders), borders, place.legend);
    scene.close();
}

fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name}, {unit}")
    }
}

const SAMPLE: f64 = 40.0;

fn legend(panel: &Panel, borders: [f64; 2]) -> Vec<Entry<'_>> {
    let entry = |(index, series): (usize, &Series)| {
        let sample = move |scene: &mut Scene, x: f64, y: f64| {
            scene.line([x, y], [x + SAMPLE, y], line::stroke(index));
            line::marker(scene, [x + SAMPLE / 2.0, y], index);
        };
        Entry::new(SAMPLE, &series.name, sample).fitted(borders)
    };
    panel.series.iter().enumerate().map(entry).collect()
}

fn legend_height(panel: &Panel, borders: [f64; 2]) -> f64 {
    legend::height(&legend(panel, borders), borders) + 6.0
}
