//! A register of all error codes: the meaning of each, and what the user can do.
//!
//! The tables of `docs/reference/errors.md` are made from it; a test looks for codes that are not here.

use osim_model::messages::Phrase;

/// An error by its code: what it means, and what the user can do.
#[derive(Debug, PartialEq, Eq)]
pub struct ErrorCode {
    /// Code of the error, as JSON has it in `error.code`.
    pub code: &'static str,
    means: &'static str,
    way_out: &'static str,
}

impl ErrorCode {
    pub fn means(&self) -> Phrase {
        Phrase::template(self.means)
    }

    /// A sentence about what the user can do about the error.
    pub fn way_out(&self) -> Phrase {
        Phrase::template(self.way_out)
    }
}

/// The kinds of errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorGroup {
    /// Errors of a file, before anything in it is read.
    File,
    /// Errors in the content of a model.
    Model,
    /// A question that only the user can answer.
    Question,
    /// Errors in a request.
    Request,
}

impl ErrorGroup {
    /// Every group, in the order of the documents.
    pub const ALL: [Self; 4] = [Self::File, Self::Model, Self::Question, Self::Request];

    /// Codes of the errors in this group.
    pub const fn errors(self) -> &'static [ErrorCode] {
        match self {
            Self::File => FILE_ERRORS,
            Self::Model => MODEL_ERRORS,
            Self::Question => QUESTION_ERRORS,
            Self::Request => REQUEST_ERRORS,
        }
    }
}

/// All errors, in the order of the groups.
pub fn errors() -> impl Iterator<Item = &'static ErrorCode> {
    ErrorGroup::ALL.iter().flat_map(|group| group.errors())
}

/// The error whose code is `code`.
pub fn error(code: &str) -> Option<&'static ErrorCode> {
    errors().find(|error| error.code == code)
}

/// Codes, each with its meaning and the way out. Inputs and calls are in backticks.
macro_rules! codes {
    ($($code:literal: $means:literal, $way_out:literal;)+) => {
        &[$(ErrorCode { code: $code, means: $means, way_out: $way_out }),+]
    };
}

/// Errors about files that cannot be read or written.
const FILE_ERRORS: &[ErrorCode] = codes! {
    "unreadable": "the file, or one that belongs to it, is not there or cannot be read; a link leads nowhere or back; another program is writing it; a pipe, a device or a folder is in the place of a file; it is larger than 2 GiB",
        "check name, folder and permissions. Dragging the file onto the terminal types its path for you";
    "no-models": "the folder holds no .osim file", "name a model, or the folder that holds them";
    "not-xml": "this is not XML: an empty file, a ZIP archive, a motion, a table, a binary file",
        "get the model again from where it came";
    "encoding": "the file is UTF-16, or starts with two byte order marks; OpenSim cannot read it",
        "save it as UTF-8. Windows PowerShell makes UTF-16 when you use >; use `output=FILE`";
    "mesh-missing": "a body shows a mesh that is in none of the folders: the model's own, its Geometry, and that of `geometry_dir`",
        "copy the file there, or name the folder with `geometry_dir=DIR`";
    "bad-mesh": "a mesh that cannot be read, or has fewer than four points or all in a line",
        "get the file again from where it came, or leave its body out of `feet`";
    "doctype": "a DOCTYPE with a part in [...], which OpenSim cannot read", "delete the DOCTYPE";
    "malformed-xml": "the XML is broken: a tag left open, crossed tags, two documents in one file",
        "if it looks truncated, copy the file again; else open it at the line given";
    "not-opensim": "XML, but no OpenSim document: another outermost element, no Version, or neither a Model nor a set inside",
        "check that this is the model, not a settings file or a saved web page";
    "incomplete-set": "a ForceSet without its geometry, or a ContactGeometrySet alone",
        "name the force set and give `geometry=FILE`; see docs/scaling.md";
};

