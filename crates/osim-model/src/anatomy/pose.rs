//! How the two frames of a joint are placed to each other at given values of its coordinates.

use osim_xml::{ElementId, opensim_text};

use super::functions::evaluate;
use crate::document::Document;
use crate::reference_frame::{Placement, Rotation, times};

/// Three axes of rotation and three of translation, in the order in which OpenSim applies them.
const ROTATIONS: [&str; 3] = ["rotation1", "rotation2", "rotation3"];
const TRANSLATIONS: [&str; 3] = ["translation1", "translation2", "translation3"];

/// The child's frame of the joint at `element` in its parent's; `None` if it is not known. `values` are those of its
/// coordinates, in their order, with their names.
pub(super) fn motion(document: &Document, element: ElementId, values: &[(&str, f64)]) -> Option<Placement> {
    let value = |index: usize| values.get(index).map_or(0.0, |(_, value)| *value);
    let [first, second, third, ..] = std::array::from_fn::<f64, 6, _>(value);
    let turned = Rotation::body_fixed_xyz([first, second, third]);
    let only = |rotation| Placement { rotation, ..Placement::IDENTITY };
    Some(match document.tree().name(element) {
        "WeldJoint" => Placement::IDENTITY,
        "PinJoint" => only(Rotation::about([0.0, 0.0, 1.0], first)),
        "SliderJoint" => Placement { translation_m: [first, 0.0, 0.0], ..Placement::IDENTITY },
        "UniversalJoint" => only(Rotation::body_fixed_xyz([first, second, 0.0])),
        "GimbalJoint" | "BallJoint" => only(turned),
        "PlanarJoint" => Placement {
            rotation: Rotation::about([0.0, 0.0, 1.0], first),
            translation_m: [second, third, 0.0],
        },
        "FreeJoint" => Placement { rotation: turned, translation_m: [value(3), value(4), value(5)] },
        "EllipsoidJoint" => {
            let radii = document.triple(element, "radii_x_y_z")?;
            Placement { rotation: turned, translation_m: times(radii, turned.to_body([0.0, 0.0, 1.0])) }
        }
        "CustomJoint" => spatial(document, element, values)?,
        _ => return None,
    })
}

/// A `<SpatialTransform>`: rotations about three axes, each in the frame that those before have turned, and translations.
fn spatial(document: &Document, joint: ElementId, values: &[(&str, f64)]) -> Option<Placement> {
    let tree = document.tree();
    let Some(transform) = tree.child(joint, "SpatialTransform") else { return Some(Placement::IDENTITY) };
    let mut placement = Placement::IDENTITY;
    for (index, axis) in tree.children(transform).enumerate() {
        let name = tree.attribute(axis, "name").unwrap_or_default();
        let named = ROTATIONS.iter().chain(&TRANSLATIONS).position(|known| *known == &*name);
        let value = value_of(document, axis, values)?;
        let direction = document.triple(axis, "axis").unwrap_or([0.0; 3]);
        if named.unwrap_or(index) < ROTATIONS.len() {
            placement.rotation = placement.rotation.after(&Rotation::about(direction, value));
        } else {
            let [x, y, z] = direction;
            let length = libm::sqrt(x * x + y * y + z * z);
            // OpenSim gives each axis the length 1; one without length moves nothing.
            let value = if length > 0.0 { value / length } else { 0.0 };
            placement.translation_m =
                std::array::from_fn(|i| placement.translation_m[i] + direction[i] * value);
        }
    }
    Some(placement)
}

/// What moves along or about one axis.
fn value_of(document: &Document, axis: ElementId, values: &[(&str, f64)]) -> Option<f64> {
    let tree = document.tree();
    let names = tree.child(axis, "coordinates").map(|list| tree.text_of(list)).unwrap_or_default();
    let mut names = opensim_text::list(&names);
    let argument = match names.next() {
        Some(name) => Some(values.iter().find(|(known, _)| *known == name)?.1),
        None => None,
    };
    // A function of several coordinates is not understood.
    if names.next().is_some() {
        return None;
    }
    let wrapped = tree.child(axis, "function").and_then(|wrapper| tree.children(wrapper).next());
    let is_function = |id: &ElementId| !["coordinates", "axis", "function"].contains(&tree.name(*id));
    match wrapped.or_else(|| tree.children(axis).find(is_function)) {
        Some(function) => evaluate(document, function, argument.unwrap_or(0.0)),
        None => argument.is_none().then_some(0.0),
    }
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
            // OpenSim gives the axis the length 1.
            axis("translation3", "t", "0 0 2", spline),
        );
        at(&chain(&custom, "0.05 0 0"), [0.12, 0.05, 0.03]);
        // A curve that is not known is not guessed.
        let unknown = custom.replace("SimmSpline", "GCVSpline");
        let anatomy = chain(&unknown, "0.05 0 0");
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
