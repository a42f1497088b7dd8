//! A macro's `params`: names, defaults, blocks.

/// A parameter of a macro.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parameter {
    /// Its name, without the stars of a block.
    pub(super) name: String,
    pub(super) kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// A value.
    Value {
        /// `^`: the caller's property of the same name, if it has one.
        forward: bool,
        /// The text of the default.
        default: Option<String>,
    },
    /// `*name`: an element; `**name`: its contents.
    Block { contents: bool },
}

/// The parameters in `name other:=default *block third:=^|default`; an error is the text that makes no sense.
pub(super) fn parse(text: &str) -> Result<Vec<Parameter>, String> {
    let mut parameters = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let end = rest
            .find(|c: char| c.is_whitespace() || c == ':' || c == '=')
            .unwrap_or(rest.len());
        let (name, after) = rest.split_at(end);
        if name.trim_start_matches('*').is_empty() {
            return Err(rest.to_owned());
        }
        let after = after.trim_start();
        let value = after.strip_prefix(":=").or_else(|| after.strip_prefix('='));
        let kind = if let Some(value) = value {
            let (kind, end) = default(value.trim_start());
            rest = end.trim_start();
            kind
        } else if after.starts_with(':') {
            return Err(rest.to_owned());
        } else {
            rest = after;
            Kind::Value {
                forward: false,
                default: None,
            }
        };
        let stars = name.len() - name.trim_start_matches('*').len();
        let kind = match stars {
            0 => kind,
            _ => Kind::Block {
                contents: stars > 1,
            },
        };
        parameters.push(Parameter {
            name: name[stars..].to_owned(),
            kind,
        });
    }
    Ok(parameters)
}

/// A default and what follows it.
fn default(text: &str) -> (Kind, &str) {
    let forwarded = text.strip_prefix('^');
    let forward = forwarded.is_some();
    let text = forwarded.map_or(text, |rest| rest.strip_prefix('|').unwrap_or(rest));
    let end = default_end(text);
    let default = Some(text[..end].to_owned()).filter(|d| !d.is_empty() || !forward);
    (Kind::Value { forward, default }, &text[end..])
}

/// A default ends at a space that stands neither in quotes nor in `${...}` or `$(...)`.
fn default_end(text: &str) -> usize {
    let mut closers: Vec<char> = Vec::new();
    let mut previous = ' ';
    for (at, c) in text.char_indices() {
        match closers.last() {
            Some(&closer) if c == closer => {
                closers.pop();
            }
            Some('\'' | '"') => {}
            _ => match c {
                '\'' | '"' => closers.push(c),
                '{' if previous == '$' || !closers.is_empty() => closers.push('}'),
                '(' if previous == '$' || !closers.is_empty() => closers.push(')'),
                _ if c.is_whitespace() && closers.is_empty() => return at,
                _ => {}
            },
        }
        previous = c;
    }
    text.len()
}
