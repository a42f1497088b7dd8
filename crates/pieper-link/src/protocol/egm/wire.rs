//! Protobuf's encoding of fields, as far as EGM uses it.

/// A field's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// Whole numbers, enumerations, truth values.
    Varint(u64),
    /// Eight bytes: here always a double.
    Double(f64),
    /// Text, bytes, a nested message, or packed numbers.
    Bytes(&'a [u8]),
    /// Four bytes: never ours, but it may be skipped.
    Fixed32(u32),
}

/// The longest list of packed or unpacked numbers that is looked at.
const NUMBERS: usize = super::JOINTS;

/// Reads the fields of a message, one after the other. Ends at the first byte that cannot be one, with [`Fields::is_broken`].
#[derive(Clone, Debug)]
pub struct Fields<'a> {
    rest: &'a [u8],
    is_broken: bool,
}

impl<'a> Fields<'a> {
    /// The fields of a message.
    pub fn of(bytes: &'a [u8]) -> Self {
        Self {
            rest: bytes,
            is_broken: false,
        }
    }

    /// Whether the bytes ended in the middle of a field, or had one that cannot be.
    pub fn is_broken(&self) -> bool {
        self.is_broken
    }

    fn varint(&mut self) -> Option<u64> {
        let mut value = 0_u64;
        for index in 0..10 {
            let (&byte, rest) = self.rest.split_first()?;
            self.rest = rest;
            let bits = u64::from(byte & 0x7f);
            // Of the tenth byte only one bit has room.
            if index == 9 && bits > 1 {
                return None;
            }
            value |= bits << (7 * index);
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
        None
    }

    fn field(&mut self) -> Option<(u32, Value<'a>)> {
        let tag = self.varint()?;
        let number = u32::try_from(tag >> 3).ok().filter(|&number| number > 0)?;
        let value = match tag & 7 {
            0 => Value::Varint(self.varint()?),
            1 => {
                let (bytes, rest) = self.rest.split_first_chunk::<8>()?;
                self.rest = rest;
                Value::Double(f64::from_le_bytes(*bytes))
            }
            2 => {
                let length = usize::try_from(self.varint()?).ok()?;
                let (bytes, rest) = self.rest.split_at_checked(length)?;
                self.rest = rest;
                Value::Bytes(bytes)
            }
            5 => {
                let (bytes, rest) = self.rest.split_first_chunk::<4>()?;
                self.rest = rest;
                Value::Fixed32(u32::from_le_bytes(*bytes))
            }
            // Groups are older than EGM.
            _ => return None,
        };
        Some((number, value))
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = (u32, Value<'a>);

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() || self.is_broken {
            return None;
        }
        let field = self.field();
        self.is_broken = field.is_none();
        field
    }
}

/// Adds the numbers of one occurrence of a repeated double, packed or not. `None` where it is neither, or the list is too long.
pub(super) fn doubles(
    value: Value<'_>,
    list: &mut [f64; NUMBERS],
    count: &mut usize,
) -> Option<()> {
    let mut put = |number: f64| -> Option<()> {
        *list.get_mut(*count)? = number;
        *count += 1;
        Some(())
    };
    match value {
        Value::Double(number) => put(number),
        Value::Bytes(bytes) => {
            let (numbers, rest) = bytes.as_chunks::<8>();
            if !rest.is_empty() {
                return None;
            }
            numbers
                .iter()
                .try_for_each(|bytes| put(f64::from_le_bytes(*bytes)))
        }
        _ => None,
    }
}

fn varint(mut value: u64, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push(value as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

/// Appends a whole number.
pub(super) fn number(field: u32, value: u64, out: &mut Vec<u8>) {
    varint(u64::from(field) << 3, out);
    varint(value, out);
}

/// Appends a double.
pub(super) fn double(field: u32, value: f64, out: &mut Vec<u8>) {
    varint(u64::from(field) << 3 | 1, out);
    out.extend_from_slice(&value.to_le_bytes());
}

/// Appends a nested message.
pub(super) fn nested(field: u32, out: &mut Vec<u8>, write: impl FnOnce(&mut Vec<u8>)) {
    varint(u64::from(field) << 3 | 2, out);
    let begin = out.len();
    write(out);
    // The length stands before what it counts, and is known after it.
    let length = out.len() - begin;
    varint(length as u64, out);
    let prefix = out.len() - begin - length;
    out[begin..].rotate_right(prefix);
}