/// Errors about the content of a model.
const MODEL_ERRORS: &[ErrorCode] = codes! {
    "not-a-number": "a number that OpenSim reads as another one: 1,5e6 is 1 for OpenSim, abc is its default",
        "write the number plainly, like 1.5e6";
    "broken-text": "a comment or an element is in the middle of a text that OpenSim must read, such as a list of geometry",
        "remove it";
    "out-of-domain": "a number for which the equations do not hold: a radius or stiffness that is 0, negative or not finite, a negative dissipation; or a constant_contact_force that would become 0, with which OpenSim computes NaN without slip",
        "correct it in the model, or ask for another value. A radius of 0 often means that the element is missing";
    "no-mass": "a body has no mass, or all bodies together weigh nothing",
        "give the body a <mass>, or use `mass=KG` or `contacts_mass=KG`";
    "no-contacts": "no HuntCrossleyForce or SmoothSphereHalfSpaceForce in which a moving sphere can touch a half-space. A folder's models without contacts are skipped instead",
        "give it contacts with `add MODEL from=OTHER`; see docs/add.md. If OpenSim shows contacts, `check MODEL` says why they are not found";
    "unresolved": "a force names a sphere, or a sphere a body, that is not in the file",
        "correct the path; OpenSim could not connect it either";
};

/// Errors that ask for a fact or for an answer.
const QUESTION_ERRORS: &[ErrorCode] = codes! {
    "no-mesh": "a body of `feet` shows no mesh, so nothing says where its sole is",
        "name another body, or give the places in a table: `contacts=TABLE`";
    "unknown-pose": "where a body is at the default pose follows from a joint, a function or a constraint that is not understood",
        "give the places in the frames of the bodies: `contacts=TABLE` with columns x, y and z";
    "included-file": "the number to change is in another file, which the model names with file=\"...\"",
        "open the model in OpenSim, save it as one file, change that";
    "parameters-in-defaults": "a force has no ContactParameters of its own; those in <defaults> may serve other forces, too",
        "write a contact_parameters set into the force";
    "implausible-mass": "a mass is about 1000 times what the bodies of the model weigh together, or the 1000th part of it (within 15 %), or outside 1 mg to 200 t; or, in a table, 10 or 1000 times above or below the masses of all other rows: it may be in g or tonnes, or have a digit too many or too few",
        "write it in kg; if it is correct, confirm it with `yes=implausible-mass`";
    "mass-in-pounds": "a mass is 2.2 times what the bodies of the model weigh together, or 1/2.2 of it (within 1 %); or, in a table of at least four rows, about 2.2 times above or below the masses of all other rows: one of them may be in lb",
        "write it in kg; if it is correct, confirm it with `yes=mass-in-pounds`";
    "against-note": "one `contacts_mass` was given for several models, and the note of this one says another mass: the others are done",
        "do this model in a call of its own, or give each model its mass in a table (`batch`); if it is correct, confirm it with `yes=against-note`";
    "implausible-radius": "a sphere would get a radius above the longest distance between two joints of its body, or of a body next to it, or, in `design` and `fit` without a model, of 1 m or more, or the indentation goes to more than twice the radius: lengths may be in mm or cm",
        "write them in m, or say the unit; if they are correct, confirm them with `yes=implausible-radius`";
    "implausible-place": "a place of a table is farther from the joints of its body than 3 times the longest distance between two joints of that body, or of one next to it; or the sole is farther below the bones than the foot is long: they may be in mm or cm",
        "write places, and `pad`, in m; if they are correct, confirm them with `yes=implausible-place`";
    "implausible-scale": "a body would be more than 50 times as large as the reference's, or less than 1/50: between a mouse and a giraffe it is 38 times; the factor may be in percent",
        "write 0.95 for 95 %; if it is correct, confirm it with `yes=implausible-scale`";
    "tilted-foot": "a foot is tilted by more than 10 degrees at the default pose, or bones near the ground cover less than 80 % of its length or width there: spheres would be under its heel or one edge only",
        "give the coordinates that the message names default values at which the foot lies flat, or the places in a table, `contacts=TABLE`; if this is intended, confirm it with `yes=tilted-foot`";
    "unequal-feet": "left and right foot are not posed as mirror images at the default pose (by more than 1 degree): spheres under their bones would differ from side to side",
        "give the coordinates of both legs the same default values, or the places in a table, `contacts=TABLE`; if this is intended, confirm it with `yes=unequal-feet`";
    "wrong-afterwards": "the model that would be written has an error that it does not have now, or a stiffness was given that is below 1 kN/m2 and at most a thousandth of the present one: it may be a factor, or in MPa",
        "do what the message says; if this is intended, confirm it with `yes=wrong-afterwards`";
    "many-models": "a sweep would make more than 10,000 models", "give fewer values, or `yes=many-models`";
    "poor-fit": "the fitted model has more than half of the error of a model that never touches, or a larger error than the model as it is",
        "correct the motion instead (`motion MODEL correct=FILE`); if this is intended, confirm it with `yes=poor-fit`";
    "same-operation": "the note says that this very factor was applied already (set … `in_place`, `radius=xFACTOR` `in_place`), or that spheres follow their bodies already (`body_scale_file`)",
        "apply it once more with `force`, or leave out `body_scale_file`";
    "body-scale": "how a body was scaled is not in the files, or meshes, or left and right, contradict each other (`transfer follow_bodies`); or `body_scale_file` belongs to another generic model than `from`",
        "`body_scale=BODY=x,y,z` (or one factor, `body_scale=BODY=f`), or `body_scale_file=FILE`; see docs/scaling.md";
    "contacts-exist": "a model that is to get contacts has some already",
        "make them right with `rescale` or `transfer`, or take them out first with `replace`";
    "missing-body": "a body that carries spheres in the reference is not in the model, such as toes in a foot of one piece",
        "`body_map=toes_r=calcn_r` names the body that takes its spheres, once for each";
    "moved-spheres": "spheres were moved or resized already (`transfer follow_bodies`)",
        "keep them there with `moved_spheres=keep`, or place them again with `moved_spheres=replace`; see docs/scaling.md";
    "stale-note": "this program left a note in the file, which says the mass that the contacts are made for, and the note no longer fits: contacts were changed since, only some were scaled, the note is damaged, or force set and geometry set come from different runs",
        "give that mass with `contacts_mass=KG`, and that gravity with `contacts_gravity=G`; see docs/scaling.md";
    "several-trees": "contact spheres are on bodies that are joined only through ground (player and ball): which of them have to be changed?",
        "`select=GLOB`";
    "shared-sphere": "a sphere should change its radius, but another force that is not rescaled uses it too",
        "choose all of its forces with `select`, or keep radii: `radius=keep`, with `follow_bodies` `keep=radius`";
    "sphere-count": "how many spheres share the body weight? Limbs have different counts, or left and right cannot be determined",
        "`spheres=N`; for the reference `reference_spheres=N`. Nothing is asked where spheres are matched one to one (`follow_bodies`)";
    "which-reference": "the contacts of the reference differ, and it has no spheres with the names of yours",
        "`reference_sphere=NAME`";
};

