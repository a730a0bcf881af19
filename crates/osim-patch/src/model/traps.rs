//! Known traps of OpenSim and its users, looked for in every model that is read.

use std::collections::HashMap;

use super::limbs::Side;
use super::{Force, Model};
use crate::document::{Origin, Value};
use crate::property::{Class, Property};
use crate::warning::{Warning, WarningCode};

const ELASTIC_FOUNDATION_PARAMETERS: &str = "ElasticFoundationForce::ContactParameters";
const NOT_HERTZ: [&str; 3] = ["ElasticFoundationForce", "ExponentialContactForce", "MeyerFregly2016Force"];

impl Model<'_, '_> {
    /// For each sphere name, the forces of other contact classes whose geometry lists it.
    pub(crate) fn users_of_other_classes(&self) -> HashMap<String, Vec<String>> {
        let files = self.files();
        let mut users: HashMap<String, Vec<String>> = HashMap::new();
        let foundations =
            files.objects.iter().filter(|(id, _)| files.tag(*id) == ELASTIC_FOUNDATION_PARAMETERS);
        for (id, _) in foundations {
            let tree = files.doc(id).tree();
            let Some(geometry) = tree.child(files.element(id), "geometry") else { continue };
            let mut at = files.objects.get(id).and_then(|object| object.parent);
            while let Some(force) = at.filter(|&force| files.tag(force) != "ElasticFoundationForce") {
                at = files.objects.get(force).and_then(|object| object.parent);
            }
            let Some(force) = at else { continue };
            for name in tree.text_of(geometry).split_ascii_whitespace() {
                let last = name.rsplit('/').next().unwrap_or(name);
                users.entry(last.to_owned()).or_default().push(files.name(force));
            }
        }
        users
    }

    /// The force on the right that has the name of `left` but for the side.
    #[must_use]
    pub fn right_of(&self, left: &Force) -> Option<&Force> {
        let name = without_side(&left.name);
        let is_right = |force: &&Force| Side::of_name(&force.name) == Some(Side::Right);
        self.forces.iter().filter(is_right).find(|force| without_side(&force.name) == name)
    }

    pub(super) fn find_traps(&mut self) {
        let mut found = Vec::new();
        self.numbers(&mut found);
        self.included_contacts(&mut found);
        self.dead_elements(&mut found);
        self.several_spheres(&mut found);
        self.spheres_in_two_forces(&mut found);
        self.default_stiffness(&mut found);
        self.zero_constant_contact_force(&mut found);
        self.left_and_right(&mut found);
        self.contact_defaults(&mut found);
        self.objects_of_note(&mut found);
        self.warnings.append(&mut found);
    }

    fn numbers(&self, found: &mut Vec<Warning>) {
        let parameters = self.forces.iter().flat_map(|force| {
            let own = force.sets.iter().flat_map(|set| &set.values);
            own.map(move |value| (force.path.as_str(), force.file, value))
        });
        let radii = self.spheres.iter().map(|sphere| (sphere.path.as_str(), sphere.file, &sphere.radius));
        let masses = self.bodies().iter().map(|body| (body.path.as_str(), body.file, &body.mass));
        for (path, file, value) in parameters.chain(radii).chain(masses) {
            let (code, text) = if value.fault.is_some() {
                (
                    WarningCode::OddNumber,
                    format!("is '{}', which OpenSim reads as {}", value.text, value.number),
                )
            } else if !value.number.is_finite() {
                (WarningCode::NotFinite, format!("is {}", value.number))
            } else if !value.property.allows(value.number) && !is_default_stiffness(value) {
                let expected = value.property.domain();
                (WarningCode::OutOfDomain, format!("is {}, expected {expected}", value.number))
            } else {
                continue;
            };
            let line = self.file(file).line(value.offset);
            found.push(Warning::at(code, line, format!("{} of {path} {text}", value.property)).about(path));
        }
    }

    /// Contacts that stand in included files can be read but not changed.
    fn included_contacts(&self, found: &mut Vec<Warning>) {
        let forces = self.forces.iter().map(|force| (force.file, &force.path));
        let spheres = self.spheres.iter().map(|sphere| (sphere.file, &sphere.path));
        let mut said: Vec<usize> = Vec::new();
        for (file, path) in forces.chain(spheres) {
            if let (Some(name), false) = (self.included_file(file), said.contains(&file)) {
                let text = format!("{path} and others stand in the file '{name}' that the model includes");
                found.push(Warning::new(WarningCode::IncludedFile, text));
                said.push(file);
            }
        }
    }

