//! What only the user can know about the size of a body against that of another model.

use crate::messages::{Input, Part, Phrase, phrase};

/// What has to be answered about the factors of a body.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FactorQuestion {
    /// Two meshes of one body have different factors.
    Meshes {
        /// Name of the body.
        body: String,
        /// The meshes, and what each says along x, y and z.
        meshes: [(String, [f64; 3]); 2],
    },
    /// Left and right have different factors in models that are not scaled copies of each other.
    Sides {
        /// Names of both bodies.
        bodies: [String; 2],
        /// What each would get along x, y and z; NaN where it is not known.
        factors: [[f64; 3]; 2],
    },
    /// A mesh of one name shows another animal's bone: what its factors say of a distance, and the distance itself, are far apart.
    OtherBone {
        /// Name of the body.
        body: String,
        /// The joint that the distance goes to.
        joint: String,
        /// The distance against the reference's, by the mesh and by the joint.
        ratios: [f64; 2],
    },
    /// Two different models have nothing in common that says how large a body is.
    Nothing {
        /// Name of the body.
        body: String,
    },
    /// The factors of the Scale Tool's file do not lead from the reference to the model.
    OtherReference {
        /// Name of the body.
        body: String,
        /// A joint on it that is somewhere else.
        joint: String,
        /// How far it is from where the file puts it, m.
        apart_m: f64,
    },
}

impl FactorQuestion {
    /// What is not known, and how to say it.
    pub(super) fn phrase(&self) -> Phrase {
        let one = |factor: f64| if factor.is_nan() { "unknown".to_owned() } else { format!("{factor:.4}") };
        let three = |factors: &[f64; 3]| factors.map(one).join(", ");
        match self {
            Self::Meshes { body, meshes: [(one, by_one), (other, by_other)] } => phrase![
                format!(
                    "the meshes of body {body} say different factors: {one} says {}, {other} says {}",
                    three(by_one),
                    three(by_other)
                ),
                say(": say which with ", &[body]),
            ],
            Self::Sides { bodies: [one, other], factors: [by_one, by_other] } => phrase![
                format!(
                    "left and right would get different factors, and this model is not a scaled copy of the reference: {one} {}, \
                     {other} {}",
                    three(by_one),
                    three(by_other)
                ),
                say(": say them with ", &[one, other]),
            ],
            Self::OtherBone { body, joint, ratios: [by_mesh, by_joint] } => phrase![
                format!(
                    "the mesh of body {body} has a bone of the reference's size times {by_mesh:.4}, but its distance to joint {joint} is \
                     the reference's times {by_joint:.4}: the file is probably another animal's bone of the same name"
                ),
                say("; say the factors with ", &[body]),
            ],
            Self::Nothing { body } => phrase![
                format!(
                    "how large body {body} is against the reference's is not in the files (no mesh of the same bone, and no joint \
                     of the same name 20 mm or more from its origin)"
                ),
                say(": say it with ", &[body]),
            ],
            Self::OtherReference { body, joint, apart_m } => phrase![
                format!("joint {joint} on {body} is {:.1} mm from where ", apart_m * 1000.0),
                Input::BodyScaleFile,
                " puts it: that file was applied to another model than the reference; take the contacts from that model, or leave ",
                Input::BodyScaleFile,
                " out",
            ],
        }
    }
}

/// The way out of a verb that takes the factors of `bodies`.
fn say(how: &'static str, bodies: &[&String]) -> Part {
    let named = bodies.iter().map(|body| Input::BodyScale.being(format!("{body}=x,y,z")).into());
    let named = Phrase::joined(named, " and ").unwrap_or_default();
    Input::BodyScale.either(phrase![how, &named], "")
}
