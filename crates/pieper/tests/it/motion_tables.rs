//! Motion tables: what reads, and mistakes by name with their place.

use nalgebra::Vector3;
use pieper::describe::{MotionTable, MotionValues};
use pieper::model::Chain;
use std::f64::consts::{FRAC_PI_2, PI};

fn chain(id: &str) -> Chain {
    pieper_robots::find(id).unwrap().robot().chain().unwrap()
}

fn joints(id: &str, text: &str) -> Vec<Vec<f64>> {
    match MotionTable::from_csv("m.csv", text, &chain(id))
        .unwrap()
        .values
    {
        MotionValues::Joints(rows) => rows,
        other => panic!("{other:?}"),
    }
}

/// The SCARA: joint_1 and joint_2 turn, joint_3 slides, joint_4 turns.
const HEAD: &str = "t,q1,q2,q3,q4\n";

#[test]
fn joints_read_by_number_and_by_name_in_any_unit_and_order() {
    let expected = vec![vec![PI, -FRAC_PI_2, 0.15, 2.0]];
    for text in [
        "t,q1,q2,q3,q4\n0,3.141592653589793,-1.5707963267948966,0.15,2\n",
        "q1_deg,t,q2_deg,q3_mm,q4\n180,0,-90,150,2",
        "t,joint_1_deg,joint_2_deg,joint_3_mm,joint_4\n0,180,-90,150,2\n",
        "\u{feff}t,q1_deg,q2_deg,q3,q4\r\n0,180,-90,.15,+2e0\r\n",
        "# a motion\n\n  # of one row\nt , q1_deg,\"q2_deg\",q3_mm,q4\n\n 0 ,\"180\", -90\t, 150 , 2\n# end",
    ] {
        assert_eq!(joints("cobra600", text), expected, "{text}");
    }
}

#[test]
fn marks_are_names_and_may_be_quoted() {
    let text =
        "t,mark,q1,q2,q3,q4\n0,home,0,0,0,0\n1,,0,0,0,0\n2,\"over \"\"A\"\", high\",0,0,0,0\n";
    let table = MotionTable::from_csv("m.csv", text, &chain("cobra600")).unwrap();
    let expected = [(0, "home".to_owned()), (2, "over \"A\", high".to_owned())];
    assert_eq!(table.reference_positions(), expected);
    let text = format!("{HEAD}0,0,0,0,0\n0.5,0,0,0,0\n");
    let table = MotionTable::from_csv("m.csv", &text, &chain("cobra600")).unwrap();
    assert_eq!(
        table.reference_positions(),
        [(0, "0".to_owned()), (1, "1".to_owned())]
    );
}

#[test]
fn tool_poses_and_tool_points_are_told_from_joints() {
    let read = |id: &str, text: &str| {
        MotionTable::from_csv("m.csv", text, &chain(id))
            .unwrap()
            .values
    };
    let MotionValues::Poses(by_angles) = read(
        "ar3",
        "t,x_mm,y,z,roll,pitch,yaw_deg\n0,100,0.2,0.3,0,0,90\n",
    ) else {
        panic!("poses were expected");
    };
    let MotionValues::Poses(by_quaternion) = read(
        "ar3",
        "t,x,y,z,qw,qx,qy,qz\n0,0.1,0.2,0.3,0.7071067811865476,0,0,0.7071067811865476\n",
    ) else {
        panic!("poses were expected");
    };
    let MotionValues::Points(points) = read(
        "ar3",
        "t,Dx,Dy,Dz,Kx,Ky,Kz,Ex,Ey,Ez\n0,0.1,0.2,0.3,0.1,0.2,0.5,-0.3,0.2,0.4\n",
    ) else {
        panic!("points were expected");
    };
    assert_eq!(points[0].on_z, Vector3::new(0.1, 0.2, 0.5));
    for pose in [by_quaternion[0], points[0].pose] {
        let off = (pose.to_homogeneous() - by_angles[0].to_homogeneous()).amax();
        assert!(off < 1e-15, "{off:e}");
    }
    // A gantry's joints are called x, y, z, roll, pitch, turn: only the whole of a pose's header is a pose.
    let text = "t,x,y,z,roll,pitch,turn\n0,1,2,3,0,0,0\n";
    assert!(matches!(read("gantry", text), MotionValues::Joints(_)));
}

fn check(text: &str, expected: &str) {
    let error = MotionTable::from_csv("m.csv", text, &chain("cobra600"))
        .expect_err(text)
        .to_string();
    assert_eq!(error, expected, "for the table\n{text}");
}

fn check_rows(rows: &str, expected: &str) {
    check(&format!("{HEAD}{rows}"), expected);
}

