//! Going to a place within rates and accelerations.

/// The longest step that the way is computed in, seconds.
const STEP: f64 = 0.01;

/// Joints on their way to a target; all of them arrive together where they start from rest.
#[derive(Clone, Debug)]
pub(super) struct Follower {
    target: Vec<f64>,
    rate: Vec<f64>,
    /// The shares of rate and acceleration that let the joints arrive together.
    share: Vec<f64>,
}

impl Follower {
    pub(super) fn new(dof: usize) -> Self {
        Self {
            target: vec![0.0; dof],
            rate: vec![0.0; dof],
            share: vec![1.0; dof],
        }
    }

    /// Rest at `q`.
    pub(super) fn rest(&mut self, q: &[f64]) {
        self.target.copy_from_slice(q);
        self.rate.fill(0.0);
    }

    /// A new target, seen from `q`.
    pub(super) fn aim(&mut self, q: &[f64], target: &[f64], rates: &[f64]) {
        self.target.copy_from_slice(target);
        let is_at_rest = self.rate.iter().all(|rate| *rate == 0.0);
        let time = |joint: usize| (target[joint] - q[joint]).abs() / rates[joint];
        let longest = (0..q.len()).map(time).fold(0.0, f64::max);
        for joint in 0..q.len() {
            // On the move every joint goes as fast as it may: a share could keep it from stopping in time.
            self.share[joint] = match is_at_rest && longest > 0.0 {
                true => (time(joint) / longest).max(1e-3),
                false => 1.0,
            };
        }
    }

    /// Whether it has arrived.
    pub(super) fn is_there(&self, q: &[f64]) -> bool {
        self.target == q && self.rate.iter().all(|rate| *rate == 0.0)
    }

    /// Moves `q` on by `seconds`.
    pub(super) fn advance(
        &mut self,
        q: &mut [f64],
        seconds: f64,
        rates: &[f64],
        accelerations: &[f64],
    ) {
        let steps = (seconds / STEP).ceil().max(1.0);
        let dt = seconds / steps;
        for _ in 0..steps as usize {
            for joint in 0..q.len() {
                let share = self.share[joint];
                let bounds = [rates[joint] * share, accelerations[joint] * share];
                let (place, rate) =
                    step(q[joint], self.rate[joint], self.target[joint], bounds, dt);
                (q[joint], self.rate[joint]) = (place, rate);
            }
        }
    }
}

/// One step towards a target: as fast as still allows stopping there.
fn step(q: f64, rate: f64, target: f64, [limit, acceleration]: [f64; 2], dt: f64) -> (f64, f64) {
    let way = target - q;
    let gain = acceleration * dt;
    // From here the joint can stop on the way if it goes no faster than this, in steps of dt.
    let stopping = (gain * gain * 0.25 + 2.0 * acceleration * way.abs()).sqrt() - gain * 0.5;
    let wish = way.signum() * stopping.min(limit).min(way.abs() / dt);
    let next = wish.clamp(rate - gain, rate + gain).clamp(-limit, limit);
    let place = next.mul_add(dt, q);
    let is_past = (target - place) * way <= 0.0;
    match is_past && next.abs() <= gain {
        true => (target, 0.0),
        false => (place, next),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_arrives_within_its_bounds_whatever_is_asked_on_the_way() {
        let mut random = 12_345_u64;
        let mut next = move || {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (random >> 33) as f64 / f64::from(u32::MAX >> 1) * 2.0 - 1.0
        };
        let (rates, accelerations) = ([1.0, 0.3, 2.0], [4.0, 1.0, 9.0]);
        for _ in 0..300 {
            let mut q = [0.0; 3];
            let mut follower = Follower::new(3);
            follower.rest(&q);
            let mut before = [0.0; 3];
            for tick in 0..4000 {
                // The target jumps about for a while, and then stays.
                if tick % 37 == 0 && tick < 400 {
                    let target = [next(), next(), next()];
                    follower.aim(&q, &target, &rates);
                }
                let was = q;
                let dt = 0.004;
                follower.advance(&mut q, dt, &rates, &accelerations);
                for joint in 0..3 {
                    let rate = (q[joint] - was[joint]) / dt;
                    assert!(rate.abs() <= rates[joint] * (1.0 + 1e-9), "{rate}");
                    let acceleration = (rate - before[joint]) / dt;
                    // The last step of a move may be shorter than its rate.
                    assert!(
                        acceleration.abs() <= accelerations[joint] * 2.0 + 1e-9,
                        "{acceleration} at tick {tick}"
                    );
                    before[joint] = rate;
                }
            }
            assert!(follower.is_there(&q), "{q:?} {:?}", follower.target);
        }
    }
}
