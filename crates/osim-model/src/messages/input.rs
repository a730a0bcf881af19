//! The names of all inputs of requests and of all verbs (commands), and the parts of a message that refer to them.

use std::borrow::Cow;
use std::fmt;

use super::printable::shown_whole;

/// Declares enums whose variants have a fixed name each, for JSON, tables and messages: `as_str` gives it, and `ALL` all variants.
#[macro_export]
macro_rules! named {
    ($($(#[$about:meta])* $visibility:vis enum $name:ident {
        $($(#[$of_variant:meta])* $variant:ident = $text:literal),+ $(,)?
    })+) => {$(
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        $visibility enum $name {
            $($(#[$of_variant])* $variant),+
        }

        impl $name {
            /// All variants, in the order of their declaration.
            #[allow(dead_code, reason = "not every enum is listed")]
            $visibility const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The fixed name, for JSON, tables and messages.
            $visibility const fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $text),+ }
            }
        }
    )+};
}

macro_rules! inputs {
    ($($variant:ident = $name:literal, $label:literal;)+) => {
        /// An input that a caller can give, called after its field in a request.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Input {
            $(#[doc = concat!("`", $name, "`: ", $label, ".")] $variant,)+
        }

        impl Input {
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Name of the field in a request, for example `contacts_mass`.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }

            /// The input with exactly this name.
            pub fn find(name: &str) -> Option<Self> {
                match name {
                    $($name => Some(Self::$variant),)+
                    _ => None,
                }
            }

            /// A few words that describe the input, for forms.
            pub const fn label(self) -> &'static str {
                match self { $(Self::$variant => $label),+ }
            }
        }
    };
}

