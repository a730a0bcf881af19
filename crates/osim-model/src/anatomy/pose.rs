//! How the two frames of a joint stand to each other where all coordinates have their default values.

use std::collections::HashMap;

use crate::components::{ComponentId, Components};
use crate::document::Document;
use crate::rotation::Rotation;
use osim_xml::{ElementId, opensim_text};

/// Three axes of rotation and three of translation, in the order in which OpenSim applies them.
const ROTATIONS: [&str; 3] = ["rotation1", "rotation2", "rotation3"];
const TRANSLATIONS: [&str; 3] = ["translation1", "translation2", "translation3"];
/// Joints whose frames coincide while all coordinates are 0.
const COINCIDE_AT_ZERO: [&str; 7] =
    ["PinJoint", "SliderJoint", "UniversalJoint", "GimbalJoint", "BallJoint", "PlanarJoint", "FreeJoint"];

/// A frame in another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Placement {
    pub rotation: Rotation,
    pub translation: [f64; 3],
}

impl Placement {
    pub(super) const NONE: Self = Self { rotation: Rotation::IDENTITY, translation: [0.0; 3] };

    /// A point of the frame, seen from the other one.
    pub(super) fn of(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.rotation.to_body(point);
        std::array::from_fn(|i| self.translation[i] + turned[i])
    }

    /// A frame in this one, seen from where this one is seen.
    pub(super) fn then(&self, inner: &Self) -> Self {
        Self { rotation: self.rotation.after(&inner.rotation), translation: self.of(inner.translation) }
    }

    pub(super) fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        let translation = rotation.to_body(self.translation).map(|value| -value);
        Self { rotation, translation }
    }
}

/// The child's frame of `joint` in its parent's; `None` where that is not known.
pub(super) fn at_default(components: &Components, joint: ComponentId) -> Option<Placement> {
    let document = components.doc(joint);
    let element = components.element(joint);
    let defaults = defaults(document, element)?;
    let still = defaults.values().all(|&value| value == 0.0);
    match components.tag(joint) {
        "WeldJoint" => Some(Placement::NONE),
        "CustomJoint" => spatial(document, element, &defaults),
        "PinJoint" if !still && defaults.len() == 1 => {
            let angle = defaults.values().next().copied()?;
            Some(Placement { rotation: Rotation::about([0.0, 0.0, 1.0], angle), ..Placement::NONE })
        }
        tag if still && COINCIDE_AT_ZERO.contains(&tag) => Some(Placement::NONE),
        _ => None,
    }
}

/// Default values of the coordinates of a joint, by name.
fn defaults(document: &Document, joint: ElementId) -> Option<HashMap<String, f64>> {
    let tree = document.tree();
    let old = || tree.child(tree.child(joint, "CoordinateSet")?, "objects");
    let list = tree.child(joint, "coordinates").or_else(old);
    let coordinates = list.into_iter().flat_map(|list| tree.children(list));
    coordinates
        .filter(|&id| tree.name(id) == "Coordinate")
        .map(|id| {
            let name = tree.attribute(id, "name").unwrap_or_default().into_owned();
            let value = match tree.child(id, "default_value") {
                Some(_) => {
                    numbers(document, id, "default_value").and_then(|values| values.first().copied())?
                }
                None => 0.0,
            };
            Some((name, value))
        })
        .collect()
}

/// A `<SpatialTransform>`: rotations about three axes, each in the frame that those before have turned, and translations.
fn spatial(document: &Document, joint: ElementId, defaults: &HashMap<String, f64>) -> Option<Placement> {
    let tree = document.tree();
    let Some(transform) = tree.child(joint, "SpatialTransform") else { return Some(Placement::NONE) };
    let mut placement = Placement::NONE;
    for (index, axis) in tree.children(transform).enumerate() {
        let name = tree.attribute(axis, "name").unwrap_or_default();
        let named = ROTATIONS.iter().chain(&TRANSLATIONS).position(|known| *known == &*name);
        let value = value_of(document, axis, defaults)?;
        let direction = document.triple(axis, "axis").unwrap_or([0.0; 3]);
        if named.unwrap_or(index) < ROTATIONS.len() {
            placement.rotation = placement.rotation.after(&Rotation::about(direction, value));
        } else {
            placement.translation = std::array::from_fn(|i| placement.translation[i] + direction[i] * value);
        }
    }
    Some(placement)
}

