//! Reasons why the caller has to give a fact: the use of gravity, doubts about a note, unknown factors of bodies.

use crate::messages::{Input, Phrase, PhrasePart, Verb, named, phrase, readable};

/// The use of gravity in a request, if the file gives no gravity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GravityFor {
    Weight,
    Load,
    /// For the impact speed at the beginning of a contact.
    ImpactSpeed,
    /// For contacts that are scaled to another gravity: the gravity for which they were made.
    Contacts,
    Reference,
    /// For the model that gets contacts made for another gravity.
    Target,
    /// For the weight of a body with which a drop is compared.
    Compared,
    /// For forces in body weights, in figures that the caller did not ask for.
    Figures,
}

impl GravityFor {
    /// The inputs with which the caller can give the gravity, with placeholders for their values; empty if only the file can give it.
    const fn answers(self) -> &'static [(Input, &'static str)] {
        match self {
            Self::Weight => &[(Input::Gravity, "G")],
            Self::Load => &[(Input::Gravity, "G"), (Input::Load, "N")],
            Self::ImpactSpeed => &[(Input::ImpactSpeed, "M/S")],
            Self::Contacts => &[(Input::ContactsGravity, "G")],
            Self::Reference => &[(Input::ReferenceGravity, "G")],
            Self::Target => &[(Input::TargetGravity, "G")],
            Self::Compared | Self::Figures => &[],
        }
    }

    /// The message that the gravity is not known, with the inputs that give it.
    pub(super) fn phrase(self) -> Phrase {
        let whose = if self == Self::Reference { "the reference" } else { "the model" };
        let mut text = phrase![whose, NO_GRAVITY];
        for (index, &(input, unit)) in self.answers().iter().enumerate() {
            text.push(if index == 0 { ": give " } else { " or " });
            text.push(input.with_placeholder(unit));
        }
        if self.answers().is_empty() {
            text.push(": set <gravity> in its file");
        }
        text
    }
}

/// The end of a sentence that begins with "the model" or "the reference".
const NO_GRAVITY: &str = " has no gravity";

/// Why the radius or the centre of a sphere would change. The advice on keeping it depends on this.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RadiusChangeReason {
    Rule,
    /// Spheres follow bodies that were scaled.
    Bodies,
    ContactStiffness,
    Assignment,
    /// The bottoms of a foot are made level: the centre changes, not the radius.
    Level,
    /// A fit moves spheres: the centre changes, not the radius.
    Fit,
}

impl RadiusChangeReason {
    /// Advice on how the radius can stay as it is.
    pub(super) fn phrase(self) -> Phrase {
        match self {
            Self::Rule => phrase!["leave radii as they are with ", Input::Radius.with_value("keep")],
            Self::Bodies => phrase!["leave radii as they are with ", Input::Keep.with_value("radius")],
            Self::ContactStiffness => phrase!["leave out ", Input::ContactStiffness],
            Self::Assignment => "set no radius".into(),
            Self::Level => phrase!["leave out ", Input::Level],
            Self::Fit => phrase!["fit what moves no sphere, such as ", Input::Fit.with_value("height")],
        }
    }
}

/// The beginning of the message about a sphere that both `changed` forces and `left` forces use. The end, how its radius can stay, is
/// added later.
pub(super) fn shared_sphere(sphere: &str, changed: &str, left: &[String], can_choose: bool) -> Phrase {
    let stays = if left.len() == 1 { "which stays as it is" } else { "which stay as they are" };
    let left = left.join(", ");
    let mut text: Phrase =
        format!("sphere {sphere} is used by {changed}, which would change, and by {left}, {stays}: ").into();
    if can_choose {
        text.push(&phrase![
            "choose all of them with {}, excluding none of these, or ";
            Input::Select.with_placeholder("GLOB")
        ]);
    }
    text
}

/// The message that asks for which mass contacts were made, if the note is in doubt: the model's own contacts, or those of a reference.
pub(super) fn contacts_mass(noted_kg: Option<f64>, doubt: NoteDoubt, input: Input) -> Phrase {
    let noted = noted_kg.map(|kg| format!(" (the note says {} kg)", readable(kg)));
    phrase![
        "it is not certain which mass {} made for, because {}{}{}";
        contacts_are(input), doubt.as_str(), noted.unwrap_or_default(),
        input.either(phrase![": give that mass with ", input.with_placeholder("KG")], "")
    ]
}

/// The message that asks for which mass published contacts were made, on bodies of another mass.
pub(super) fn known_contacts_mass(title: &str, made_for_kg: f64, bodies_kg: f64, input: Input) -> Phrase {
    let (made_for, bodies) = (readable(made_for_kg), readable(bodies_kg));
    let contacts = contacts_are(input);
    phrase![
        format!(
            "{contacts} those of {title} for a body of {made_for} kg, but the bodies weigh {bodies} kg: if OpenSim scaled this \
             model, "
        ),
        &match input {
            Input::ReferenceMass => "take the one that was scaled; if the contacts are right where they are, confirm their mass with ".into(),
            _ => phrase![
                "take the contacts of the one that was scaled with ",
                Verb::Transfer
                    .call_with_model()
                    .with_placeholder(Input::From, "GENERIC")
                    .with_flag(Input::FollowBodies)
                    .with_flag(Input::Level),
                "; if only the mass changes, confirm that of the contacts with ",
            ],
        },
        input.with_value(made_for.clone()),
    ]
}

