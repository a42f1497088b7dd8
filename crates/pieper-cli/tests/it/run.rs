//! `pieper run`, from a table to every file.

use std::fs;

use serde_json::Value;

use crate::support::{Temporary, pieper};

const FIGURES: [&str; 7] = ["joints", "rates", "arm", "path", "i", "j", "k"];

fn files() -> Vec<String> {
    let figures = FIGURES
        .iter()
        .flat_map(|name| ["svg", "png"].map(|ending| format!("{name}.{ending}")));
    let rest = [
        "matrices.txt",
        "matrices.tex",
        "matrices.json",
        "samples.csv",
        "poses.csv",
        "report.html",
    ];
    figures.chain(rest.map(str::to_owned)).collect()
}

/// Runs a motion and gives the JSON document of it.
fn document(arguments: &[&str]) -> Value {
    let ended = pieper(&[&["run"], arguments, &["--json"]].concat());
    assert_eq!(
        (ended.code, ended.stderr.as_str()),
        (0, ""),
        "{arguments:?}"
    );
    serde_json::from_str(&ended.stdout).expect("one JSON document")
}

#[test]
fn the_papers_programme_leaves_every_file() {
    let folder = Temporary::new();
    let out = folder.path("new/ar3");
    let ended = pieper(&["run", "ar3", "examples/ar3-programme.csv", "--out", &out]);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    assert!(
        ended.stdout.starts_with(
            "Annin Robotics AR3: 6 s, 7 reference positions, 301 samples\n20 files in "
        )
    );
    assert!(ended.stdout.ends_with("report.html\n"));
    for name in files() {
        let content = fs::read(format!("{out}/{name}")).expect(&name);
        assert!(content.len() > 1000, "{name} is nearly empty");
    }
    let written = fs::read_dir(&out).unwrap().count();
    assert_eq!(written, files().len(), "nothing else was written");
}

#[test]
fn figures_are_pictures_and_the_report_refers_to_nothing_outside() {
    let folder = Temporary::new();
    let out = folder.path("out");
    document(&["ar3", "examples/ar3-programme.csv", "--out", &out]);
    for name in FIGURES {
        let png = fs::read(format!("{out}/{name}.png")).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&png))
            .read_info()
            .expect(name);
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).expect(name);
        assert!(
            frame.width >= 1000 && frame.height >= 500,
            "{name} {frame:?}"
        );
        let colours: std::collections::HashSet<_> = pixels.chunks(4).collect();
        assert!(colours.len() > 10, "{name} is blank");
        let svg = fs::read_to_string(format!("{out}/{name}.svg")).unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    }
    let html = fs::read_to_string(format!("{out}/report.html")).unwrap();
    for outside in [
        "http:",
        "https:",
        "src=",
        "url(",
        "@import",
        "<script",
        "<link rel=\"stylesheet\"",
    ] {
        let found = html.match_indices(outside).find(|(at, _)| {
            !html[*at..].starts_with("http://www.w3.org/") && !html[*at..].starts_with("url(#")
        });
        assert_eq!(
            found,
            None,
            "{}",
            &html[found.map_or(0, |(at, _)| at)..][..40]
        );
    }
    for text in [
        "T₆(6)",
        "Figure 7.",
        "Direction cosines",
        "The AR3 paper",
        "All 301 rows",
    ] {
        assert!(html.to_lowercase().contains(&text.to_lowercase()), "{text}");
    }
    assert!(!html.contains("Limits exceeded"));
}

#[test]
fn matrices_are_the_papers_in_every_form() {
    let folder = Temporary::new();
    let out = folder.path("out");
    let document = document(&["ar3", "examples/ar3-programme.csv", "--out", &out]);
    let file: Value =
        serde_json::from_str(&fs::read_to_string(format!("{out}/matrices.json")).unwrap()).unwrap();
    assert_eq!(document["marks"], file["marks"]);
    // Position 5 of the paper: n = (0, 0, -1), s = (0, 1, 0), a = (1, 0, 0), p = (0.301, 0.0777, 0.469).
    let expected = [
        [0., 0., 1., 0.301],
        [0., 1., 0., 0.0777],
        [-1., 0., 0., 0.469],
        [0., 0., 0., 1.],
    ];
    for (row, expected) in expected.iter().enumerate() {
        for (column, expected) in expected.iter().enumerate() {
            let given = file["marks"][5]["pose"][row][column].as_f64().unwrap();
            assert!((given - expected).abs() <= 1e-15, "{given} {expected}");
        }
    }
    let text = fs::read_to_string(format!("{out}/matrices.txt")).unwrap();
    assert!(text.contains("T6(5), t = 5 s, q = (-90 deg, 90 deg, 90 deg, 90 deg, 90 deg, 0 deg)\n   0.000000  0.000000  1.000000  0.301000\n"));
    let latex = fs::read_to_string(format!("{out}/matrices.tex")).unwrap();
    assert!(latex.contains(
        "  T_{6}(5) = \\begin{bmatrix}\n    0 & 0 & 1 & 0.301 \\\\\n    0 & 1 & 0 & 0.0777 \\\\\n"
    ));
}

