"""Names of options. Written by dev/generate_python.py from the schemas of requests: do not edit."""

from __future__ import annotations

from typing import Literal

#: OpenSim's properties that verbs change.
Property = Literal[
    "stiffness", "dissipation", "static_friction", "dynamic_friction", "viscous_friction", "transition_velocity",
    "constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing", "radius",
]

#: Codes of questions, which `yes` answers.
Question = Literal[
    "implausible-mass", "mass-in-pounds", "against-note", "implausible-radius", "implausible-place",
    "implausible-scale", "tilted-foot", "unequal-feet", "wrong-afterwards", "many-models", "poor-fit",
]

#: Verbs that change any number of models.
ChangingVerb = Literal[
    "rescale", "transfer", "add", "remove", "convert", "design", "set", "note",
]

#: Options that a row of a table has as columns.
ROW_OPTIONS = frozenset({
    "angles", "belt", "belt_column", "body_map", "body_scale", "body_scale_file", "body_weights", "branch", "class",
    "constant_contact_force", "constant_indentation", "contact_stiffness", "contacts", "contacts_gravity",
    "contacts_mass", "count", "default_pose", "dimensionless_stiffness", "dissipation_by", "dynamic_friction", "end",
    "exclude", "exclude_body", "feet", "fit", "follow_bodies", "force", "force_column", "force_unit", "friction",
    "from", "geometry", "geometry_dir", "geometry_output", "gravity", "height_in", "height_ratio", "hertz_smoothing",
    "hunt_crossley_smoothing", "impact_speed", "in_place", "indentation", "indentation_column", "indentation_unit",
    "keep", "level", "level_axis", "load", "loads", "low_pass", "mass", "mirror", "model", "motion", "moved_spheres",
    "no_backup", "no_note", "only", "onset", "other_poisson", "other_young", "output", "output_dir", "pad", "plates",
    "plates_delay", "poisson", "presets", "radius", "radius_axis", "reference_gravity", "reference_mass",
    "reference_select", "reference_sphere", "reference_spheres", "replace", "restitution", "rule", "select", "set",
    "skip_disabled", "sockets", "speed_column", "speed_smoothing", "speed_unit", "speed_width", "spheres",
    "stance_limbs", "start", "state_smoothing", "state_width", "static_friction", "stiffness", "stress", "strict",
    "target_gravity", "target_mass", "threshold", "time_column", "time_unit", "to", "transition_velocity",
    "unbounded", "verb", "viscous_friction", "yes", "young",
})

#: Options of a whole run, which no row can have.
RUN_OPTIONS = frozenset({
    "deny", "diff", "dry_run", "format", "jobs", "quiet", "report", "resume", "shard", "summary",
})

#: Options that name files or folders.
PATHS = frozenset({
    "body_scale_file", "compare", "contacts", "correct", "data", "file", "from", "from_moco_setup", "geometry",
    "geometry_dir", "geometry_output", "loads", "manifest", "moco", "moco_setup", "model", "models", "motion", "nmsm",
    "output", "output_dir", "plates", "presets", "report", "subject", "summary", "table",
})
