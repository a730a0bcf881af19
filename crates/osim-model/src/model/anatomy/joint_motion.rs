//! The placement of a joint's child frame in its parent frame at given values of the coordinates, and the velocity of the child frame.

use glam::DVec3;

use crate::model::{CoordinateFunction, Document, MovingPlacement, Placement, Rotation};
use crate::xml::{ElementId, opensim_text};

/// How fast the coordinates of a joint change, as rates or as OpenSim's generalized speeds: one number for each coordinate. Missing numbers
/// count as 0.
///
/// Rates and generalized speeds differ only for the three angles of a BallJoint, FreeJoint or EllipsoidJoint. There, OpenSim's speeds (the
/// `speed` columns of its states) are the child's angular velocity in the parent's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speeds<'s> {
    /// Time derivatives of the coordinates' values, rad/s or m/s.
    Rates(&'s [f64]),
    /// The quantities that OpenSim calls generalized speeds.
    Generalized(&'s [f64]),
}

impl Speeds<'_> {
    pub(crate) fn speed_at(&self, index: usize) -> f64 {
        let (Self::Rates(all) | Self::Generalized(all)) = self;
        all.get(index).copied().unwrap_or(0.0)
    }

    /// The angular velocity of a frame whose rotation is given by the first three of `values`, rad/s.
    pub(crate) fn angular_velocity(&self, values: &[f64]) -> DVec3 {
        let first = [self.speed_at(0), self.speed_at(1), self.speed_at(2)];
        match self {
            Self::Rates(_) => {
                let value = |index: usize| values.get(index).copied().unwrap_or(0.0);
                Rotation::body_fixed_velocity([value(0), value(1), value(2)], first)
            }
            Self::Generalized(_) => first.into(),
        }
    }
}

/// Names of the three rotation axes, in the order in which OpenSim applies them.
const ROTATIONS: [&str; 3] = ["rotation1", "rotation2", "rotation3"];
/// Names of the three translation axes, in the order in which OpenSim applies them.
const TRANSLATIONS: [&str; 3] = ["translation1", "translation2", "translation3"];

/// How the coordinates of a joint move its child frame. Read from the file once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum JointMotion {
    Weld,
    Pin,
    Slider,
    Universal,
    Gimbal,
    /// Three rotation angles. Their speeds in OpenSim are an angular velocity.
    Ball,
    Planar,
    Free,
    /// Three angles, and the radii, m, of the ellipsoid on whose surface the child glides.
    Ellipsoid(DVec3),
    /// The axes of a `<SpatialTransform>`.
    Spatial(Vec<TransformAxis>),
}

/// One of the six axes of a CustomJoint: the function by which a coordinate turns or shifts the child along it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TransformAxis {
    /// Whether the child rotates about this axis; if not, it moves along the axis.
    rotates: bool,
    direction: DVec3,
    /// The index of the joint's coordinate that drives this axis; `None` if no coordinate does.
    coordinate: Option<usize>,
    function: CoordinateFunction,
    /// Whether the function is a `LinearFunction` of slope 1 or -1. The coordinate is then the angle or the distance itself.
    is_pure: bool,
}

impl JointMotion {
    /// Reads the motion of the joint at `element`, which has the named `coordinates`; `None` for an unsupported class or function.
    pub(crate) fn read(document: &Document, element: ElementId, coordinates: &[&str]) -> Option<Self> {
        Some(match document.tree().name(element) {
            "WeldJoint" => Self::Weld,
            "PinJoint" => Self::Pin,
            "SliderJoint" => Self::Slider,
            "UniversalJoint" => Self::Universal,
            "GimbalJoint" => Self::Gimbal,
            "BallJoint" => Self::Ball,
            "PlanarJoint" => Self::Planar,
            "FreeJoint" => Self::Free,
            "EllipsoidJoint" => Self::Ellipsoid(document.triple(element, "radii_x_y_z")?.into()),
            "CustomJoint" => Self::Spatial(transform_axes(document, element, coordinates)?),
            _ => return None,
        })
    }

