//! STL, binary and as text.

use super::Loose;

/// Bytes before the number of triangles, and bytes of a triangle.
const HEADER: usize = 80;
const TRIANGLE: usize = 50;

pub(super) fn read(bytes: &[u8]) -> Result<Loose, String> {
    // Some writers begin binary files with "solid" too: the length tells.
    if let Some(count) = binary_count(bytes) {
        let body = &bytes[HEADER + 4..];
        if body.len() == count * TRIANGLE || !bytes.starts_with(b"solid") {
            return binary(body, count);
        }
    }
    text(bytes)
}

fn binary_count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER..HEADER + 4)?;
    Some(u32::from_le_bytes(count.try_into().ok()?) as usize)
}

fn binary(body: &[u8], count: usize) -> Result<Loose, String> {
    if body.len() / TRIANGLE < count {
        return Err(format!(
            "it announces {count} triangles and ends after {}",
            body.len() / TRIANGLE
        ));
    }
    let number =
        |bytes: &[u8]| f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    let triangle = |bytes: &[u8]| {
        // The normal comes first: it follows from the corners.
        std::array::from_fn(|corner| {
            std::array::from_fn(|k| number(&bytes[12 + 12 * corner + 4 * k..]))
        })
    };
    let triangles = body
        .chunks_exact(TRIANGLE)
        .take(count)
        .map(triangle)
        .collect();
    Ok(vec![(triangles, None)])
}

fn text(bytes: &[u8]) -> Result<Loose, String> {
    let text =
        std::str::from_utf8(bytes).map_err(|_| "it is neither a binary STL nor text".to_owned())?;
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        if words.next() != Some("vertex") {
            continue;
        }
        let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
        let corner = numbers.try_into().map_err(|_| {
            format!(
                "line {}: `{}`: three numbers were expected after vertex",
                index + 1,
                line.trim()
            )
        })?;
        corners.push(corner);
    }
    let (triangles, rest) = corners.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(format!(
            "it has {} corners: three for each triangle were expected",
            corners.len()
        ));
    }
    Ok(vec![(triangles.to_vec(), None)])
}