    fn dead_elements(&self, found: &mut Vec<Warning>) {
        for force in &self.forces {
            let document = self.file(force.file);
            if let Some(dead) = document.tree().child(force.element, "derivative_smoothing") {
                let line = document.line(document.tree().span(dead).start);
                let text = format!("{}: derivative_smoothing is ignored by OpenSim", force.path);
                found.push(Warning::at(WarningCode::DeadDerivativeSmoothing, line, text).about(&force.path));
            }
        }
    }

    fn several_spheres(&self, found: &mut Vec<Warning>) {
        for force in &self.forces {
            let moving = force
                .spheres()
                .into_iter()
                .filter(|&s| self.spheres.get(s).is_some_and(|s| !s.fixed))
                .count();
            if matches!(force.kind, super::ForceKind::HuntCrossley) && moving > 1 {
                let text =
                    format!("{} holds {moving} spheres: Simbody can drop the force of some", force.path);
                found.push(Warning::at(WarningCode::SeveralSpheres, force.line, text).about(&force.path));
            }
        }
    }

    fn spheres_in_two_forces(&self, found: &mut Vec<Warning>) {
        let mut users: HashMap<usize, Vec<&str>> = HashMap::new();
        for force in self.forces.iter().filter(|force| force.applies && self.meets_half_space(force)) {
            for sphere in force.spheres() {
                users.entry(sphere).or_default().push(&force.path);
            }
        }
        let mut shared: Vec<_> = users.into_iter().filter(|(_, forces)| forces.len() > 1).collect();
        shared.sort_unstable();
        for (index, forces) in shared {
            let Some(sphere) = self.spheres.get(index) else { continue };
            let text = format!("sphere {} meets the ground through {}", sphere.path, forces.join(" and "));
            found.push(Warning::at(WarningCode::SphereInTwoForces, sphere.line, text).about(&sphere.path));
        }
    }

    fn default_stiffness(&self, found: &mut Vec<Warning>) {
        for force in &self.forces {
            for set in &force.sets {
                let default =
                    set.value(Property::Stiffness).filter(|value| value.origin == Origin::ClassDefault);
                if let Some(value) = default {
                    let text =
                        format!("{}: stiffness is OpenSim's default, {} N/m2", force.path, value.number);
                    found.push(Warning::at(WarningCode::DefaultStiffness, set.line, text).about(&force.path));
                }
            }
        }
    }

    fn zero_constant_contact_force(&self, found: &mut Vec<Warning>) {
        for force in &self.forces {
            let zero = force.value(0, Property::ConstantContactForce).filter(|value| value.number == 0.0);
            if let Some(value) = zero {
                let line = self.file(force.file).line(value.offset);
                let text =
                    format!("{}: constant_contact_force is 0: OpenSim computes NaN without slip", force.path);
                found.push(Warning::at(WarningCode::ZeroConstantContactForce, line, text).about(&force.path));
            }
        }
    }

    /// Forces whose names differ only in the side should have equal parameters.
    fn left_and_right(&self, found: &mut Vec<Warning>) {
        let mut right: HashMap<String, usize> = HashMap::new();
        let side = |name: &str| Side::of_name(name);
        for (index, force) in self.forces.iter().enumerate() {
            if side(&force.name) == Some(Side::Right) {
                right.entry(without_side(&force.name)).or_insert(index);
            }
        }
        for force in self.forces.iter().filter(|force| side(&force.name) == Some(Side::Left)) {
            let Some(other) = right.get(&without_side(&force.name)).and_then(|&index| self.forces.get(index))
            else {
                continue;
            };
            let differing = force.sets.iter().zip(&other.sets).find_map(|(left, right)| {
                left.values
                    .iter()
                    .zip(&right.values)
                    .find(|(l, r)| l.number != r.number && !l.number.is_nan())
            });
            let radii = |force: &Force| -> Vec<u64> {
                let spheres = force.spheres().into_iter().filter_map(|index| self.spheres.get(index));
                spheres.map(|sphere| sphere.radius.number.to_bits()).collect()
            };
            let what = match differing {
                Some((left, right)) => format!("{} is {} and {}", left.property, left.number, right.number),
                None if radii(force) != radii(other) => "radii differ".to_owned(),
                None => continue,
            };
            let text = format!("{} and {} differ: {what}", force.path, other.path);
            found.push(Warning::at(WarningCode::LeftRightDiffer, force.line, text).about(&force.path));
        }
    }