    /// The placement of the child frame in the parent frame if the coordinates have `values`. Missing values count as 0.
    pub(crate) fn placement(&self, values: &[f64]) -> Placement {
        let value = |index: usize| values.get(index).copied().unwrap_or(0.0);
        let [first, second, third] = [value(0), value(1), value(2)];
        let turned = || Rotation::body_fixed_xyz([first, second, third]);
        let only = |rotation| Placement { rotation, ..Placement::IDENTITY };
        match self {
            Self::Weld => Placement::IDENTITY,
            Self::Pin => only(Rotation::about(DVec3::Z, first)),
            Self::Slider => Placement { translation_m: DVec3::new(first, 0.0, 0.0), ..Placement::IDENTITY },
            Self::Universal => only(Rotation::body_fixed_xyz([first, second, 0.0])),
            Self::Gimbal | Self::Ball => only(turned()),
            Self::Planar => Placement {
                rotation: Rotation::about(DVec3::Z, first),
                translation_m: DVec3::new(second, third, 0.0),
            },
            Self::Free => {
                Placement { rotation: turned(), translation_m: DVec3::new(value(3), value(4), value(5)) }
            }
            Self::Ellipsoid(radii_m) => {
                let rotation = turned();
                Placement { rotation, translation_m: *radii_m * rotation.to_body(DVec3::Z) }
            }
            Self::Spatial(axes) => {
                axes.iter().fold(Placement::IDENTITY, |placement, axis| axis.applied_to(placement, value))
            }
        }
    }

    /// Whether coordinate number `index` of a CustomJoint is the angle of a rotation about an axis; `false` if it is a distance along an
    /// axis, `None` if it is neither. If the coordinate drives several axes, the last one counts, as in OpenSim.
    pub(crate) fn is_pure_rotation(&self, index: usize) -> Option<bool> {
        let Self::Spatial(axes) = self else { return None };
        axes.iter().rfind(|axis| axis.coordinate == Some(index) && axis.is_pure).map(|axis| axis.rotates)
    }

    /// Whether coordinate number `index` is an angle; `false` for a length, `None` if it is neither.
    pub(crate) fn is_angle(&self, index: usize) -> Option<bool> {
        match self {
            Self::Weld => None,
            Self::Pin | Self::Universal | Self::Gimbal | Self::Ball | Self::Ellipsoid(_) => Some(true),
            Self::Slider => Some(false),
            Self::Planar => Some(index == 0),
            Self::Free => Some(index < 3),
            Self::Spatial(_) => self.is_pure_rotation(index),
        }
    }

    /// The placement of the child frame in the parent frame, and its velocity, if the coordinates have `values` and change with `speeds`.
    pub(crate) fn placement_and_velocity(&self, values: &[f64], speeds: Speeds<'_>) -> MovingPlacement {
        let value = |index: usize| values.get(index).copied().unwrap_or(0.0);
        let speed = |index: usize| speeds.speed_at(index);
        let [first, second, third] = [speed(0), speed(1), speed(2)];
        let at = self.placement(values);
        let still = MovingPlacement::at_rest(at);
        match self {
            Self::Weld => still,
            Self::Pin => MovingPlacement { angular_velocity: DVec3::new(0.0, 0.0, first), ..still },
            Self::Slider => MovingPlacement { velocity_m_s: DVec3::new(first, 0.0, 0.0), ..still },
            Self::Universal => {
                let angular_velocity =
                    Rotation::body_fixed_velocity([value(0), value(1), 0.0], [first, second, 0.0]);
                MovingPlacement { angular_velocity, ..still }
            }
            Self::Gimbal => {
                let angles = [value(0), value(1), value(2)];
                let angular_velocity = Rotation::body_fixed_velocity(angles, [first, second, third]);
                MovingPlacement { angular_velocity, ..still }
            }
            Self::Ball => MovingPlacement { angular_velocity: speeds.angular_velocity(values), ..still },
            Self::Planar => MovingPlacement {
                angular_velocity: DVec3::new(0.0, 0.0, first),
                velocity_m_s: DVec3::new(second, third, 0.0),
                ..still
            },
            Self::Free => MovingPlacement {
                angular_velocity: speeds.angular_velocity(values),
                velocity_m_s: DVec3::new(speed(3), speed(4), speed(5)),
                ..still
            },
            Self::Ellipsoid(radii_m) => {
                let angular_velocity = speeds.angular_velocity(values);
                let along = angular_velocity.cross(at.rotation.to_body(DVec3::Z));
                MovingPlacement { angular_velocity, velocity_m_s: *radii_m * along, ..still }
            }
            Self::Spatial(axes) => {
                let start = MovingPlacement::at_rest(Placement::IDENTITY);
                axes.iter().fold(start, |moving, axis| axis.applied_to_moving(moving, value, speed))
            }
        }
    }
}