#[test]
fn samples_read_back_as_a_motion() {
    let folder = Temporary::new();
    let out = folder.path("out");
    let first = document(&[
        "ar3",
        "examples/ar3-programme.csv",
        "--out",
        &out,
        "--rate",
        "20",
        "--profile",
        "cubic",
    ]);
    let text = fs::read_to_string(format!("{out}/samples.csv")).unwrap();
    assert!(text.starts_with(
        "t,mark,q1,q2,q3,q4,q5,q6,x,y,z,ix,iy,iz,jx,jy,jz,kx,ky,kz\n0,0,0,0,0,0,0,0,"
    ));
    assert_eq!(text.lines().count(), 122);
    assert!(!text.contains("-0,"), "no negative zeros");
    let table: String = text
        .lines()
        .map(|line| line.split(',').take(8).collect::<Vec<_>>().join(",") + "\n")
        .collect();
    let motion = folder.file("samples.csv", &table);
    let again = document(&["ar3", &motion, "--out", &out, "--rate", "20"]);
    assert_eq!(first["marks"], again["marks"]);
}

#[test]
fn every_kind_of_arm_runs() {
    let folder = Temporary::new();
    let many: String = (0..=200)
        .map(|k| format!("{},{}\n", 0.01 * f64::from(k), 0.01 * f64::from(k)))
        .collect();
    for (robot, table) in [
        ("iiwa7", "t,A1_deg,A2,A3,A4,A5,A6,A7,mark\n0,0,0,0,0,0,0,0,\n2,20,1,-1,1,-1,1,-1,\n".to_owned()),
        ("cobra600", "t,q1,q2,q3_mm,q4,mark\n0,0,0,0,0,home\n1,1,1,150,1,a & b <c> #1_$%\n1.5,0,0,0,0,\n".to_owned()),
        ("gantry", "t,q1,q2,q3,q4,q5,q6\n0,0,0,0,0,0,0\n".to_owned()),
        (&*folder.file("one.toml", "name = 'one'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5"), format!("t,q1\n{many}")),
        (&*folder.file("s.toml", "name = 'screw'\n[[screws]]\nh = [0, 0, 1]\np = [0, 0, 0.2]\n[tool]\nxyz = [0.3, 0, 0]"), format!("t,q1\n{many}")),
    ] {
        let motion = folder.file("motion.csv", &table);
        let out = folder.path("out");
        for profile in ["linear", "trapezoid"] {
            document(&[robot, &motion, "--out", &out, "--profile", profile]);
        }
        let latex = fs::read_to_string(format!("{out}/matrices.tex")).unwrap();
        if robot == "cobra600" {
            assert!(latex.contains("(\\text{a \\& b \\textless{}c\\textgreater{} \\#1\\_\\$\\%})"));
            let html = fs::read_to_string(format!("{out}/report.html")).unwrap();
            assert!(html.contains("a &amp; b &lt;c&gt; #1_$%") && !html.contains("<c>"));
        }
    }
}

#[test]
fn limits_are_told_in_the_report_and_on_request() {
    let folder = Temporary::new();
    let motion = folder.file(
        "m.csv",
        "t,q1_deg,q2,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,0\n1,175,0,0,0,0,0,0\n",
    );
    let out = folder.path("out");
    let run = ["run", "iiwa7", &motion, "--out", &out];
    let ended = pieper(&run);
    assert_eq!((ended.code, ended.stderr.as_str()), (0, ""));
    assert!(
        ended
            .stdout
            .contains("\n2 limits are exceeded: see the report; --limits names them\n")
    );
    let ended = pieper(&[&run[..], &["--limits"]].concat());
    assert_eq!(
        ended.stderr,
        "warning: A1 is 175° at t = 1 s, its limit is 170°\n\
         warning: the rate of A1 gets to 175 °/s in the move that begins at t = 0 s, its limit is 98 °/s\n"
    );
    let html = fs::read_to_string(format!("{out}/report.html")).unwrap();
    assert!(
        html.contains("Limits exceeded")
            && html.contains("<li>A1 is 175° at t = 1 s, its limit is 170°.</li>")
    );
}

