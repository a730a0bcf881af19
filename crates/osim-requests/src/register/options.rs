//! The entries of the register: one option per paragraph, with its help, and other help texts for some verbs.

use osim_model::messages::Input;
use osim_model::messages::Verb::{
    self, Add, Batch, Check, Convert, Design, DropTest, Explain, Fit, Inspect, Motion, Note, Plot, Presets,
    Remove, Reproduce, Rescale, Set, Sweep, Transfer,
};

use super::entry::{Entry, Field, FieldGroup};
use crate::options::*;
use crate::request::*;
use crate::values::serial::Words;

// Headings of the help.

/// The heading of options that only one verb has; the help lists them first.
const GROUP_OF_ONE_VERB: &str = "";
const MASSES_GROUP: &str = "Masses";
const CHANGES_GROUP: &str = "What changes";
const FORCES_GROUP: &str = "Which forces";
const OUTPUT_GROUP: &str = "Output";
const SETS_GROUP: &str = "Standalone sets";
const WEIGHT_GROUP: &str = "Spheres that share the weight";
const FIGURES_GROUP: &str = "What the values are computed for";
const REFERENCE_GROUP: &str = "The reference";
const SCALED_GROUP: &str = "A model that OpenSim scaled (`from` is the generic model)";
const WANTED_GROUP: &str = "What is wanted or known";
const NUMBERS_GROUP: &str = "Numbers without a reference";
const LOAD_GROUP: &str = "The load";
const CONTACT_GROUP: &str = "Without a model (with `mass` and `spheres`)";
const FALL_GROUP: &str = "The fall (drop, loop, sweep)";
const SWEEP_GROUP: &str = "The sweep";
const FIGURE_GROUP: &str = "The figure";
const RECORDING_GROUP: &str = "To a recording";
const COLUMNS_GROUP: &str = "Columns and units";

const fn format_words(verb: Verb) -> Words {
    match verb {
        Sweep | Reproduce | Presets | Explain => Format::WORDS,
        Inspect | Check => SheetFormat::WORDS,
        DropTest => SeriesFormat::WORDS,
        Motion => MotionFormat::WORDS,
        _ => RunFormat::WORDS,
    }
}

/// Makes the entries from rows `Input = value, "help", Verb => "another help";`. An input without a row does not compile.
macro_rules! entries {
    (
        ($field:expr, $verb:expr);
        operands { $($name:literal = $of_takes:ident $of_args:tt $(. $of_more:ident $of_more_args:tt)*,
            $of_help:literal $(, $($of_verb:ident)|+ => $of_other:literal)*;)+ }
        $($heading:ident => { $($input:ident = $takes:ident $args:tt $(. $more:ident $more_args:tt)*,
            $help:literal $(, $($other_verb:ident)|+ => $other:literal)*;)+ })+
    ) => {
        match $field {
            $($(Field::Input(Input::$input) => {
                let help = help_for($verb, $help, &[$((&[$($other_verb),+], $other)),*]);
                Entry::new(Input::$input.name(), $heading, help).$takes $args $(.$more $more_args)*
            })+)+
            $(Field::Operand($name) => {
                let help = help_for($verb, $of_help, &[$((&[$($of_verb),+], $of_other)),*]);
                Entry::new($name, GROUP_OF_ONE_VERB, help).$of_takes $of_args $(.$of_more $of_more_args)*
            })+
            Field::Operand(_) => return None,
        }
    };
}

fn help_for(verb: Verb, help: &'static str, others: &[(&[Verb], &'static str)]) -> &'static str {
    others.iter().find(|(verbs, _)| verbs.contains(&verb)).map_or(help, |(_, help)| help)
}

