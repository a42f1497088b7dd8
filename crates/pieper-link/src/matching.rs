//! Matching a servo to its joint at extreme positions: where the joint is, and where the servo.

/// Where a joint was, and where its servo, at two places or more.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ends {
    places: Vec<[f64; 2]>,
}

/// How a servo follows its joint: `centre + sign * ratio * joint`, radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Match {
    /// The servo's angle where the joint is at zero.
    pub centre: f64,
    /// +1 if both turn the same way, otherwise -1.
    pub sign: f64,
    /// Servo turns for one of the joint.
    pub ratio: f64,
    /// The largest difference of a place from that line, of the servo.
    pub residual: f64,
}

/// Places nearer to one another than this say nothing of a ratio, radians.
const APART: f64 = 0.01;

impl Ends {
    /// The joint is at `joint` where the servo is at `servo`, radians.
    pub fn add(&mut self, joint: f64, servo: f64) {
        self.places.push([joint, servo]);
    }

    /// The line through the places, by least squares. `None` unless both joint and servo have moved.
    ///
    /// ```
    /// use pieper_link::matching::Ends;
    /// let mut ends = Ends::default();
    /// ends.add(-1.0, 2.5);
    /// assert_eq!(ends.solve(), None);
    /// ends.add(1.0, 0.5);
    /// let of = ends.solve().unwrap();
    /// assert_eq!((of.centre, of.sign, of.ratio), (1.5, -1.0, 1.0));
    /// ```
    pub fn solve(&self) -> Option<Match> {
        let count = self.places.len() as f64;
        let mean = |of: usize| self.places.iter().map(|place| place[of]).sum::<f64>() / count;
        let (joint, servo) = (mean(0), mean(1));
        let (mut both, mut square) = (0.0, 0.0);
        for [j, s] in &self.places {
            both += (j - joint) * (s - servo);
            square += (j - joint) * (j - joint);
        }
        if !(square.sqrt() > APART && both.abs() > APART * APART) {
            return None;
        }
        let slope = both / square;
        let centre = servo - slope * joint;
        let off = |[j, s]: &[f64; 2]| (slope.mul_add(*j, centre) - s).abs();
        Some(Match {
            centre,
            sign: slope.signum(),
            ratio: slope.abs(),
            residual: self.places.iter().map(off).fold(0.0, f64::max),
        })
    }
}