#[test]
fn mistakes_in_the_header_are_named() {
    let all = "t, q1, q2, q3, q4 (or joint_1, joint_2, joint_3, joint_4) and mark were expected, \
               angles also with _deg and lengths with _mm";
    check("", "m.csv: a header was expected, such as t,q1,q2,q3,mark");
    check(
        "# only\n\n",
        "m.csv: a header was expected, such as t,q1,q2,q3,mark",
    );
    check(HEAD, "m.csv: a row of values was expected below the header");
    check(
        "t,q1,q2,q3,q4,q5\n",
        &format!("m.csv:1:15: \"q5\": an unknown column: {all}"),
    );
    check(
        "# x\nt,q1,,q3,q4\n",
        &format!("m.csv:2:6: \"\": an unknown column: {all}"),
    );
    check(
        "t;q1;q2;q3;q4\n",
        "m.csv:1:1: \"t;q1;q2;q3;q4\": columns separated by commas were expected, not by ';'",
    );
    check(
        "q1,q2,q3,q4\n",
        "m.csv:1: a column t was expected: the time in seconds",
    );
    check(
        "t,q1,q2,q4\n",
        "m.csv:1: a column q3 or joint_3 was expected",
    );
    check(
        "t,q1,q2,q3_deg,q4\n",
        "m.csv:1:9: \"q3_deg\": this is a length: metres, or millimetres with _mm, were expected",
    );
    check(
        "t,q1_mm,q2,q3,q4\n",
        "m.csv:1:3: \"q1_mm\": this is an angle: radians, or degrees with _deg, were expected",
    );
    check(
        "t,q1,joint_1_deg,q2\n",
        "m.csv:1:6: \"joint_1_deg\": a second column for what the column q1 holds",
    );
    check(
        "t,mark,q1,mark\n",
        "m.csv:1:11: \"mark\": a second column for what the column mark holds",
    );
    check(
        "t,\"q1,q2\n0,1",
        "m.csv:1:3: \"\\\"q1,q2\": a closing quote was expected",
    );
    check(
        "t,\"q1\"x,q2\n",
        "m.csv:1:7: \"x,q2\": a comma or the end of the line was expected after the closing quote",
    );
    check("t,x,y,z,roll,pitch\n", "m.csv:1: a column yaw was expected");
    check(
        "t,x,y,z,qw,qx,qy,qz,q1\n",
        "m.csv:1:21: \"q1\": an unknown column: t, x, y, z, qw, qx, qy, qz and mark were expected",
    );
    check(
        &",".repeat(2000),
        "m.csv:1:1001: \",,,,,,,,,,,,,,,,,,,,\": at most 1000 cells in a line were expected",
    );
}

#[test]
fn mistakes_in_rows_are_named() {
    check_rows(
        "0,0,0,zero,0\n",
        "m.csv:2:7: q3 = \"zero\": a number was expected",
    );
    check_rows(
        "0,0,0,,0\n",
        "m.csv:2:7: q3: a number was expected, the cell is empty",
    );
    check_rows(
        "0,NaN,0,0,0\n",
        "m.csv:2:3: q1 = \"NaN\": a finite number was expected",
    );
    check_rows(
        "0,0,-inf,0,0\n",
        "m.csv:2:5: q2 = \"-inf\": a finite number was expected",
    );
    check_rows(
        "0,1e400,0,0,0\n",
        "m.csv:2:3: q1 = \"1e400\": a finite number was expected",
    );
    check_rows(
        "0,1e300,0,0,0\n",
        "m.csv:2:3: q1 = \"1e300\": a number between -1e9 and 1e9 was expected",
    );
    check_rows(
        "0,0,0\n1,0,0,0,0\n",
        "m.csv:2:6: q3: a value was expected, the line ends after 3 of 5 cells",
    );
    check_rows(
        "0,0,0,0,0,7\n",
        "m.csv:2:11: \"7\": an extra cell: 5 were expected, as in the header",
    );
    check_rows(
        "0,0,0,0,0\n\n# x\n1,0,0,0,0\n1,0,0,0,0\n",
        "m.csv:6:1: t = \"1\": a time after 1 s, that of the row before, was expected",
    );
    check_rows(
        "2,0,0,0,0\n1.5,0,0,0,0\n",
        "m.csv:3:1: t = \"1.5\": a time after 2 s, that of the row before, was expected",
    );
    check_rows(
        &format!("0,{},0,0,0", "x".repeat(1000)),
        &format!(
            "m.csv:2:3: q1 = \"{}...\": a number was expected",
            "x".repeat(40)
        ),
    );
    check(
        "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,1,0,0\n",
        "m.csv:2: qw, qx, qy, qz: a quaternion of length 1 was expected, its length is 1.4142135623730951",
    );
    check(
        "t,Dx,Dy,Dz,Kx,Ky,Kz,Ex,Ey,Ez\n0,0,0,0,0,0,1,0,0,2\n",
        "m.csv:2: tool points: D, K and E are collinear: E was expected beside the line through D and K",
    );
}

#[test]
fn a_large_table_is_read_and_a_larger_one_refused() {
    let rows = |count: usize| {
        (0..count)
            .map(|k| format!("{k},0,0,0,0\n"))
            .collect::<String>()
    };
    let read = |count| {
        MotionTable::from_csv(
            "m.csv",
            &format!("{HEAD}{}", rows(count)),
            &chain("cobra600"),
        )
    };
    assert_eq!(read(100_000).unwrap().times.len(), 100_000);
    let error = read(1_000_001).unwrap_err().to_string();
    assert_eq!(error, "m.csv:1000002: at most 1000000 rows were expected");
}
