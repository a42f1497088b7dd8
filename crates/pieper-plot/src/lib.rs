//! Figures of robot motions: plain data in, SVG and PNG out, and a report page that holds them all.
//!
//! A crate of its own, because a bitmap renderer and a font are weight the library does not carry.
//! It knows nothing of kinematics: angles, paths and skeletons come in as numbers.
//!
//! ```
//! use pieper_plot::{Panel, Series, Theme, TimeChart, time_chart};
//!
//! let times: Vec<f64> = (0..=50).map(|k| 0.02 * f64::from(k)).collect();
//! let values = times.iter().map(|t| 90.0 * t * t * (3.0 - 2.0 * t)).collect();
//! let figure = time_chart(&TimeChart {
//!     title: "Joint angle".into(),
//!     times,
//!     panels: vec![Panel::new("Angle", "°", vec![Series::new("q₁", values)])],
//!     marks: vec![],
//! })?;
//! let svg = figure.to_svg(Theme::Standalone);
//! let png = figure.to_png(2.0)?;
//! # assert!(svg.starts_with("<svg") && png.starts_with(b"\x89PNG"));
//! # Ok::<(), pieper_plot::Error>(())
//! ```

mod error;

mod font;
mod ink;

mod png;
mod scene;
mod svg;

mod figure;

mod axes;
mod labels;
mod legend;
mod ticks;
mod view;

mod arm_views;
mod branch_chart;
mod path_views;
mod sphere;
mod time_chart;

mod report;

pub use arm_views::{Arm, ArmJoint, ArmViews, JointKind, ToolFrame, arm_views};
pub use branch_chart::{BranchChart, BranchLine, branch_chart};
pub use error::{Error, Result};
pub use figure::{Figure, Theme};
pub use path_views::{PathMark, PathViews, Space, path_views};
pub use report::{Matrix, Report, Section, Table};
pub use time_chart::{Panel, Series, TimeChart, TimeMark, chart_along, time_chart};
