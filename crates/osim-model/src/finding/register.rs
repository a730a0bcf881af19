//! The one register of findings: what each code means, why it matters, what to do, how bad it is, and which command puts it
//! right. docs/warnings.md and the tables of docs/check.md are made from it.

use std::fmt;

use contact_scaling::limits;
use osim_messages::Phrase;

use super::severity::{Seen, Severity};

/// Whether a command can be proposed that puts a finding right.
///
/// Exhaustive: it can, or it cannot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Repair {
    /// Yes, where the model can be changed: what it does.
    Command(&'static str),
    /// No, and why.
    NotPossible(&'static str),
}

impl Repair {
    /// In a sentence without its full stop.
    #[must_use]
    pub fn sentence(self) -> String {
        match self {
            Self::Command(what) => format!("check proposes a command that {what}"),
            Self::NotPossible(why) => format!("no command is proposed: {why}"),
        }
    }
}

/// A text in which the numbers of limits have names.
fn template(text: &str) -> Phrase {
    let named = [
        ("{indentation}", limits::INDENTATION.value),
        ("{restitution}", limits::RESTITUTION.value),
        ("{constant_indentation}", limits::CONSTANT_INDENTATION.value),
        ("{suggested_indentation}", limits::SUGGESTED_CONSTANT_INDENTATION),
        ("{suggested_width}", limits::SUGGESTED_TRANSITION_WIDTH),
    ];
    let text =
        named.iter().fold(text.to_owned(), |text, (name, value)| text.replace(name, &value.to_string()));
    Phrase::template(text.trim_ascii())
}

macro_rules! codes {
    ($($(#[doc = $doc:literal])+ $variant:ident = $code:literal, $severity:ident, $seen:ident: $why:literal; $advice:literal; $repair:ident $what:literal.)+) => {
        /// Kinds of finding, about models and about changes. In the texts, inputs and calls are in backticks, see
        /// [`Phrase::template`].
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum FindingCode {
            $($(#[doc = $doc])+ $variant,)+
        }

        impl FindingCode {
            /// Every code.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Stable short name, as in the JSON `code`.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $code),+ }
            }

            /// What it is, in a sentence.
            #[must_use]
            pub fn what(self) -> Phrase {
                template(match self { $(Self::$variant => concat!($($doc),+)),+ })
            }

            /// Why it matters.
            #[must_use]
            pub fn why(self) -> Phrase {
                template(match self { $(Self::$variant => $why),+ })
            }

            /// How bad it is.
            #[must_use]
            pub const fn severity(self) -> Severity {
                match self { $(Self::$variant => Severity::$severity),+ }
            }

            /// Where it shows.
            #[must_use]
            pub const fn seen(self) -> Seen {
                match self { $(Self::$variant => Seen::$seen),+ }
            }

            /// What to do about it.
            #[must_use]
            pub fn advice(self) -> Phrase {
                template(match self { $(Self::$variant => $advice),+ })
            }

            /// The command that puts it right, or why there is none.
            #[must_use]
            pub const fn repair(self) -> Repair {
                match self { $(Self::$variant => Repair::$repair($what)),+ }
            }
        }
    };
}

codes! {
    /// Spheres stand where they were before OpenSim scaled their bodies.
    SpheresLeftBehind = "spheres-left-behind", Error, Model:
        "OpenSim's Scale Tool scales bones, joints and masses. It leaves contact spheres where they were, as large and as stiff as before, so that they hang beyond the foot of a smaller animal and end short of a larger one's.";
        "`rescale MODEL target_mass=KG follow_bodies` where the note in the file has the sizes of the bones; else `transfer MODEL from=ORIGINAL follow_bodies`, where ORIGINAL is the model that was scaled. Both make the contacts right for this mass, too. Add `level` only where the foot became about as much lower as it became shorter and narrower";
        Command "lets the spheres follow their bodies, where the note has their sizes or the original is named".
    /// Spheres do not fit their bones, as in no published model or as in one of another size.
    SpheresMisplaced = "spheres-misplaced", Warn, Model:
        "Either OpenSim scaled the bones and left the spheres behind, or the spheres were taken from a model of another size. Then they push where the foot is not.";
        "See where each belongs with `check MODEL from=ORIGINAL`, where ORIGINAL is the model that was scaled; then `transfer MODEL from=ORIGINAL follow_bodies`. With the Scale Tool's ScaleSet alone: `rescale MODEL body_scale_file=SCALESET.xml contacts_mass=KG target_mass=KG`";
        NotPossible "it needs the model that was scaled, or the ScaleSet, and only you know where they are".
    /// The contacts are already made for the target mass, so nothing was written.
    AlreadyAtTarget = "already-at-target", Warn, Change:
        "The mass the contacts are made for is taken from the note in the file, else `mass`, else the sum of the bodies. A model that was scaled in OpenSim weighs its new mass already while its contacts are still those of the old one; the file does not show which.";
        "Say what the contacts were made for with `contacts_mass=KG`, or take those of a known model with `transfer from=MODEL`";
        NotPossible "only you know what the contacts were made for".
    /// The note, `mass` and the bodies give different masses.
    MassSourcesDisagree = "mass-sources-disagree", Warn, Model:
        "The factor of every change follows from the mass the contacts are made for; a wrong one scales all of them wrongly.";
        "Check the mass that was taken (the first line of the output) and say `contacts_mass=KG` if it is not the right one";
        NotPossible "only you know which of the masses is right".
    /// The note gives another gravity than the model.
    GravitySourcesDisagree = "gravity-sources-disagree", Warn, Model:
        "Under another gravity than they were made for, spheres sink in more or less; figures are those under the model's own.";
        "Set gravity in OpenSim, or look at the model under the gravity of its contacts with `check MODEL gravity=G`";
        NotPossible "only you know which gravity is meant".
    /// A component was found by its name because the path written leads nowhere.
    ConnecteeByName = "connectee-by-name", Warn, Model:
        "OpenSim may fail to load such a model, or connect it to something else.";
        "Open the model in OpenSim, check the connection and save it";
        NotPossible "only OpenSim shows what it connects".
    /// A body has more than one joint: joints form a loop, or OpenSim ignores some.
    LoopOfJoints = "loop-of-joints", Warn, Model:
        "Of joints inside a body, as documents up to version 3 have them, OpenSim takes the first and ignores the others. Elsewhere it cuts a loop of joints: it divides a body into equal parts that a constraint holds together, and their masses still make the body's. Where a WeldJoint or a FreeJoint between two bodies is in the loop it divides nothing, and counts the mass of a body twice. Left, right and limbs follow the first joint of each body.";
        "Say what the model weighs with `mass=KG` where it is asked for; in OpenSim, close a loop with a constraint instead of a joint";
        NotPossible "only numbers of contacts are changed".
    /// A ContactParametersSet has a name OpenSim does not look for.
    MisnamedParameterSet = "misnamed-parameter-set", Error, Model:
        "OpenSim finds the set by its name: with another one the force has no parameters and never pushes.";
        "Name the set contact_parameters";
        NotPossible "names are left alone: only numbers are changed".
    /// A stiffness is left at its class default.
    DefaultStiffness = "default-stiffness", Error, Model:
        "OpenSim's default stiffness (1 N/m2 in SmoothSphereHalfSpaceForce) carries nothing; it is nearly always a forgotten value.";
        "Set a stiffness, for example with `transfer from=falisse2022`";
        Command "takes the contacts of a published model".
    /// A SmoothSphereHalfSpaceForce has a constant_contact_force of 0.
    ZeroConstantContactForce = "zero-constant-contact-force", Error, Model:
        "Simbody divides by the root of the squared slip speed plus constant_contact_force: with 0, the force is NaN whenever the sphere does not slip, even without friction. Scaling leaves a value of 0 as it is.";
        "Give it a small value, for example `design MODEL constant_indentation={suggested_indentation}`";
        Command "designs constant_contact_force for a small constant indentation".
    /// The file has a derivative_smoothing element, which OpenSim ignores.
    DeadDerivativeSmoothing = "dead-derivative-smoothing", Warn, Model:
        "derivative_smoothing was the name of constant_contact_force in early Moco. OpenSim ignores it and uses its default of 1e-5 m2 for constant_contact_force.";
        "Remove the element; set constant_contact_force if another value is meant";
        NotPossible "only you know which value was meant".
    /// One HuntCrossleyForce has several spheres.
    SeveralSpheres = "several-spheres-one-force", Warn, Model:
        "In Simbody, when one sphere of a HuntCrossleyForce leaves the ground faster than 2/(3 dissipation), the spheres evaluated after it lose their force in that step.";
        "Give each sphere a HuntCrossleyForce of its own with `convert MODEL to=hunt-crossley`";
        Command "makes one force for each sphere; stiffness, dissipation and friction stay as they are".
    /// Sphere and half-space of a converted force have parameters of their own.
    CompositeSurfaces = "composite-surfaces", Warn, Change:
        "A force of one sphere has one set of parameters. It gets those that both surfaces have together (A.3), which gives the same force; but Simbody moves the point of contact towards the softer surface, so that accelerations can differ by up to 3 %.";
        "Nothing, if 3 % do not matter; otherwise give both surfaces the same parameters first";
        NotPossible "only you know which parameters are meant".
    /// A compiled file, F_ and the name of the model, lies beside the output.
    CompiledModelBeside = "compiled-model-beside", Warn, Model:
        "PredSim and OpenCap compile a model to F_<name> and reuse it without looking at the model's content: the old contacts would stay in use.";
        "Delete the compiled file, or write the model under a new name";
        NotPossible "files of other programs are left alone".
    /// A model that is changed itself has other names too.
    HardLinked = "hard-linked", Warn, Change:
        "A changed model is a new file that takes the name of the old one, so that no moment is without a whole file. Hard links to the old one are names of the old file: they keep the old model.";
        "Make the other names again, or change the model under one of its names into a file of its own";
        NotPossible "only you know what the other names are for".
    /// One sphere is used by two contact forces.
    SphereInTwoForces = "sphere-in-two-forces", Warn, Model:
        "Both forces act, so the sphere is stiffer than either stiffness says, and the sphere count by which parameters scale is not what it seems.";
        "Leave the sphere in one force";
        NotPossible "only you know which force is meant".
    /// Left and right contacts differ.
    LeftRightDiffer = "left-right-differ", Warn, Model:
        "Contacts of a symmetric model are nearly always meant to be symmetric; a difference usually is a slip of the hand.";
        "Compare the two sides with `inspect` and correct the one that is wrong";
        Command "writes the values of the right side into the left force, where they can be written in one call".
    /// The defaults of the document hold contact objects.
    ContactDefaults = "contact-defaults", Warn, Model:
        "OpenSim keeps the defaults of one model for every model loaded later in the same session, so another model can silently take these values.";
        "Write the values into the forces themselves, or load the model in a fresh OpenSim";
        NotPossible "<defaults> are left alone, because other models may depend on them".
    /// Contacts of a class that is not Hertz's.
    NotHertz = "not-hertz", Info, Model:
        "ElasticFoundationForce, ExponentialContactForce and MeyerFregly2016Force do not follow the equations used here; they are left as they are.";
        "Scale them by their own theory, or replace them";
        NotPossible "the equations are not those of such a force".
    /// Radii differ within one ContactParameters.
    MixedRadii = "mixed-radii", Info, Model:
        "One ContactParameters has one modulus for all its spheres. The mean of R squared is used before and after: equal relative indentation, load in proportion to R squared.";
        "Nothing, if that is meant; else give each sphere its own force";
        NotPossible "nothing is wrong".
    /// A force has several ContactParameters.
    SeveralParameterSets = "several-parameter-sets", Info, Model:
        "The surfaces have moduli of their own and the contact uses their composite (A.3); all are multiplied by the same factor.";
        "Nothing, if that is meant";
        NotPossible "nothing is wrong".
    /// A sphere stands on ground or on a body welded to it.
    Terrain = "terrain", Info, Model:
        "Terrain does not grow with the animal: its radius stays.";
        "Nothing, if that is meant";
        NotPossible "nothing is wrong".
    /// Something that was asked for changes nothing.
    NothingToChange = "nothing-to-change", Info, Change:
        "A factor of exactly 1 leaves every byte as it is. With a radius that stays, dissipation and smoothing stay too (14, C.2, C.5, C.10).";
        "Nothing, if that is meant; else say what should change";
        NotPossible "nothing is wrong".
    /// A number in the file is not finite.
    NotFinite = "not-finite", Error, Model:
        "JSON has no NaN and no infinity: such a number is null there. OpenSim computes nonsense from it.";
        "Correct the number in the model";
        NotPossible "only you know which number was meant".
    /// A number is written in a way that OpenSim reads differently from what it looks like.
    OddNumber = "odd-number", Error, Model:
        "OpenSim reads the start of a text as far as it looks like a number and ignores the rest, or silently takes its default.";
        "Write the number plainly, like 1.5e6";
        NotPossible "only you know which number was meant".
    /// The note in the file cannot be relied on.
    StaleNote = "stale-note", Info, Model:
        "The values in the file are no longer those the note was written for, or only some of them were scaled.";
        "Say what the contacts are made for with `contacts_mass=KG`";
        NotPossible "only you know what the contacts were made for".
    /// The sphere's radius is inside the force, as in Moco 0.1 to 0.3.
    MocoDialect = "moco-dialect", Warn, Model:
        "OpenSim 4.2 and later cannot read such forces; the model works in OpenSim Moco 0.1 to 0.3 only.";
        "Rebuild the contacts with ContactSphere and ContactHalfSpace for a newer OpenSim";
        NotPossible "only numbers are changed, and OpenSim needs other elements".
    /// A contact force that is switched off is changed with the others.
    DisabledForce = "disabled-force", Info, Model:
        "A force that does not apply carries no load, so its spheres are not counted; it is still scaled, so that it is right once it is switched on.";
        "Nothing, if that is meant; else `skip_disabled`";
        NotPossible "nothing is wrong".
    /// Contacts are in a component of a class that OpenSim does not know.
    UnknownClass = "unknown-class", Error, Model:
        "OpenSim skips a component of a class it does not know, with everything in it, so these contacts do not exist for it; they were left alone. A plugin may know the class.";
        "Move the contacts into the ForceSet, or out of the component of that class";
        NotPossible "only numbers are changed, and the contacts have to move".
    /// Two components have the same name.
    DuplicateNames = "duplicate-names", Warn, Model:
        "OpenSim renames the second one when it loads the model, so a path or a name means the first one only.";
        "Give each a name of its own";
        NotPossible "names are left alone: only numbers are changed".
    /// Contacts are in a file that the model includes.
    IncludedFile = "included-file", Info, Model:
        "The contacts were read from the file that the model names; a change would have to go into that file too.";
        "Save the model in OpenSim as one file before rescaling it";
        NotPossible "the file may serve other models, too".
    /// The friction of SmoothSphereHalfSpaceForce is not exactly similar.
    FrictionNotSimilar = "friction-not-similar", Info, Change:
        "Simbody adds constant_contact_force to the squared slip speed, where similarity wants a term in proportion to g R: friction of the smooth force is similar only as far as that term is small.";
        "Compare slip speeds with the root of constant_contact_force before relying on it";
        NotPossible "it lies in how OpenSim computes friction".
    /// Two sources give different scale factors of a body.
    FactorsDisagree = "factors-disagree", Warn, Change:
        "A sphere's place and size follow from its body's factors; the first source in the order given, scale file, mesh, joint offset was taken.";
        "Look at `inspect from`, and say `body_scale=BODY=x,y,z` where another source is right";
        NotPossible "only you know which source is right".
    /// A model is not a scaled copy of the reference whose contacts follow its bodies.
    NotAScaledCopy = "not-a-scaled-copy", Warn, Change:
        "In a scaled copy, joint offsets and meshes give each factor exactly. Between different models offsets are not factors: a body then gets the ratio of the mesh factors of the same bone, else one ratio of distances to a joint below it, and the last body of a limb the factors of the body it hangs on.";
        "Nothing, if another model is meant; else name the generic model that this one was scaled from, or say `body_scale=BODY=x,y,z`";
        NotPossible "only you know which model this one was scaled from".
    /// Spheres of one ContactParameters follow bodies with different factors.
    FactorSpread = "factor-spread", Warn, Change:
        "One ContactParameters has one modulus for all its spheres; the mean of R squared is used before and after, so single spheres sink in more or less than they did.";
        "Give each sphere its own force, or accept it; `strict` refuses instead";
        NotPossible "forces cannot be divided yet: only numbers are changed".
    /// The reference has no smoothing parameters to give.
    ReferenceWithoutSmoothing = "reference-without-smoothing", Warn, Change:
        "A HuntCrossleyForce has no constant_contact_force, hertz_smoothing or hunt_crossley_smoothing, so those of the model stay (or follow its own radii where these change).";
        "Take the contacts from a model with SmoothSphereHalfSpaceForce, or check the smoothing with `inspect`";
        NotPossible "only you know which smoothing is meant".
    /// A note of another output file was found that does not belong to this one.
    MixedPair = "mixed-pair", Error, Model:
        "The force set and the geometry set carry notes of different runs: their stiffnesses and radii do not belong together.";
        "Write both again in one run";
        NotPossible "only you know which of the two files is the right one".
    /// What the model weighs, or what its contacts are made for, is not known.
    MassUnknown = "mass-unknown", Warn, Model:
        "Every factor follows from these masses.";
        "Say `mass=KG` or `contacts_mass=KG`, or correct the masses of the bodies";
        NotPossible "only you know what the model weighs".
    /// A number lies outside the domain of the contact laws.
    OutOfDomain = "out-of-domain", Error, Model:
        "OpenSim accepts it and computes NaN or nonsense; such a model is not changed.";
        "Correct the number in the model";
        NotPossible "only you know which number was meant".
    /// Spheres sink in deeper than Hertz' law is accurate for, at body weight on one limb.
    BeyondHertz = "beyond-hertz", Warn, Model:
        "Hertz' law was found accurate up to a relative indentation of {indentation}, a contact patch of 0.4 R. Beyond, the contact is a non-linear spring and no longer a material; most published gait models are there (Falisse et al. 2022: 0.353).";
        "Nothing, if a spring is meant; else `design MODEL indentation={indentation}`, larger or more spheres";
        Command "designs the stiffness for the limit; where one modulus serves different spheres, or nobody knows how many share the weight, multiplies it".
    /// Spheres sink in deeper than Hertz' law is accurate for, at two body weights and not at one.
    BeyondHertzAtTwo = "beyond-hertz-at-two", Info, Model:
        "A foot carries more than body weight in running and landing. At twice body weight the relative indentation is above {indentation}, up to which Hertz' law is accurate.";
        "Nothing, if the model only walks; else `design MODEL indentation={indentation} body_weights=2`";
        Command "designs or multiplies the stiffness as for beyond-hertz, under two body weights".
    /// Spheres sink in by their whole radius or more at body weight on one limb.
    SunkIn = "sunk-in", Error, Model:
        "A sphere that is in the floor up to its centre meets no surface that a contact law knows: OpenSim goes on with the same formula. The stiffness is nearly always one of a lighter body, or the spheres too small.";
        "Scale the contacts to this body with `rescale MODEL contacts_mass=KG target_mass=KG`, or `design MODEL indentation={indentation}`";
        Command "designs or multiplies the stiffness as for beyond-hertz".
    /// Restitution by (13) is so low that the Hunt-Crossley law is not accurate.
    BeyondHuntCrossley = "beyond-hunt-crossley", Warn, Model:
        "The Hunt-Crossley law describes materials that give back most of the impact speed. Below a restitution of {restitution} at the impact speed, dissipation is a damper that makes a simulation calm; energies lost in contact are not those of a material.";
        "Nothing, if that is meant; else `design MODEL restitution={restitution}`";
        Command "designs the dissipation for the limit; where one force has several, multiplies them".
    /// The constant indentation of constant_contact_force is a large part of the radius.
    LargeConstantIndentation = "large-constant-indentation", Warn, Model:
        "constant_contact_force is a squared indentation and does not grow with the sphere by itself: OpenSim's default of 1e-5 m2, made for spheres of 32 mm, is 3.2 mm. On smaller spheres it holds the body up before they touch (C.2).";
        "`design MODEL constant_indentation={constant_indentation}`, or {suggested_indentation} where spheres sink in by less than {indentation} R";
        Command "designs constant_contact_force for the limit".
    /// Contact sets in over more of the radius than in published models.
    WideTransition = "wide-transition", Warn, Model:
        "hertz_smoothing is an inverse length: OpenSim's default of 300 1/m, made for spheres of 32 mm, spreads the onset of contact over 10 mm. On smaller spheres that is a large part of the radius, half of it before they touch (C.7).";
        "`design MODEL state_width={suggested_width}`";
        Command "designs hertz_smoothing for a width within the limit".
    /// A sphere that only just touches the floor carries a large part of its share of body weight already.
    ForceBeforeContact = "force-before-contact", Warn, Model:
        "Smoothing lets force through before contact (Fig. C.5): the floor repels the foot, as if the spheres were larger. In Falisse et al. (2022), where that did no harm, it is 0.074 of the share.";
        "Make constant_contact_force smaller with `design MODEL constant_indentation=X`";
        Command "designs constant_contact_force so that the share comes down to the limit".
    /// The smoothing alone carries body weight: the spheres do not touch the floor.
    Floats = "floats", Error, Model:
        "With constant_contact_force and hertz_smoothing far too large for the spheres, the force before contact holds the body in the air.";
        "Make constant_contact_force smaller with `design MODEL constant_indentation=X`";
        Command "designs constant_contact_force so that the spheres touch the floor".
    /// The contacts are published ones, made for a body of another mass.
    ContactsOfAnotherMass = "contacts-of-another-mass", Warn, Model:
        "Radius, stiffness, dissipation and number of spheres are those of a published model, but the body weighs something else: contacts that are not scaled sink in more or less than they did there.";
        "If OpenSim scaled this model, `check MODEL from=GENERIC`, then `transfer MODEL from=GENERIC follow_bodies`. If its spheres are where they belong, `rescale MODEL contacts_mass=KG target_mass=KG`, with the mass the contacts were made for and the mass of this body";
        Command "scales the contacts from the mass they were made for to that of this body, where the places of the spheres are known to be right".
    /// Whether spheres followed a scaling of their bodies cannot be seen in this file.
    SpheresNotCompared = "spheres-not-compared", Info, Model:
        "The bones were scaled; OpenSim leaves contact spheres where they were, and this file alone does not show whether somebody moved them afterwards.";
        "Compare with the model that was scaled: `check MODEL from=GENERIC`";
        NotPossible "only you know which model was scaled".
    /// The contacts are known: somebody published them.
    KnownContacts = "known-contacts", Info, Model:
        "What was published so with these contacts is a remark; a warning is what is wrong for this model.";
        "Nothing, if that is meant";
        NotPossible "nothing is wrong".
    /// How many spheres share the weight is not known.
    CountUnknown = "sphere-count-unknown", Info, Model:
        "Limbs are found by left and right sides below the joint tree. Where that does not work, figures under body weight are absent and nothing is said about indentations.";
        "Say it with `spheres=N`; where spheres of several bodies are there that only ground joins, choose those of one with `select=GLOB`";
        NotPossible "only you know how many spheres share the weight".
    /// The model has no gravity.
    NoGravity = "no-gravity", Info, Model:
        "Without gravity there is no body weight, so nothing is said about indentations.";
        "Nothing, if that is meant; else set gravity in the model, or look under another one with `check MODEL gravity=G`";
        NotPossible "only you know the gravity".
}

impl fmt::Display for FindingCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
