//! A list on the stack.

/// Up to N things.
#[derive(Clone, Debug)]
pub(super) struct List<T, const N: usize> {
    items: [T; N],
    count: usize,
    /// There were more.
    pub(super) overflowed: bool,
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    pub(super) fn new() -> Self {
        Self {
            items: [T::default(); N],
            count: 0,
            overflowed: false,
        }
    }

    /// Adds a thing, unless the list is full.
    pub(super) fn push(&mut self, item: T) {
        if self.count < N {
            self.items[self.count] = item;
            self.count += 1;
        } else {
            self.overflowed = true;
        }
    }
}

impl<T, const N: usize> std::ops::Deref for List<T, N> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.items[..self.count]
    }
}
