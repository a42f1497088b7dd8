//! Position problems in which joints slide: none is solved in closed form yet; such arms go to the numeric row.
use super::position::Reaches;
use crate::spatial::Pose;
#[derive(Clone, Copy, Debug)]
pub(super) struct Three;
impl Three {
    pub(super) fn new(_: [bool; 3], _: &Pose, _: &Pose, _: f64) -> Option<Self> {
        None
    }
    pub(super) fn solve(&self, _: [f64; 3], _: [f64; 3], _: f64, _: &mut Reaches) {}
}
