//! What the files must be, whatever they show: well-formed, complete, true to scale, deterministic.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests are outside the functions marked as tests"
)]

mod arm_views;
mod branch_chart;
mod path_views;
mod report;
mod sample;
mod svg;
mod time_chart;
