//! A path in space: an axonometric view and the three projections.

mod arrows;

use crate::axes::{Axes, NORMAL};
use crate::error::{Error, Result, finite};
use crate::figure::Figure;
use crate::ink::Ink;
use crate::labels::{self, Tag};
use crate::legend::{self, Entry};
use crate::scene::{Point, Rect, Scene, Stroke, Text};
use crate::sphere;
use crate::ticks::{Ticks, level_ticks, ticks};
use crate::view::{Camera, Lens, Room, Vec3, corners, thinned};

const WIDTH: f64 = 920.0;
const RIGHT: f64 = 16.0;
/// Above each panel: its name.
const ABOVE: f64 = 30.0;
/// Below each panel: tick labels and the name of an axis.
const BELOW: f64 = 52.0;
/// The highest a panel may be, so that a figure fits on a screen.
const HIGHEST: f64 = 400.0;
const SEEN: Stroke = Stroke::solid(Ink::Path, 2.2);
const FAR: Stroke = Stroke::dashed(Ink::Hidden, 1.8, &[4.0, 3.0]);
const SHADOW: Stroke = Stroke::solid(Ink::Shadow, 1.6);

/// What kind of path is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Positions in metres. Axes count millimetres where that reads better.
    Positions,
    /// Unit vectors: a path on the unit sphere, which is drawn too.
    Directions,
}

/// A marked point of a path.
#[derive(Clone, Debug)]
pub struct PathMark {
    /// The label, such as the number of a reference position.
    pub label: String,
    /// Where.
    pub at: [f64; 3],
}

/// What [`path_views`] draws.
#[derive(Clone, Debug)]
pub struct PathViews {
    /// The figure's title.
    pub title: String,
    /// The names of the axes, such as "x₀".
    pub axes: [String; 3],
    /// Positions or directions.
    pub space: Space,
    /// The path, in order; a single point is drawn as one.
    pub path: Vec<[f64; 3]>,
    /// Points to point out.
    pub marks: Vec<PathMark>,
}

/// Draws a path in space: an axonometric view and the projections x–y, y–z and x–z.
///
/// The projections have one scale, and stand as in an engineering drawing: y–z and x–z side by side
/// with a common z, x–y above x–z with a common x. Marks that coincide share a label. Of a path of
/// directions the parts on the far side of the sphere are dimmed.
///
/// ```
/// use pieper_plot::{PathMark, PathViews, Space, path_views};
///
/// let path: Vec<[f64; 3]> = (0..=60)
///     .map(|k| (0.1 * f64::from(k)).sin_cos())
///     .map(|(sin, cos)| [cos, sin, 0.0])
///     .collect();
/// let figure = path_views(&PathViews {
///     title: "The unit vector i".into(),
///     axes: ["x₀".into(), "y₀".into(), "z₀".into()],
///     space: Space::Directions,
///     marks: vec![PathMark { label: "0".into(), at: path[0] }],
///     path,
/// })?;
/// assert!(figure.height() > 400.0);
/// # Ok::<(), pieper_plot::Error>(())
/// ```
///
/// # Errors
///
/// Where the path is empty or a number is not finite.
pub fn path_views(views: &PathViews) -> Result<Figure> {
    if views.path.is_empty() {
        return Err(Error::input("path", "at least one point was expected"));
    }
    finite("path", views.path.as_flattened())?;
    for mark in &views.marks {
        finite(&format!("mark {}", mark.label), &mark.at)?;
    }
    let drawing = Drawing::new(views);
    let layout = Layout::new(&drawing);
    let mut scene = Scene::new(WIDTH, layout.height);
    drawing.axonometric(&mut scene, layout.axonometric);
    drawing.projection(&mut scene, [0, 1], layout.xy);
    drawing.projection(&mut scene, [1, 2], layout.yz);
    drawing.projection(&mut scene, [0, 2], layout.xz);
    let borders = [layout.yz.left, WIDTH - RIGHT];
    legend::draw(
        &mut scene,
        &drawing.legend(),
        borders,
        layout.height - legend::ROW - 6.0,
    );
    Ok(Figure::new(&views.title, scene))
}

/// The panels: projections of one scale, columns of one width, rows of one height.
struct Layout {
    axonometric: Rect,
    xy: Rect,
    yz: Rect,
    xz: Rect,
    height: f64,
}

impl Layout {
    fn new(drawing: &Drawing<'_>) -> Self {
        let [x, y, z] = drawing.bounds.map(|[low, high]| high - low);
        let [_, y_gutter, z_gutter] = [0, 1, 2].map(|axis| Axes::gutter(&drawing.ticks(axis)));
        let first = z_gutter.max(56.0);
        let second = y_gutter.max(z_gutter) + 16.0;
        let room = WIDTH - first - second - RIGHT;
        let scale = (room / (x + y)).min(HIGHEST / y.max(z));
        let [x, y, z] = [x, y, z].map(|span| span * scale);
        let left = first + (room - x - y) / 2.0;
        let right = left + y + second;
        let below = ABOVE + y + BELOW + ABOVE;
        Self {
            axonometric: Rect::new(16.0, ABOVE, left + y, y + 40.0),
            xy: Rect::new(right, ABOVE, x, y),
            yz: Rect::new(left, below, y, z),
            xz: Rect::new(right, below, x, z),
            height: below + z + BELOW + legend::ROW + 8.0,
        }
    }
}

