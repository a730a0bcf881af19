//! Which coordinates a model has, and what a table says of each.

use std::collections::HashMap;

use osim_model::feet::prescribed_function;
use osim_model::{CoordinateFunction, Model, ModelJoint};

use crate::table::{Column, Table};

/// What a coordinate's number means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CoordinateKind {
    /// An angle: files may have it in degrees.
    Rotational,
    /// A length, m.
    Translational,
    /// Something that moves and turns, such as a curve's parameter: it is read as it is.
    Coupled,
}

#[derive(Debug, Clone)]
pub struct ModelCoordinate {
    pub name: String,
    pub joint: String,
    pub kind: CoordinateKind,
    /// Its value where nothing else says it.
    pub(crate) default: Option<f64>,
    /// The function of time that sets it where it is prescribed; `None` inside for one that is not known.
    pub(crate) prescribed: Option<Option<CoordinateFunction>>,
}

pub(crate) fn coordinates_of(model: &Model, joints: &[ModelJoint]) -> Vec<ModelCoordinate> {
    let mut all = Vec::new();
    for joint in joints {
        for (index, coordinate) in joint.coordinates.iter().enumerate() {
            all.push(ModelCoordinate {
                name: coordinate.name.clone(),
                joint: joint.name.clone(),
                kind: kind_of(model, joint, index),
                default: coordinate.default,
                prescribed: prescribed_function(model.file(joint.file), coordinate.element),
            });
        }
    }
    all
}

/// As OpenSim has it: a coordinate of a CustomJoint is an angle (or a length) where a LinearFunction of slope 1 or -1 turns (or shifts)
/// by it; the last such axis counts.
fn kind_of(model: &Model, joint: &ModelJoint, index: usize) -> CoordinateKind {
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

/// Columns of a table for one coordinate.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Columns<'t> {
    pub(crate) value: Option<&'t Column>,
    pub(crate) speed: Option<&'t Column>,
}

/// What the name of a column says.
#[derive(Debug, PartialEq)]
struct Label<'l> {
    joint: Option<&'l str>,
    coordinate: &'l str,
    is_speed: bool,
}

impl<'l> Label<'l> {
    /// `/jointset/J/C/value`, `J/C/speed`, plain `C`.
    fn read(name: &'l str) -> Self {
        let (path, is_speed) = match name.rsplit_once('/') {
            Some((path, "value")) => (path, false),
            Some((path, "speed")) => (path, true),
            _ => (name, false),
        };
        let mut parts = path.rsplit('/');
        let coordinate = parts.next().unwrap_or_default();
        Self { joint: parts.next().filter(|joint| !joint.is_empty()), coordinate, is_speed }
    }
}

/// The columns of each of `coordinates`, and the names of those that belong to none.
pub(crate) fn columns_of<'t>(
    coordinates: &[ModelCoordinate],
    table: &'t Table,
) -> (Vec<Columns<'t>>, Vec<String>) {
    let mut by_name: HashMap<&str, Vec<usize>> = HashMap::new();
    for (index, coordinate) in coordinates.iter().enumerate() {
        by_name.entry(&coordinate.name).or_default().push(index);
    }
    let mut found = vec![Columns::default(); coordinates.len()];
    let mut unused = Vec::new();
    for column in &table.columns {
        let label = Label::read(&column.name);
        let (at, is_speed) = match by_name.get(label.coordinate) {
            Some(named) => (of_joint(coordinates, named, label.joint), label.is_speed),
            // States of OpenSim 3 have speeds as `C_u`.
            None => {
                let plain = label.coordinate.strip_suffix("_u").and_then(|name| by_name.get(name));
                (plain.and_then(|named| of_joint(coordinates, named, label.joint)), true)
            }
        };
        let Some(place) = at.and_then(|index| found.get_mut(index)) else {
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
    (found, unused)
}

/// The first of the coordinates of one name that has this joint. OpenSim names joints that have no name, so that a coordinate whose name
/// is its own is found with any.
fn of_joint(coordinates: &[ModelCoordinate], named: &[usize], joint: Option<&str>) -> Option<usize> {
    let fits = |index: &&usize| {
        joint.is_none_or(|joint| coordinates.get(**index).is_some_and(|coordinate| coordinate.joint == joint))
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
        let label = |name| {
            let Label { joint, coordinate, is_speed } = Label::read(name);
            (joint, coordinate, is_speed)
        };
        assert_eq!(label("/jointset/hip_r/hip_flexion_r/value"), (Some("hip_r"), "hip_flexion_r", false));
        assert_eq!(label("hip_r/hip_flexion_r/speed"), (Some("hip_r"), "hip_flexion_r", true));
        assert_eq!(label("hip_flexion_r"), (None, "hip_flexion_r", false));
        assert_eq!(label("/hip_flexion_r/value"), (None, "hip_flexion_r", false));
        assert_eq!(label("/forceset/soleus_r/activation"), (Some("soleus_r"), "activation", false));
    }
}