    fn contact_defaults(&self, found: &mut Vec<Warning>) {
        let document = self.document();
        let tree = document.tree();
        let Some(defaults) = document.defaults() else { return };
        let classes = [
            Class::SmoothSphereHalfSpaceForce,
            Class::HuntCrossleyForce,
            Class::ContactParameters,
            Class::ContactSphere,
        ];
        for class in classes {
            if let Some(default) = tree.child(defaults, class.tag()) {
                // OpenSim itself writes defaults without content; those carry nothing.
                if tree.children(default).next().is_none() {
                    continue;
                }
                let line = document.line(tree.span(default).start);
                let text =
                    format!("<defaults> holds a {}: OpenSim keeps it for models loaded later", class.tag());
                found.push(Warning::at(WarningCode::ContactDefaults, line, text));
            }
        }
    }

    /// Traps that are seen from the component tree itself.
    fn objects_of_note(&self, found: &mut Vec<Warning>) {
        for sphere in self.spheres.iter().filter(|sphere| sphere.dialect == super::Dialect::InsideForce) {
            let text =
                format!("{} keeps its sphere inside: OpenSim 4.2 and later cannot read it", sphere.path);
            found.push(Warning::at(WarningCode::MocoDialect, sphere.line, text).about(&sphere.path));
        }
        let files = self.files();
        for &(file, element) in &files.objects.skipped {
            let document = files.document(file);
            let tree = document.tree();
            let inside = tree.slice(tree.span(element));
            if inside.contains("<HuntCrossleyForce ") || inside.contains("<SmoothSphereHalfSpaceForce ") {
                let line = document.line(tree.span(element).start);
                let text = format!(
                    "contacts inside a <{}> are left alone: OpenSim does not know that class",
                    tree.name(element)
                );
                found.push(Warning::at(WarningCode::UnknownClass, line, text));
            }
        }
        for (id, object) in files.objects.iter() {
            let tag = files.tag(id);
            let contact = tag.starts_with("Contact") || tag.ends_with("Force") || NOT_HERTZ.contains(&tag);
            if !contact {
                continue;
            }
            let path = files.objects.path(id);
            if NOT_HERTZ.contains(&tag) {
                let text = format!("{path} is a {tag}: left as it is");
                found.push(Warning::at(WarningCode::NotHertz, files.line(id), text).about(&path));
            }
            let name = files.name(id);
            let ours =
                tag.starts_with("Contact") || tag == "HuntCrossleyForce" || tag.starts_with("SmoothSphere");
            if ours && tag != Class::ContactParameters.tag() && object.segment != name && !name.is_empty() {
                let text = format!("'{name}' is there twice: OpenSim calls this one {path}");
                found.push(Warning::at(WarningCode::DuplicateNames, files.line(id), text).about(&path));
            }
        }
    }
}

/// Said by a warning of its own.
fn is_default_stiffness(value: &Value) -> bool {
    value.property == Property::Stiffness && value.origin == Origin::ClassDefault
}

/// The name with everything that says left or right made equal.
fn without_side(name: &str) -> String {
    let lower = name.to_lowercase().replace("right", "#").replace("left", "#");
    let tokens: Vec<&str> = lower
        .split(|c: char| !c.is_alphanumeric() && c != '#')
        .map(|token| if token == "r" || token == "l" { "#" } else { token })
        .collect();
    let joined = tokens.join("_");
    // LFoot and RFoot, footL and footR.
    let chars: Vec<char> = name.chars().collect();
    match chars.as_slice() {
        ['R' | 'L', second, third, ..] if second.is_uppercase() && third.is_lowercase() => {
            format!("#{}", joined.get(1..).unwrap_or_default())
        }
        [.., before, 'R' | 'L'] if before.is_lowercase() => {
            format!("{}#", joined.get(..joined.len().saturating_sub(1)).unwrap_or_default())
        }
        _ => joined,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_both_sides_become_equal() {
        for (right, left) in [
            ("heel_r", "heel_l"),
            ("RFoot", "LFoot"),
            ("footR", "footL"),
            ("right_toe", "left_toe"),
            ("s1_r_a", "s1_l_a"),
        ] {
            assert_eq!(without_side(right), without_side(left));
        }
        assert_ne!(without_side("heel_r"), without_side("toe_l"));
    }
}
