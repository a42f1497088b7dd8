//! What the files must be, whatever they show: well-formed, complete, true to scale, deterministic.

mod arm_views;
mod path_views;
mod report;
mod sample;
mod svg;
mod time_chart;
