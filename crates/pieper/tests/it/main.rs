//! The library's tests: identities, and independent ways to the same numbers.

mod ar3;
mod bad_robot_files;
mod batches;
mod derivatives;
mod descriptions;
mod golden;
mod hot_calls;
mod measures;
mod orientation;
mod support;
