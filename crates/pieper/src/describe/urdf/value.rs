//! Numbers in attributes.

use nalgebra::{Quaternion, UnitQuaternion, UnitVector3, Vector3};

use super::xml::{Attribute, Element};
use crate::error::Result;
use crate::spatial::{self, Pose};

/// `N` finite numbers.
pub(super) fn numbers<const N: usize>(attribute: &Attribute) -> Result<[f64; N]> {
    let expected = match N {
        1 => "a finite number was expected".to_owned(),
        _ => format!("{N} finite numbers were expected"),
    };
    let mut values = [0.0; N];
    let mut count = 0;
    for word in attribute.value.split_ascii_whitespace() {
        let Some(value) = number(word) else {
            // Where in the value the word stands; entities before it would shift this by a few columns.
            let offset = word.as_ptr().addr() - attribute.value.as_ptr().addr();
            let message = format!("{word:?} is not one; {expected}");
            return Err(attribute.spot.plus(offset).error(attribute.text(), message));
        };
        if let Some(slot) = values.get_mut(count) {
            *slot = value;
        }
        count += 1;
    }
    if count == N {
        Ok(values)
    } else {
        let found = match count {
            0 => "none was found".to_owned(),
            1 => "1 was found".to_owned(),
            _ => format!("{count} were found"),
        };
        Err(attribute.error(format!("{expected}, {found}")))
    }
}

/// A finite number as people and tools write it: `1`, `-.5`, `+2.`, `1e-3`.
fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|value: &f64| value.is_finite())
}

/// The number in an attribute, if the attribute is there.
pub(super) fn optional(element: &Element, name: &str) -> Result<Option<f64>> {
    let Some(attribute) = element.attribute(name) else {
        return Ok(None);
    };
    let [value] = numbers(attribute)?;
    Ok(Some(value))
}

/// A length that must be there and must not be negative.
pub(super) fn size(element: &Element, name: &str) -> Result<f64> {
    let attribute = element.required(name)?;
    let [value] = numbers(attribute)?;
    if value < 0.0 {
        return Err(attribute.error("a length must not be negative"));
    }
    Ok(value)
}

/// The `<origin>` of an element: position and `rpy` or `quat_xyzw`; the identity where it is left out.
pub(super) fn origin(element: &Element) -> Result<Pose> {
    let Some(origin) = element.child("origin") else {
        return Ok(Pose::identity());
    };
    let triple = |name| origin.attribute(name).map_or(Ok([0.0; 3]), numbers);
    let xyz = triple("xyz")?;
    let Some(attribute) = origin.attribute("quat_xyzw") else {
        return Ok(spatial::from_xyz_rpy(xyz, triple("rpy")?));
    };
    if origin.attribute("rpy").is_some() {
        return Err(attribute.error("either rpy or quat_xyzw was expected, not both"));
    }
    let [x, y, z, w] = numbers(attribute)?;
    let largest = [x, y, z, w].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    if largest == 0.0 {
        return Err(attribute.error("a quaternion of length zero is no rotation"));
    }
    let quaternion = Quaternion::new(w / largest, x / largest, y / largest, z / largest);
    let rotation = UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix();
    Ok(Pose::from_parts(Vector3::from(xyz).into(), rotation))
}

/// The direction of an `<axis>`; x where it is left out.
pub(super) fn axis(joint: &Element) -> Result<UnitVector3<f64>> {
    let Some(axis) = joint.child("axis") else {
        return Ok(Vector3::x_axis());
    };
    let Some(attribute) = axis.attribute("xyz") else {
        return Ok(Vector3::x_axis());
    };
    let direction = Vector3::from(numbers(attribute)?);
    let largest = direction.amax();
    if largest == 0.0 {
        return Err(attribute.error("an axis of length zero has no direction"));
    }
    // Scaled first: squares of very large or small components would leave the range of numbers.
    Ok(UnitVector3::new_normalize(direction / largest))
}
