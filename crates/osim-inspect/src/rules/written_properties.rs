//! How OpenSim reads the texts of properties on which a pose, a mass or a contact force depends, by class, and what else is in an element
//! of a skeleton.

/// How OpenSim reads the text of a property.
#[derive(Clone, Copy)]
pub(super) enum TextForm {
    /// The text is a list of this many numbers.
    Numbers(usize),
    /// The text is a flag: true or false.
    Flag,
    /// `isDisabled`, which documents up to 30508 have.
    OldFlag,
    /// Numbers that commas may separate and brackets may enclose; the number of them, if it is fixed. OpenSim refuses a model in which it
    /// cannot read them.
    OldNumbers(Option<usize>),
    /// A list of any count of numbers, which nothing encloses.
    List,
    /// One whole number. OpenSim refuses a model in which it cannot read it.
    OldCount,
}
use TextForm::{Flag, List, Numbers, OldCount, OldFlag, OldNumbers};

/// Properties of one form: their tags, the form of the text, and the default in OpenSim. If there is no default, OpenSim refuses the model.
pub(super) type WrittenProperties = (&'static [&'static str], TextForm, Option<&'static str>);

/// OpenSim's default of a location or an orientation.
const ZERO_VECTOR: Option<&str> = Some("0 0 0");
/// How OpenSim reads the properties of contact geometry that place it.
const GEOMETRY_TEXTS: &[WrittenProperties] = &[(&["location", "orientation"], Numbers(3), ZERO_VECTOR)];
/// How OpenSim reads the properties of an offset frame that place it.
const FRAME_TEXTS: &[WrittenProperties] = &[(&["translation", "orientation"], Numbers(3), ZERO_VECTOR)];
/// How OpenSim reads the properties of a joint that its motion depends on.
const JOINT_TEXTS: &[WrittenProperties] = &[
    // Documents before version 4 have the frames of a joint in the joint itself.
    (&["location_in_parent", "orientation_in_parent", "location", "orientation"], OldNumbers(Some(3)), None),
    (&["location_in_child", "orientation_in_child"], OldNumbers(Some(3)), None),
    (&["reverse"], Flag, Some("false")),
    (&["radii_x_y_z", "thoracic_ellipsoid_radii_x_y_z"], Numbers(3), None),
    (&["scapula_winging_axis_origin"], Numbers(2), Some("0 0")),
    (&["scapula_winging_axis_direction"], Numbers(1), Some("0")),
    (&["neutral_angle_x_z_y"], Numbers(3), ZERO_VECTOR),
    (&["length"], Numbers(1), Some("1")),
];
/// How OpenSim reads the points of a curve.
const CURVE_TEXTS: &[WrittenProperties] = &[
    (&["x", "y", "weights"], OldNumbers(None), None),
    (&["half_order"], OldCount, None),
    (&["error_variance"], Numbers(1), None),
];
/// How OpenSim reads the properties of a step.
const STEP_TEXTS: &[WrittenProperties] =
    &[(&["transition_start_time", "transition_end_time", "start_value", "end_value"], Numbers(1), None)];
/// How OpenSim reads the places of a bushing in documents before version 4.
const OLD_BUSHING_TEXTS: &[WrittenProperties] = &[(
    &["location_body_1", "location_body_2", "orientation_body_1", "orientation_body_2"],
    OldNumbers(Some(3)),
    None,
)];
/// How OpenSim reads the properties of a constraint that the default pose depends on.
const CONSTRAINT_TEXTS: &[WrittenProperties] = &[
    (&["isEnforced"], Flag, Some("true")),
    (&["isDisabled"], OldFlag, Some("false")),
    (&["scale_factor"], Numbers(1), Some("1")),
    (&["constant_distance"], Numbers(1), None),
    (
        &["location_body_1", "location_body_2", "orientation_body_1", "orientation_body_2"],
        Numbers(3),
        ZERO_VECTOR,
    ),
    (&["line_direction_vec", "point_on_line", "point_on_follower"], Numbers(3), ZERO_VECTOR),
];

