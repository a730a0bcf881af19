//! What can be unknown about a pose.

/// Why it is not known where a body is at the default pose.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PoseFault {
    /// No body of that name is joined to ground.
    #[error("no joints lead from ground to body {body}, so it is not known where it is at the default pose")]
    NotJoined {
        /// The body.
        body: String,
    },
    /// A joint, or a function of it, that is not understood.
    #[error(
        "it is not known how joint {joint}, a {class}, stands at the default pose: one of its functions, or the joint itself, is not understood"
    )]
    Joint {
        /// The joint.
        joint: String,
        /// Its class.
        class: String,
    },
    /// A coordinate without a value.
    #[error("coordinate {coordinate} of joint {joint} has no default value that can be read")]
    Coordinate {
        /// The coordinate.
        coordinate: String,
        /// The joint.
        joint: String,
    },
    /// A constraint that may move bodies before anything else does.
    #[error(
        "constraint {constraint}, a {class}, may move bodies at the default pose, which is not computed: switch it off in a copy of the model"
    )]
    Constraint {
        /// The constraint.
        constraint: String,
        /// Its class.
        class: String,
    },
    /// Joints in a loop that does not close.
    #[error("joint {joint} closes a loop of joints that is open at the default pose")]
    Loop {
        /// The joint.
        joint: String,
    },
}
