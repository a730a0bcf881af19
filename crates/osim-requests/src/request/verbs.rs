//! The register of verbs: the request type of each verb, its texts for the help and for pages, and its fields without names in a
//! call.

use std::path::PathBuf;

use osim_model::messages::{Input, Verb, named};
use serde_json::{Map, Value};

use crate::options::{AnswerOptions, OutputOptions, RunOptions};
use crate::request::change::{
    AddRequest, ConvertRequest, RemoveRequest, RescaleRequest, SetRequest, TransferRequest,
};
use crate::request::design_and_fit::{DesignRequest, FitRequest};
use crate::request::inspect::{CheckRequest, DropTestRequest, InspectRequest, MotionRequest, NoteRequest};
use crate::request::knowledge::{ExplainRequest, PresetsRequest, ReproduceRequest};
use crate::request::library::{BatchRequest, SweepRequest};
use crate::request::plot::PlotRequest;
use crate::{Relation, RequestFault, dictionary};

/// The name of the dictionary field for the verb.
pub(super) const VERB_FIELD: &str = "verb";

/// Texts about a verb for the help and for pages.
#[derive(Debug, Clone, Copy)]
pub struct VerbEntry {
    /// The group of the verb in the help.
    pub group: VerbGroup,
    /// Purpose of the verb, in a line of the help.
    pub about: &'static str,
    /// More text of the long help; may be empty.
    pub details: &'static str,
    /// Purpose of the verb, as the heading of a form; if empty, the name of the verb is the heading.
    title: &'static str,
    /// What the contacts on a report page are, for its title.
    pub contacts: &'static str,
    /// The heading at the top of a report.
    pub purpose: &'static str,
    /// The fields that a call has without their names, in order. Schemas have them as `x-positional`.
    pub positional: &'static [&'static str],
}

impl VerbEntry {
    /// A verb with its group, its fields without names, and a line of help.
    const fn new(group: VerbGroup, positional: &'static [&'static str], about: &'static str) -> Self {
        let purpose = "What contacts the model has, and what they do under its weight. Nothing was changed.";
        Self { group, about, details: "", title: "", contacts: "Changed contacts", purpose, positional }
    }

    const fn details(self, details: &'static str) -> Self {
        Self { details, ..self }
    }

    const fn title(self, title: &'static str) -> Self {
        Self { title, ..self }
    }

    const fn contacts(self, contacts: &'static str) -> Self {
        Self { contacts, ..self }
    }

    const fn purpose(self, purpose: &'static str) -> Self {
        Self { purpose, ..self }
    }
}

/// Purpose of a verb, as the heading of a form.
pub(crate) fn verb_title(verb: Verb) -> &'static str {
    match verb_entry(verb).title {
        "" => verb.name(),
        title => title,
    }
}

named! {
    /// Groups of verbs in the help, by their headings.
    pub enum VerbGroup {
        Change = "Change models",
        Look = "Look at models",
        Study = "Study",
        More = "More",
    }
}

impl VerbGroup {
    /// Verbs of the group, in the order of the help.
    pub fn verbs(self) -> impl Iterator<Item = Verb> {
        ALL_VERBS.iter().copied().filter(move |verb| verb_entry(*verb).group == self)
    }
}

macro_rules! marked {
    ($mark:ident $value:expr) => {
        $value
    };
}