inputs! {
    Again = "again", "apply it once more";
    AllowOutside = "allow_outside", "write outside the folder";
    Angles = "angles", "unit of the motion's angles";
    Ascii = "ascii", "plain letters";
    Axes = "axes", "units of the axes";
    Belt = "belt", "speed of the treadmill's belt";
    BeltColumn = "belt_column", "column of the belt's speed";
    BodyScale = "body_scale", "scale factors of a body";
    BodyScaleFile = "body_scale_file", "the Scale Tool's ScaleSet";
    BodyWeights = "body_weights", "load in body weights";
    BodyMap = "body_map", "body that takes the spheres of another";
    Branch = "branch", "part of the measurement";
    Class = "class", "class of the new forces";
    Compare = "compare", "body to compare with";
    CompareSpheres = "compare_spheres", "spheres that share the other body's weight";
    ConstantContactForce = "constant_contact_force", "constant contact force";
    ConstantIndentation = "constant_indentation", "constant indentation over radius";
    ContactStiffness = "contact_stiffness", "stiffness of one sphere";
    Contacts = "contacts", "table of contacts";
    ContactsGravity = "contacts_gravity", "gravity the contacts were made for";
    ContactsMass = "contacts_mass", "mass the contacts were made for";
    Correct = "correct", "file of the corrected motion";
    Count = "count", "spheres under each foot";
    Data = "data", "table of the numbers drawn";
    DefaultPose = "default_pose", "global places are those of the default pose";
    Deny = "deny", "findings that count as a failure";
    Diff = "diff", "unified diff";
    DimensionlessStiffness = "dimensionless_stiffness", "dimensionless stiffness";
    Dissipation = "dissipation", "dissipation";
    DissipationBy = "dissipation_by", "how dissipation follows";
    Dpi = "dpi", "pixels per inch";
    DryRun = "dry_run", "dry run";
    Duration = "duration", "duration";
    DynamicFriction = "dynamic_friction", "dynamic friction";
    End = "end", "end of the motion's window";
    Error = "error", "usual errors of the motion";
    Exclude = "exclude", "forces to leave out";
    ExcludeBody = "exclude_body", "bodies to leave out of the sum";
    Feet = "feet", "bodies that touch the ground";
    Fit = "fit", "what is fitted";
    Fix = "fix", "do what check prints";
    Floor = "floor", "height of the floor";
    FollowBodies = "follow_bodies", "spheres follow their bodies";
    FontSize = "font_size", "size of the letters";
    FootMass = "foot_mass", "mass of the foot that falls";
    Force = "force", "replace existing files";
    ForceColumn = "force_column", "column of the force";
    ForceUnit = "force_unit", "unit of the force";
    Format = "format", "how to print";
    Friction = "friction", "scale friction speeds too";
    From = "from", "source of the contacts";
    FromMocoSetup = "from_moco_setup", "Moco setup of the original";
    Full = "full", "everything in full";
    Geometry = "geometry", "file of the contact geometry set";
    GeometryDir = "geometry_dir", "folder of the bones' meshes";
    GeometryOutput = "geometry_output", "output file of the geometry set";
    Gravity = "gravity", "gravity";
    Grid = "grid", "values along an axis";
    Height = "height", "height of the drop";
    HeightIn = "height_in", "what a fitted height moves";
    HeightRatio = "height_ratio", "ratio of the heights";
    HertzSmoothing = "hertz_smoothing", "Hertz smoothing";
    HuntCrossleySmoothing = "hunt_crossley_smoothing", "Hunt-Crossley smoothing";
    ImpactSpeed = "impact_speed", "impact speed";
    InPlace = "in_place", "change the model itself";
    Indentation = "indentation", "relative indentation";
    IndentationColumn = "indentation_column", "column of the indentation";
    IndentationUnit = "indentation_unit", "unit of the indentation";
    Jobs = "jobs", "models to work on at once";
    Keep = "keep", "properties that stay";
    Kind = "kind", "what to draw";
    Label = "label", "name of a curve";
    Ladder = "ladder", "steps of a ladder";
    Level = "level", "soles stay level";
    LevelAxis = "level_axis", "axis that points up";
    Load = "load", "total load";
    Loads = "loads", "OpenSim's ExternalLoads";
    LowPass = "low_pass", "cutoff of the low-pass filter";
    Mass = "mass", "mass of the model";
    Mirror = "mirror", "axis of the mirror";
    Moco = "moco", "folder for Moco";
    MocoSetup = "moco_setup", "Moco setup";
    Model = "model", "file of the model";
    Motion = "motion", "motion of the model";
    MovedSpheres = "moved_spheres", "spheres that were moved already";
    Nmsm = "nmsm", "folder for NMSM";
    NoBackup = "no_backup", "keep no backup";
    NoNote = "no_note", "leave no note";
    Only = "only", "properties that change";
    Onset = "onset", "where contact begins";
    OtherPoisson = "other_poisson", "Poisson's ratio of the other surface";
    OtherYoung = "other_young", "Young's modulus of the other surface";
    Output = "output", "output file";
    OutputDir = "output_dir", "output folder";
    Pad = "pad", "sole below the bones";
    Plates = "plates", "measured ground reactions";
    PlatesDelay = "plates_delay", "delay of the force plates";
    Point = "point", "one point of the grid";
    Poisson = "poisson", "Poisson's ratio";
    Presets = "presets", "file with presets";
    Quantity = "quantity", "what the colours show";
    Quiet = "quiet", "errors only";
    Radius = "radius", "radius";
    RadiusAxis = "radius_axis", "how a radius follows from three factors";
    ReferenceGravity = "reference_gravity", "gravity of the reference";
    ReferenceMass = "reference_mass", "mass the reference's contacts were made for";
    ReferenceSelect = "reference_select", "forces of the reference";
    ReferenceSphere = "reference_sphere", "sphere of the reference";
    ReferenceSpheres = "reference_spheres", "spheres that share the reference's weight";
    Replace = "replace", "take the model's own contacts out first";
    Report = "report", "report";
    Restitution = "restitution", "coefficient of restitution";
    Resume = "resume", "continue an earlier run";
    Rule = "rule", "whose scaling";
    Samples = "samples", "points of the series";
    Select = "select", "forces to choose";
    Shard = "shard", "share of the models";
    SkipDisabled = "skip_disabled", "leave out disabled forces";
    Sockets = "sockets", "paths of sockets";
    Soft = "soft", "dimensionless stiffness of the first step";
    SpeedColumn = "speed_column", "column of the speed";
    SpeedSmoothing = "speed_smoothing", "Hunt-Crossley smoothing times the root of the radius";
    SpeedUnit = "speed_unit", "unit of the speed";
    SpeedWidth = "speed_width", "width of the transition in speed";
    Spheres = "spheres", "spheres that share the body weight";
    StanceLimbs = "stance_limbs", "limbs that share the body weight";
    Start = "start", "start of the motion's window";
    StateSmoothing = "state_smoothing", "Hertz smoothing times the radius";
    StateWidth = "state_width", "width of the contact transition over radius";
    StaticFriction = "static_friction", "static friction";
    Stiffness = "stiffness", "OpenSim's stiffness";
    Stress = "stress", "mean stress";
    Strict = "strict", "refuse instead of warning";
    Summary = "summary", "summary file";
    Table = "table", "table to draw";
    TargetGravity = "target_gravity", "gravity to scale to";
    TargetMass = "target_mass", "target mass";
    Threshold = "threshold", "threshold that the widths refer to";
    TimeColumn = "time_column", "column of the time";
    TimeUnit = "time_unit", "unit of the time";
    Title = "title", "title of the figure";
    To = "to", "class that forces get";
    Topics = "topics", "what to explain";
    TransitionVelocity = "transition_velocity", "transition velocity";
    Vertical = "vertical", "only vertical forces";
    ViscousFriction = "viscous_friction", "viscous friction";
    Unbounded = "unbounded", "spheres deeper than their radius";
    ValueColumn = "value_column", "column of the colours";
    ValueRange = "value_range", "range of the colours";
    Width = "width", "width of the figure";
    XColumn = "x_column", "column of the horizontal axis";
    XRange = "x_range", "limits of the horizontal axis";
    YColumn = "y_column", "column of the vertical axis";
    YRange = "y_range", "limits of the vertical axis";
    Yes = "yes", "questions that you confirm";
    Young = "young", "Young's modulus";
}

