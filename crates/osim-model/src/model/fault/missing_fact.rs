//! Facts that the caller has to give, because the files do not contain them.

use crate::messages::{Input, Phrase, PhrasePart, phrase, readable};
use crate::model::fault::reasons::{
    GravityFor, NoteDoubt, RadiusChangeReason, UnknownFactors, contacts_mass, known_contacts_mass,
    shared_sphere,
};

/// Advice for a set in a separate file, given to a verb that needs a whole model.
const WHOLE_MODELS: &str = "name the model (.osim) that has both: this works on whole models";

/// A fact that the caller has to give, because the files do not contain it.
///
/// Each variant is one unknown fact. [`MissingFact::inputs`] are the fields with which the caller can give it.
///
/// ```
/// use osim_model::messages::Input;
/// use osim_model::{FaultKind, MassRequest, Model};
///
/// # let text = include_str!("../../../tests/data/one_foot.osim");
/// // A model whose only body has no mass.
/// let model = Model::parse(text.replace("<mass>10</mass>", ""))?;
/// let fault = MassRequest::default().model_mass(&model).unwrap_err();
/// let FaultKind::MissingFact(fact) = fault.kind else { panic!("{fault}") };
/// // A page can show a field for the mass; the text says it in words.
/// assert_eq!((fact.code(), fact.inputs()), ("no-mass", vec![Input::Mass]));
/// assert!(fact.phrase().to_string().starts_with("body 'foot_r' has no mass"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum MissingFact {
    /// The mass of a body, which OpenSim reads as NaN.
    BodyMass { body: String },
    /// The mass of the model: the masses of its bodies have no usable sum.
    ModelMass { bodies: usize, kg: f64 },
    /// The mass of the model: OpenSim counts a body in a loop of joints twice, so the sum is in doubt.
    MassOfLoop,
    /// The mass for which the contacts were made: the note in the file is in doubt. The answer goes to `input`.
    ContactsMass { noted_kg: Option<f64>, doubt: NoteDoubt, input: Input },
    /// The gravity for which the contacts were made: the note in the file is in doubt.
    ContactsGravity { doubt: NoteDoubt },
    /// The choice of forces: the forces belong to several animals. The answer goes to `input`, for the model or for a reference.
    Selection { trees: Vec<ForcesOfAnimal>, input: Input },
    /// The number of spheres that share the weight.
    SphereCount { of: CountedSpheres, why: Phrase },
    /// The choice of forces: `changed`, some of the chosen forces, share a sphere with `left`, forces that are not chosen. `can_choose` says
    /// whether the caller can also choose all of these.
    SharedSphere {
        sphere: String,
        changed: String,
        left: Vec<String>,
        can_choose: bool,
        radius: RadiusChangeReason,
    },
    /// The contact to take: `unmatched` are spheres of the model without a sphere of the same name in the reference.
    ReferenceContact { reference: String, unmatched: Vec<String> },
    /// The sphere in the reference whose contact one force gets: the spheres of the force have different contacts there.
    ReferenceContactOfForce { force: String },
    /// The radius: the spheres of the reference have different radii, and `unmatched` have no sphere of the same name there.
    ReferenceRadius { reference: String, unmatched: Vec<String> },
    /// The scale factors of a body along some axes.
    BodyFactors { body: String, axes: Vec<&'static str> },
    /// The size of a body relative to the body of another model.
    Factors(UnknownFactors),
    /// Whether spheres that were moved or resized already should be placed again.
    MovedSpheres { model: String, spheres: Vec<String> },
    /// Whether a factor should be applied a second time.
    Repetition { operation: String },
    /// A ScaleSet was given, but the note says that the spheres already followed their bodies.
    AlreadyFollowed,
    /// The file of the geometry set, for a force set without a model.
    Geometry,
    /// The file of the force set, for a geometry set without a model.
    ForceSet,
    /// The load at which an indentation is wanted.
    Load,
    /// The gravity, which the file does not give.
    Gravity { purpose: GravityFor },
    /// The mass for which the contacts were made: they are published contacts for another mass than that of the bodies.
    KnownContactsMass { title: String, made_for_kg: f64, bodies_kg: f64, input: Input },
    /// The scale factors of bodies, which the note cannot give: it has no sizes, or spheres were moved later.
    NotedSizes,
    /// The ratio of body heights, for the scaling rule of PredSim.
    HeightRatio,
}

