//! The component classes that OpenSim knows; and the sets of a model that are read if another set is given as a separate file.

/// Subclasses of `Component` in the Python package `opensim` 4.6, sorted.
const COMPONENT_CLASSES: &[&str] = &[
    "AbstractGeometryPath",
    "AbstractPathPoint",
    "AbstractReporter",
    "ActivationCoordinateActuator",
    "ActivationFiberLengthMuscle",
    "Actuator",
    "ActuatorForceProbe",
    "ActuatorPowerProbe",
    "AnalyticGeometry",
    "Arrow",
    "BallJoint",
    "Bhargava2004MuscleMetabolicsProbe",
    "Bhargava2004SmoothedMuscleMetabolics",
    "Bhargava2004SmoothedMuscleMetabolics_MuscleParameters",
    "Blankevoort1991Ligament",
    "Body",
    "BodyActuator",
    "BodySet",
    "Brick",
    "BushingForce",
    "ClutchedPathSpring",
    "Component",
    "ComponentSet",
    "ConditionalPathPoint",
    "Cone",
    "ConsoleReporter",
    "ConsoleReporterVec3",
    "ConstantCurvatureJoint",
    "ConstantDistanceConstraint",
    "Constraint",
    "ConstraintSet",
    "ContactCylinder",
    "ContactEllipsoid",
    "ContactGeometry",
    "ContactGeometrySet",
    "ContactHalfSpace",
    "ContactMesh",
    "ContactSphere",
    "ContactTorus",
    "Controller",
    "ControllerSet",
    "Coordinate",
    "CoordinateActuator",
    "CoordinateCouplerConstraint",
    "CoordinateLimitForce",
    "CustomJoint",
    "Cylinder",
    "DeGrooteFregly2016Muscle",
    "ElasticFoundationForce",
    "Ellipsoid",
    "EllipsoidJoint",
    "ExponentialContactForce",
    "ExpressionBasedBushingForce",
    "ExpressionBasedCoordinateForce",
    "ExpressionBasedPathForce",
    "ExpressionBasedPointToPointForce",
    "ExternalForce",
    "ExternalLoads",
    "Force",
    "ForceProducer",
    "ForceSet",
    "Frame",
    "FrameGeometry",
    "FreeJoint",
    "FunctionBasedBushingForce",
    "FunctionBasedPath",
    "Geometry",
    "GeometryPath",
    "GimbalJoint",
    "Ground",
    "HopperDevice",
    "HuntCrossleyForce",
    "IMU",
    "InputController",
    "Joint",
    "JointInternalPowerProbe",
    "JointSet",
    "Ligament",
    "LineGeometry",
    "Marker",
    "MarkerSet",
    "McKibbenActuator",
    "Mesh",
    "MeyerFregly2016Force",
    "MeyerFregly2016Muscle",
    "Millard2012AccelerationMuscle",
    "Millard2012EquilibriumMuscle",
    "MocoScaleFactor",
    "Model",
    "ModelComponent",
    "ModelComponentSetBodies",
    "ModelComponentSetConstraints",
    "ModelComponentSetContactGeometry",
    "ModelComponentSetControllers",
    "ModelComponentSetExternalForces",
    "ModelComponentSetForces",
    "ModelComponentSetFrames",
    "ModelComponentSetJoints",
    "ModelComponentSetMarkers",
    "ModelComponentSetModelComponent",
    "ModelComponentSetProbes",
    "ModelComponentSetWrapObjects",
    "MovingPathPoint",
    "Muscle",
    "MuscleActiveFiberPowerProbe",
    "MuscleFirstOrderActivationDynamicModel",
    "MuscleFixedWidthPennationModel",
    "PathActuator",
    "PathPoint",
    "PathSpring",
    "PathWrap",
    "PathWrapPoint",
    "PhysicalFrame",
    "PhysicalFrameWithOffset",
    "PhysicalOffsetFrame",
    "PinJoint",
    "PlanarJoint",
    "Point",
    "PointActuator",
    "PointConstraint",
    "PointOnLineConstraint",
    "PointToPointActuator",
    "PointToPointSpring",
    "PositionMotion",
    "PrescribedController",
    "PrescribedForce",
    "Probe",
    "ProbeSet",
    "ReporterDouble",
    "ReporterVec3",
    "ReporterVector",
    "RigidTendonMuscle",
    "ScalarActuator",
    "ScapulothoracicJoint",
    "Scholz2015GeometryPath",
    "Scholz2015GeometryPathElement",
    "Scholz2015GeometryPathObstacle",
    "Scholz2015GeometryPathPoint",
    "SetBodies",
    "SetConstraints",
    "SetContactGeometry",
    "SetControllers",
    "SetExternalForces",
    "SetForces",
    "SetFrames",
    "SetJoints",
    "SetMarkers",
    "SetModelComponents",
    "SetProbes",
    "SetWrapObject",
    "SliderJoint",
    "SmoothSphereHalfSpaceForce",
    "Sphere",
    "SpringGeneralizedForce",
    "StatesTrajectoryReporter",
    "Station",
    "StationDefinedFrame",
    "SynergyController",
    "SystemEnergyProbe",
    "TableReporter",
    "TableReporterVec3",
    "TableReporterVector",
    "TableSource",
    "TableSourceVec3",
    "Thelen2003Muscle",
    "TorqueActuator",
    "Torus",
    "ToyPropMyoController",
    "ToyReflexController",
    "TwoFrameLinkerConstraint",
    "TwoFrameLinkerForce",
    "TwoFrameLinkerForceProducer",
    "Umberger2010MuscleMetabolicsProbe",
    "UniversalJoint",
    "WeldConstraint",
    "WeldJoint",
    "WrapCylinder",
    "WrapEllipsoid",
    "WrapObject",
    "WrapObjectSet",
    "WrapSphere",
    "WrapTorus",
];

/// Whether OpenSim 4.6 reads components of this class.
pub(super) fn is_component_class(tag: &str) -> bool {
    COMPONENT_CLASSES.binary_search(&tag).is_ok()
}

/// Which sets of a model file (`ForceSet`, `ContactGeometrySet`, `BodySet`, …) are read. A set that is given as a separate file replaces the model's own set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CountedSets {
    All,
    /// Only the contact geometry: the file is given for its spheres, and another model has masses and joints.
    Geometry,
    /// Everything except forces: the separate set has the forces.
    AllButForces,
    /// Everything except forces and contact geometry: other files have these.
    Bodies,
}

impl CountedSets {
    /// The sets that are read from file number `index` of the `count` files given with a separate set. The geometry comes first, then the
    /// model.
    pub(super) fn of_file_beside_set(index: usize, count: usize) -> Self {
        match (index, count) {
            (0, 1) => Self::AllButForces,
            (0, _) => Self::Geometry,
            _ => Self::Bodies,
        }
    }

    /// Whether `set` is read from the file.
    pub(super) fn includes(self, set: &str) -> bool {
        match self {
            Self::All => true,
            Self::Geometry => set == "ContactGeometrySet",
            Self::AllButForces => set != "ForceSet",
            Self::Bodies => !["ForceSet", "ContactGeometrySet"].contains(&set),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_component_classes_are_sorted() {
        assert!(COMPONENT_CLASSES.is_sorted());
        assert!(
            is_component_class("SmoothSphereHalfSpaceForce")
                && is_component_class("Body")
                && !is_component_class("MyContacts")
        );
    }
}
