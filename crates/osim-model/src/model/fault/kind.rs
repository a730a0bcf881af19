//! The kinds of errors about models and requests.

use crate::messages::{Input, Phrase, Verb, phrase, readable};
use crate::xml::SyntaxFault;
use crate::xml::opensim_text::NumberFault;
use contact_scaling::{DomainError, limits};

use super::missing_fact::MissingFact;
use super::suspicion::Suspicion;

/// The kinds of errors, each with the data that a program needs.
///
/// ```
/// use osim_model::{FaultKind, Model, NumberFault, Property, SetId};
///
/// # let text = include_str!("../../../tests/data/one_foot.osim");
/// // A decimal comma: OpenSim reads 1 and ignores the rest.
/// let model = Model::parse(text.replace("<stiffness>1000000<", "<stiffness>1,5e6<"))?;
/// let fault = model.forces()[0].checked(SetId::FIRST, Property::Stiffness).unwrap_err();
/// let FaultKind::Number { property, text, fault: why } = &fault.kind else { panic!("{fault}") };
/// assert_eq!((property.as_str(), text.as_str()), ("stiffness", "1,5e6"));
/// assert_eq!(*why, NumberFault::Prefix { opensim_reads: 1.0 });
/// // Line and column follow from the bytes.
/// let place = fault.located(model.document().bytes()).position;
/// assert_eq!(place.map(|place| place.line), Some(30));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum FaultKind {
    /// The file is not one well-formed XML document.
    Syntax(SyntaxFault),
    /// The file is XML, but not an OpenSim document.
    NotOpenSim { root: String },
    /// The `Version` attribute is missing or is not a number.
    NoVersion { found: String },
    /// The file is an OpenSim document, but not a model or a set of contacts.
    WrongDataRoot { tag: String },
    /// A number that OpenSim reads differently from a person or a strict program.
    Number { property: String, text: String, fault: NumberFault },
    /// A text that OpenSim refuses because another element or comment interrupts it.
    BrokenText { property: String },
    /// A number, as OpenSim reads it, outside the domain in which the equations hold.
    Domain { property: String, value: f64, expected: &'static str },
    /// A new number that is not finite, or outside the domain in which the equations hold. `origin` is how it was computed.
    NewValue { property: String, value: f64, expected: &'static str, origin: String },
    /// A new `constant_contact_force` of 0, with which OpenSim computes NaN.
    ZeroConstantContactForce,
    /// The model has no contacts. `detail` says what is missing, as the beginning of a sentence; with `replaces`, new contacts have to
    /// replace those of another class.
    NoContacts { detail: String, replaces: bool },
    /// A path or name, `connectee` in the file, to which no component belongs. `unread`: the line and the class of an object of that name
    /// that OpenSim does not read.
    Unresolved { owner: String, connectee: String, wanted: &'static str, unread: Option<(usize, String)> },
    /// The socket of a force leads to `connectee`, contact geometry of a class that it does not take.
    OtherSurface { owner: String, connectee: String, class: String, expected: String, are_exchanged: bool },
    /// The caller has to give a missing fact.
    MissingFact(MissingFact),
    /// A number that looks wrong. It is used only if the caller confirms it.
    Suspicion(Suspicion),
    /// Contacts are to be added to a model that already has some.
    ContactsExist { forces: String, can_scale: bool },
    /// Bodies that carry spheres in the reference do not exist in the model. `others` is a pattern that matches only the reference's forces
    /// whose spheres are on bodies of the model, if there is such a pattern.
    MissingCarriers { bodies: Vec<String>, others: Option<String> },
    /// The element at `path` is in another file that the model includes.
    IncludedFile { path: String, file: String },
    /// The parameters of the force are those in `<defaults>`, which may serve other forces too.
    ParametersInDefaults { force: String },
    /// A number that the caller gave is outside its domain.
    BadInput { input: Input, value: f64, expected: &'static str },
    /// The caller named a body that the model does not have.
    UnknownBody { body: String },
    /// The caller named a sphere that the reference does not have.
    UnknownReferenceSphere { sphere: String, reference: String, known: Vec<String> },
    /// The options of the caller select none of the model's forces.
    NothingSelected { forces: String },
    /// The change has a warning, and the caller wants no change with warnings (`strict`).
    StrictlyRefused { text: String },
    /// The change is not possible for this force; the caller can leave the force out. `otherwise` is further advice as a clause, or empty.
    ForceCannotChange { text: String, force: String, otherwise: &'static str },
    /// The request makes no sense for this model. The text names no input.
    Refused(String),
    /// Recordings determine nothing of what was to be fitted to them.
    NothingDetermined { text: String },
    /// A quantity that the caller gave is outside its domain.
    Quantity(DomainError),
    /// The force contains its sphere, as Moco 0.1 to 0.3 wrote it, and cannot get the contacts of other forces.
    SphereInsideForce { force: String },
    /// An edit begins before the last one ends, or ends after the file: an error of this program, never of the file.
    OverlappingEdits { at: usize },
}

impl FaultKind {
    /// Stable short name, as in the JSON `code`.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Syntax(
                SyntaxFault::NotXml
                | SyntaxFault::Empty
                | SyntaxFault::Packed(_)
                | SyntaxFault::Motion
                | SyntaxFault::Table,
            ) => "not-xml",
            Self::Syntax(SyntaxFault::Utf16 | SyntaxFault::SecondByteOrderMark) => "encoding",
            Self::Syntax(SyntaxFault::DoctypeSubset) => "doctype",
            Self::Syntax(_) => "malformed-xml",
            Self::NotOpenSim { .. } | Self::NoVersion { .. } | Self::WrongDataRoot { .. } => "not-opensim",
            Self::Number { .. } => "not-a-number",
            Self::BrokenText { .. } => "broken-text",
            Self::Domain { .. } | Self::NewValue { .. } | Self::ZeroConstantContactForce => "out-of-domain",
            Self::NoContacts { .. } => "no-contacts",
            Self::Unresolved { .. } | Self::OtherSurface { .. } => "unresolved",
            Self::MissingFact(fact) => fact.code(),
            Self::Suspicion(doubt) => doubt.question().as_str(),
            Self::ContactsExist { .. } => "contacts-exist",
            Self::MissingCarriers { .. } => "missing-body",
            Self::IncludedFile { .. } => "included-file",
            Self::ParametersInDefaults { .. } => "parameters-in-defaults",
            Self::BadInput { .. }
            | Self::UnknownBody { .. }
            | Self::UnknownReferenceSphere { .. }
            | Self::NothingSelected { .. }
            | Self::StrictlyRefused { .. }
            | Self::ForceCannotChange { .. }
            | Self::SphereInsideForce { .. }
            | Self::NothingDetermined { .. }
            | Self::Refused(_) => "refused",
            Self::Quantity(_) => "out-of-range",
            Self::OverlappingEdits { .. } => "internal",
        }
    }

    /// The message of the error. Inputs in it are data for a front end.
    pub fn phrase(&self) -> Phrase {
        match self {
            Self::MissingFact(fact) => fact.phrase(),
            Self::Suspicion(doubt) => doubt.phrase(),
            Self::Syntax(fault @ SyntaxFault::Table) => phrase![fault.to_string(), Verb::Batch.call()],
            Self::Syntax(fault @ SyntaxFault::Motion) => phrase![
                fault.to_string(),
                Verb::Check
                    .call_with_model()
                    .with_placeholder(Input::Motion, "FILE")
                    .with_placeholder(Input::Plates, "FORCES"),
            ],
            Self::BadInput { input, value, expected } => {
                phrase![*input, format!(" is {value}, expected {expected}")]
            }
            Self::UnknownBody { body } => {
                phrase![Input::BodyScale.with_value(body), ": the model has no body of that name"]
            }
            Self::NoContacts { detail, replaces } => {
                let add = Verb::Add.call_with_model().with_placeholder(Input::From, "OTHER");
                if *replaces {
                    phrase!["{}: replace them with {}"; detail.clone(), add.with_flag(Input::Replace)]
                } else {
                    phrase!["{}: give it contacts with {}"; detail.clone(), add]
                }
            }
            Self::ContactsExist { forces, can_scale: false } => phrase![
                "the model has contacts already: {forces}, which this program does not scale; replace them with {}";
                Input::Replace
            ],
            Self::ContactsExist { forces, can_scale: true } => phrase![
                "the model has contacts already: {forces}; make them right with {} or {}, or replace them with {}";
                Verb::Rescale.call(), Verb::Transfer.call(), Input::Replace
            ],
            Self::MissingCarriers { bodies, others } => {
                let (is, first) = match bodies.as_slice() {
                    [one] => (format!("body {one}, which carries"), one.as_str()),
                    [one, ..] => (format!("bodies {}, which carry", bodies.join(", ")), one.as_str()),
                    [] => (String::new(), ""),
                };
                let mut text = phrase![
                    format!("the model lacks {is} spheres in the reference: name what takes them here with "),
                    Input::BodyMap.with_value(format!("{first}=BODY")),
                ];
                if let Some(pattern) = others {
                    text.push(", or leave them out with ");
                    text.push(Input::ReferenceSelect.with_value(pattern));
                }
                text
            }
            Self::UnknownReferenceSphere { sphere, reference, known } => phrase![
                Input::ReferenceSphere.with_value(sphere),
                match known.as_slice() {
                    [] => format!(" is not in {reference}, whose contact names no sphere"),
                    known => format!(" is not in {reference}, which has {}", known.join(", ")),
                },
            ],
            Self::NothingSelected { forces } => phrase![
                "no contact force is left by {}, {} and {}; the model has {forces}";
                Input::Select, Input::Exclude, Input::SkipDisabled
            ],
            Self::ZeroConstantContactForce => phrase![
                "the new constant_contact_force is 0, and OpenSim computes NaN with 0 whenever the sphere does not \
                slip, so in every model at rest: give it a small value, such as that of {}";
                Verb::Design.call()
                    .with_value(Input::ConstantIndentation, limits::SUGGESTED_CONSTANT_INDENTATION.to_string())
            ],
            Self::StrictlyRefused { text } => {
                phrase![text.clone(), " (refused because of ", Input::Strict, ")"]
            }
            Self::NothingDetermined { text } => {
                let correct = Verb::Motion.call_with_model().with_placeholder(Input::Correct, "FILE");
                phrase!["{}: correct the motion instead, with {}"; text.clone(), correct]
            }
            Self::SphereInsideForce { force } => phrase![
                "{force} keeps its sphere inside itself, as Moco 0.1 to 0.3 wrote it, and OpenSim 4.2 and later \
                cannot read that: first do {}, then this with what it wrote";
                Verb::Convert.call().with_value(Input::To, "smooth")
            ],
            Self::ForceCannotChange { text, force, otherwise } => {
                let other = if otherwise.is_empty() { String::new() } else { format!(", or {otherwise}") };
                phrase!["{text}: leave this force out with {}{}"; Input::Exclude.with_value(globset::escape(force)), other]
            }
            other => other.without_inputs().into(),
        }
    }

    /// The text of an error that names no input.
    fn without_inputs(&self) -> String {
        match self {
            Self::Syntax(fault) => fault.to_string(),
            Self::NotOpenSim { root } => format!(
                "this is XML but not an OpenSim document: the outermost element is <{root}>, expected <OpenSimDocument>"
            ),
            Self::NoVersion { found } => format!(
                "<OpenSimDocument> has no readable Version (found '{found}'), expected a number like 40000"
            ),
            Self::WrongDataRoot { tag } => {
                format!("the document holds a <{tag}>, expected a Model, a ForceSet or a ContactGeometrySet")
            }
            Self::Number { property, text, fault } => {
                format!("{property} is '{text}', {}", number_hint(property, fault))
            }
            Self::BrokenText { property } => format!(
                "{property} has a comment or element in the middle of its text, which OpenSim cannot read: remove it"
            ),
            Self::Domain { property, value, expected } => {
                format!("{property} is {value}, expected {expected}")
            }
            Self::NewValue { property, value, expected, origin } => {
                let value = readable(*value);
                format!("the new {property} is {value}, expected {expected}: it comes from {origin}")
            }
            Self::Unresolved { owner, connectee, wanted, .. } if connectee.is_empty() => {
                format!("{owner} names nothing: a name or path is empty, expected the {wanted}")
            }
            Self::OtherSurface { owner, connectee, class, expected, are_exchanged } => {
                let why =
                    if *are_exchanged { ": the sockets of sphere and half-space are exchanged" } else { "" };
                format!("{owner}: '{connectee}' is a {class}, expected a {expected}{why}")
            }
            Self::Unresolved { owner, connectee, unread: Some((line, class)), .. } => format!(
                "{owner}: OpenSim does not read the {class} that '{connectee}' names, in line {line}: its class is unknown, \
                 or it is outside of the set that counts"
            ),
            Self::Unresolved { owner, connectee, wanted, .. } => {
                format!("{owner}: nothing called '{connectee}' is in the file, expected the {wanted}")
            }
            Self::IncludedFile { path, file } => format!(
                "{path} is in the file '{file}' that the model includes: open the model in OpenSim and save it as one \
                 file, then change that"
            ),
            Self::ParametersInDefaults { force } => format!(
                "{force} takes its ContactParameters from <defaults>, which may serve other forces too: write a \
                 contact_parameters set into the force itself, then change that"
            ),
            Self::Refused(text) => text.clone(),
            Self::Quantity(error) => error.to_string(),
            Self::OverlappingEdits { at } => {
                format!("internal error: two edits overlap at byte {at}; nothing was changed")
            }
            // All others have a phrase of their own.
            _ => String::new(),
        }
    }
}

macro_rules! kinds_from {
    ($($from:ident => $kind:ident),+) => {$(
        impl From<$from> for FaultKind {
            fn from(from: $from) -> Self {
                Self::$kind(from)
            }
        }
    )+};
}

kinds_from!(MissingFact => MissingFact, Suspicion => Suspicion, DomainError => Quantity);

fn number_hint(property: &str, fault: &NumberFault) -> String {
    match fault {
        NumberFault::Empty | NumberFault::Unreadable if property == "mass" => {
            "expected a number: OpenSim refuses the model".to_owned()
        }
        NumberFault::Empty => "expected a number: OpenSim silently takes its default here".to_owned(),
        NumberFault::Prefix { opensim_reads } => {
            format!(
                "expected one plain number like 1.5e6: OpenSim reads {opensim_reads} and ignores the rest"
            )
        }
        NumberFault::Unreadable => "expected a number: OpenSim silently takes its default instead".to_owned(),
        NumberFault::Interrupted => {
            "with a comment or element in the middle of it, expected one plain number".to_owned()
        }
    }
}
