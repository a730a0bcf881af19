//! Rules about models and changes, and findings: cases in which a rule applies. Also the codes of all rules, in the order of the
//! documentation, the severity of findings, and the verdicts to which rules belong.

use std::fmt;

use contact_scaling::limits;
use indexmap::IndexMap;

use crate::messages::{Dialect, Phrase, named};
use crate::xml::TextPosition;

/// One case in which a rule applies to a model or a change, with its place and message.
///
/// ```
/// use osim_model::{FindingCode, Model, Severity};
///
/// # let text = include_str!("../../tests/data/one_foot.osim");
/// let off = "<stiffness>1000000</stiffness><appliesForce>false</appliesForce>";
/// let model = Model::parse(text.replace("<stiffness>1000000</stiffness>", off))?;
/// let finding = &model.remarks_on(&model.force_ids())[0];
/// assert_eq!((finding.code(), finding.code().as_str()), (FindingCode::DisabledForce, "disabled-force"));
/// assert_eq!(finding.place.as_deref(), Some("/forceset/contact_heel_r"));
/// // The rule is shared by all findings of one code.
/// assert_eq!(finding.rule.severity, Severity::Remark);
/// assert!(finding.advice.to_string().starts_with("Nothing, if this is intended"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Finding {
    pub rule: &'static Rule,
    /// The severity of the rule, or of what follows from the finding; a lower one for the published state of known contacts.
    pub severity: Severity,
    pub message: Phrase,
    pub why: Phrase,
    /// Advice on this finding, by default that of the rule.
    pub advice: Phrase,
    /// Component path of the force, sphere or body in question; of the worst one if there are several. `None` if no component is meant.
    pub place: Option<String>,
    /// Component paths of all elements in question, `place` first; empty if there is only one.
    pub places: Vec<String>,
    /// Names of all spheres in question; empty if the finding is not about spheres.
    pub spheres: Vec<String>,
    /// Place in the model's file; `None` if there is no single place.
    pub position: Option<TextPosition>,
    /// For the result of a change: whether the model before the change, or the reference, already has this finding.
    pub had_before: bool,
    /// Whether the known contacts of the model were published with this finding.
    pub is_published: bool,
    /// A sentence for each component in question, if there is more to say than its name.
    pub details: Vec<String>,
    /// The size of the problem, for comparing the finding with the same finding in other models.
    pub measure: Option<Measure>,
}

/// The size of the problem in a finding.
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// The size as a number: larger is worse. All sizes of a code that have words have the same unit; those without may have another one.
    pub size: f64,
    /// The size in a few words, with its unit; may be empty.
    pub text: String,
}

impl Finding {
    /// A finding of `rule`, without a place.
    pub fn new(rule: &'static Rule, message: impl Into<Phrase>) -> Self {
        Self {
            rule,
            severity: rule.severity,
            message: message.into(),
            why: rule.why(),
            advice: rule.advice(),
            place: None,
            places: Vec::new(),
            spheres: Vec::new(),
            position: None,
            had_before: false,
            is_published: false,
            details: Vec::new(),
            measure: None,
        }
    }

    /// A finding of `rule` at a place in the file.
    pub fn at(rule: &'static Rule, position: TextPosition, message: impl Into<Phrase>) -> Self {
        Self { position: Some(position), ..Self::new(rule, message) }
    }

    pub fn code(&self) -> FindingCode {
        self.rule.code
    }

    /// The finding with the component path that it is about.
    pub fn with_place(self, path: &str) -> Self {
        Self { place: Some(path.to_owned()), ..self }
    }

    /// The finding with its line and column.
    pub fn with_position(self, position: Option<TextPosition>) -> Self {
        Self { position, ..self }
    }

    /// The finding with the names of its spheres.
    pub fn with_spheres(self, spheres: Vec<String>) -> Self {
        Self { spheres, ..self }
    }

    /// The finding with a sentence for each of its cases.
    pub fn with_details(self, details: Vec<String>) -> Self {
        Self { details, ..self }
    }