impl TransformAxis {
    /// Adds the rotation or translation of this axis, and its velocity, to the placement `moving`.
    fn applied_to_moving(
        &self,
        mut moving: MovingPlacement,
        value_of: impl Fn(usize) -> f64,
        speed_of: impl Fn(usize) -> f64,
    ) -> MovingPlacement {
        let rate =
            self.coordinate.map_or(0.0, |index| self.function.slope(value_of(index)) * speed_of(index));
        let length = self.direction.length();
        if length > 0.0 {
            let along = self.direction / length * rate;
            if self.rotates {
                // The axis is one of the frame that those before have turned.
                moving.angular_velocity += moving.at.rotation.to_body(along);
            } else {
                moving.velocity_m_s += along;
            }
        }
        moving.at = self.applied_to(moving.at, value_of);
        moving
    }

    /// Adds the rotation or translation of this axis to `placement`. Each rotation is made in the frame that the rotations before it have
    /// turned.
    fn applied_to(&self, mut placement: Placement, value_of: impl Fn(usize) -> f64) -> Placement {
        let value = self.function.value(self.coordinate.map_or(0.0, value_of));
        if self.rotates {
            placement.rotation = placement.rotation.after(&Rotation::about(self.direction, value));
            return placement;
        }
        let length = self.direction.length();
        // OpenSim gives each axis the length 1; one without length moves nothing.
        let value = if length > 0.0 { value / length } else { 0.0 };
        placement.translation_m += self.direction * value;
        placement
    }
}

/// The axes of a joint's `<SpatialTransform>`, in the order in which OpenSim applies them.
fn transform_axes(document: &Document, joint: ElementId, coordinates: &[&str]) -> Option<Vec<TransformAxis>> {
    let tree = document.tree();
    let Some(transform) = tree.child(joint, "SpatialTransform") else { return Some(Vec::new()) };
    let read = |(index, axis): (usize, ElementId)| {
        let name = tree.attribute(axis, "name").unwrap_or_default();
        let named = ROTATIONS.iter().chain(&TRANSLATIONS).position(|known| *known == &*name);
        let (coordinate, function, is_pure) = axis_function(document, axis, coordinates)?;
        let rotates = named.unwrap_or(index) < ROTATIONS.len();
        let direction = document.triple(axis, "axis").unwrap_or_default().into();
        Some(TransformAxis { rotates, direction, coordinate, function, is_pure })
    };
    tree.children(transform).enumerate().map(read).collect()
}

