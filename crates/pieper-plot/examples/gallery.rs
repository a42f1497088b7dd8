//! Writes sample figures and a report to a folder: the AR3's test programme.
//!
//!     cargo run -p pieper-plot --example gallery -- out/gallery
//!
//! The poses are computed here from the arm's Denavit-Hartenberg table; the crate itself only draws.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use std::{env, fs};

use pieper_plot::{
    Arm, ArmJoint, ArmViews, Figure, JointKind, Matrix, Panel, PathMark, PathViews, Report,
    Section, Series, Space, Table, Theme, TimeChart, TimeMark, ToolFrame, arm_views, path_views,
    time_chart,
};

type Pose = [[f64; 4]; 4];

/// Offset and sign of the joint angle, alpha, d, a.
const TABLE: [(f64, f64, f64, f64, f64); 6] = [
    (FRAC_PI_2, 1.0, FRAC_PI_2, 0.164, 0.079),
    (0.0, 1.0, 0.0, 0.0, 0.305),
    (FRAC_PI_2, -1.0, FRAC_PI_2, 0.0, 0.0),
    (0.0, 1.0, -FRAC_PI_2, 0.222, 0.0),
    (0.0, -1.0, FRAC_PI_2, 0.0, 0.0),
    (FRAC_PI_2, 1.0, FRAC_PI_2, 0.0777, 0.0),
];
const RATE: usize = 50;
const MARKS: usize = 7;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).unwrap_or_else(|| "out/gallery".into());
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;

    let times: Vec<f64> = (0..=6 * RATE).map(|k| k as f64 / RATE as f64).collect();
    let joints: Vec<[f64; 6]> = times.iter().map(|&time| programme(time)).collect();
    let tools: Vec<Pose> = joints.iter().map(|q| frames(q)[6]).collect();

    let chart = joint_chart(&times, &joints)?;
    let arms = arm_pictures(&joints, &tools)?;
    let path = path_of(&tools, "Path of the tool point", 3, Space::Positions)?;
    let [i, j, k] = [("i", 0), ("j", 1), ("k", 2)].map(|(name, column)| {
        path_of(
            &tools,
            &format!("Path of the unit vector {name}"),
            column,
            Space::Directions,
        )
    });
    let (i, j, k) = (i?, j?, k?);
    let sliders = two_panels()?;
    let figures = [
        ("joints", &chart),
        ("arm", &arms),
        ("path", &path),
        ("i", &i),
        ("j", &j),
        ("k", &k),
        ("panels", &sliders),
        ("scara", &scara()?),
        ("errors", &errors()?),
    ];
    for (name, figure) in figures {
        write(folder, name, figure)?;
    }
    for (name, figure) in degenerate()? {
        write(folder, name, &figure)?;
    }

    let report = Report::new("Annin Robotics AR3: test programme")
        .lead("Seven reference positions, one joint per second: what the arm does, from its table alone.")
        .fact("Joints", "6 revolute")
        .fact("Duration", "6 s")
        .fact("Samples", times.len().to_string())
        .fact("Reference positions", MARKS.to_string())
        .section(
            Section::new("Joint angles")
                .paragraph("Each joint starts when the previous one has arrived, and then holds. Joint 1 turns to −90°, all others to +90°.")
                .figure(&chart, "Joint angles over time; dashed lines mark the reference positions 0 to 6.")
                .table(angle_table(&times, &joints)),
        )
        .section(Section::new("The arm").figure(&arms, "The arm at each reference position, with the frame of the tool and the path of its point."))
        .section(
            Section::new("Path of the tool point")
                .paragraph("Positions in the frame of the base. The three projections have one scale.")
                .figure(&path, "Path of the tool point: axonometric view and projections."),
        )
        .section(
            Section::new("Orientation of the tool")
                .paragraph("The tool's unit vectors move on the unit sphere.")
                .figure(&i, "Path of the unit vector i.")
                .figure(&j, "Path of the unit vector j.")
                .figure(&k, "Path of the unit vector k."),
        )
        .section(
            Section::new("Poses at the reference positions")
                .paragraph("Columns n, s, a (the tool's axes) and p (its point, in metres) in the frame of the base.")
                .matrices(matrices(&tools)),
        )
        .footer("Written by the example gallery of pieper-plot.");
    fs::write(folder.join("report.html"), report.to_html())?;
    Ok(())
}

fn write(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    fs::write(
        folder.join(format!("{name}.svg")),
        figure.to_svg(Theme::Standalone),
    )?;
    fs::write(folder.join(format!("{name}.png")), figure.to_png(2.0)?)?;
    Ok(())
}

