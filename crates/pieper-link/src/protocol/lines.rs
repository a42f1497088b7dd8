//! Lines of text from a stream of bytes.

/// The longest line that is kept: no reply of these controllers is half as long.
const LONGEST: usize = 512;

/// Cuts a stream into lines, at `\r` and `\n`. What is too long to be a line is dropped, up to its end.
#[derive(Debug, Default)]
pub struct Lines {
    line: Vec<u8>,
    is_overlong: bool,
}

impl Lines {
    /// Takes bytes; every finished line goes to `take`, or the number of bytes of what was no line. Empty lines count.
    ///
    /// ```
    /// let mut lines = pieper_link::protocol::Lines::default();
    /// let mut got = Vec::new();
    /// lines.push(b"Do", |line| got.push(line.map(str::to_owned)));
    /// lines.push(b"ne\r\nA1", |line| got.push(line.map(str::to_owned)));
    /// assert_eq!(got, [Ok("Done".to_owned())]);
    /// assert_eq!(lines.rest(), b"A1");
    /// ```
    pub fn push(&mut self, bytes: &[u8], mut take: impl FnMut(Result<&str, usize>)) {
        for &byte in bytes {
            match byte {
                // A line's end may be \r\n, \n or \r: the second of two is an empty line to whoever reads.
                b'\n' => {
                    self.finish(&mut take);
                }
                b'\r' => {}
                _ if self.line.len() == LONGEST => self.is_overlong = true,
                _ => self.line.push(byte),
            }
        }
    }

    /// As [`Lines::push`], for whoever waits for replies: empty lines are left out, and what is no text comes as a sentence.
    pub(crate) fn texts(&mut self, bytes: &[u8], mut take: impl FnMut(Result<&str, String>)) {
        self.push(bytes, |line| match line {
            Ok("") => {}
            Ok(line) => take(Ok(line)),
            Err(length) => take(Err(format!("{length} bytes that are no text"))),
        });
    }

    /// The line that has begun and not ended.
    pub fn rest(&self) -> &[u8] {
        &self.line
    }

    /// Ends the line here, as a controller that prints no end of line makes necessary.
    pub fn finish(&mut self, mut take: impl FnMut(Result<&str, usize>)) {
        let length = self.line.len();
        let text = std::str::from_utf8(&self.line).ok();
        let is_text = |text: &&str| text.bytes().all(|b| (b' '..=b'~').contains(&b));
        match text.filter(is_text).filter(|_| !self.is_overlong) {
            Some(line) => take(Ok(line)),
            None => take(Err(length)),
        }
        self.line.clear();
        self.is_overlong = false;
    }
}