/// The index of the coordinate that drives one axis, the function of the coordinate, and whether the function is linear with slope 1 or -1.
fn axis_function(
    document: &Document,
    axis: ElementId,
    coordinates: &[&str],
) -> Option<(Option<usize>, CoordinateFunction, bool)> {
    let tree = document.tree();
    let names = tree.child(axis, "coordinates").map(|list| tree.text_of(list)).unwrap_or_default();
    let mut names = opensim_text::list_words(&names);
    let coordinate = match names.next() {
        Some(name) => Some(coordinates.iter().position(|known| *known == name)?),
        None => None,
    };
    // A function of several coordinates is not understood.
    if names.next().is_some() {
        return None;
    }
    let wrapped = tree.child(axis, "function").and_then(|wrapper| tree.children(wrapper).next());
    let is_function = |id: &ElementId| !["coordinates", "axis", "function"].contains(&tree.name(*id));
    let element = wrapped.or_else(|| tree.children(axis).find(is_function));
    let function = match element {
        Some(function) => CoordinateFunction::read(document, function)?,
        None if coordinate.is_none() => CoordinateFunction::ZERO,
        None => return None,
    };
    let is_linear = element.is_some_and(|function| tree.name(function) == "LinearFunction");
    let is_pure = is_linear && function.slope(0.0).abs() == 1.0;
    Some((coordinate, function, is_pure))
}

#[cfg(test)]
mod tests {
    use crate::model::anatomy::Anatomy;
    use crate::model::typed_model::Model;

    /// A chain of the bodies calcn, mid and fore. `middle` and `end` are XML that goes between the frames of the two joints.
    fn anatomy_of_chain(middle: &str, end: &str) -> Anatomy {
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
    fn assert_place(anatomy: &Anatomy, expected: [f64; 3]) {
        let joint = anatomy.joints.iter().find(|joint| joint.name == "mtp_r").unwrap();
        let place = anatomy.joint_place_seen_from("calcn_r", joint).unwrap();
        assert!(place.abs_diff_eq(expected.into(), 1e-15), "{place:?}");
    }

    #[test]
    fn a_joint_is_seen_from_a_body_above_other_bodies() {
        // 0.1 to the joint, 0.02 down to the middle body's origin, then 0.05 on.
        assert_place(&anatomy_of_chain("WeldJoint:", "0.05 0 0"), [0.15, -0.02, 0.0]);
        let anatomy = anatomy_of_chain("WeldJoint:", "0.05 0 0");
        assert!(
            anatomy.joint_place_seen_from("toes_r", &anatomy.joints[1]).is_none(),
            "it is not below the toes"
        );
    }

    #[test]
    fn default_values_turn_and_move_the_bodies_between() {
        let coordinate = |name: &str, value: &str| {
            format!("<Coordinate name=\"{name}\"><default_value>{value}</default_value></Coordinate>")
        };
        // A quarter turn about z: the middle body's x points up, its y back; 0.1 - (-0.02 turned) = 0.1 + 0.02, and 0.05 up.
        let quarter = "1.5707963267948966";
        let pin = format!("PinJoint:<coordinates>{}</coordinates>", coordinate("q", quarter));
        assert_place(&anatomy_of_chain(&pin, "0.05 0 0"), [0.12, 0.05, 0.0]);
        // A CustomJoint for the same quarter turn: half of the angle by each of two functions, and 0.03 along z.
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
        assert_place(&anatomy_of_chain(&custom, "0.05 0 0"), [0.12, 0.05, 0.03]);
        // A curve that is not known is not guessed.
        let unknown = custom.replace("SimmSpline", "GCVSpline");
        let anatomy = anatomy_of_chain(&unknown, "0.05 0 0");
        assert!(anatomy.joint_place_seen_from("calcn_r", &anatomy.joints[1]).is_none());
    }

    #[test]
    fn a_joint_far_down_a_chain_is_not_seen_from_a_body() {
        // Body number n is joined to number n - 1, 0.1 m along x.
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
        let place = |n: usize| anatomy.joint_place_seen_from("b0", anatomy.joint(&format!("j{n}")).unwrap());
        // Joint 65 is at body 64, with 64 joints between.
        assert!((place(65).unwrap()[0] - 6.4).abs() < 1e-12);
        assert!(place(66).is_none());
    }
}
