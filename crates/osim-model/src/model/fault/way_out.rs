//! What a question asks for depends on what was to be done: for a gravity that is not there, for radii that must stay, and for
//! the mass of contacts that are the model's own or a reference's.

use crate::messages::{Input, Phrase, phrase, readable};

use super::note_doubt::NoteDoubt;

/// What a gravity is needed for that the file does not have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum GravityFor {
    /// The weight of the body.
    Weight,
    /// The load that an indentation is about.
    Load,
    /// The speed with which contacts begin.
    ImpactSpeed,
    /// Contacts that were made for it, and are scaled to another.
    Contacts,
    /// The same contacts in a reference.
    Reference,
    /// The model that gets the contacts of another gravity.
    Target,
    /// The weight of a body that a drop is compared with.
    Compared,
    /// Figures under body weight, beside something else that was asked for.
    Figures,
}

impl GravityFor {
    /// Every purpose.
    pub const ALL: [Self; 8] = [
        Self::Weight,
        Self::Load,
        Self::ImpactSpeed,
        Self::Contacts,
        Self::Reference,
        Self::Target,
        Self::Compared,
        Self::Figures,
    ];

    /// What answers it, and its unit; `None` if only the file can.
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

    pub(super) fn phrase(self) -> Phrase {
        let whose = if self == Self::Reference { "the reference" } else { "the model" };
        let mut text = phrase![whose, NO_GRAVITY];
        for (index, &(input, unit)) in self.answers().iter().enumerate() {
            text.push(if index == 0 { ": say " } else { " or " });
            text.push(input.like(unit));
        }
        if self.answers().is_empty() {
            text.push(": set <gravity> in its file");
        }
        text
    }
}

/// What is missing, after whose it is.
const NO_GRAVITY: &str = " has no gravity";

/// Why a radius is about to change, which decides how it can stay.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum RadiusFrom {
    /// The rule of radii.
    Rule,
    /// The bodies that spheres follow.
    Bodies,
    /// A wanted stiffness of the contact.
    ContactStiffness,
    /// A value that is set.
    Assignment,
    /// The foot, whose bottoms are made level: the centre changes then, and not the radius.
    Level,
    /// A fit that moves spheres: the centre changes, and not the radius.
    Fit,
}

impl RadiusFrom {
    /// How the radius stays.
    pub(super) fn phrase(self) -> Phrase {
        match self {
            Self::Rule => phrase!["leave radii as they are with ", Input::Radius.being("keep")],
            Self::Bodies => phrase!["leave radii as they are with ", Input::Keep.being("radius")],
            Self::ContactStiffness => phrase!["leave out ", Input::ContactStiffness],
            Self::Assignment => "set no radius".into(),
            Self::Level => phrase!["leave out ", Input::Level],
            Self::Fit => phrase!["fit what moves no sphere, such as ", Input::Fit.being("height")],
        }
    }
}

/// What is asked about a sphere that `changed` forces use and `left` ones too, up to how its radius stays.
pub(super) fn shared_sphere(sphere: &str, changed: &str, left: &[String], can_choose: bool) -> Phrase {
    let stays = if left.len() == 1 { "which stays as it is" } else { "which stay as they are" };
    let left = left.join(", ");
    let mut text: Phrase =
        format!("sphere {sphere} is used by {changed}, which would change, and by {left}, {stays}: ").into();
    if can_choose {
        text.push(&phrase![
            "choose all of them with ",
            Input::Select.like("GLOB"),
            ", excluding none of these, or "
        ]);
    }
    text
}

/// Asks what contacts with a doubtful note were made for: the model's own, or those of a reference.
pub(super) fn contacts_mass(noted_kg: Option<f64>, doubt: NoteDoubt, input: Input) -> Phrase {
    let noted = noted_kg.map(|kg| format!(" (the note says {} kg)", readable(kg)));
    phrase![
        format!("it is not certain which mass {} made for, because ", contacts_are(input)),
        doubt.as_str(),
        noted.unwrap_or_default(),
        ": give that mass with ",
        input.like("KG")
    ]
}

/// Asks what known contacts were made for, under bodies of another mass.
pub(super) fn known_contacts_mass(title: &str, made_for_kg: f64, bodies_kg: f64, input: Input) -> Phrase {
    let (made_for, bodies) = (readable(made_for_kg), readable(bodies_kg));
    let contacts = contacts_are(input);
    phrase![
        format!(
            "{contacts} those of {title} for a body of {made_for} kg, but the bodies weigh {bodies} kg: if nobody changed the \
             contacts, confirm their mass with "
        ),
        input.being(made_for.clone()),
    ]
}

fn contacts_are(input: Input) -> &'static str {
    match input {
        Input::ReferenceMass => "the contacts of the reference are",
        _ => "the contacts are",
    }
}
