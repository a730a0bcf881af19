//! The coordinates of a model, and their columns in a motion file.

use std::collections::HashMap;

use osim_model::feet::prescribed_function;
use osim_model::{CoordinateFunction, Model, ModelJoint};

use crate::table::{Column, Table};

/// What the value of a coordinate is: an angle, a length, or a number on which both depend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CoordinateKind {
    /// An angle; files may have it in degrees.
    Rotational,
    /// A length, m.
    Translational,
    /// A number on which both angles and lengths of a joint depend; it is used without conversion of units.
    Coupled,
}

/// A coordinate of a model, whose values a recording gives.
#[derive(Debug, Clone)]
pub struct ModelCoordinate {
    pub name: String,
    pub joint: String,
    pub kind: CoordinateKind,
    /// Value of the coordinate in the default pose.
    pub(crate) default: Option<f64>,
    /// The least and the largest value that the model wants.
    pub(crate) range: Option<[f64; 2]>,
    pub(crate) locked: bool,
    /// The function of time that prescribes the coordinate, if there is one; the inner `None` means a function that this
    /// program cannot read.
    pub(crate) prescribed: Option<Option<CoordinateFunction>>,
}

/// All coordinates of the model, in the order of its joints.
pub(crate) fn model_coordinates(model: &Model, joints: &[ModelJoint]) -> Vec<ModelCoordinate> {
    let mut all = Vec::new();
    for joint in joints {
        for (index, coordinate) in joint.coordinates.iter().enumerate() {
            all.push(ModelCoordinate {
                name: coordinate.name.clone(),
                joint: joint.name.clone(),
                kind: coordinate_kind(model, joint, index),
                default: coordinate.default,
                range: coordinate.range,
                locked: matches!(model.file(joint.file).flag(coordinate.element, "locked"), Ok(Some(true))),
                prescribed: prescribed_function(model.file(joint.file), coordinate.element),
            });
        }
    }
    all
}

/// The kind of a coordinate as OpenSim determines it. A coordinate of a `CustomJoint` is an angle (or a length) if a
/// `LinearFunction` of slope 1 or -1 turns (or shifts) along an axis by it; the last such axis decides.
fn coordinate_kind(model: &Model, joint: &ModelJoint, index: usize) -> CoordinateKind {
    use CoordinateKind::{Coupled, Rotational, Translational};
    match (joint.class.as_str(), index) {
        ("SliderJoint", _) | ("PlanarJoint", 1..) | ("FreeJoint", 3..) => Translational,
        ("CustomJoint", _) => match joint.is_pure_rotation(model, index) {
            Some(true) => Rotational,
            Some(false) => Translational,
            None => Coupled,
        },
        _ => Rotational,
    }
}

/// The columns of values and of speeds of one coordinate in a table.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct CoordinateColumns<'t> {
    pub(crate) value: Option<&'t Column>,
    pub(crate) speed: Option<&'t Column>,
}

/// The joint and the coordinate in a column's name, such as `/jointset/J/C/value`, `J/C/speed` or `C`, and whether it is a speed.
fn read_column_name(name: &str) -> (Option<&str>, &str, bool) {
    let (path, is_speed) = match name.rsplit_once('/') {
        Some((path, "value")) => (path, false),
        Some((path, "speed")) => (path, true),
        _ => (name, false),
    };
    let mut parts = path.rsplit('/');
    let coordinate = parts.next().unwrap_or_default();
    (parts.next().filter(|joint| !joint.is_empty()), coordinate, is_speed)
}

/// The columns of each of `coordinates`, and the names of the columns without a coordinate.
pub(crate) fn columns_by_coordinate<'t>(
    coordinates: &[ModelCoordinate],
    table: &'t Table,
) -> (Vec<CoordinateColumns<'t>>, Vec<String>) {
    let mut by_name: HashMap<&str, Vec<usize>> = HashMap::new();
    for (index, coordinate) in coordinates.iter().enumerate() {
        by_name.entry(&coordinate.name).or_default().push(index);
    }
    let mut columns = vec![CoordinateColumns::default(); coordinates.len()];
    let mut unused = Vec::new();
    for column in &table.columns {
        let (joint, coordinate, is_speed) = read_column_name(&column.name);
        let (at, is_speed) = match by_name.get(coordinate) {
            Some(named) => (coordinate_in_joint(coordinates, named, joint), is_speed),
            // States of OpenSim 3 have speeds as `C_u`.
            None => {
                let plain = coordinate.strip_suffix("_u").and_then(|name| by_name.get(name));
                (plain.and_then(|named| coordinate_in_joint(coordinates, named, joint)), true)
            }
        };
        let Some(place) = at.and_then(|index| columns.get_mut(index)) else {
            unused.push(column.name.clone());
            continue;
        };
        let place = if is_speed { &mut place.speed } else { &mut place.value };
        if place.is_some() {
            unused.push(column.name.clone());
        } else {
            *place = Some(column);
        }
    }
    (columns, unused)
}

/// The coordinate with the given name in the given joint. If only one coordinate has the name, the joint does not matter, because
/// OpenSim gives names to joints without a name.
fn coordinate_in_joint(all: &[ModelCoordinate], named: &[usize], joint: Option<&str>) -> Option<usize> {
    let fits = |index: &&usize| {
        joint.is_none_or(|joint| all.get(**index).is_some_and(|coordinate| coordinate.joint == joint))
    };
    match named {
        [only] => Some(*only),
        _ => named.iter().find(fits).copied(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_columns_are_read() {
        let label = read_column_name;
        assert_eq!(label("/jointset/hip_r/hip_flexion_r/value"), (Some("hip_r"), "hip_flexion_r", false));
        assert_eq!(label("hip_r/hip_flexion_r/speed"), (Some("hip_r"), "hip_flexion_r", true));
        assert_eq!(label("hip_flexion_r"), (None, "hip_flexion_r", false));
        assert_eq!(label("/hip_flexion_r/value"), (None, "hip_flexion_r", false));
        assert_eq!(label("/forceset/soleus_r/activation"), (Some("soleus_r"), "activation", false));
    }
}
