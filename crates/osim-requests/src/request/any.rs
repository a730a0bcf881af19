//! Any request, by its verb.

use osim_model::messages::{Input, Verb};
#[cfg(feature = "schemas")]
use schemars::Schema;
use serde_json::{Map, Value};

use super::add::AddRequest;
use super::convert::ConvertRequest;
use super::design::DesignRequest;
use super::drop_test::DropTestRequest;
use super::fit::FitRequest;
use super::inspect::{CheckRequest, InspectRequest};
use super::knowledge::{ExplainRequest, PresetsRequest};
use super::library::{BatchRequest, SweepRequest};
use super::motion::MotionRequest;
use super::note::NoteRequest;
use super::plot::PlotRequest;
use super::remove::RemoveRequest;
use super::reproduce::ReproduceRequest;
use super::rescale::RescaleRequest;
use super::set::SetRequest;
use super::transfer::TransferRequest;
use crate::dictionary;
use crate::fault::RequestFault;
use crate::options::{AnswerOptions, MassOptions, OutputOptions, RunOptions};
#[cfg(feature = "clap")]
use crate::relation::Relation;
#[cfg(feature = "schemas")]
use crate::schema::schema;

/// The name under which a dictionary says which verb it is for.
const VERB: &str = "verb";

macro_rules! requests {
    ($($variant:ident($type:ty) = $relations:expr;)+) => {
        /// A request, whatever its verb.
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum Request {
            $(#[doc = concat!("[`Verb::", stringify!($variant), "`].")] $variant(Box<$type>),)+
        }

        impl Request {
            /// What it asks for.
            #[must_use]
            pub const fn verb(&self) -> Verb {
                match self { $(Self::$variant(_) => Verb::$variant),+ }
            }

            /// Reads the fields of a request for `verb`.
            ///
            /// # Errors
            /// A field that the verb does not have, a value that cannot be taken, or fields that do not go together.
            pub fn read(verb: Verb, fields: Map<String, Value>) -> Result<Self, RequestFault> {
                match verb {
                    $(Verb::$variant => {
                        dictionary::read::<$type>(fields, $relations).map(|request| Self::$variant(Box::new(request)))
                    })+
                    _ => Err(RequestFault::general(format!("'{}' takes no request", verb.name()))),
                }
            }

            /// The fields that say something, as [`Request::read`] takes them; the verb among them.
            #[must_use]
            pub fn to_map(&self) -> Map<String, Value> {
                let fields = match self { $(Self::$variant(request) => dictionary::said(request.as_ref())),+ };
                std::iter::once((VERB.to_owned(), self.verb().name().into())).chain(fields).collect()
            }

            /// Checks that its fields go together.
            ///
            /// # Errors
            /// The first that does not.
            pub fn check(&self) -> Result<(), RequestFault> {
                match self { $(Self::$variant(request) => dictionary::check(request.as_ref(), $relations)),+ }
            }
        }

        /// The schema of the requests for `verb`, where it takes some.
        #[cfg(feature = "schemas")]
        #[must_use]
        pub fn schema_of(verb: Verb) -> Option<Schema> {
            match verb { $(Verb::$variant => Some(schema::<$type>(verb, $relations)),)+ _ => None }
        }

        /// The fields of a request for `verb` with their defaults.
        #[must_use]
        pub fn silent_fields(verb: Verb) -> Map<String, Value> {
            match verb { $(Verb::$variant => dictionary::map(&<$type>::default()),)+ _ => Map::new() }
        }

        /// Whether requests for `verb` have a field for `input`.
        #[must_use]
        pub fn takes(verb: Verb, input: Input) -> bool {
            silent_fields(verb).contains_key(input.name())
        }

        /// How the fields of requests for `verb` depend on each other.
        #[cfg(feature = "clap")]
        pub(crate) const fn relations_of(verb: Verb) -> &'static [&'static [Relation]] {
            match verb { $(Verb::$variant => $relations,)+ _ => &[] }
        }

        $(impl From<$type> for Request {
            fn from(request: $type) -> Self {
                Self::$variant(Box::new(request))
            }
        })+
    };
}

impl Request {
    /// Answers to questions, of a verb that changes models.
    pub fn answers_mut(&mut self) -> Option<&mut AnswerOptions> {
        Some(match self {
            Self::Rescale(request) => &mut request.answers,
            Self::Transfer(request) => &mut request.answers,
            Self::Add(request) => &mut request.answers,
            Self::Remove(request) => &mut request.answers,
            Self::Convert(request) => &mut request.answers,
            Self::Design(request) => &mut request.answers,
            Self::Set(request) => &mut request.answers,
            Self::Note(request) => &mut request.answers,
            Self::Fit(request) => &mut request.answers,
            _ => return None,
        })
    }

    /// What it says of masses, of a verb that changes models.
    pub fn masses_mut(&mut self) -> Option<&mut MassOptions> {
        Some(match self {
            Self::Rescale(request) => &mut request.masses,
            Self::Transfer(request) => &mut request.masses,
            Self::Add(request) => &mut request.masses,
            Self::Design(request) => &mut request.masses,
            Self::Set(request) => &mut request.masses,
            _ => return None,
        })
    }

    /// Where results go, of a verb that changes models.
    pub fn output_mut(&mut self) -> Option<&mut OutputOptions> {
        Some(match self {
            Self::Rescale(request) => &mut request.output,
            Self::Transfer(request) => &mut request.output,
            Self::Add(request) => &mut request.output,
            Self::Remove(request) => &mut request.output,
            Self::Convert(request) => &mut request.output,
            Self::Design(request) => &mut request.output,
            Self::Set(request) => &mut request.output,
            Self::Note(request) => &mut request.output,
            Self::Fit(request) => &mut request.output,
            _ => return None,
        })
    }

    /// How to go about the work, of a verb that changes models.
    #[must_use]
    pub fn run_options(&self) -> Option<&RunOptions> {
        Some(match self {
            Self::Rescale(request) => &request.run,
            Self::Transfer(request) => &request.run,
            Self::Add(request) => &request.run,
            Self::Remove(request) => &request.run,
            Self::Convert(request) => &request.run,
            Self::Design(request) => &request.run,
            Self::Set(request) => &request.run,
            Self::Note(request) => &request.run,
            Self::Fit(request) => &request.run,
            _ => return None,
        })
    }
}

requests! {
    Rescale(RescaleRequest) = RescaleRequest::RELATIONS;
    Transfer(TransferRequest) = TransferRequest::RELATIONS;
    Add(AddRequest) = AddRequest::RELATIONS;
    Remove(RemoveRequest) = RemoveRequest::RELATIONS;
    Convert(ConvertRequest) = ConvertRequest::RELATIONS;
    Design(DesignRequest) = DesignRequest::RELATIONS;
    Set(SetRequest) = SetRequest::RELATIONS;
    Note(NoteRequest) = NoteRequest::RELATIONS;
    Batch(BatchRequest) = BatchRequest::RELATIONS;
    Sweep(SweepRequest) = SweepRequest::RELATIONS;
    Inspect(InspectRequest) = InspectRequest::RELATIONS;
    Check(CheckRequest) = CheckRequest::RELATIONS;
    DropTest(DropTestRequest) = DropTestRequest::RELATIONS;
    Motion(MotionRequest) = MotionRequest::RELATIONS;
    Plot(PlotRequest) = PlotRequest::RELATIONS;
    Fit(FitRequest) = FitRequest::RELATIONS;
    Reproduce(ReproduceRequest) = ReproduceRequest::RELATIONS;
    Presets(PresetsRequest) = &[];
    Explain(ExplainRequest) = &[];
}