/// What moves along or about one axis.
fn value_of(document: &Document, axis: ElementId, defaults: &HashMap<String, f64>) -> Option<f64> {
    let tree = document.tree();
    let names = tree.child(axis, "coordinates").map(|list| tree.text_of(list)).unwrap_or_default();
    let argument = opensim_text::list(&names).next().map_or(Some(0.0), |name| defaults.get(name).copied())?;
    let wrapped = tree.child(axis, "function").and_then(|wrapper| tree.children(wrapper).next());
    let is_function = |id: &ElementId| !["coordinates", "axis", "function"].contains(&tree.name(*id));
    match wrapped.or_else(|| tree.children(axis).find(is_function)) {
        Some(function) => evaluate(document, function, argument),
        None => names.is_empty().then_some(0.0),
    }
}

/// A function of one coordinate; a curve only at its own knots.
fn evaluate(document: &Document, function: ElementId, x: f64) -> Option<f64> {
    let tree = document.tree();
    match tree.name(function) {
        "Constant" => match tree.child(function, "value") {
            Some(_) => numbers(document, function, "value")?.first().copied(),
            None => Some(0.0),
        },
        "LinearFunction" | "PolynomialFunction" => {
            let coefficients = numbers(document, function, "coefficients")?;
            Some(coefficients.into_iter().fold(0.0, |sum, coefficient| sum * x + coefficient))
        }
        "MultiplierFunction" => {
            let inner = tree.children(tree.child(function, "function")?).next()?;
            let scale = match tree.child(function, "scale") {
                Some(_) => numbers(document, function, "scale")?.first().copied()?,
                None => 1.0,
            };
            Some(scale * evaluate(document, inner, x)?)
        }
        "SimmSpline" | "NaturalCubicSpline" | "PiecewiseLinearFunction" => {
            let (xs, ys) = (numbers(document, function, "x")?, numbers(document, function, "y")?);
            // Many joints hold constants as curves between equal values.
            let first = ys.first().copied()?;
            let flat = ys.iter().all(|&y| y == first);
            let knot = || ys.get(xs.iter().position(|&knot| knot == x)?).copied();
            if flat { Some(first) } else { knot() }
        }
        _ => None,
    }
}

fn numbers(document: &Document, owner: ElementId, tag: &str) -> Option<Vec<f64>> {
    let tree = document.tree();
    let text = tree.text_of(tree.child(owner, tag)?);
    opensim_text::numbers(&text).filter(|values| values.iter().all(|value| value.is_finite()))
}

#[cfg(test)]
mod tests {
    use crate::anatomy::Anatomy;
    use crate::model::Model;