struct Drawing<'a> {
    views: &'a PathViews,
    bounds: [[f64; 2]; 3],
    /// The unit of the axes in units of the points.
    unit: f64,
    suffix: &'static str,
}

impl<'a> Drawing<'a> {
    fn new(views: &'a PathViews) -> Self {
        let bounds = match views.space {
            Space::Directions => [[-1.14, 1.14]; 3],
            Space::Positions => bounds(views),
        };
        let widest = bounds
            .iter()
            .map(|[low, high]| high - low)
            .fold(0.0, f64::max);
        let (unit, suffix) = match views.space {
            Space::Directions => (1.0, ""),
            Space::Positions if widest < 3.0 => (1e-3, ", mm"),
            Space::Positions => (1.0, ", m"),
        };
        Self {
            views,
            bounds,
            unit,
            suffix,
        }
    }

    fn name(&self, axis: usize) -> String {
        format!("{}{}", self.views.axes[axis], self.suffix)
    }

    fn in_unit(&self, axis: usize) -> [f64; 2] {
        self.bounds[axis].map(|end| end / self.unit)
    }

    /// How many ticks an axis has room for: with one step for all, the grids are squares.
    fn count(&self, axis: usize) -> usize {
        let [x, y, z] = self.bounds.map(|[low, high]| high - low);
        (7.0 * [x, y, z][axis] / x.max(y).max(z)).round().max(2.0) as usize
    }

    fn ticks(&self, axis: usize) -> Ticks {
        let [low, high] = self.in_unit(axis);
        ticks(low, high, self.count(axis), "")
    }

    fn axonometric(&self, scene: &mut Scene, area: Rect) {
        scene.open("axonometric");
        panel_name(scene, &area, "Axonometric view");
        let camera = Camera::axonometric();
        let [low, high] = [0, 1].map(|end| self.bounds.map(|ends| ends[end]));
        let names = [0, 1, 2].map(|axis| self.name(axis));
        let names = [&*names[0], &*names[1], &*names[2]];
        if self.views.space == Space::Directions {
            let side = area.height - 40.0;
            let lens = Lens {
                camera,
                scale: side / 2.0 / 1.2,
                offset: [area.center()[0], area.top + side / 2.0 + 12.0],
            };
            sphere::ball(scene, &lens);
            sphere::axes(scene, &lens, names);
            self.path(scene, &lens, &area);
        } else {
            let margin = self.ticks(2).widest_label().max(38.0) + 14.0;
            let inner = Rect::new(
                area.left + margin,
                area.top + 2.0,
                area.width - margin - 30.0,
                area.height - 48.0,
            );
            let lens = Lens::fit(camera, &corners(low, high), &inner);
            let unit = self.unit;
            Room {
                low,
                high,
                names,
                unit,
            }
            .draw(scene, &lens);
            let fallen: Vec<Vec3> = self
                .views
                .path
                .iter()
                .map(|p| [p[0], p[1], low[2]])
                .collect();
            scene.polyline(thinned(&lens.line(&fallen)), SHADOW);
            self.path(scene, &lens, &inner);
        }
        scene.close();
    }

    fn projection(&self, scene: &mut Scene, [right, up]: [usize; 2], area: Rect) {
        let names = [&self.views.axes[right], &self.views.axes[up]];
        scene.open(format!("{}-{}", names[0], names[1]));
        panel_name(scene, &area, &format!("{}\u{2013}{}", names[0], names[1]));
        let axes = Axes::new(area, self.in_unit(right), self.in_unit(up));
        let y_ticks = self.ticks(up);
        let x_ticks = level_ticks(self.in_unit(right), self.count(right), "", area.width);
        axes.ground(scene, &x_ticks, &y_ticks);
        axes.label_x(scene, &x_ticks, &self.name(right));
        axes.label_y(scene, &y_ticks, &self.name(up));
        let camera = Camera::along(right, up);
        let scale = area.width / (self.bounds[right][1] - self.bounds[right][0]);
        let corner = [self.bounds[right][0], self.bounds[up][0]].map(|low| low * scale);
        let lens = Lens {
            camera,
            scale,
            offset: [area.left - corner[0], area.bottom() + corner[1]],
        };
        if self.views.space == Space::Directions {
            sphere::ball(scene, &lens);
        }
        self.path(scene, &lens, &area);
        scene.close();
    }