/// Each row is `Variant(its request) = its entry;`, with `change` before the sign where it changes models that it names.
macro_rules! verbs {
    ($($variant:ident($type:ty) $($change:ident)? = $entry:expr;)+) => {
        /// A request for any verb.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Request {
            $($variant(Box<$type>),)+
        }

        /// All verbs, in the order of the help within each group.
        const ALL_VERBS: &[Verb] = &[$(Verb::$variant),+];

        /// The verbs that change models which are named in the request.
        pub const CHANGING: &[Verb] = &[$($(marked!($change Verb::$variant),)?)+];

        pub const fn verb_entry(verb: Verb) -> VerbEntry {
            match verb { $(Verb::$variant => $entry),+ }
        }

        impl Request {
            pub const fn verb(&self) -> Verb {
                match self { $(Self::$variant(_) => Verb::$variant),+ }
            }

            /// Reads the fields of a request for `verb`; only the relations that satisfy `checked` are checked.
            pub(crate) fn read_checking(
                verb: Verb,
                fields: Map<String, Value>,
                checked: fn(&Relation) -> bool,
            ) -> Result<Self, RequestFault> {
                match verb {
                    $(Verb::$variant => dictionary::read::<$type>(fields, &<$type>::relations(), checked)
                        .map(|request| Self::$variant(Box::new(request))),)+
                }
            }

            /// The given fields and the verb, in the form that [`Request::from_map`] takes.
            pub fn to_map(&self) -> Map<String, Value> {
                let fields = match self { $(Self::$variant(request) => dictionary::given_fields(request.as_ref())),+ };
                std::iter::once((VERB_FIELD.to_owned(), self.verb().name().into())).chain(fields).collect()
            }

            /// Checks the relations between the fields of the request.
            ///
            /// # Errors
            /// The first violated relation.
            pub fn check(&self) -> Result<(), RequestFault> {
                match self {
                    $(Self::$variant(request) => dictionary::check(request.as_ref(), &<$type>::relations()),)+
                }
            }

            /// The answers to questions, for a verb that changes models.
            pub fn answers_mut(&mut self) -> Option<&mut AnswerOptions> {
                match self {
                    $($(Self::$variant($change) => Some(&mut $change.answers),)?)+
                    _ => None,
                }
            }

            /// The options for results, for a verb that changes models.
            pub fn output_mut(&mut self) -> Option<&mut OutputOptions> {
                match self {
                    $($(Self::$variant($change) => Some(&mut $change.output),)?)+
                    _ => None,
                }
            }

            /// The models, for a verb that changes their present contacts.
            pub fn models_mut(&mut self) -> Option<&mut Vec<PathBuf>> {
                match self {
                    Self::Rescale(request) => Some(&mut request.models),
                    Self::Transfer(request) => Some(&mut request.models),
                    Self::Convert(request) => Some(&mut request.models),
                    Self::Design(request) => Some(&mut request.models),
                    Self::Set(request) => Some(&mut request.models),
                    _ => None,
                }
            }

            /// The options of a run, for a verb that changes models.
            pub fn run_options(&self) -> Option<&RunOptions> {
                match self {
                    $($(Self::$variant($change) => Some(&$change.run),)?)+
                    _ => None,
                }
            }
        }

        /// Checks one field of a request for `verb`.
        ///
        /// # Errors
        /// The value has the wrong form; the message gives the expected form.
        #[cfg(feature = "clap")]
        pub(crate) fn check_value(verb: Verb, field: &str, value: Value) -> Result<(), String> {
            match verb { $(Verb::$variant => dictionary::check_value::<$type>(field, value)),+ }
        }

        /// The schema of the requests for `verb` by their type, with the relations between fields.
        #[cfg(feature = "schemas")]
        pub(crate) fn type_schema(verb: Verb) -> schemars::Schema {
            let generator = schemars::generate::SchemaSettings::draft2020_12().into_generator();
            match verb { $(Verb::$variant => generator.into_root_schema_for::<$type>()),+ }
        }

        /// The fields of a request for `verb` with their defaults.
        pub fn silent_fields(verb: Verb) -> Map<String, Value> {
            match verb { $(Verb::$variant => dictionary::all_fields(&<$type>::default())),+ }
        }

        /// The relations between the fields of requests for `verb`.
        #[cfg(any(feature = "clap", feature = "schemas"))]
        pub(crate) fn relations_of(verb: Verb) -> Vec<Relation> {
            match verb { $(Verb::$variant => <$type>::relations()),+ }
        }

        $(impl From<$type> for Request {
            fn from(request: $type) -> Self {
                Self::$variant(Box::new(request))
            }
        })+
    };
}

/// Whether requests for `verb` have a field for `input`.
pub fn verb_takes(verb: Verb, input: Input) -> bool {
    silent_fields(verb).contains_key(input.name())
}