fn contacts_are(input: Input) -> &'static str {
    match input {
        Input::ReferenceMass => "the contacts of the reference are",
        _ => "the contacts are",
    }
}

named! {
    /// Why the note in a file may not describe its contacts any more.
    pub enum NoteDoubt {
        /// The model has no note, and the sum of its bodies differs from the known mass: the bodies were scaled.
        Absent = "the bodies were scaled, and the file has no note of this program",
        Unreadable = "the note that this program left in the file is damaged",
        /// Force set and geometry set have notes from different changes.
        MixedPair = "the force set and its geometry set come from different runs",
        ValuesChanged = "contacts were changed after this program left its note in the file",
        /// The change that wrote the note changed only some of the contacts' values; the others may be made for another mass.
        Partial = "the run that left the note in the file changed only some values",
        /// The note says that the mass is not known.
        MassUnknown = "the mass was not known when this program left its note in the file",
        /// The note has no mass because the mass of the bodies was taken, and the bodies were scaled later.
        BodiesScaled = "the note in the file gives no mass, and the bodies were scaled after it was written",
    }
}

/// Why the scale factors of a body are not known.
#[derive(Debug, Clone, PartialEq)]
pub enum UnknownFactors {
    /// Two meshes of one body have different factors along x, y and z.
    Meshes { body: String, meshes: [(String, [f64; 3]); 2] },
    /// Left and right have different factors along x, y and z, in models that are not scaled copies of each other; NaN for unknown ones.
    Sides { bodies: [String; 2], factors: [[f64; 3]; 2] },
    /// A mesh has the name of the bone but probably belongs to another animal: the ratio of the distance of a joint to the reference's is
    /// another by the factors of the mesh than as measured.
    OtherBone { body: String, joint: String, ratios: [f64; 2] },
    /// Two different models have no mesh or joint in common that gives the size of a body.
    NoSource { body: String },
    /// The factors of the Scale Tool's file do not lead from the reference to the model: a joint is `apart_m` from where they put it.
    OtherReference { body: String, joint: String, apart_m: f64 },
}

impl UnknownFactors {
    /// The message: which factors are unknown, and how the caller can give them.
    pub(super) fn phrase(&self) -> Phrase {
        let one = |factor: f64| if factor.is_nan() { "unknown".to_owned() } else { format!("{factor:.4}") };
        let three = |factors: &[f64; 3]| factors.map(one).join(", ");
        match self {
            Self::Meshes { body, meshes: [(one, by_one), (other, by_other)] } => phrase![
                "the meshes of body {body} give different factors: {one} gives {}, {other} gives {}{}";
                three(by_one).to_string(), three(by_other).to_string(),
                body_scale_hint(": give the right ones with ", &[body])
            ],
            Self::Sides { bodies: [one, other], factors: [by_one, by_other] } => phrase![
                "left and right would get different factors, and this model is not a scaled copy of the reference: \
                {one} {}, {other} {}{}";
                three(by_one).to_string(), three(by_other).to_string(),
                body_scale_hint(": say them with ", &[one, other])
            ],
            Self::OtherBone { body, joint, ratios: [by_mesh, by_joint] } => phrase![
                "the mesh of body {body} has a bone of the reference's size times {by_mesh:.4}, but its distance to \
                joint {joint} is the reference's times {by_joint:.4}: the file is probably another animal's bone of \
                the same name{}";
                body_scale_hint("; say the factors with ", &[body])
            ],
            Self::NoSource { body } => phrase![
                "the size of body {body} compared with the reference is not in the files (no mesh of the same bone, \
                and no joint of the same name 20 mm or more from its origin){}";
                body_scale_hint(": say it with ", &[body])
            ],
            Self::OtherReference { body, joint, apart_m } => phrase![
                "joint {joint} on {body} is {} mm from where {} puts it: that file was applied to another model than \
                the reference; take the contacts from that model, or leave {} out";
                format!("{:.1}", apart_m * 1000.0), Input::BodyScaleFile, Input::BodyScaleFile
            ],
        }
    }
}

/// Advice for a verb that takes the scale factors of `bodies`.
fn body_scale_hint(how: &'static str, bodies: &[&String]) -> PhrasePart {
    let named = bodies.iter().map(|body| Input::BodyScale.with_value(format!("{body}=x,y,z")).into());
    let named = Phrase::joined(named, " and ").unwrap_or_default();
    Input::BodyScale.either(phrase![how, &named], "")
}