    /// The path, its direction and its marks, as one lens sees them.
    fn path(&self, scene: &mut Scene, lens: &Lens, bounds: &Rect) {
        let on_sphere = self.views.space == Space::Directions;
        let line = thinned(&lens.line(&self.views.path));
        if on_sphere {
            let mut parts = sphere::stretches(&lens.camera, &self.views.path);
            // Far parts first: where both run over one place in the picture, the near one is seen.
            parts.sort_by_key(|part| !part.hidden);
            for part in &parts {
                let stroke = if part.hidden { FAR } else { SEEN };
                scene.polyline(thinned(&lens.line(&part.points)), stroke);
            }
        } else {
            scene.polyline(line.clone(), SEEN);
        }
        self.heads(scene, lens);
        let marks = self.views.marks.iter().map(|mark| Tag {
            at: lens.at(mark.at),
            text: mark.label.clone(),
            hidden: on_sphere && sphere::hidden(&lens.camera, mark.at),
        });
        let tags = labels::merge(marks.collect());
        if tags.is_empty() && line.len() == 1 {
            labels::dot(scene, line[0], false);
        }
        labels::draw(scene, &tags, &[line], bounds);
    }

    /// Arrow heads on each stretch between marks.
    fn heads(&self, scene: &mut Scene, lens: &Lens) {
        let mut taken: Vec<Point> = self
            .views
            .marks
            .iter()
            .map(|mark| lens.at(mark.at))
            .collect();
        for ends in stops(self.views).windows(2) {
            let stretch = &self.views.path[ends[0]..=ends[1]];
            let parts = match self.views.space {
                Space::Directions => sphere::stretches(&lens.camera, stretch),
                Space::Positions => vec![sphere::Stretch {
                    points: stretch.to_vec(),
                    hidden: false,
                }],
            };
            for part in parts {
                let ink = if part.hidden { Ink::Hidden } else { Ink::Path };
                let heads = arrows::places(&thinned(&lens.line(&part.points)), &mut taken);
                heads
                    .into_iter()
                    .for_each(|(at, way)| arrows::draw(scene, at, way, ink));
            }
        }
    }

    fn legend(&self) -> Vec<Entry<'static>> {
        let line = |stroke: Stroke, name: &str| {
            Entry::new(34.0, name, move |scene, x, y| {
                scene.line([x, y], [x + 34.0, y], stroke)
            })
        };
        let dot = |hidden: bool, name: &str| {
            Entry::new(10.0, name, move |scene, x, y| {
                labels::dot(scene, [x + 5.0, y], hidden)
            })
        };
        let head = Entry::new(34.0, "direction of motion", |scene, x, y| {
            scene.line([x, y], [x + 34.0, y], SEEN);
            arrows::draw(scene, [x + 17.0, y], [1.0, 0.0], Ink::Path);
        });
        let on_sphere = self.views.space == Space::Directions;
        let mut entries = if on_sphere {
            vec![
                line(SEEN, "near side of the sphere"),
                line(FAR, "far side"),
                head,
            ]
        } else {
            vec![
                line(SEEN, "path"),
                line(SHADOW, "its foot on the floor of the box"),
                head,
            ]
        };
        if !self.views.marks.is_empty() {
            entries.push(dot(false, "reference position"));
            if on_sphere {
                entries.push(dot(true, "on the far side"));
            }
        }
        entries
    }
}

/// The box of a path: as tight as its extents allow, but never flat.
fn bounds(views: &PathViews) -> [[f64; 2]; 3] {
    let points = || {
        views
            .path
            .iter()
            .chain(views.marks.iter().map(|mark| &mark.at))
    };
    let tight = [0, 1, 2].map(|k| {
        let [low, high] = points().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], p| {
            [a.min(p[k]), b.max(p[k])]
        });
        [(low + high) / 2.0, high - low]
    });
    let widest = tight.iter().map(|[_, span]| *span).fold(0.0, f64::max);
    // A point, or what rounding left of one, gets a box of a tenth of a metre.
    let farthest = tight
        .iter()
        .map(|[middle, _]| middle.abs())
        .fold(0.0, f64::max);
    let widest = if widest < 1e-9_f64.max(1e-7 * farthest) {
        0.1_f64.max(1e-6 * farthest)
    } else {
        widest
    };
    tight.map(|[middle, span]| {
        let half = (0.58 * span).max(0.36 * widest);
        [middle - half, middle + half]
    })
}

fn panel_name(scene: &mut Scene, area: &Rect, name: &str) {
    let at = [area.left, area.top - 10.0];
    scene.text(Text::new(at, name, NORMAL).bold());
}

/// Where along the path the marks are, in the path's order. Repeated places are found in turn.
fn stops(views: &PathViews) -> Vec<usize> {
    let mut stops = vec![0];
    let mut from = 0;
    for mark in &views.marks {
        if let Some(ahead) = views.path[from..]
            .iter()
            .position(|point| *point == mark.at)
        {
            from += ahead;
            stops.push(from);
        }
    }
    stops.push(views.path.len() - 1);
    stops.dedup();
    stops
}
