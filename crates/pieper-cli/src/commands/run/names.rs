//! How joints, numbers and marks are called in figures and reports.

use pieper::model::{Chain, Variable};

/// Digits below the line.
pub(super) fn subscript(number: usize) -> String {
    let lower = |digit: char| {
        let value = digit.to_digit(10).unwrap_or(0);
        char::from_u32(0x2080 + value).unwrap_or(digit)
    };
    number.to_string().chars().map(lower).collect()
}

/// `q₁`, with the joint's own name if that says more.
pub(super) fn joint(index: usize, variable: &Variable) -> String {
    let symbol = format!("q{}", subscript(index + 1));
    match says_more(&variable.name, index + 1) {
        true => format!("{symbol} {}", variable.name),
        false => symbol,
    }
}

/// Whether a name is more than a letter or the word joint with the joint's number.
fn says_more(name: &str, number: usize) -> bool {
    let Some(word) = name.strip_suffix(&number.to_string()) else {
        return true;
    };
    let word = word.trim_end_matches('_').to_ascii_lowercase();
    !(word.len() <= 1 || word == "joint")
}

/// The last frame's transform: `T₆`.
pub(super) fn transform(chain: &Chain) -> String {
    format!("T{}", subscript(chain.dof()))
}

/// At most so many decimals, without zeros at the end.
pub(super) fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    match text {
        "-0" => "0".to_owned(),
        text => text.to_owned(),
    }
}

/// "1 sample", "2 samples".
pub(super) fn count(number: usize, one: &str, more: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { more })
}

/// A formula as it is set in print: π, subscripts of joint variables, the true minus sign.
pub(super) fn formula(text: &str) -> String {
    let mut out = String::new();
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = match is_word(first) {
            true => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            false => first.len_utf8(),
        };
        let (token, after) = rest.split_at(length);
        match (token, token.strip_prefix('q').map(str::parse)) {
            ("pi", _) => out.push('π'),
            ("-", _) => out.push('\u{2212}'),
            (_, Some(Ok(number))) => out.push_str(&format!("q{}", subscript(number))),
            _ => out.push_str(token),
        }
        rest = after;
    }
    out
}