    /// A chain of bodies: calcn, mid, fore; each joint says what stands between its frames.
    fn chain(middle: &str, end: &str) -> Anatomy {
        let body = |name: &str| format!("<Body name=\"{name}\"><mass>1</mass></Body>");
        let frame = |name: &str, at: &str, turned: &str, body: &str| {
            format!(
                "<PhysicalOffsetFrame name=\"{name}\"><socket_parent>/bodyset/{body}</socket_parent><translation>{at}</translation>\
                 <orientation>{turned}</orientation></PhysicalOffsetFrame>"
            )
        };
        let joint = |class: &str, name: &str, frames: &str, inner: &str| {
            format!(
                "<{class} name=\"{name}\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>c</socket_child_frame>\
                 {inner}<frames>{frames}</frames></{class}>"
            )
        };
        let (class, inner) = middle.split_once(':').unwrap();
        let middle = joint(
            class,
            "mid_joint",
            &format!(
                "{}{}",
                frame("p", "0.1 0 0", "0 0 0", "calcn_r"),
                frame("c", "0 0.02 0", "0 0 0", "mid_r")
            ),
            inner,
        );
        let last = joint(
            "WeldJoint",
            "mtp_r",
            &format!("{}{}", frame("p", end, "0 0 0", "mid_r"), frame("c", "0 0 0", "0 0 0", "toes_r")),
            "",
        );
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><BodySet><objects>{}{}{}</objects></BodySet><JointSet><objects>\
             {middle}{last}</objects></JointSet></Model></OpenSimDocument>",
            body("calcn_r"),
            body("mid_r"),
            body("toes_r")
        );
        Anatomy::of(&Model::parse(text).unwrap()).unwrap()
    }

    #[track_caller]
    fn at(anatomy: &Anatomy, expected: [f64; 3]) {
        let joint = anatomy.joints.iter().find(|joint| joint.name == "mtp_r").unwrap();
        let place = anatomy.place_below("calcn_r", joint).unwrap();
        for (value, expected) in place.into_iter().zip(expected) {
            assert!((value - expected).abs() < 1e-15, "{place:?}");
        }
    }

    #[test]
    fn a_joint_is_found_through_bodies_between() {
        // 0.1 to the joint, 0.02 down to the middle body's origin, then 0.05 on.
        at(&chain("WeldJoint:", "0.05 0 0"), [0.15, -0.02, 0.0]);
        let anatomy = chain("WeldJoint:", "0.05 0 0");
        assert!(anatomy.place_below("toes_r", &anatomy.joints[1]).is_none(), "it is not below the toes");
    }

    #[test]
    fn default_values_turn_and_move_the_bodies_between() {
        let coordinate = |name: &str, value: &str| {
            format!("<Coordinate name=\"{name}\"><default_value>{value}</default_value></Coordinate>")
        };
        // A quarter turn about z: the middle body's x points up, its y back; 0.1 - (-0.02 turned) = 0.1 + 0.02, and 0.05 up.
        let quarter = "1.5707963267948966";
        let pin = format!("PinJoint:<coordinates>{}</coordinates>", coordinate("q", quarter));
        at(&chain(&pin, "0.05 0 0"), [0.12, 0.05, 0.0]);
        // The same by a CustomJoint: half of the angle by each of two functions, and 0.03 along z.
        let axis = |name: &str, q: &str, direction: &str, function: &str| {
            format!(
                "<TransformAxis name=\"{name}\"><coordinates>{q}</coordinates><axis>{direction}</axis>{function}</TransformAxis>"
            )
        };
        let linear = "<LinearFunction name=\"function\"><coefficients> 0.5 0</coefficients></LinearFunction>";
        let scaled = "<function><MultiplierFunction><function><PolynomialFunction><coefficients>1 0</coefficients>\
                      </PolynomialFunction></function><scale>0.5</scale></MultiplierFunction></function>";
        let spline = "<SimmSpline><x> -1 0 1</x><y> 0.01 0.03 0.02</y></SimmSpline>";
        let custom = format!(
            "CustomJoint:<coordinates>{}{}</coordinates><SpatialTransform>{}{}{}{}{}{}</SpatialTransform>",
            coordinate("q", quarter),
            coordinate("t", "0"),
            axis("rotation1", "q", "0 0 1", linear),
            axis("rotation2", "q", "0 0 2", scaled),
            axis("rotation3", "", "1 0 0", "<Constant><value>0</value></Constant>"),
            axis("translation1", "", "1 0 0", ""),
            axis("translation2", "", "0 1 0", ""),
            axis("translation3", "t", "0 0 1", spline),
        );
        at(&chain(&custom, "0.05 0 0"), [0.12, 0.05, 0.03]);
        // Between its knots, a curve is not guessed.
        let between = custom.replace("<default_value>0<", "<default_value>0.5<");
        let anatomy = chain(&between, "0.05 0 0");
        assert!(anatomy.place_below("calcn_r", &anatomy.joints[1]).is_none());
    }

    #[test]
    fn a_joint_far_down_a_chain_says_nothing_about_a_body() {
        // Body number n hangs on number n - 1, 0.1 m along x.
        let joint = |n: usize| {
            format!(
                "<WeldJoint name=\"j{n}\"><socket_parent_frame>/bodyset/b{}</socket_parent_frame>\
                 <socket_child_frame>f</socket_child_frame><frames><PhysicalOffsetFrame name=\"f\"><socket_parent>/bodyset/b{n}\
                 </socket_parent><translation>-0.1 0 0</translation></PhysicalOffsetFrame></frames></WeldJoint>",
                n - 1
            )
        };
        let bodies: String = (0..100).map(|n| format!("<Body name=\"b{n}\"><mass>1</mass></Body>")).collect();
        let joints: String = (1..100).map(joint).collect();
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><BodySet><objects>{bodies}</objects></BodySet>\
             <JointSet><objects>{joints}</objects></JointSet></Model></OpenSimDocument>"
        );
        let anatomy = Anatomy::of(&Model::parse(text).unwrap()).unwrap();
        let place = |n: usize| anatomy.place_below("b0", anatomy.joint(&format!("j{n}")).unwrap());
        // Joint 65 is at body 64, with 64 joints between.
        assert!((place(65).unwrap()[0] - 6.4).abs() < 1e-12);
        assert!(place(66).is_none());
    }
}