/// The properties of `class` on which a pose, a mass or a contact force depends, without the properties of contacts that are a [`Value`].
pub(super) fn written_properties(class: &str) -> &'static [WrittenProperties] {
    match class {
        "Model" => &[(&["gravity"], Numbers(3), Some("0 -9.80665 0"))],
        "Body" => &[
            (&["mass_center"], Numbers(3), ZERO_VECTOR),
            (&["inertia"], Numbers(6), Some("0 0 0 0 0 0")),
            (
                &["inertia_xx", "inertia_yy", "inertia_zz", "inertia_xy", "inertia_xz", "inertia_yz"],
                Numbers(1),
                None,
            ),
        ],
        "Mesh" => &[(&["scale_factors"], Numbers(3), Some("1 1 1"))],
        "VisibleObject" | "DisplayGeometry" => &[
            (&["scale_factors"], Numbers(3), Some("1 1 1")),
            (&["transform"], OldNumbers(Some(6)), None),
            (&["color"], OldNumbers(Some(3)), None),
            (&["display_preference"], OldCount, None),
        ],
        "Coordinate" => &[
            (&["default_value", "default_speed_value"], Numbers(1), Some("0")),
            (&["range"], Numbers(2), Some("-10 10")),
            (&["clamped", "locked", "prescribed", "is_free_to_satisfy_constraints"], Flag, Some("false")),
        ],
        "TransformAxis" => &[(&["axis"], Numbers(3), Some("1 0 0"))],
        "Constant" => &[(&["value"], Numbers(1), None)],
        "MultiplierFunction" => &[(&["scale"], Numbers(1), None)],
        "LinearFunction" => &[(&["coefficients"], OldNumbers(Some(2)), None)],
        "PolynomialFunction" => &[(&["coefficients"], List, Some("1"))],
        "MultivariatePolynomialFunction" => &[(&["coefficients"], List, None)],
        "Sine" => {
            &[(&["amplitude", "omega"], Numbers(1), Some("1")), (&["phase", "offset"], Numbers(1), Some("0"))]
        }
        "StepFunction" => STEP_TEXTS,
        _ if class.ends_with("Spline") || class.starts_with("Piecewise") => CURVE_TEXTS,
        "ContactEllipsoid" => &[(&["location", "orientation", "radii"], Numbers(3), ZERO_VECTOR)],
        // A NaN in the orientation of a sphere makes its force NaN.
        "ContactSphere" | "ContactHalfSpace" => GEOMETRY_TEXTS,
        "HuntCrossleyForce" => {
            &[(&["appliesForce"], Flag, Some("true")), (&["isDisabled"], OldFlag, Some("false"))]
        }
        "ElasticFoundationForce" => &[
            (&["appliesForce"], Flag, Some("true")),
            (&["isDisabled"], OldFlag, Some("false")),
            (&["transition_velocity"], Numbers(1), Some("0.01")),
        ],
        "ElasticFoundationForce::ContactParameters" => &[(
            &["stiffness", "dissipation", "static_friction", "dynamic_friction", "viscous_friction"],
            Numbers(1),
            Some("0"),
        )],
        "SmoothSphereHalfSpaceForce" => &[
            (&["appliesForce"], Flag, Some("true")),
            // As Moco 0.1 to 0.3 wrote them.
            (
                &["contact_sphere_location", "contact_half_space_location", "contact_half_space_orientation"],
                Numbers(3),
                ZERO_VECTOR,
            ),
        ],
        "BushingForce" => OLD_BUSHING_TEXTS,
        // OpenSim refuses one with an infinite limit or without a transition.
        "CoordinateLimitForce" => &[
            (&["upper_stiffness", "lower_stiffness"], Numbers(1), Some("1")),
            (&["upper_limit", "lower_limit"], Numbers(1), Some("0")),
            (&["damping"], Numbers(1), Some("0.001")),
            (&["transition"], Numbers(1), Some("0.1")),
        ],
        _ if class.ends_with("Frame") => FRAME_TEXTS,
        _ if class.ends_with("Joint") => JOINT_TEXTS,
        _ if class.ends_with("Constraint") => CONSTRAINT_TEXTS,
        _ => &[],
    }
}

/// What is in a `TransformAxis` beside its numbers: the function is in an element of its own, or stands there itself.
pub(super) const PARTS_OF_AXIS: &[&str] = &[
    "coordinates",
    "function",
    "Constant",
    "GCVSpline",
    "LinearFunction",
    "MultiplierFunction",
    "NaturalCubicSpline",
    "PiecewiseConstantFunction",
    "PiecewiseLinearFunction",
    "PolynomialFunction",
    "SimmSpline",
];

/// The last version whose axes have one `<coordinate>` instead of `<coordinates>`.
pub(super) const LAST_VERSION_WITH_ONE_COORDINATE: u32 = 10900;

/// What is in an element `tag` of a skeleton beside numbers and flags, if its names are looked at. It is in an element `parent`.
pub(super) fn known_parts<'t>(tag: &str, parent: impl Fn() -> &'t str) -> &'static [&'static str] {
    match tag {
        "SpatialTransform" => &["TransformAxis"],
        "CoordinateSet" => &["objects"],
        "objects" if parent() == "CoordinateSet" => &["Coordinate"],
        "coordinates" if parent().ends_with("Joint") => &["Coordinate"],
        "Body" => &["mass", "Joint", "FrameGeometry", "frame_geometry"],
        "HuntCrossleyForce::ContactParameters" => &["geometry"],
        "CoordinateCouplerConstraint" => {
            &["coupled_coordinates_function", "independent_coordinate_names", "dependent_coordinate_name"]
        }
        "function"
        | "coupled_coordinates_function"
        | "prescribed_function"
        | "TransformAxis"
        | "MultiplierFunction" => PARTS_OF_AXIS,
        _ if tag == "Ground" || tag.ends_with("Frame") => &["FrameGeometry", "frame_geometry"],
        _ if tag.ends_with("Joint") => {
            &["frames", "coordinates", "CoordinateSet", "SpatialTransform", "parent_body"]
        }
        _ => &[],
    }
}
