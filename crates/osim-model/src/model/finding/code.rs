//! The codes of all rules, in the order of the documentation; the severity of findings, and the verdicts to which rules belong.

use std::fmt;

use crate::messages::named;

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
