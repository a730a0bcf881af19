// The layout of forms: fields that the page leaves out, fields that come first, and groups of the others.

/** Groups of fields that no form has, by their names in the schemas, with the reason. */
export const GROUPS_LEFT_OUT = {
  output: "the page downloads results", many: "the page asks for one model at a time", shown: "the page shows results itself",
};

/** Single fields that no form has, with the reason. */
export const LEFT_OUT = {
  models: "it is the model that is open", geometry_dir: "meshes are among the files that are open",
  dry_run: "nothing is written before it is downloaded", report: "the page has a button for it",
};

/** Fields of the calculator's form that are about a model: the calculator has none. */
export const ONLY_WITH_MODEL = [
  "contacts_mass", "exclude_body", "select", "exclude", "skip_disabled", "no_note", "yes", "geometry", "model",
];

/** The verbs of the page in their order, each with a few words and the fields that come first. */
export const VERBS = {
  rescale: {
    title: "Rescale", about: "Make the contacts right for another body mass.",
    usual: ["target_mass"],
  },
  transfer: {
    title: "Transfer", about: "Take over the contacts of another model, or of a preset, at this model’s size.",
    usual: ["from", "radius", "follow_bodies", "body_scale_file", "only", "select"],
  },
  add: {
    title: "Add", about: "Give contacts to a model that has none at its feet.",
    usual: ["from", "contacts", "feet", "count", "pad", "radius", "class", "replace"],
  },
  convert: {
    title: "Convert", about: "Change the class of the forces, so that they act alike.",
    usual: ["to", "select"],
  },
  remove: {
    title: "Remove", about: "Take the foot contacts out of the model.",
    usual: ["select", "exclude"],
  },
  set: {
    title: "Set", about: "Write numbers of your own, or multiply by a factor.",
    usual: ["set", "level", "select"],
  },
  design: {
    title: "Design", about: "Find parameters from what you want: indentation, stiffness, restitution.",
    usual: ["radius", "indentation", "contact_stiffness", "restitution", "impact_speed", "stiffness", "body_weights", "spheres"],
  },
};

/** Fields of the calculator that come first. */
export const CALCULATOR = [
  "radius", "indentation", "contact_stiffness", "restitution", "impact_speed", "stiffness", "mass", "load", "spheres",
];

/** Groups of the other fields, in their order. A field that none of them names is at the end of the last. */
export const GROUPS = {
  "Masses and gravity": [
    "contacts_mass", "mass", "exclude_body", "reference_mass", "contacts_gravity", "target_gravity", "gravity", "reference_gravity",
  ],
  "Which contacts": ["only", "keep", "select", "exclude", "skip_disabled", "reference_select", "reference_sphere"],
  "Spheres and their places": [
    "radius", "level", "level_axis", "spheres", "stance_limbs", "reference_spheres", "count", "pad", "default_pose", "mirror",
    "body_map", "moved_spheres", "replace",
  ],
  "Sizes of bodies": ["follow_bodies", "body_scale_file", "body_scale", "radius_axis", "height_ratio", "rule"],
  "Load and behaviour": [
    "indentation", "contact_stiffness", "stiffness", "young", "poisson", "restitution", "impact_speed", "load", "body_weights",
    "dissipation_by", "friction",
  ],
  "Smoothing": [
    "constant_indentation", "state_width", "speed_width", "threshold", "constant_contact_force", "hertz_smoothing",
    "hunt_crossley_smoothing",
  ],
  "Friction": ["static_friction", "dynamic_friction", "viscous_friction", "transition_velocity"],
  "Files": ["geometry", "model", "presets"],
  "Other": ["class", "sockets", "strict", "no_note", "yes"],
};

/** The sources of the options of lists, texts and files. */
export const SOURCES = {
  only: "properties", keep: "properties", select: "forces", exclude: "forces", exclude_body: "bodies", feet: "bodies",
  from: "references", presets: "presets", body_scale_file: "scales", contacts: "tables", geometry: "geometries", model: "models",
};

/** The default of lists in which nothing is ticked; all others have none. */
export const ALL_UNLESS_TICKED = ["only", "select"];

/** Labels of choices. */
export const CHOICE_TEXTS = {
  smooth: "SmoothSphereHalfSpaceForce", "hunt-crossley": "HuntCrossleyForce",
  isometric: "isometric (R ~ M^1/3)", keep: "keep as it is", follow: "follow the bodies",
  geomean: "geometric mean", min: "smallest", max: "largest", paper: "the paper’s", predsim: "PredSim’s", replace: "place again",
};

/** Words of descriptions for the command line, with their replacements for the page. */
export const WORDS = [
  ["; may be repeated", ""], [", separated by commas", ""], [" (or one, BODY=f)", ": BODY=x,y,z or BODY=f"],
  ["the one that takes its spheres here", "the one that takes its spheres here: toes_r=calcn_r"],
  ["(with models also keep or a factor like x1.5)", ""], ["OpenSim's names, and radius", "by OpenSim’s names, and the radius"],
  ["Only its forces", "Only the reference’s forces"], ["forces with such a name", "forces with these names"],
  ["Confirm what looks like a mistake: the code of the error that asks", "Codes of the errors that you have read and that are no mistakes"],
  ["Take places that the table has in ground only as those", "Places that the table has in ground only are those"],
  ["Mass the contacts are made for now", "Mass that the contacts are right for now"],
  ["The load in body weights", "Load under which the spheres sink so far, in body weights"],
  [": if given, contacts are scaled from it to `target_gravity`", "; with it, contacts are scaled to `target_gravity`"],
];