named! {
    /// A task that this program can do with models, such as `rescale`.
    pub enum Verb {
        /// A model's own contacts at another mass.
        Rescale = "rescale",
        /// Contacts of another model or of a preset.
        Transfer = "transfer",
        /// Contacts for a model that has none.
        Add = "add",
        /// Contacts out of a model.
        Remove = "remove",
        /// Forces of one class as forces of the other.
        Convert = "convert",
        /// Parameters from what is wanted.
        Design = "design",
        /// Plain values and factors.
        Set = "set",
        /// The mass that contacts were made for, written down.
        Note = "note",
        /// Many models, as a table says.
        Batch = "batch",
        /// Variants of one model.
        Sweep = "sweep",
        /// What contacts a model has, and what they do.
        Inspect = "inspect",
        /// Models compared with the limits of the paper and the traps of the format.
        Check = "check",
        /// A body that falls on its contacts.
        DropTest = "drop-test",
        /// Contacts along a recorded motion.
        Motion = "motion",
        /// Draws figures.
        Plot = "plot",
        /// Parameters from a measured indentation and force.
        Fit = "fit",
        /// What the paper prints and draws, computed again.
        Reproduce = "reproduce",
        /// Published contacts and the user's own.
        Presets = "presets",
        /// What an equation or a code means.
        Explain = "explain",
    }
}

// Inputs and calls as they are in a sentence.

/// A part of a message: text, an input, a call, or a choice between two texts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PhrasePart {
    Text(Cow<'static, str>),
    /// An input that the reader can give, perhaps with an example of its value.
    Input(Input, Option<Example>),
    /// A call of a verb that the reader can make.
    Call(Call),
    /// Two alternative texts: the first for verbs that take the input, the second for other verbs.
    Either(Input, Box<[Vec<PhrasePart>; 2]>),
}

/// An example of an input's value in a message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Example {
    /// A word in place of a value that the reader knows, such as `KG`.
    Placeholder(Cow<'static, str>),
    /// The value itself: a number, or a word such as `keep`.
    Value(String),
}

/// A call of a verb in a message, with the inputs that it gives.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Call {
    pub verb: Verb,
    pub with_model: bool,
    /// Names of the models' files, where they are known.
    pub files: Vec<String>,
    pub inputs: Vec<(Input, Option<Example>)>,
}

impl Verb {
    /// Name of the verb, for example `drop-test`.
    pub const fn name(self) -> &'static str {
        self.as_str()
    }

    /// The verb with exactly this name.
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|verb| verb.name() == name)
    }

    /// The verb as a call without inputs.
    pub const fn call(self) -> Call {
        Call { verb: self, with_model: false, files: Vec::new(), inputs: Vec::new() }
    }

    /// The verb as a call that names a model.
    pub const fn call_with_model(self) -> Call {
        Call { verb: self, with_model: true, files: Vec::new(), inputs: Vec::new() }
    }
}

impl Call {
    /// The names of the models' files; `placeholder` where they are not known; none for a call without a model.
    pub fn models_or<'c>(&'c self, placeholder: &'c str) -> impl Iterator<Item = &'c str> {
        let is_unnamed = self.with_model && self.files.is_empty();
        self.files.iter().map(String::as_str).chain(is_unnamed.then_some(placeholder))
    }

    /// Adds an input to the call, with a placeholder for its value.
    pub fn with_placeholder(mut self, input: Input, placeholder: &'static str) -> Self {
        self.inputs.push((input, Some(Example::Placeholder(placeholder.into()))));
        self
    }

    /// The call with an input that has no value.
    pub(crate) fn with_flag(mut self, input: Input) -> Self {
        self.inputs.push((input, None));
        self
    }

    /// The call with an input and its value.
    pub fn with_value(mut self, input: Input, value: impl Into<String>) -> Self {
        self.inputs.push((input, Some(Example::Value(value.into()))));
        self
    }
}

impl Input {
    /// This input with a placeholder for its value: `--mass KG`.
    pub const fn with_placeholder(self, placeholder: &'static str) -> PhrasePart {
        PhrasePart::Input(self, Some(Example::Placeholder(Cow::Borrowed(placeholder))))
    }

    /// This input with a value: `--radius keep`.
    pub fn with_value(self, value: impl Into<String>) -> PhrasePart {
        PhrasePart::Input(self, Some(Example::Value(value.into())))
    }
}

impl fmt::Display for Example {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Placeholder(word) => f.write_str(word),
            // A value may be the name of a file or of a sphere.
            Self::Value(value) => shown_whole(value).fmt(f),
        }
    }
}