    /// The finding with the size of the problem, as a number and in words.
    pub fn with_measure(self, size: f64, text: impl Into<String>) -> Self {
        Self { measure: Some(Measure { size, text: text.into() }), ..self }
    }

    pub fn with_message(self, message: impl Into<Phrase>) -> Self {
        Self { message: message.into(), ..self }
    }

    pub fn with_advice(self, advice: impl Into<Phrase>) -> Self {
        Self { advice: advice.into(), ..self }
    }

    pub fn with_severity(self, severity: Severity) -> Self {
        Self { severity, ..self }
    }

    /// Whether the known contacts were published like this, and nobody has to look at it. That they were published does not make them right
    /// for a body of another mass, and what Simbody does with several spheres stays worth seeing.
    pub fn is_as_published(&self) -> bool {
        use FindingCode::{ContactsOfAnotherMass, KnownContacts, MixedRadii, SeveralSpheres};
        let is_worth_seeing = matches!(self.code(), ContactsOfAnotherMass | MixedRadii | SeveralSpheres);
        self.code() == KnownContacts || self.is_published && !is_worth_seeing
    }

    /// The component paths of all elements in question.
    pub fn paths(&self) -> impl Iterator<Item = &String> {
        self.place.iter().filter(|_| self.places.is_empty()).chain(&self.places)
    }

    /// The component paths of all elements in question, or `None` alone.
    pub fn paths_or_none(&self) -> impl Iterator<Item = Option<&str>> {
        let no_path = self.place.is_none().then_some(None);
        self.paths().map(|path| Some(path.as_str())).chain(no_path)
    }

    /// What findings of one cause have in common: all but their lines, and in their texts the component paths and the names after "m for".
    /// Numbers that are misread or differ between the sides may each have a value of its own.
    fn cause(&self) -> String {
        use FindingCode::{LeftRightClose, LeftRightDiffer, OddNumber};
        let without_paths = |text: &str| {
            let words: Vec<&str> = text.split(' ').collect();
            let is_name = |at: usize| at > 1 && words.get(at - 2..at) == Some(&["m", "for"]);
            let words = words.iter().enumerate();
            let words = words.map(|(at, word)| if word.starts_with('/') || is_name(at) { "/" } else { word });
            words.collect::<Vec<_>>().join(" ")
        };
        let message = self.message.to_string();
        let is_of_value = matches!(self.code(), LeftRightClose | LeftRightDiffer | OddNumber);
        if let Some((what, _)) = message.split_once(" is ").filter(|_| is_of_value) {
            return format!("{:?}", (self.code(), self.severity, without_paths(what)));
        }
        let texts = std::iter::once(&message).chain(&self.details).map(|text| without_paths(text));
        format!("{:?}", (self.code(), self.severity, texts.collect::<Vec<_>>(), &self.spheres))
    }

    /// Makes one finding of all that have the same cause. It has the place and the line of the first, and a sentence for each.
    pub fn group_by_cause(findings: Vec<Self>) -> Vec<Self> {
        let mut groups: IndexMap<String, Vec<Self>> = IndexMap::new();
        for finding in findings {
            groups.entry(finding.cause()).or_default().push(finding);
        }
        groups.values().filter_map(|cases| Self::join_cases(cases)).collect()
    }

    /// The largest measure of findings with one code.
    pub fn largest_measure<'f>(findings: impl Iterator<Item = &'f Self>) -> Option<&'f Measure> {
        findings.filter_map(|one| one.measure.as_ref()).max_by(|a, b| a.size.total_cmp(&b.size))
    }

    /// One finding of all `cases`, with the place and the line of the first, and a sentence for each.
    pub fn join_cases(cases: &[Self]) -> Option<Self> {
        let mut joined = cases.first()?.clone();
        if cases.len() > 1 {
            joined.places = cases.iter().flat_map(Self::paths).cloned().collect();
            joined.message.push(format!(" (and {} more)", cases.len() - 1));
            joined.details = cases.iter().flat_map(Self::sentences).collect();
            joined.measure = Self::largest_measure(cases.iter()).cloned();
        }
        Some(joined)
    }

    /// The details, or else the message.
    fn sentences(&self) -> Vec<String> {
        if self.details.is_empty() { vec![self.message.to_string()] } else { self.details.clone() }
    }

    /// Converts the texts of the finding to the `dialect` of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        for phrase in [&mut self.message, &mut self.why, &mut self.advice] {
            phrase.spell(dialect);
        }
    }
}

