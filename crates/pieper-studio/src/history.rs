//! Undo and redo: one step for each gesture.

/// The most steps kept.
const MOST: usize = 200;

#[derive(Clone, Debug)]
struct Step<S> {
    label: String,
    /// The state before.
    before: S,
}

/// States that can be gone back to, and forward again.
#[derive(Clone, Debug)]
pub(crate) struct History<S> {
    past: Vec<Step<S>>,
    future: Vec<Step<S>>,
    gesture: Option<String>,
}

impl<S> Default for History<S> {
    fn default() -> Self {
        Self {
            past: Vec::new(),
            future: Vec::new(),
            gesture: None,
        }
    }
}

impl<S> History<S> {
    /// Keeps the state before a change. Changes of one gesture are one step, named by its first.
    pub(crate) fn remember(&mut self, label: &str, gesture: Option<&str>, before: S) {
        let goes_on = gesture.is_some() && self.gesture.as_deref() == gesture;
        self.gesture = gesture.map(str::to_owned);
        if goes_on {
            return;
        }
        self.future.clear();
        if self.past.len() == MOST {
            self.past.remove(0);
        }
        self.past.push(Step {
            label: label.to_owned(),
            before,
        });
    }

    /// Names the step that goes on by what it has become.
    pub(crate) fn rename(&mut self, label: String) {
        if let Some(step) = self.past.last_mut() {
            step.label = label;
        }
    }

    /// Goes back a step from the state `now`.
    pub(crate) fn undo(&mut self, now: S) -> Option<(String, S)> {
        let step = self.past.pop()?;
        self.gesture = None;
        self.future.push(Step {
            label: step.label.clone(),
            before: now,
        });
        Some((step.label, step.before))
    }

    /// Goes forward again.
    pub(crate) fn redo(&mut self, now: S) -> Option<(String, S)> {
        let step = self.future.pop()?;
        self.gesture = None;
        self.past.push(Step {
            label: step.label.clone(),
            before: now,
        });
        Some((step.label, step.before))
    }

    /// What would be undone, and redone.
    pub(crate) fn labels(&self) -> [Option<&str>; 2] {
        [&self.past, &self.future].map(|steps| steps.last().map(|step| step.label.as_str()))
    }
}
