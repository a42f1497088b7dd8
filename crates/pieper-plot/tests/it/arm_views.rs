//! Pictures of arms.

use pieper_plot::{ArmViews, Theme, arm_views};

use crate::sample::arms;

#[test]
fn every_position_has_its_picture() {
    for count in [1, 2, 3, 4, 5, 7, 9] {
        let svg = arm_views(&arms(count)).unwrap().to_svg(Theme::Page);
        assert_eq!(svg.matches("data-panel=\"position ").count(), count);
    }
}

#[test]
fn an_arm_of_one_point_is_a_picture_too() {
    let mut views = arms(1);
    views.path.clear();
    views.arms[0].points.truncate(1);
    assert!(arm_views(&views).is_ok());
}

#[test]
fn what_cannot_be_drawn_is_refused_with_its_place() {
    type Spoil = fn(&mut ArmViews);
    let cases: [(Spoil, &str); 5] = [
        (|v| v.arms.clear(), "arms"),
        (|v| v.arms[1].points.clear(), "arm 1"),
        (|v| v.arms[1].points[0][2] = f64::NAN, "arm 1: number 2"),
        (|v| v.arms[0].joints[0].axis[0] = f64::NAN, "arm 0"),
        (|v| v.path[0][0] = f64::INFINITY, "path"),
    ];
    for (spoil, expected) in cases {
        let mut views = arms(2);
        spoil(&mut views);
        let error = arm_views(&views).unwrap_err();
        assert!(
            error.is_input() && error.to_string().contains(expected),
            "{error}"
        );
    }
}