/// Errors about the request itself.
const REQUEST_ERRORS: &[ErrorCode] = codes! {
    "refused": "the request makes no sense for this model; the message says why (for example, no force is left by `select`)",
        "as the message says";
    "out-of-range": "a quantity that follows from the request is outside the domain of the equations",
        "check the masses and radii you gave";
    "drop-test": "the fall cannot be computed: a contact is so stiff or so dissipative that the integration fails",
        "a shorter `duration`, or check the numbers with inspect";
    "motion": "the motion, the plates or the ExternalLoads: the message says what is missing, with the line in the file",
        "as the message says; see docs/motion.md";
    "plot": "the figure cannot be drawn: the message says what of the model it lacks, or that there are too many curves",
        "as the message says; see docs/plots.md";
    "fit": "the CSV file, or what is in it: the message names line and column, or what the data do not determine",
        "see docs/fit.md";
    "output": "the result cannot be written: the file exists already, it is the input itself, the folder cannot be written to, the disk is full",
        "another name with `output` or `output_dir`, or `force`; for the input itself `in_place`. After a full disk make room and continue with `resume` (docs/libraries.md)";
    "table": "a table of contacts: a column or a cell is wrong, a name is refused by OpenSim, or a place is given in ground only or twice and differently; the message names the line",
        "correct what is named; `default_pose` takes places in ground as those of the default pose";
    "no-such-body": "the model has no body of a name that `feet` or a table says",
        "one of the names in the message";
    "too-many-spheres": "so many spheres under one foot would be closer than 1 mm", "fewer with `count=N`";
    "manifest": "a row of a table is wrong: the message names row and column. No model was changed",
        "correct the cells that are named, and run again; see docs/libraries.md";
    "internal": "a defect of this program; nothing was changed",
        "please report it, with the model if you may";
};