/// A rule: the kind of a finding, with its code, its texts and an example. In the texts, inputs and calls are in backticks, see
/// [`Phrase::template`], and names of limits are in braces.
#[derive(Debug, PartialEq, Eq)]
pub struct Rule {
    pub code: FindingCode,
    pub severity: Severity,
    /// The topic of the verdict to which the rule contributes, if any.
    pub verdict: Option<VerdictTopic>,
    pub what: &'static str,
    pub why: &'static str,
    pub advice: &'static str,
    /// What a proposed command does to repair the model, or why there is no command.
    pub repair: Repair,
    pub example: Example,
}

/// Declares the static of a rule: `NAME: Code, Severity, Topic of its verdict; what: "...", why: "...", ...`. A rule without a verdict
/// has no topic.
#[macro_export]
macro_rules! rule {
    (@verdict) => { None };
    (@verdict $verdict:ident) => { Some($crate::VerdictTopic::$verdict) };
    ($(#[$doc:meta])* $visibility:vis $name:ident: $code:ident, $severity:ident $(, $verdict:ident)?; $($field:ident: $value:expr),+ $(,)?) => {
        $(#[$doc])*
        $visibility static $name: $crate::Rule = $crate::Rule {
            code: $crate::FindingCode::$code,
            severity: $crate::Severity::$severity,
            verdict: $crate::rule!(@verdict $($verdict)?),
            $($field: $value),+
        };
    };
}

/// Whether a command can be proposed that removes the reason of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Repair {
    /// A command exists; the text says what it does to the model.
    Command(&'static str),
    /// No command repairs the model; the text says why.
    NotPossible(&'static str),
    /// No command, because only a change can have this finding, not a model; the text explains.
    OnlyInChange(&'static str),
}

/// An example that has the finding, and one that does not. Models are those of `fixtures/`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Example {
    /// A piece of a model: with `good` in it there is no finding, with `bad` in its place there is one.
    Piece { model: &'static str, good: &'static str, bad: &'static str },
    /// In `check/within_limits.osim`, the text of the first element `tag` with the text `good` becomes `bad`: then there is a finding.
    ElementText { tag: &'static str, good: &'static str, bad: &'static str },
    /// Two models: `good` has no such finding, `bad` has one.
    Models { good: &'static str, bad: &'static str },
    /// A request, as JSON, whose result has the finding.
    Request { good: &'static str, bad: &'static str },
    /// A description of files that have the finding together. A separate test makes the files.
    InWords { good: &'static str, bad: &'static str },
}

impl Rule {
    pub fn what(&self) -> Phrase {
        with_limits(self.what)
    }

    pub fn why(&self) -> Phrase {
        with_limits(self.why)
    }

    pub fn advice(&self) -> Phrase {
        with_limits(self.advice)
    }
}

impl Repair {
    /// The text as a sentence, without its full stop.
    pub fn sentence(self) -> String {
        match self {
            Self::Command(what) => format!("check proposes a command that {what}"),
            Self::NotPossible(why) | Self::OnlyInChange(why) => format!("no command is proposed: {why}"),
        }
    }
}

/// The phrase of a template in which names in braces are replaced by limits of the crate contact-scaling.
fn with_limits(text: &str) -> Phrase {
    if !text.contains('{') {
        return Phrase::template(text.trim_ascii());
    }
    let named = [
        ("{indentation}", limits::INDENTATION.value),
        ("{restitution}", limits::RESTITUTION.value),
        ("{constant_indentation}", limits::CONSTANT_INDENTATION.value),
        ("{suggested_indentation}", limits::SUGGESTED_CONSTANT_INDENTATION),
        ("{suggested_width}", limits::SUGGESTED_TRANSITION_WIDTH),
    ];
    let used = named.iter().filter(|(name, _)| text.contains(name));
    let text = used.fold(text.to_owned(), |text, (name, value)| text.replace(name, &value.to_string()));
    Phrase::template(text.trim_ascii())
}

named! {
    /// The kinds of findings, about models and about changes. [`Rule`](crate::model::finding::Rule) describes each. Findings of equal severity
    /// are listed in this order.
    pub enum FindingCode {
        SpheresLeftBehind = "spheres-left-behind",
        SpheresMisplaced = "spheres-misplaced",
        AlreadyAtTarget = "already-at-target",
        MassSourcesDisagree = "mass-sources-disagree",
        GravitySourcesDisagree = "gravity-sources-disagree",
        OtherVersion = "other-version",
        ConnecteeByName = "connectee-by-name",
        SocketNowhere = "socket-nowhere",
        BodyWithoutJoint = "body-without-joint",
        MisplacedObject = "misplaced-object",
        IgnoredContacts = "ignored-contacts",
        UnknownName = "unknown-name",
        LoopOfJoints = "loop-of-joints",
        MisnamedParameterSet = "misnamed-parameter-set",
        DefaultStiffness = "default-stiffness",
        ZeroConstantContactForce = "zero-constant-contact-force",
        DeadDerivativeSmoothing = "dead-derivative-smoothing",
        SeveralSpheres = "several-spheres-one-force",
        CompositeSurfaces = "composite-surfaces",
        CompiledModelBeside = "compiled-model-beside",
        HardLinked = "hard-linked",
        SphereInTwoForces = "sphere-in-two-forces",
        SurfaceNamedTwice = "surface-named-twice",
        NoSurfacesMeet = "no-surfaces-meet",
        SphereOfOtherSide = "sphere-of-other-side",
        ShapePressesNothing = "shape-presses-nothing",
        DoubledSpheres = "doubled-spheres",
        OddParent = "odd-parent",
        LeftRightBones = "left-right-bones",
        FootSphereOnGround = "foot-sphere-on-ground",
        LeftRightDiffer = "left-right-differ",
        LeftRightPlaces = "left-right-places",
        LeftRightMissing = "left-right-missing",
        LeftRightSwapped = "left-right-swapped",
        LeftRightOff = "left-right-off",
        LeftRightClose = "left-right-close",
        OneSideOnly = "one-side-only",
        OddRadius = "odd-radius",
        OddPlace = "odd-place",
        CrowdedSpheres = "crowded-spheres",
        OddMesh = "odd-mesh",
        LargeFriction = "large-friction",
        DynamicAboveStatic = "dynamic-above-static",
        OddTransitionVelocity = "odd-transition-velocity",
        ContactDefaults = "contact-defaults",
        NotHertz = "not-hertz",
        Ellipsoid = "ellipsoid",
        MixedRadii = "mixed-radii",
        SeveralParameterSets = "several-parameter-sets",
        Terrain = "terrain",
        BottomsMoved = "bottoms-moved",
        NothingToChange = "nothing-to-change",
        NotFinite = "not-finite",
        OddNumber = "odd-number",
        StaleNote = "stale-note",
        MocoDialect = "moco-dialect",
        DisabledForce = "disabled-force",
        UnknownClass = "unknown-class",
        DuplicateNames = "duplicate-names",
        RefusedName = "refused-name",
        IncludedFile = "included-file",
        FrictionNotSimilar = "friction-not-similar",
        FactorsDisagree = "factors-disagree",
        NotAScaledCopy = "not-a-scaled-copy",
        FactorSpread = "factor-spread",
        ReferenceWithoutSmoothing = "reference-without-smoothing",
        MixedPair = "mixed-pair",
        MassUnknown = "mass-unknown",
        MasslessBody = "massless-body",
        HeavyFoot = "heavy-foot",
        DefaultOutsideRange = "default-outside-range",
        AngleInDegrees = "angle-in-degrees",
        GravityTooLarge = "gravity-too-large",
        GravityNotDown = "gravity-not-down",
        FloorUpsideDown = "floor-upside-down",
        FloorUpright = "floor-upright",
        FloorOnLimb = "floor-on-limb",
        FloorSlopes = "floor-slopes",
        FloorStep = "floor-step",
        OutOfDomain = "out-of-domain",
        BeyondHertz = "beyond-hertz",
        BeyondHertzAtTwo = "beyond-hertz-at-two",
        SunkIn = "sunk-in",
        TooStiff = "too-stiff",
        BeyondHuntCrossley = "beyond-hunt-crossley",
        LargeConstantIndentation = "large-constant-indentation",
        WeakAtRest = "weak-at-rest",
        WideTransition = "wide-transition",
        ForceBeforeContact = "force-before-contact",
        Floats = "floats",
        UnevenBottoms = "uneven-bottoms",
        UnlevelFoot = "unlevel-foot",
        NotOnFloor = "not-on-floor",
        RootHeld = "root-held",
        ContactsOfAnotherMass = "contacts-of-another-mass",
        SpheresNotCompared = "spheres-not-compared",
        KnownContacts = "known-contacts",
        CountUnknown = "sphere-count-unknown",
        NoGravity = "no-gravity",
        BareModel = "bare-model",
        UnmatchedPattern = "unmatched-pattern",
        MassAgainstLength = "mass-against-length",
        DissipationForms = "dissipation-forms",
        UnlikeRecording = "unlike-recording",
        LargeCorrection = "large-correction",
        HorizontalError = "horizontal-error",
        OddGravity = "odd-gravity",
        NoFriction = "no-friction",
        NoDissipation = "no-dissipation",
    }
}

impl fmt::Display for FindingCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

named! {
    /// The severity of a finding, from harmless to harmful.
    ///
    /// Exhaustive: the JSON of a finding promises exactly these three.
    pub enum Severity {
        /// Possibly intended, such as a pose or a damped contact.
        Remark = "remark",
        /// A value is outside a limit; or OpenSim loads the model, but a contact does not act, or acts elsewhere than the file suggests.
        Warning = "warning",
        /// OpenSim 4.6 refuses the model or reads another number than is written; or the model is certainly wrong.
        Error = "error",
    }
}

named! {
    /// The topic of a verdict. Each rule about a model belongs to one topic, or to none.
    ///
    /// Exhaustive: six topics for every model, and one more for a recording.
    pub enum VerdictTopic {
        /// Whether the floor is level and on ground, and gravity points down.
        Floor = "floor",
        /// Whether the model stands on its spheres at the default pose.
        Standing = "standing",
        /// Whether the contacts fit the mass of the body.
        Mass = "mass",
        /// Whether left and right agree.
        Sides = "sides",
        /// Whether sizes and places of spheres are believable.
        Sizes = "sizes",
        /// Whether a solver can handle the contacts: smoothing, speeds, restitution.
        Solver = "solver",
        /// Whether the contacts fit a recording: their forces beside those of force plates.
        Recording = "motion",
    }
}

impl VerdictTopic {
    /// The topics of every model, in the order in which they are shown.
    pub const OF_EVERY_MODEL: [Self; 6] =
        [Self::Floor, Self::Standing, Self::Mass, Self::Sides, Self::Sizes, Self::Solver];

    /// The topic as a question to the reader.
    pub const fn as_question(self) -> &'static str {
        match self {
            Self::Floor => "Is the floor level and fixed?",
            Self::Standing => "Does it stand?",
            Self::Mass => "Do the contacts fit the mass?",
            Self::Sides => "Do left and right agree?",
            Self::Sizes => "Are sizes and places believable?",
            Self::Solver => "Can a solver handle it?",
            Self::Recording => "Does it fit the recording?",
        }
    }
}