verbs! {
    Rescale(RescaleRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Rescale a model's own contacts to another mass (the verb may be left out)")
        .details("Spheres move only with `follow_bodies`, `body_scale_file` or `level`. After OpenSim's Scale Tool, check SCALED \
                  `from=GENERIC` first. With a note in the model (see note), SCALED `target_mass=KG` `follow_bodies` `level` needs no \
                  other file; without one, `body_scale_file` takes the ScaleSet that was applied.")
        .title("Scale the contacts")
        .contacts("Rescaled contacts")
        .purpose("Contacts that are made for one body mass, rescaled to another: each parameter is multiplied by the factor that its \
                  equation gives, so that the dimensionless contact stays the same.");
    Transfer(TransferRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Give a model the contacts of another model or of a preset, at its own size")
        .details("After OpenSim's Scale Tool: check SCALED `from=GENERIC` says where each sphere belongs, and transfer SCALED \
                  `from=GENERIC` `follow_bodies` `level` `output=OUT` puts it there and makes the contacts right for the new mass.")
        .title("Take the contacts of another model")
        .contacts("Transferred contacts")
        .purpose("The contacts of another model, given to this one at its own mass, radii and number of spheres, so that the dimensionless contact is the reference's.");
    Add(AddRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Give a model contacts: of another model, a table, or under its bones")
        .details("Spheres are placed by the size of this model's own bones, and their numbers made for its mass. remove takes them out \
                  again.")
        .title("Add contacts")
        .contacts("Added contacts")
        .purpose("Contacts for a model that had none, at its own size, with numbers made for its mass: equal to a reference's in dimensionless form, or as asked for.");
    Remove(RemoveRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Take the foot contacts out of a model")
        .details("After add, and also after a later rescale, remove restores the original file byte for byte.")
        .title("Remove the contacts")
        .contacts("Removed contacts")
        .purpose("Contacts taken out of the model. Nothing else was changed.");
    Convert(ConvertRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Make forces of one class from those of the other, one for each sphere")
        .details("It also divides a HuntCrossleyForce with several spheres into one force for each sphere, of either class.")
        .title("Convert the forces")
        .contacts("Converted contacts")
        .purpose("Forces of another class, one for each sphere, with the same stiffness, dissipation and friction.");
    Design(DesignRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Find parameters from what is wanted: indentation, stiffness, restitution")
        .title("Design the contacts")
        .contacts("Designed contacts")
        .purpose("Parameters found from what the contacts should do.");
    Set(SetRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Set properties to a value, or multiply them by a factor")
        .title("Set")
        .purpose("Properties written, or multiplied, as given.");
    Sweep(SweepRequest) = VerbEntry::new(VerbGroup::Study, &["model"],
        "Make a grid of variants of a model, or a ladder of them from soft to stiff");
    DropTest(DropTestRequest) = VerbEntry::new(VerbGroup::Study, &["subject"],
        "Let a model fall on its contacts and see what they do");
    Motion(MotionRequest) = VerbEntry::new(VerbGroup::Study, &["subject", "motion"],
        "Follow the contacts along a recorded motion, beside what force plates measured")
        .details("Forces, indentations, slip and impacts of each sphere; the ground reaction of each foot, and how far it is from the \
                  plates.");
    Fit(FitRequest) change = VerbEntry::new(VerbGroup::Study, &["file"],
        "Find contact parameters from a measured indentation and force")
        .purpose("Contact parameters, fitted to what was measured.");
    Reproduce(ReproduceRequest) = VerbEntry::new(VerbGroup::Study, &[],
        "Compare Table 1 of the paper with what its equations give, and draw its figures");
    Note(NoteRequest) change = VerbEntry::new(VerbGroup::Change, &["models"],
        "Write down the mass that a model's contacts were made for")
        .details("No number changes. OpenSim keeps the note when it scales the model: check SCALED knows then what the contacts were \
                  made for and whether spheres followed their bodies, and SCALED `target_mass=KG` `follow_bodies` moves them without \
                  the generic model.")
        .contacts("Noted contacts")
        .purpose("The mass that the contacts were made for, written into the file. No number was changed.");
    Batch(BatchRequest) = VerbEntry::new(VerbGroup::Change, &["manifest"],
        "Change many models, as a table says: one row per model")
        .purpose("Many models changed, each as its row of a table says.");
    Check(CheckRequest) = VerbEntry::new(VerbGroup::Look, &["models"],
        "Compare models with the limits of the paper and the traps of the format")
        .details("After OpenSim's Scale Tool: check SCALED `from=GENERIC` says where each sphere belongs, and prints the transfer \
                  SCALED `from=GENERIC` `follow_bodies` `level` that puts it there. Where the generic model had a note, check SCALED \
                  alone is enough.")
        .contacts("Check of contacts")
        .purpose("Models compared with the limits of the paper and the traps of the format. Nothing was changed.");
    Inspect(InspectRequest) = VerbEntry::new(VerbGroup::Look, &["models"],
        "Show what contacts a model has")
        .contacts("Contacts");
    Plot(PlotRequest) = VerbEntry::new(VerbGroup::Look, &["kind", "models"],
        "Draw what contacts do, as SVG, PDF or PNG");
    Explain(ExplainRequest) = VerbEntry::new(VerbGroup::More, &["topics"],
        "Explain an equation, a quantity, a finding or an error (alone: list them all)");
    Presets(PresetsRequest) = VerbEntry::new(VerbGroup::More, &["name"],
        "List presets, or show one");
}
