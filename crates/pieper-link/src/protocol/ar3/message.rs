//! What is said, both ways.

use std::fmt::Write as _;

/// Joints of the arm.
pub const JOINTS: usize = 6;

/// From a joint's negative to its positive limit: both in degrees, and the steps between, as the AR2's and AR3's calibration
/// file has them.
pub const STEPS: [([f64; 2], f64); JOINTS] = [
    ([-170.0, 170.0], 15200.0),
    ([-132.0, 0.0], 7300.0),
    ([1.0, 141.0], 7850.0),
    ([-165.0, 165.0], 15200.0),
    ([-105.0, 105.0], 4575.0),
    ([-155.0, 155.0], 6625.0),
];

/// The step count of a joint at an angle in radians.
pub fn steps(joint: usize, angle: f64) -> i32 {
    let ([lower, upper], count) = STEPS[joint];
    ((angle.to_degrees() - lower) / (upper - lower) * count).round() as i32
}

/// The angle of a joint in radians at a step count.
///
/// ```
/// use pieper_link::protocol::ar3::{angle, steps};
/// assert_eq!(steps(0, 0.0), 7600);
/// assert!((angle(1, 7300) - 0.0).abs() < 1e-12);
/// ```
pub fn angle(joint: usize, steps: i32) -> f64 {
    let ([lower, upper], count) = STEPS[joint];
    (lower + f64::from(steps) * (upper - lower) / count).to_radians()
}

/// What the program says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ask {
    /// `GP`: compare your encoders with these counts, without moving.
    Compare([i32; JOINTS]),
    /// `MJ`: make these steps, and be at these counts afterwards.
    Move {
        /// Steps from here.
        by: [i32; JOINTS],
        /// Percent of the full speed, 1 to 100.
        speed: u8,
        /// The counts afterwards.
        to: [i32; JOINTS],
    },
}

const COUNT_TAGS: [char; JOINTS] = ['U', 'V', 'W', 'X', 'Y', 'Z'];
const JOINT_TAGS: [char; JOINTS] = ['A', 'B', 'C', 'D', 'E', 'F'];

/// Ramps as the desktop program's defaults: duration and speed while speeding up and slowing down, in percent.
const RAMPS: &str = "G15H10I20K5";

impl Ask {
    /// The line, without its end. The direction digit is 1 for more steps.
    pub fn write(&self) -> String {
        let mut line = String::new();
        let counts = match self {
            Self::Compare(counts) => {
                line.push_str("GP");
                counts
            }
            Self::Move { by, speed, to } => {
                line.push_str("MJ");
                for (tag, by) in JOINT_TAGS.iter().zip(by) {
                    let direction = u8::from(*by >= 0);
                    let _ = write!(line, "{tag}{direction}{}", by.abs());
                }
                let _ = write!(line, "T00S{speed}{RAMPS}");
                to
            }
        };
        for (tag, count) in COUNT_TAGS.iter().zip(counts) {
            let _ = write!(line, "{tag}{count}");
        }
        line
    }

    /// Reads a line. `None` for what is neither, or not well-formed.
    pub fn read(line: &str) -> Option<Self> {
        if let Some(rest) = line.strip_prefix("GP") {
            return Some(Self::Compare(tagged(rest, &COUNT_TAGS)?));
        }
        let rest = line.strip_prefix("MJ")?;
        let (joints, rest) = rest.split_at(rest.find('T')?);
        let by = tagged_with(joints, &JOINT_TAGS, |text| {
            let count: i32 = text.get(1..)?.parse().ok()?;
            match text.get(..1)? {
                "0" => Some(-count),
                "1" => Some(count),
                _ => None,
            }
        })?;
        let (speed, rest) = rest.split_once('S')?.1.split_once('G')?;
        let to = tagged(&rest[rest.find('U')?..], &COUNT_TAGS)?;
        let speed = speed
            .parse()
            .ok()
            .filter(|speed| (1..=100).contains(speed))?;
        Some(Self::Move { by, speed, to })
    }
}

fn tagged(text: &str, tags: &[char; JOINTS]) -> Option<[i32; JOINTS]> {
    tagged_with(text, tags, |text| text.parse().ok())
}

/// Six values behind their tags, which follow one another; nothing before and nothing after.
fn tagged_with(
    text: &str,
    tags: &[char; JOINTS],
    read: impl Fn(&str) -> Option<i32>,
) -> Option<[i32; JOINTS]> {
    let mut values = [0; JOINTS];
    let mut rest = text.strip_prefix(tags[0])?;
    for (index, place) in values.iter_mut().enumerate() {
        let (value, after) = match tags.get(index + 1) {
            Some(&tag) => rest.split_once(tag)?,
            None => (rest, ""),
        };
        *place = read(value)?;
        rest = after;
    }
    Some(values)
}

/// What the firmware answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reply {
    /// Every joint is where it should be; with the steps, in answer to `GP`.
    Agrees(Option<[i32; JOINTS]>),
    /// These joints are not, and where all of them are.
    Differs([bool; JOINTS], [i32; JOINTS]),
}

impl Reply {
    /// Reads a line: `00`, or `00` or `01` with six flags and the true steps.
    ///
    /// ```
    /// use pieper_link::protocol::ar3::Reply;
    /// let line = "00000000A7995B2321C9D7594E2277F3308";
    /// assert_eq!(Reply::read(line), Some(Reply::Agrees(Some([7995, 2321, 9, 7594, 2277, 3308]))));
    /// assert_eq!(Reply::read("00"), Some(Reply::Agrees(None)));
    /// ```
    pub fn read(line: &str) -> Option<Self> {
        if line == "00" {
            return Some(Self::Agrees(None));
        }
        let (verdict, rest) = line.split_at_checked(2)?;
        let (flags, counts) = rest.split_at_checked(JOINTS)?;
        let mut differs = [false; JOINTS];
        for (flag, digit) in differs.iter_mut().zip(flags.chars()) {
            *flag = match digit {
                '0' => false,
                '1' => true,
                _ => return None,
            };
        }
        let counts = tagged(counts, &JOINT_TAGS)?;
        match verdict {
            "00" => Some(Self::Agrees(Some(counts))),
            "01" => Some(Self::Differs(differs, counts)),
            _ => None,
        }
    }

    /// The line, without its end.
    pub fn write(&self) -> String {
        let (verdict, differs, counts) = match self {
            Self::Agrees(None) => return "00".to_owned(),
            Self::Agrees(Some(counts)) => ("00", &[false; JOINTS], counts),
            Self::Differs(differs, counts) => ("01", differs, counts),
        };
        let mut line = verdict.to_owned();
        line.extend(differs.iter().map(|&flag| if flag { '1' } else { '0' }));
        for (tag, count) in JOINT_TAGS.iter().zip(counts) {
            let _ = write!(line, "{tag}{count}");
        }
        line
    }
}
