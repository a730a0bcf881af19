//! Tests of numbers with mass, length or time in their unit.

use osim_model::{Model, SizedKind, SizedValues};

/// The numbers of one kind, in file order.
fn values_of_kind(found: &SizedValues, kind: SizedKind) -> Vec<f64> {
    found.values.iter().filter(|one| one.kind == kind).map(|one| one.value).collect()
}

fn sizes_of_model(version: u32, inside: &str) -> SizedValues {
    let text = format!(r#"<OpenSimDocument Version="{version}"><Model>{inside}</Model></OpenSimDocument>"#);
    SizedValues::of(&Model::parse(text).unwrap())
}

#[test]
fn numbers_come_from_the_object_then_defaults_then_the_class() {
    let found = sizes_of_model(
        40000,
        "<defaults><Thelen2003Muscle name='default'><activation_time_constant>0.02</activation_time_constant>
            <max_isometric_force>7</max_isometric_force></Thelen2003Muscle></defaults>
        <ForceSet><objects><Thelen2003Muscle name='a'><max_isometric_force> 900 </max_isometric_force></Thelen2003Muscle>
            <Thelen2003Muscle name='b'/></objects></ForceSet>",
    );
    assert_eq!(values_of_kind(&found, SizedKind::MaxIsometricForce), [900.0, 7.0]);
    assert_eq!(values_of_kind(&found, SizedKind::ActivationTime), [0.02, 0.02]);
    // `opensim.Thelen2003Muscle()` of OpenSim 4.6 has these.
    assert_eq!(values_of_kind(&found, SizedKind::DeactivationTime), [0.05, 0.05]);
    assert_eq!(values_of_kind(&found, SizedKind::OptimalFiberLength), [0.1, 0.1]);
    assert_eq!(values_of_kind(&found, SizedKind::MaxContractionVelocity), [10.0, 10.0]);
}

#[test]
fn the_kind_of_a_force_on_a_coordinate_depends_on_the_coordinate() {
    let found = sizes_of_model(
        40000,
        "<BodySet><objects><Body name='b'><mass>1</mass></Body></objects></BodySet>
        <JointSet><objects><PlanarJoint name='j'><socket_parent_frame>/ground</socket_parent_frame>
            <socket_child_frame>/bodyset/b</socket_child_frame><coordinates><Coordinate name='turn'/><Coordinate name='x'/>
            <Coordinate name='y'/></coordinates></PlanarJoint></objects></JointSet>
        <ForceSet><objects>
            <CoordinateActuator name='torque'><coordinate>turn</coordinate><optimal_force>5</optimal_force></CoordinateActuator>
            <CoordinateActuator name='force'><coordinate>y</coordinate><optimal_force>6</optimal_force></CoordinateActuator>
            <CoordinateLimitForce name='angle'><coordinate>turn</coordinate><upper_limit>30</upper_limit></CoordinateLimitForce>
            <CoordinateLimitForce name='place'><coordinate>x</coordinate><upper_limit>2</upper_limit></CoordinateLimitForce>
            <SpringGeneralizedForce name='lost'><coordinate>nowhere</coordinate><stiffness>8</stiffness></SpringGeneralizedForce>
        </objects></ForceSet>",
    );
    assert_eq!(values_of_kind(&found, SizedKind::ActuatorTorque), [5.0]);
    assert_eq!(values_of_kind(&found, SizedKind::ActuatorForce), [6.0]);
    // A limit of an angle is no length; its two kinds of stiffness are 1 in OpenSim, its transition is 0.1.
    assert_eq!(values_of_kind(&found, SizedKind::LimitRotationalStiffness), [1.0, 1.0]);
    assert_eq!(values_of_kind(&found, SizedKind::LimitLength), [2.0, 0.0, 0.1]);
    assert!(values_of_kind(&found, SizedKind::CoordinateStiffness).is_empty());
    assert_eq!(found.not_read.len(), 1);
    assert_eq!((found.not_read[0].class.as_str(), found.not_read[0].count), ("SpringGeneralizedForce", 1));
}

#[test]
fn bushings_have_three_numbers_and_expressions_are_not_read() {
    let found = sizes_of_model(
        40000,
        "<ForceSet><objects>
            <BushingForce name='b'><rotational_stiffness>1 2 3</rotational_stiffness></BushingForce>
            <ExpressionBasedBushingForce name='e'><Mx_expression>-5*theta_x</Mx_expression>
                <rotational_damping>4 5 6</rotational_damping></ExpressionBasedBushingForce>
            <PathSpring name='p'><stiffness>10</stiffness></PathSpring>
        </objects></ForceSet>",
    );
    assert_eq!(values_of_kind(&found, SizedKind::BushingRotationalStiffness), [1.0, 2.0, 3.0]);
    assert_eq!(values_of_kind(&found, SizedKind::BushingRotationalDamping), [0.0, 0.0, 0.0, 4.0, 5.0, 6.0]);
    assert_eq!(values_of_kind(&found, SizedKind::SpringStiffness), [10.0]);
    // OpenSim has NaN for a length that is not given.
    assert!(values_of_kind(&found, SizedKind::SpringLength).is_empty());
    let unread: Vec<(&str, &str)> = found.not_read.iter().map(|one| (one.class.as_str(), one.why)).collect();
    assert_eq!(unread, [("ExpressionBasedBushingForce", "expressions")]);
}

#[test]
fn moments_of_inertia_in_separate_elements_are_read() {
    let found = sizes_of_model(
        30000,
        "<BodySet><objects><Body name='b'><mass>1</mass><inertia_xx>1</inertia_xx><inertia_yy>2</inertia_yy>
            <inertia_zz>4</inertia_zz></Body></objects></BodySet>",
    );
    assert_eq!(values_of_kind(&found, SizedKind::Inertia), [7.0]);
}