/// A bad call: exit code 2, nothing on standard output, and this on standard error.
fn refused(arguments: &[&str], expected: &str) {
    let ended = pieper(arguments);
    assert_eq!(
        (ended.code, ended.stdout.as_str()),
        (2, ""),
        "{arguments:?}"
    );
    assert_eq!(ended.stderr, format!("error: {expected}\n"));
}

#[test]
fn bad_input_is_named() {
    let folder = Temporary::new();
    let (out, good) = (folder.path("out"), "examples/ar3-programme.csv");
    let run =
        |motion: &str, expected: &str| refused(&["run", "ar3", motion, "--out", &out], expected);
    let bad = folder.file("bad.csv", "t,q1,q2,q3,q4,q5,q6\n0,0,0,0,0,x,0\n");
    run(
        &bad,
        &format!("{bad}:2:11: q5 = \"x\": a number was expected"),
    );
    let path = folder.file(
        "path.csv",
        "t,x,y,z,roll,pitch,yaw\n0,0.3,0,0.3,0,0,0\n1,0.3,0,0.3,0,0,3.141592653589793\n",
    );
    run(
        &path,
        "the rows at t = 0 s and t = 1 s: the tool turns by half a turn, and either way round is as short: a row between them was expected",
    );
    let path = folder.file("path.csv", "t,x,y,z,roll,pitch,yaw\n0,0.3,0,0.3,0,0,0\n");
    let wish = |flag: &[&str], expected: &str| {
        refused(
            &[&["run", "ar3", &path, "--out", &out][..], flag].concat(),
            expected,
        );
    };
    wish(
        &["--tolerance", "0"],
        "tolerance 0: a finite number above 0 was expected",
    );
    wish(
        &["--start", "0,x"],
        "--start 0,x: numbers separated by commas were expected",
    );
    wish(
        &["--start", "0,1"],
        "--start: joint values: 6 were expected (J1, J2, J3, J4, J5, J6), 2 were given",
    );
    let missing = folder.path("none.csv");
    run(
        &missing,
        &format!("{missing}: it could not be read: No such file or directory (os error 2)"),
    );
    refused(
        &["run", "ar3", good, "--out", &bad],
        &format!("{bad}: a folder to write to was expected, this is a file"),
    );
    refused(
        &["run", "ar3", good, "--out", &out, "--rate", "0"],
        "--rate: rate 0: a number of samples per second above 0 was expected",
    );
    refused(
        &["run", "ar3", good, "--out", &out, "--rate", "1e9"],
        "--rate: 1000000000 samples per second over 6 s: at most 2000000 samples were expected",
    );
    refused(
        &["run", "six-axis", good, "--out", &out],
        "Generic six-axis arm: numbers are needed for the parameters d1, a2, d4, d6: give them with --set NAME=VALUE",
    );
    assert!(
        !fs::exists(&out).unwrap(),
        "nothing was written for a bad call"
    );
}

#[test]
fn motors_that_cannot_follow_are_named() {
    let folder = Temporary::new();
    let (table, out) = (folder.path("table.csv"), folder.path("out"));
    // The crank of joint 3 leaves its window first; joint 5 follows at once.
    let text = "t,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n0,0,90,0,0,10,0\n1,0,90,-55,0,10,0\n2,0,90,-55,0,120,0\n";
    fs::write(&table, text).unwrap();
    let run = [
        "run",
        "abb-paper",
        &table,
        "--out",
        &out,
        "--rate",
        "10",
        "--json",
    ];
    let ended = pieper(&run);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let document: Value = serde_json::from_str(&ended.stdout).unwrap();
    let warnings = document["warnings"].to_string();
    let motors = fs::read_to_string(format!("{out}/motors.csv")).unwrap();
    let lines: Vec<&str> = motors.lines().collect();
    assert_eq!((lines[0], lines.len()), ("t,m1,m2,m3,m4,m5,m6", 22));
    for (motor, column) in [("m3", 3), ("m5", 5)] {
        let empty = lines
            .iter()
            .filter(|line| line.split(',').nth(column) == Some(""));
        let count = empty.count();
        assert!(count > 0, "{motors}");
        let sentence = format!("{count} samples are out of this drive's reach");
        assert!(
            warnings.contains(motor) && warnings.contains(&sentence),
            "{warnings}"
        );
    }
}