/// One joint per second, each by 90 degrees with a smooth start and stop.
fn programme(time: f64) -> [f64; 6] {
    [0, 1, 2, 3, 4, 5].map(|joint| {
        let share = (time - joint as f64).clamp(0.0, 1.0);
        let turn = FRAC_PI_2 * share * share * (3.0 - 2.0 * share);
        if joint == 0 { -turn } else { turn }
    })
}

/// The frames 0 to 6.
fn frames(q: &[f64; 6]) -> [Pose; 7] {
    let mut out = [[[0.0; 4]; 4]; 7];
    out[0] = [0, 1, 2, 3].map(|r| [0, 1, 2, 3].map(|c| f64::from(u8::from(r == c))));
    for (k, (offset, sign, alpha, d, a)) in TABLE.into_iter().enumerate() {
        let (s, c) = (offset + sign * q[k]).sin_cos();
        let (sa, ca) = alpha.sin_cos();
        let step = [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0.0, sa, ca, d],
            [0.0, 0.0, 0.0, 1.0],
        ];
        out[k + 1] = product(&out[k], &step);
    }
    out
}

fn product(a: &Pose, b: &Pose) -> Pose {
    [0, 1, 2, 3].map(|r| [0, 1, 2, 3].map(|c| (0..4).map(|k| a[r][k] * b[k][c]).sum()))
}

fn column(pose: &Pose, column: usize) -> [f64; 3] {
    [0, 1, 2].map(|row| pose[row][column])
}

fn joint_chart(times: &[f64], joints: &[[f64; 6]]) -> pieper_plot::Result<Figure> {
    let names = ["q₁", "q₂", "q₃", "q₄", "q₅", "q₆"];
    let series = names
        .into_iter()
        .enumerate()
        .map(|(k, name)| Series::new(name, joints.iter().map(|q| q[k].to_degrees()).collect()));
    time_chart(&TimeChart {
        title: "Joint angles of the AR3 over time".into(),
        times: times.to_vec(),
        panels: vec![Panel::new("Joint angle", "°", series.collect())],
        marks: (0..MARKS)
            .map(|k| TimeMark {
                label: k.to_string(),
                time: k as f64,
            })
            .collect(),
    })
}

fn arm_pictures(joints: &[[f64; 6]], tools: &[Pose]) -> pieper_plot::Result<Figure> {
    let arms = (0..MARKS).map(|mark| {
        let frames = frames(&joints[mark * RATE]);
        let mut points = vec![[0.0; 3]];
        for (k, row) in TABLE.iter().enumerate() {
            // A link's offset: first d along the joint's axis, then a across it.
            let (origin, axis) = (column(&frames[k], 3), column(&frames[k], 2));
            points.push([0, 1, 2].map(|n| origin[n] + row.3 * axis[n]));
            points.push(column(&frames[k + 1], 3));
        }
        points.dedup_by(|a, b| (0..3).all(|n| (a[n] - b[n]).abs() < 1e-9));
        Arm {
            label: mark.to_string(),
            note: format!("t = {mark} s"),
            points,
            joints: (0..6)
                .map(|k| ArmJoint {
                    at: column(&frames[k], 3),
                    axis: column(&frames[k], 2),
                    kind: JointKind::Revolute,
                })
                .collect(),
            tool: ToolFrame {
                at: column(&frames[6], 3),
                axes: [0, 1, 2].map(|axis| column(&frames[6], axis)),
            },
        }
    });
    arm_views(&ArmViews {
        title: "The AR3 at the reference positions".into(),
        arms: arms.collect(),
        path: tools.iter().map(|pose| column(pose, 3)).collect(),
    })
}

fn path_of(tools: &[Pose], title: &str, which: usize, space: Space) -> pieper_plot::Result<Figure> {
    let path: Vec<[f64; 3]> = tools.iter().map(|pose| column(pose, which)).collect();
    path_views(&PathViews {
        title: title.into(),
        axes: ["x₀".into(), "y₀".into(), "z₀".into()],
        space,
        marks: (0..MARKS)
            .map(|k| PathMark {
                label: k.to_string(),
                at: path[k * RATE],
            })
            .collect(),
        path,
    })
}

