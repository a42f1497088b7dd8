//! Wavefront OBJ: corners and faces; materials are not read.

use super::Loose;

pub(super) fn read(bytes: &[u8]) -> Result<Loose, String> {
    let text = String::from_utf8_lossy(bytes);
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let mut triangles = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let wrong = |what: &str| format!("line {}: `{}`: {what}", index + 1, line.trim());
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
                let [x, y, z, ..] = numbers[..] else {
                    return Err(wrong("three numbers were expected"));
                };
                corners.push([x, y, z]);
            }
            Some("f") => {
                let face: Option<Vec<[f64; 3]>> =
                    words.map(|word| corner(word, &corners)).collect();
                let face = face.ok_or_else(|| wrong("it names a corner that is not there"))?;
                if face.len() < 3 {
                    return Err(wrong("a face has three corners or more"));
                }
                triangles.extend((1..face.len() - 1).map(|k| [face[0], face[k], face[k + 1]]));
            }
            _ => {}
        }
    }
    Ok(vec![(triangles, None)])
}

/// `7`, `7/1`, `7//3`; counted from 1, or from the end if negative.
fn corner(word: &str, corners: &[[f64; 3]]) -> Option<[f64; 3]> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let place = match number {
        1.. => usize::try_from(number - 1).ok()?,
        _ => corners
            .len()
            .checked_sub(usize::try_from(number.checked_neg()?).ok()?)?,
    };
    corners.get(place).copied()
}
