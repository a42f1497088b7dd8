//! Fair timing: contenders take turns on the same inputs, so that a machine whose speed drifts drifts for all.

use std::time::Instant;

/// One contender: a name, and a call that does `calls` operations on the shared inputs.
pub struct Contender<'a> {
    /// What the table calls it.
    pub name: &'a str,
    /// Operations in one call of `run`.
    pub calls: usize,
    /// Does them.
    pub run: Box<dyn FnMut() + 'a>,
}

impl<'a> Contender<'a> {
    /// A contender whose `run` does `calls` operations.
    pub fn new(name: &'a str, calls: usize, run: impl FnMut() + 'a) -> Self {
        Self { name, calls, run: Box::new(run) }
    }
}

/// A contender's times for one operation, nanoseconds.
pub struct Times {
    /// Its name.
    pub name: String,
    /// The median over the rounds.
    pub median: f64,
    /// The fastest round.
    pub fastest: f64,
}

/// Times the contenders in turns, `rounds` times.
pub fn race(contenders: &mut [Contender<'_>], rounds: usize) -> Vec<Times> {
    for contender in contenders.iter_mut() {
        (contender.run)();
    }
    let mut samples = vec![Vec::with_capacity(rounds); contenders.len()];
    for _ in 0..rounds {
        for (contender, samples) in contenders.iter_mut().zip(&mut samples) {
            let start = Instant::now();
            (contender.run)();
            samples.push(start.elapsed().as_nanos() as f64 / contender.calls as f64);
        }
    }
    let times = contenders.iter().zip(samples).map(|(contender, mut samples)| {
        samples.sort_by(f64::total_cmp);
        let name = contender.name.to_owned();
        Times { name, median: samples[samples.len() / 2], fastest: samples[0] }
    });
    times.collect()
}

/// Prints the times as a Markdown table, with ratios to the contender called `reference`.
pub fn print(title: &str, times: &[Times], reference: &str) {
    let base = times.iter().find(|times| times.name == reference).expect("the reference took part");
    println!("\n{title}\n");
    println!("| | median ns | fastest ns | median / {reference} |");
    println!("|---|---|---|---|");
    for times in times {
        let ratio = times.median / base.median;
        println!("| {} | {:.1} | {:.1} | 1/{:.1} ({ratio:.3}) |", times.name, times.median, times.fastest, 1.0 / ratio);
    }
}