/// An arm with a sliding joint, alone in its figure.
fn scara() -> pieper_plot::Result<Figure> {
    let joint = |at, kind| ArmJoint {
        at,
        axis: [0.0, 0.0, 1.0],
        kind,
    };
    arm_views(&ArmViews {
        title: "A SCARA arm".into(),
        arms: vec![Arm {
            label: "home".into(),
            note: "q = (20°, 45°, 60 mm, 0°)".into(),
            points: vec![
                [0.0, 0.0, 0.0],
                [0.0, 0.0, 0.24],
                [0.23, 0.08, 0.24],
                [0.34, 0.26, 0.24],
                [0.34, 0.26, 0.08],
            ],
            joints: vec![
                joint([0.0, 0.0, 0.24], JointKind::Revolute),
                joint([0.23, 0.08, 0.24], JointKind::Revolute),
                joint([0.34, 0.26, 0.24], JointKind::Prismatic),
                joint([0.34, 0.26, 0.24], JointKind::Revolute),
            ],
            tool: ToolFrame {
                at: [0.34, 0.26, 0.08],
                axes: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]],
            },
        }],
        path: vec![],
    })
}

fn two_panels() -> pieper_plot::Result<Figure> {
    let times: Vec<f64> = (0..200).map(|k| 0.01 * f64::from(k)).collect();
    let wave = |f: f64, a: f64| times.iter().map(|t| a * (f * t).sin()).collect();
    time_chart(&TimeChart {
        title: "A turning and two sliding joints".into(),
        panels: vec![
            Panel::new(
                "Joint angle",
                "°",
                vec![Series::new("q₁", wave(3.0, 120.0))],
            ),
            Panel::new(
                "Joint travel",
                "mm",
                vec![
                    Series::new("q₂", wave(2.0, 80.0)),
                    Series::new("q₃", wave(5.0, 35.0)),
                ],
            ),
        ],
        marks: vec![
            TimeMark {
                label: "0".into(),
                time: 0.0,
            },
            TimeMark {
                label: "1".into(),
                time: 1.0,
            },
            TimeMark {
                label: "2".into(),
                time: 1.02,
            },
        ],
        times,
    })
}

/// What a later user draws: errors, whose numbers need powers of ten.
fn errors() -> pieper_plot::Result<Figure> {
    let times: Vec<f64> = (0..20_000).map(|k| 0.0005 * f64::from(k)).collect();
    let error = |size: f64, pace: f64| {
        let value = |t: &f64| size * ((pace * t).sin() + 0.4 * (97.0 * pace * t).sin());
        times.iter().map(value).collect()
    };
    time_chart(&TimeChart {
        title: "Tracking error of a very good arm".into(),
        panels: vec![
            Panel::new(
                "Position",
                "mm",
                vec![
                    Series::new("x₀", error(3e-5, 1.0)),
                    Series::new("y₀", error(1e-5, 1.7)),
                ],
            ),
            Panel::new(
                "Turn",
                "rad",
                vec![Series::new("about a", error(2e-9, 0.6))],
            ),
        ],
        marks: vec![
            TimeMark {
                label: "approach".into(),
                time: 2.0,
            },
            TimeMark {
                label: "weld".into(),
                time: 2.5,
            },
            TimeMark {
                label: "retract".into(),
                time: 8.0,
            },
        ],
        times,
    })
}

/// Paths without extent in one, two or all directions.
fn degenerate() -> pieper_plot::Result<Vec<(&'static str, Figure)>> {
    let views = |title: &str, path: Vec<[f64; 3]>| PathViews {
        title: title.into(),
        axes: ["x₀".into(), "y₀".into(), "z₀".into()],
        space: Space::Positions,
        marks: vec![
            PathMark {
                label: "0".into(),
                at: path[0],
            },
            PathMark {
                label: "1".into(),
                at: path[path.len() - 1],
            },
        ],
        path,
    };
    let line = (0..=50)
        .map(|k| [0.2 + 0.01 * f64::from(k), 0.3, 0.1])
        .collect();
    Ok(vec![
        (
            "point",
            path_views(&views("A tool at rest", vec![[0.3, -0.2, 0.5]; 3]))?,
        ),
        ("line", path_views(&views("A straight line", line))?),
    ])
}

fn angle_table(times: &[f64], joints: &[[f64; 6]]) -> Table {
    let head = ["t, s", "q₁, °", "q₂, °", "q₃, °", "q₄, °", "q₅, °", "q₆, °"];
    let rows = times.iter().zip(joints);
    rows.fold(Table::new("Joint angles", head), |table, (time, q)| {
        let angles = q.iter().map(|angle| format!("{:.3}", angle.to_degrees()));
        table.row([format!("{time:.2}")].into_iter().chain(angles))
    })
}

fn matrices(tools: &[Pose]) -> Vec<Matrix> {
    (0..MARKS)
        .map(|k| {
            Matrix::of_numbers(
                format!("T₆({k})"),
                format!("t = {k} s"),
                &tools[k * RATE],
                4,
            )
        })
        .collect()
}