/// The contact forces of one of several animals in a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ForcesOfAnimal {
    /// Name of the topmost body of the animal, which is joined to ground.
    pub top: String,
    /// Names of the animal's forces, shortened.
    pub forces: String,
}

/// The body whose number of load-sharing spheres is not known: the model, the reference, or the model to compare with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CountedSpheres {
    Model,
    Reference,
    Compared,
}

impl CountedSpheres {
    /// The input with which the caller gives the number of spheres.
    pub const fn input(self) -> Input {
        match self {
            Self::Model => Input::Spheres,
            Self::Reference => Input::ReferenceSpheres,
            Self::Compared => Input::CompareSpheres,
        }
    }
}

impl MissingFact {
    /// Stable short name, as in the JSON `code`.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::BodyMass { .. }
            | Self::ModelMass { .. }
            | Self::MassOfLoop
            | Self::KnownContactsMass { .. }
            | Self::ContactsMass { doubt: NoteDoubt::Absent, .. } => "no-mass",
            Self::ContactsMass { .. } | Self::ContactsGravity { .. } => "stale-note",
            Self::Selection { .. } => "several-trees",
            Self::SphereCount { .. } => "sphere-count",
            Self::SharedSphere { .. } => "shared-sphere",
            Self::ReferenceContact { .. }
            | Self::ReferenceContactOfForce { .. }
            | Self::ReferenceRadius { .. } => "which-reference",
            Self::NotedSizes | Self::BodyFactors { .. } | Self::Factors(_) => "body-scale",
            Self::MovedSpheres { .. } => "moved-spheres",
            Self::Repetition { .. } | Self::AlreadyFollowed => "same-operation",
            Self::Geometry | Self::ForceSet => "incomplete-set",
            Self::Load | Self::Gravity { .. } | Self::HeightRatio => "refused",
        }
    }

    /// The fields with which the caller can give the fact, the usual one first.
    pub fn inputs(&self) -> Vec<Input> {
        match self {
            // The message begins with what was asked for.
            Self::HeightRatio => vec![Input::HeightRatio, Input::FollowBodies],
            // Another verb is named, too.
            Self::KnownContactsMass { input, .. } => vec![*input],
            other => other.phrase().inputs(),
        }
    }

    /// The message that asks for the fact, with the inputs that give it.
    pub fn phrase(&self) -> Phrase {
        match self {
            Self::BodyMass { body } => phrase![
                "body '{body}' has no mass (OpenSim reads NaN): give it a <mass>{}";
                advice_for_verbs_that_take(Input::Mass, ", or give the mass of the model with ", "KG", "")
            ],
            Self::ModelMass { bodies, kg } => phrase![
                match bodies {
                    0 => "the mass is not in the file: no body is left to sum".to_owned(),
                    count => format!("the {count} bodies weigh {} kg in all", readable(*kg)),
                },
                Input::Mass.either(
                    phrase![
                        ": give the mass of the model with {}, or the mass that its contacts are made for with {}";
                        Input::Mass.with_placeholder("KG"), Input::ContactsMass.with_placeholder("KG")
                    ],
                    ": give them masses",
                ),
            ],
            Self::MassOfLoop => phrase![
                "joints form a loop with a WeldJoint or FreeJoint between bodies, where OpenSim counts the mass of a \
                body twice{}";
                advice_for_verbs_that_take(Input::Mass, ": give the mass of the model with ", "KG", "")
            ],
            Self::ContactsMass { noted_kg, doubt, input } => contacts_mass(*noted_kg, *doubt, *input),
            Self::KnownContactsMass { title, made_for_kg, bodies_kg, input } => {
                known_contacts_mass(title, *made_for_kg, *bodies_kg, *input)
            }
            Self::ContactsGravity { doubt } => phrase![
                "it is not certain which gravity the contacts are made for, because {}: give that gravity with {}";
                doubt.as_str(), Input::ContactsGravity.with_placeholder("G")
            ],
            Self::Selection { trees, input } => {
                let each: Vec<_> =
                    trees.iter().map(|tree| format!("{} (forces {})", tree.top, tree.forces)).collect();
                phrase![
                    "contact spheres are on bodies that are joined only through ground: {}{}";
                    each.join("; "), advice_for_verbs_that_take(*input, ": choose the forces with ", "GLOB", "")
                ]
            }
            Self::SphereCount { of, why } => phrase![
                "how many spheres share the body weight is not known: {}: say it with {}";
                why, of.input().with_placeholder("N")
            ],
            Self::SharedSphere { sphere, changed, left, can_choose, radius } => {
                let mut text = shared_sphere(sphere, changed, left, *can_choose);
                text.push(&radius.phrase());
                text
            }
            Self::ReferenceContact { reference, unmatched } => phrase![
                "the contacts of {reference} differ from each other, and it has no spheres with these names: {}: \
                choose the contact to take with {}";
                unmatched.join(", "), Input::ReferenceSphere.with_placeholder("NAME")
            ],
            Self::ReferenceContactOfForce { force } => phrase![
                "the spheres of {force} have different contacts in the reference: choose the contact to take with {}";
                Input::ReferenceSphere.with_placeholder("NAME")
            ],
            Self::ReferenceRadius { reference, unmatched } => phrase![
                "radii differ in {reference}, and it has no spheres with these names: {}: say the radius with {}, or \
                whose with {}, or keep radii with {}";
                unmatched.join(", "), Input::Radius.with_placeholder("METRES"),
                Input::ReferenceSphere.with_placeholder("NAME"), Input::Radius.with_value("keep")
            ],
            Self::BodyFactors { body, axes } => {
                let factors = Input::BodyScale.with_value(format!("{body}=x,y,z"));
                let file = |text| advice_for_verbs_that_take(Input::BodyScaleFile, text, "FILE", "");
                let both = phrase![": say it with {}{}"; factors, file(", or give the ScaleSet that was applied with ")];
                phrase![
                    "how body {body} was scaled along {} is not in the files{}";
                    joined_axes(axes), Input::BodyScale.either(both, file(": give the ScaleSet that was applied with "))
                ]
            }
            Self::Factors(factors) => factors.phrase(),
            Self::MovedSpheres { model, spheres } => phrase![
                "spheres of {model} were moved or resized already: {}: keep them with {}, or place them again with {}";
                spheres.join(", "), Input::MovedSpheres.with_value("keep"),
                Input::MovedSpheres.with_value("replace")
            ],
            Self::Repetition { operation } => phrase![
                "the note in the file says that '{operation}' was done already: apply it once more with {}";
                Input::Force
            ],
            Self::AlreadyFollowed => phrase![
                "by the note in the file, spheres follow their bodies already, and a ScaleSet would move them once more: \
                 leave out ",
                Input::BodyScaleFile,
            ],
            Self::Geometry => phrase![
                "this is a ForceSet without its model: its spheres are in another file, {}";
                advice_for_verbs_that_take(Input::Geometry, "name it with ", "FILE", WHOLE_MODELS)
            ],
            Self::ForceSet => phrase![
                "this is a ContactGeometrySet, which has no forces: {}";
                advice_for_verbs_that_take(Input::Geometry, "name the ForceSet file and give this one as ", "FILE", WHOLE_MODELS)
            ],
            Self::Load => phrase![
                "an indentation needs a load: give {} or {}";
                Input::Load.with_placeholder("N"), Input::BodyWeights.with_placeholder("B")
            ],
            Self::NotedSizes => phrase![
                "the file does not show how its bodies were scaled (it has no note, or spheres were moved since): take \
                 the contacts of the model that was scaled (transfer), or name the Scale Tool's file with ",
                Input::BodyScaleFile.with_placeholder("FILE"),
            ],
            Self::Gravity { purpose } => purpose.phrase(),
            Self::HeightRatio => phrase![
                "{} needs the ratio of heights: give {}, or {}";
                Input::Rule.with_value("predsim"), Input::HeightRatio.with_placeholder("RATIO"),
                Input::FollowBodies
            ],
        }
    }
}

/// Advice to give `input`, for verbs that take it: `advice` and then the input. For other verbs the text is `otherwise`.
fn advice_for_verbs_that_take(
    input: Input,
    advice: &'static str,
    placeholder: &'static str,
    otherwise: &'static str,
) -> PhrasePart {
    input.either(phrase![advice, input.with_placeholder(placeholder)], otherwise)
}

/// The names of one, two or three axes in a sentence: `x, y and z`.
fn joined_axes(axes: &[&str]) -> String {
    match axes {
        [x, y, z] => format!("{x}, {y} and {z}"),
        fewer => fewer.join(" and "),
    }
}