pub(super) fn entry_of(field: Field<'_>, verb: Verb) -> Option<Entry> {
    let is = |verbs: &[Verb]| verbs.contains(&verb);
    Some(entries! {
    (field, verb);
    operands {
        "models" = read(if is(&[Plot]) { "MODEL|PRESET" } else { "MODEL" }).list_if(true),
            "Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input",
            Add | Remove | Convert => "Models (.osim), folders, or - for standard input",
            Design => "Models to write the design into; without one, a calculator",
            Plot => "Models (.osim) or presets, overlaid in one figure; none for fig4 and fig-c5";
        "subject" = read(if is(&[Motion]) { "MODEL" } else { "MODEL|PRESET" }),
            "The model to drop (.osim), or a preset; without one, give the numbers",
            Motion => "The model (.osim), or a ForceSet (.xml) with `geometry` and `model`";
        "manifest" = read("TABLE"), "A table (.csv, .xlsx): a column 'model', and one for each option that rows need; - is standard input";
        "file" = read("FILE|MODEL"), "Measured indentation and force (.csv; - is standard input); with `motion`, the model (.osim)";
        "name" = value("NAME"), "One preset (without it: list them all)";
        "set" = assignments(), "Properties by OpenSim's names, each with its value, or with a factor such as \"x2\"";
    }
    GROUP_OF_ONE_VERB => {
        TargetMass = value("KG").signed(), "Mass the contacts should be made for, kg",
            Inspect => "List what else changes with body size, for a body of this mass, kg: muscles, springs, actuators",
            Plot => "Draw each contact also as it is after scaling to this mass, kg";
        BodyScaleFile = read("FILE").under_if(is(&[Rescale]), CHANGES_GROUP).under_if(is(&[Transfer]), SCALED_GROUP).rare_if(!is(&[Transfer])),
            "With `from`: the ScaleSet that the Scale Tool applied",
            Rescale => "ScaleSet that the Scale Tool applied: spheres follow their bodies",
            Transfer => "The ScaleSet that the Scale Tool applied (its output_scale_file)";
        FollowBodies = flag().under_if(is(&[Rescale]), CHANGES_GROUP).under_if(is(&[Transfer]), SCALED_GROUP),
            "Spheres follow bodies scaled since the model's note was written",
            Transfer => "Spheres take place and size from their bodies, which OpenSim has scaled";
        From = read(if is(&[Inspect, Check]) { "MODEL" } else { "MODEL|PRESET" }),
            "Where the contacts come from: a model, or a preset such as falisse2022",
            Add => "Where the contacts come from: a model, or a preset with places: falisse2022, dhondt2024, moco-2d-gait",
            Inspect => "The generic model this one was scaled from: show each body's factors",
            Check => "The generic model this one was scaled from: whether its spheres followed, and what else follows size";
        Presets = read("FILE").rare_if(!is(&[Presets])), "A file with presets of your own (TOML)";
        Contacts = read("TABLE"),
            "Where the spheres are: a table with name, body, x, y, z [m, in the body's frame] and perhaps radius, or MuSkeMo's export";
        DefaultPose = flag().rare(), "Take places that the table has in ground only as those of the default pose";
        Feet = with_commas("BODY"), "Lay spheres under the meshes of these bodies, which touch the ground, separated by commas";
        Count = value("N"), "Spheres under each foot";
        Pad = value("METRES").signed(), "How far below the lowest bone point the sole is, m: bones have no skin";
        GeometryDir = folder().rare_if(is(&[Add])), "A folder with the bones' meshes, beside that of the model and its Geometry",
            Plot => "Of feet: a folder with the bones' meshes, beside the model's own and its Geometry";
        Mirror = choice(MirrorChoice::WORDS).rare(), "If the reference has one side only: make the other side, too, mirrored in this axis";
        Class = choice(ClassChoice::WORDS), "Class of the new forces [default: the reference's]";
        BodyMap = values("BODY=BODY"), "A body of the reference, and the one that takes its spheres here; may be repeated";
        Replace = flag(), "Take the model's own foot contacts out first";
        To = choice(ClassChoice::WORDS), "The class that forces get";
        Sockets = flag(), "Write the paths of sockets that lead nowhere, where only one component has the name in them";
        ConstantContactForce = value(if is(&[DropTest]) { "CF" } else { "M2" }).under_if(is(&[DropTest]), CONTACT_GROUP),
            "OpenSim's constant_contact_force of forces that had none [default: Falisse et al. (2022) at each radius (C.2)]",
            DropTest => "With the next two: SmoothSphereHalfSpaceForce's law, m2";
        HertzSmoothing = value(if is(&[DropTest]) { "BD" } else { "PER_M" }).under_if(is(&[DropTest]), CONTACT_GROUP),
            "hertz_smoothing of forces that had none, 1/m [default: Falisse et al. (2022) at each radius (C.5)]",
            DropTest => "1/m";
        HuntCrossleySmoothing = value(if is(&[DropTest]) { "BV" } else { "S_PER_M" }).under_if(is(&[DropTest]), CONTACT_GROUP),
            "hunt_crossley_smoothing of forces that had none, s/m [default: Falisse et al. (2022) at each radius (C.10)]",
            DropTest => "s/m";
        Grid = values("NAME=V,V,..."),
            "Values of a property (stiffness=1e5,1e6), factors (stiffness=x0.1,x1,x10), a logarithmic range (stiffness=x0.1..x10/9), or \
             values of indentation, restitution or target_mass; may be repeated";
        Ladder = value("N"), "N steps from a soft contact to `indentation` and `restitution`, to search for a gait step by step";
        Soft = value("K").rare(), "With `ladder`: dimensionless stiffness of the first step";
        Point = value("N").rare(), "Only point N of the grid, or step N of the ladder, counted from 1, for job arrays";
        Full = flag().about(FieldGroup::Shown), "Show everything: each model, all rows, all explanations, all digits";
        MocoSetup = read("FILE").rare(), "With `from`: list what else follows size in this Moco setup (.omoco), too";
        FromMocoSetup = read("FILE").rare(), "With `moco_setup`: the Moco setup of the generic model, to compare with";
        Motion = read(if is(&[Motion]) { "MOTION" } else { "FILE" }).list_if(is(&[Fit])).under_if(is(&[Fit]), RECORDING_GROUP)
            .rare_if(is(&[Plot])),
            "Say whether the contacts fit this motion (.mot, .sto), too",
            Motion => "Its motion: coordinates over time (.mot or .sto), from inverse kinematics or a simulation",
            Plot => "Of motion: coordinates over time (.mot, .sto)",
            Fit => "Fit the model to this motion (.mot, .sto), so that its forces are the measured ones; may be repeated, for several \
                    trials";
        Plates = read("FILE").list_if(is(&[Fit])).under_if(is(&[Fit]), RECORDING_GROUP).rare_if(is(&[Plot])),
            "With `motion`: the ground reactions that force plates measured (.mot, .sto)",
            Motion => "Ground reactions that force plates measured (.mot or .sto)",
            Plot => "Of motion: the ground reactions that force plates measured (.mot, .sto)",
            Fit => "Ground reactions that force plates measured (.mot, .sto); one for each motion";
        Loads = read("FILE").list_if(is(&[Fit])).under_if(is(&[Fit]), RECORDING_GROUP).rare_if(is(&[Check, Plot])),
            "With `motion`: OpenSim's ExternalLoads (.xml)",
            Motion => "OpenSim's ExternalLoads (.xml): which columns of the plates act on which body",
            Plot => "Of motion: OpenSim's ExternalLoads (.xml)",
            Fit => "OpenSim's ExternalLoads (.xml); one for each motion, or one for all";
        Angles = choice(AngleChoice::WORDS).under_if(is(&[Fit]), RECORDING_GROUP).rare_if(is(&[Check, Plot])),
            "With `motion`: the unit of its angles, where its header does not say it",
            Motion => "The unit of the motion's angles, where its header does not say it",
            Plot => "Of motion: the unit of its angles, where its header does not say it",
            Fit => "The unit of the motions' angles, where their headers do not say it";
        Fix = flag().about(FieldGroup::Output), "Do what the printed commands do, and check the result: with `output`, `output_dir` or `in_place`";
        Deny = choice(Deny::WORDS).rare_if(!is(&[Check])).about(FieldGroup::Shown).of_run(),
            "Exit with 1 where the result has a finding as bad as this, or worse",
            Check => "Exit with 1 where a finding is as bad as this, or worse";
        Height = value("HEIGHT").under_if(is(&[Plot]), FALL_GROUP),
            "Height of the spheres' lowest points at the start: metres, or a factor of the radius like x0.25";
        Duration = value("S").under_if(is(&[Plot]), FALL_GROUP).rare_if(is(&[Plot])), "How long to follow the body, s",
            Plot => "How long to follow the body, s [default: 20 sqrt(R/g), of the slowest]";
        Samples = value("N").rare(), "Points of the series";
        Compare = read("OTHER"), "Say how far this drop and that of OTHER (a model or preset) lie apart in dimensionless form";
        CompareSpheres = value("N").rare(), "With `compare`: the spheres that share OTHER's weight [default: as found on one limb]";
        FootMass = value("KG").rare(), "Let a foot of this mass fall in the place of the body, kg: it is the foot that strikes the ground";
        PlatesDelay = value("S").signed().under_if(is(&[Fit]), RECORDING_GROUP).rare(),
            "Delay of the plates, s: their data are moved earlier by this time";
        LowPass = value("HZ").under_if(is(&[Fit]), RECORDING_GROUP),
            "Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6 is usual for walking)";
        Belt = value("M/S").signed().under_if(is(&[Fit]), RECORDING_GROUP),
            "Speed of a treadmill's belt towards -x, m/s; slip is relative to it";
        BeltColumn = value("NAME").under_if(is(&[Fit]), RECORDING_GROUP).rare(), "Speed of a treadmill's belt from this column of the motion",
            Fit => "Speed of a treadmill's belt from this column of each motion";
        Start = value("S").signed().under_if(is(&[Fit]), RECORDING_GROUP), "Leave out what the motion has before this time, s";
        End = value("S").signed().under_if(is(&[Fit]), RECORDING_GROUP), "Leave out what the motion has after this time, s";
        Correct = written("FILE"), "Write the motion to this file (.sto, .mot) after the least correction that makes the contacts give \
                                    the forces of the plates";
        Vertical = flag().rare(), "With `correct`: only forces along the normal of the floor and their centres count";
        Floor = value("M").signed().rare(), "With `correct`: the floor is this much higher than in the model, m [default: it is found]";
        Moco = folder().rare(), "With `correct`: write what Moco needs to track the corrected motion and the plates into this folder";
        Nmsm = folder().rare(), "With `correct`: write what NMSM's ground contact personalisation reads into this folder, not corrected";
        Error = value("MM,DEG").rare(), "With `correct`: usual errors of the motion's places and angles, as in 6mm,2deg [default: these]. \
                                         The limits of the verdict grow with the first";
        Kind = choice(PlotKind::WORDS), "What to draw";
        Data = written("FILE").about(FieldGroup::Output), "Write the numbers that are drawn to this file, too (CSV)";
        Axes = choice(AxesChoice::WORDS), "Units of indentation and force [default: x/R and N; x/R and shares of the weight for several]";
        Onset = value("M|fit").signed(), "Where contact begins, in metres, or fit to find it";
        Branch = choice(BranchChoice::WORDS).rare(), "Which part of the measurement";
        Topics = values("EQUATION|QUANTITY|CODE"),
            "Number of an equation (10, C.5), a word from the column \"equation\", a property or figure (stiffness, x/R), or a code as \
             printed after a finding";
        Ascii = flag().about(FieldGroup::Shown), "Spell symbols in plain letters, for consoles that cannot show them";
    }
    MASSES_GROUP => {
        ContactsMass = value("KG").signed().under_if(is(&[Note]), GROUP_OF_ONE_VERB).rare_if(is(&[Sweep, Motion, Plot, Fit]))
            .refused_if(is(&[Transfer, Add, Design, DropTest])),
            "Mass the contacts are made for now, kg [default: the note, else `mass`]",
            Note => "Mass the contacts in the file were made for, kg";
        Mass = value("KG").signed(), "Mass of this model, kg [default: the sum of its bodies]";
        ExcludeBody = values("GLOB").rare(), "Leave these bodies out of the sum (props, platforms); may be repeated";
    }
    CHANGES_GROUP => {
        Radius = value(if is(&[DropTest, Fit]) { "M" } else { "RULE" }).under_if(is(&[Add, Fit]), GROUP_OF_ONE_VERB)
            .under_if(is(&[Design, Sweep]), WANTED_GROUP).under_if(is(&[DropTest]), CONTACT_GROUP),
            "Radii: isometric (R ~ M^1/3), keep, a radius in metres, or a factor like x1.5 [default: isometric with `target_mass`, keep \
             otherwise]",
            Transfer => "Radii: keep, isometric (as the reference's, in proportion to M^(1/3)), follow (with the factors of bodies, by \
                         `radius_axis`), a radius in metres, or a factor like x1.5 [default: keep; isometric with `follow_bodies`]",
            Design | Sweep => "Sphere radius in metres (with models also keep or a factor like x1.5)",
            DropTest | Fit => "Sphere radius, m",
            Add => "Radii: isometric (R ~ M^1/3), follow (with the factors of the bodies), or a radius in metres";
        Level = flag().under_if(is(&[Add]), GROUP_OF_ONE_VERB),
            "Keep the soles: where a radius changes, move the centre so that the lowest point of the sphere stays",
            Transfer => "Keep the soles: where a radius changes, move the centre so that the lowest point of the sphere stays (with \
                         `follow_bodies`: on the scaled sole)",
            Add | Set => "Move spheres down until all spheres of a foot are as low as its lowest one, at the default pose";
        LevelAxis = choice(AxisChoice::WORDS).signed().rare(),
            "The axis of the spheres' frames that points up with the foot flat [default: nearest to -gravity]";
        Only = with_commas("LIST").rare(), "Only these properties, separated by commas (OpenSim's names, and radius)";
        Keep = with_commas("LIST").rare(), "Everything but these properties";
        DissipationBy = choice(DissipationChoice::WORDS).rare(), "What dissipation follows (14): R^-1/2 or M^-1/6";
        Friction = flag().under_if(is(&[Add]), GROUP_OF_ONE_VERB).rare(),
            "Scale transition_velocity and viscous_friction too (an extension of the paper)",
            Add => "Scale transition_velocity and viscous_friction of the reference too (an extension of the paper)";
        ContactsGravity = value("G").signed_if(is(&[Note])).under_if(is(&[Note]), GROUP_OF_ONE_VERB).rare_if(!is(&[Note])).refused_if(is(&[Transfer])),
            "Gravity the contacts are made for now, m/s2 [default: the note's, else the model's]",
            Note => "Gravity the contacts in the file were made for, m/s2 [default: the model's]";
        TargetGravity = value("G").rare(),
            "Scale to this gravity too, m/s2 (an extension of the paper) [default with `reference_gravity`: the model's]";
    }
    FORCES_GROUP => {
        Select = values("GLOB"), "Only forces with such a name; may be repeated";
        Exclude = values("GLOB").rare_if(!is(&[Add, Remove, Convert])), "No forces with such a name; may be repeated";
        SkipDisabled = flag().rare(), "Leave out forces that are switched off";
    }
    OUTPUT_GROUP => {
        Output = written("FILE").short('o').under_if(is(&[Motion, Plot]), GROUP_OF_ONE_VERB).refused_if(is(&[Batch])).about(FieldGroup::Output),
            "Write to this file, or - [default: NAME.scaled.osim beside it]",
            Motion => "Write the model's ground reactions to this file (.sto), with its ExternalLoads beside it (.xml)",
            Plot => "Write to this file: .svg, .pdf or .png (- is SVG on standard output)";
        GeometryOutput = written("FILE").rare().refused_if(is(&[Remove, Convert, Batch])).about(FieldGroup::Output),
            "Write the changed ContactGeometrySet of a standalone ForceSet to this file";
        OutputDir = folder().short('d').under_if(is(&[Reproduce]), GROUP_OF_ONE_VERB).rare_if(is(&[Fit])).about(FieldGroup::Output), "Write into this \
                                                                                                                        folder",
            Sweep => "Write the models into this folder [default: NAME.sweep beside the model]",
            Reproduce => "Write table1.csv, fig4.svg and fig-c5.svg into this folder";
        InPlace = flag().rare_if(is(&[Fit])).about(FieldGroup::Output), "Change the model itself and keep the old one as NAME.osim.bak";
        NoBackup = flag().rare().about(FieldGroup::Output), "With `in_place`: keep no backup";
        Force = flag().under_if(is(&[Motion, Plot, Reproduce]), GROUP_OF_ONE_VERB).about(FieldGroup::Output), "Replace existing files",
            Inspect => "Replace an existing report",
            Check => "Replace existing files";
        NoNote = flag().rare(), "Leave no note (in the credits) in the model",
            Sweep => "Leave no note (in the credits) in the models";
        DryRun = flag().of_run(), "Write nothing, only show what would change",
            Sweep => "Write nothing, only show what would be made";
        Diff = flag().rare_if(!is(&[Remove, Convert, Note])).about(FieldGroup::Shown).of_run(), "Show the changes as a unified diff too";
        Format = choice(format_words(verb)).under_if(is(&[Inspect, Check, DropTest, Motion, Reproduce, Presets, Explain]), GROUP_OF_ONE_VERB)
            .rare_if(is(&[Rescale, Fit])).about(FieldGroup::Shown).of_run(),
            "How to print [default: table; lines if more than 10 models]",
            Sweep | Inspect | Check | DropTest | Motion | Reproduce | Presets | Explain => "How to print";
        Quiet = flag().short('q').rare().about(FieldGroup::Shown).of_run(), "Print errors only";
        Report = written("FILE").of_run(), "Write a page for browsers too (.html): tables, plots, findings";
        Jobs = value("N").rare().about(FieldGroup::Many).of_run(), "Models to work on at once [default: one per processor]",
            Sweep => "Models to make at once [default: one per processor]";
        Summary = written("FILE").rare().about(FieldGroup::Many).of_run(), "Keep a line per model in this file (.csv or .ndjson)";
        Resume = flag().rare().about(FieldGroup::Many).of_run(), "Skip models that `summary` says are done, if nothing has changed since",
            Sweep => "Continue a sweep that was stopped or changed: make the models that are missing or out of date, and leave edited ones";
        Shard = value("I/N").under_if(is(&[Sweep]), GROUP_OF_ONE_VERB).rare().about(FieldGroup::Many).of_run(), "Only share I of N of the models, for \
                       job arrays",
            Sweep => "Only share I of N of the points, for job arrays";
        Yes = values("CODE").rare(), "Confirm what looks like a mistake: the code of the error that asks; may be repeated";
        Again = flag(), "Apply it once more";
        AllowOutside = flag(), "Let rows name files to write outside the folder of the results, or of the table";
    }
    SETS_GROUP => {
        Geometry = read("FILE").rare(), "The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet";
        Model = read(if is(&[Sweep]) { "MODEL" } else { "FILE" }).under_if(is(&[Sweep]), GROUP_OF_ONE_VERB).rare_if(!is(&[Sweep])),
            "The model a standalone ForceSet belongs to, for its masses and joints",
            Sweep => "The model (.osim) whose variants are made";
    }
    WEIGHT_GROUP => {
        Spheres = value("N").under_if(is(&[Inspect, Check]), FIGURES_GROUP).under_if(is(&[Fit]), GROUP_OF_ONE_VERB),
            "Spheres that share the body weight, all stance limbs together [default: as found per limb]",
            Fit => "Spheres that share the measured force";
        StanceLimbs = value("N").under_if(is(&[Note]), GROUP_OF_ONE_VERB).under_if(is(&[Inspect, Check]), FIGURES_GROUP).rare_if(!is(&[Note])),
            "Limbs that share the body weight [default: as the note in the model says, else 1]",
            Note => "Limbs that share the body weight [default: as the note in the model says]";
    }
    REFERENCE_GROUP => {
        ReferenceMass = value("KG").signed(), "Mass its contacts are made for, kg [default: its note, else its bodies]";
        ReferenceSpheres = value("N").rare(), "Its spheres that share the body weight [default: as found per limb]";
        ReferenceGravity = value("G").rare(),
            "Its gravity, m/s2 [default: its note's, else its own]: if given, contacts are scaled from it to `target_gravity`";
        ReferenceSelect = values("GLOB").rare(), "Only its forces with such a name; may be repeated";
        ReferenceSphere = value("NAME").rare(), "Take contact and isometric radius of this sphere for all";
    }
    SCALED_GROUP => {
        BodyScale = values("BODY=x,y,z").under_if(is(&[Add]), GROUP_OF_ONE_VERB).rare_if(is(&[Transfer])),
            "Factors of a body (or one, BODY=f); may be repeated",
            Add => "Factors of a body against the reference's (or one, BODY=f); may be repeated";
        RadiusAxis = choice(RadiusAxisChoice::WORDS).rare(), "How the radius of a sphere follows from the three factors of its body [default: geomean, where radii follow]";
        MovedSpheres = choice(MovedChoice::WORDS).rare(), "Spheres that were moved or resized already: keep them, or place them again";
        Strict = flag().under_if(is(&[Convert]), GROUP_OF_ONE_VERB).rare(), "Refuse where spheres of one force follow bodies with different factors",
            Convert => "Refuse where sphere and half-space have parameters of their own that differ";
        Rule = choice(RuleChoice::WORDS).rare(), "The paper's scaling, or PredSim's (stiffness by mass/height^2, dissipation by 1/height)";
        HeightRatio = value("RATIO").rare(), "Height of this model over that of the reference [default: mean of the body factors]";
    }
    WANTED_GROUP => {
        Indentation = value("X").under_if(is(&[Add]), NUMBERS_GROUP), "Relative indentation x/R under the load, 0 to 1 (11)";
        DimensionlessStiffness = value("K"), "Dimensionless stiffness k R n/F under the load, 1.5 or more: x/R is 3/(2 K) (B.3)";
        Stress = value("N/M2"), "Mean stress on the contact patch under the load, N/m2: x/R is F/(n pi R^2 stress) (15)";
        Young = value("E").under_if(is(&[Add]), NUMBERS_GROUP).rare(), "Young's modulus, N/m2 (A.1, A.5)";
        Poisson = value("NU").signed().under_if(is(&[Add]), NUMBERS_GROUP).rare(), "Poisson's ratio";
        OtherYoung = value("E").rare(), "With `young`: Young's modulus of the other surface, N/m2 [default: rigid]";
        OtherPoisson = value("NU").signed().rare(), "Poisson's ratio of the other surface";
        Restitution = value("CR").under_if(is(&[Add]), NUMBERS_GROUP), "Coefficient of restitution, 0 to 1 (13)";
        ImpactSpeed = value("M/S").under_if(is(&[Add]), NUMBERS_GROUP).under_if(is(&[Inspect, Check]), FIGURES_GROUP).rare_if(!is(&[Design, Sweep])),
            "Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]",
            Inspect | Check => "Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]";
        ConstantIndentation = value("X").under_if(is(&[Add]), NUMBERS_GROUP).rare_if(!is(&[Design])),
            "Constant indentation over radius, for constant_contact_force (C.2)";
        StateWidth = value("X").under_if(is(&[Add]), NUMBERS_GROUP).rare(),
            "Width of the contact transition over radius, for hertz_smoothing (C.8)";
        SpeedWidth = value("M/S").under_if(is(&[Add]), NUMBERS_GROUP).rare(),
            "Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)";
        StateSmoothing = value("B").rare(), "Hertz smoothing times radius, without unit, for hertz_smoothing (C.5)";
        SpeedSmoothing = value("B").rare(),
            "Hunt-Crossley smoothing times the root of the radius, s/m^(1/2), for hunt_crossley_smoothing (C.10)";
        Threshold = value("T").under_if(is(&[Add]), NUMBERS_GROUP).rare(), "Threshold t that the widths refer to: from t to 1 - t";
        ContactStiffness = value("N/M").rare(), "Stiffness of one sphere at that load, N/m (11 with B.2)";
        Stiffness = value(if is(&[Plot]) { "GRID" } else { "E1" }).under_if(is(&[DropTest]), CONTACT_GROUP).under_if(is(&[Plot]), SWEEP_GROUP)
            .refused_if(is(&[Sweep])),
            "OpenSim's stiffness (plane strain modulus of one surface), N/m2",
            Plot => "Values of stiffness: FROM..TO/COUNT in N/m2, or factors like x0.1..x10/25";
    }
    NUMBERS_GROUP => {
        StaticFriction = value("MU").signed(), "Static friction of the new forces [default: the reference's, else OpenSim's]";
        DynamicFriction = value("MU").signed(), "Their dynamic friction [default: the reference's, else OpenSim's]";
        ViscousFriction = value("S_PER_M").rare(), "Their viscous friction, s/m [default: the reference's, else OpenSim's]";
        TransitionVelocity = value("M/S").rare(), "Their transition velocity, m/s [default: the reference's, else OpenSim's]";
    }
    LOAD_GROUP => {
        Load = value("N").rare_if(!is(&[Design])), "Total load on all spheres, N";
        BodyWeights = value("B").rare_if(!is(&[Design])), "The load in body weights [default: 1 where a mass is known]";
        Gravity = value("G").under_if(is(&[Inspect, Check]), FIGURES_GROUP).under_if(is(&[DropTest]), CONTACT_GROUP).under_if(is(&[Plot]), GROUP_OF_ONE_VERB)
            .rare_if(!is(&[Design, DropTest])),
            "Gravity, m/s2 [default: the model's, else 9.80665]",
            Inspect | Check => "Gravity, m/s2 [default: the model's own]",
            Plot => "Gravity, m/s2 [default: the model's]";
    }
    CONTACT_GROUP => {
        Dissipation = value(if is(&[Plot]) { "GRID" } else { "A" }).under_if(is(&[Plot]), SWEEP_GROUP), "OpenSim's dissipation, s/m",
            Plot => "Values of dissipation: FROM..TO/COUNT in s/m, or factors";
    }
    SWEEP_GROUP => {
        Quantity = choice(QuantityChoice::WORDS), "What the colours show";
        Table = read("FILE"), "Draw a column of this table (CSV) instead, such as a sweep's with your results in it";
        ValueColumn = value("NAME"), "The table's column that is drawn";
        XColumn = value("NAME").rare(), "The table's column along the horizontal axis [default: the first grid_ column]";
        YColumn = value("NAME").rare(), "The table's column along the vertical axis [default: the second grid_ column]";
        ValueRange = value("RANGE").signed().rare(), "From which value to which colours change: FROM..TO";
    }
    FIGURE_GROUP => {
        Title = value("TEXT"), "Title of the figure; \"\" for none";
        Label = values("NAME"), "Name of a curve, in the order of the legend; once for each";
        Width = value("MM"), "Width on paper, mm [default: 90, one column of a journal; 190 for several panels side by side]";
        FontSize = value("PT"), "Size of the letters on paper, points; everything else grows with them";
        XRange = value("RANGE").signed(), "Limits of the horizontal axis, in its unit: FROM..TO";
        YRange = value("RANGE").signed(), "Limits of the vertical axis, in its unit: FROM..TO";
        Dpi = value("N").rare(), "Pixels to the inch of a PNG";
    }
    RECORDING_GROUP => {
        Fit = choice(FittedChoice::WORDS).list_if(true).called("WHAT"), "What to fit; may be repeated [default: stiffness, dissipation \
                                                                and height]";
        Unbounded = flag(), "Let spheres go deeper than their radius";
        HeightIn = choice(HeightChoice::WORDS).called("WHAT"), "What a fitted height moves";
    }
    COLUMNS_GROUP => {
        IndentationColumn = value("NAME"), "Column of the indentation";
        ForceColumn = value("NAME"), "Column of the force";
        SpeedColumn = value("NAME").rare(), "Column of the speed of indentation; without it and without a time, dissipation is not fitted";
        TimeColumn = value("NAME").rare(), "Column of the time, from which the speed is taken";
        IndentationUnit = choice(LengthUnit::WORDS), "Unit of the indentation";
        ForceUnit = choice(ForceUnit::WORDS), "Unit of the force";
        SpeedUnit = choice(SpeedUnit::WORDS).rare(), "Unit of the speed";
        TimeUnit = choice(TimeUnit::WORDS).rare(), "Unit of the time";
    }
    })
}
