//! Common misunderstandings about each quantity, and the symbols of the quantity.

/// A common misunderstanding about a quantity, with the quantity's name in JSON or in OpenSim, and its other names.
pub(super) struct Trap {
    pub(super) name: &'static str,
    /// Symbols and words for the quantity, as in the paper and in tables.
    pub(super) symbols: &'static [&'static str],
    pub(super) trap: &'static str,
}

/// Misunderstandings, each with the quantity's name and its symbols.
macro_rules! traps {
    ($($name:literal [$($symbol:literal),*] $trap:literal;)+) => {
        &[$(Trap { name: $name, symbols: &[$($symbol),*], trap: $trap }),+]
    };
}

/// All misunderstandings. Names of inputs and calls are in backquotes.
pub(super) const ALL: &[Trap] = traps! {
    "stiffness" ["E1*", "E₁*", "E1", "plane_strain_modulus"]
        "it is a modulus in N/m2: neither a stiffness in N/m nor Young's modulus. E₁* is E/(1 − ν²) (A.1), and the contact of two equal surfaces has the modulus E₁*/2^(3/2) (A.4). Equal numbers are equal contacts only at equal mass, radius and number of spheres";
    "dissipation" ["alpha", "α"]
        "it is not a damping coefficient in N s/m, and it does not scale with mass: it follows R^(−1/2) (14). Above about 0.2 over the impact speed the restitution by (13) is no longer right";
    "static_friction" ["mu_s", "us"]
        "it has no unit and stays as it is at every size; the force reaches it only near the slip speed of transition_velocity, not at rest";
    "dynamic_friction" ["mu_d", "ud"] "it has no unit and stays as it is at every size";
    "viscous_friction" ["mu_v", "uv"]
        "it multiplies a speed, so it depends on size; it is scaled only with `friction`";
    "transition_velocity" ["vt"]
        "it is a speed, so it depends on size, and below it a foot creeps instead of standing; it is scaled only with `friction`";
    "constant_contact_force" ["cf"]
        "it is a squared indentation in m2, not a force, though OpenSim's documentation says N: it scales with R² (C.2). With 0 OpenSim computes NaN for every sphere that does not slip";
    "hertz_smoothing" ["bd"]
        "it is in 1/m, so the same number is soft for a small sphere and hard for a large one: it scales with 1/R (C.5). Without the element OpenSim takes 300, which is made for a radius of about 0.03 m";
    "hunt_crossley_smoothing" ["bv"]
        "it is in s/m and scales with R^(−1/2) (C.10). Together with a large dissipation it takes force away at rest too: (C.9) has 2/(3α) in it";
    "radius" ["R"]
        "it is in m, and as an input may be a factor: 30 is 30 m, x1.5 is one and a half times as large. If it changes, the stiffness for the same relative indentation changes with 1/R², and the lowest point of the sphere moves, unless `level` keeps it";
    "mass" ["M"]
        "it is in kg, and the mass that contacts are made for need not be what the bodies of the file weigh: see `contacts_mass`";
    "radius_m" [] "spheres of one force may have several radii: what they share follows the mean of R²";
    "composite_modulus_n_m2" ["E*", "composite_modulus"]
        "it is never in the file: OpenSim's stiffness is 2^(3/2) times as large where both surfaces are alike (A.4)";
    "first_modulus_n_m2" [] "it goes into the ContactParameters of the first surface as it is, without 2^(3/2)";
    "other_modulus_n_m2" [] "it goes into the ContactParameters of the other surface as it is, without 2^(3/2)";
    "composite_modulus_opensim_n_m2" []
        "it is smaller than Johnson's (A.2) for the same two materials, down to 0.71 of it where they are equal";
    "opensim_over_johnson" [] "it depends on the ratio of the two moduli alone: 0.71 for equal ones, near 1 for a hard floor";
    "dissipation_s_m" []
        "where two surfaces differ it is a mean weighted by their moduli (Simbody's rule), and in no place of the file";
    "load_n" ["W/n"]
        "it is one body weight shared by the spheres of the limbs that stand, n, not by all spheres of the model";
    "relative_indentation_hertz" ["x/R", "x_hat", "x̂"]
        "it is by the Hertz law, at one body weight. A smoothed force rests at a little less, see relative_indentation_model_law, and a step or a landing carries two body weights or more";
    "relative_indentation_model_law" []
        "below 0 the smoothing alone carries the load: the sphere floats above the ground";
    "relative_indentation_hertz_standing" []
        "it belongs to the default pose: in another pose the spheres have other heights. Below 0 a sphere does not touch";
    "relative_indentation_model_law_standing" []
        "it belongs to the default pose: in another pose the spheres have other heights. Below 0 the sphere is above the floor";
    "relative_indentation_hertz_level" []
        "it takes the limb's spheres as level: large spheres carry more than small ones";
    "relative_indentation_model_law_level" [] "as relative_indentation_hertz_level, by the law of the file";
    "relative_indentation_hertz_at_two" []
        "twice the load is 2^(2/3) = 1.59 times the indentation, not twice";
    "relative_indentation_model_law_at_two" [] "twice the load is not twice the indentation";
    "relative_indentation_hertz_level_at_two" []
        "twice the load is 2^(2/3) = 1.59 times the indentation, not twice";
    "relative_indentation_model_law_level_at_two" [] "twice the load is not twice the indentation";
    "contact_stiffness_n_m" ["k", "contact_stiffness"]
        "it is the slope of the force at that load: half the load has a smaller one. OpenSim's stiffness is something else, a modulus";
    "dimensionless_stiffness" ["k_hat", "k̂"]
        "by the Hertz law it says the same as the relative indentation: it is 3/(2 x/R). Two contacts of one value are alike at every size";
    "natural_frequency_hz" ["f_n"]
        "it is that of small motions about the rest, of the mass on one sphere; it does not include leaving the ground";
    "mean_contact_stress_n_m2" ["sigma", "σ"]
        "it is a mean over the flattened patch: the middle carries one and a half times as much";
    "restitution_exact" ["c_r"] "it is that of one impact at this speed: a harder impact has a smaller one";
    "restitution_approximate" []
        "(13) is good from about 0.8 upwards. It falls below the exact one and reaches 0 long before the contact stops bouncing";
    "constant_indentation" ["x_c"]
        "it is what makes constant_contact_force comparable between spheres. A sphere that does not touch carries force too, and more of it with a larger value";
    "transition_width" ["dx_hat"]
        "it is in radii, and half of it lies above the ground: the sphere carries force before it touches";
    "force_just_touching_n" [] "it is not 0 for a smoothed force: smoothing always gives some force before contact";
    "touching_share" [] "a share of a tenth is what the paper starts from; large shares let spheres float";
    "load_per_sphere_n" ["F/n"] "the load is that on all spheres together, and n counts those that share it";
    "relative_indentation" []
        "it is an input and a result: if you ask for 0.16, it is at the limit of the Hertz law";
    "indentation_m" ["x", "indentation"] "it cannot be compared between sizes: divide by the radius";
    "contact_patch_diameter_m" []
        "it is the diameter of the flattened patch, not that of the sphere's cut with the ground, which is 1.41 times as large for a small indentation";
    "equilibrium_frequency_hz" []
        "it is the natural frequency at rest under body weight by (B.5): other loads have others";
    "impact_speed_m_s" ["v"]
        "a fall from a height that grows with the body is faster for large ones: sqrt(gR/2) for a quarter of the radius";
    "restitution" []
        "it is what is wanted by (13); the law itself gives more, see restitution_exact_at_this_dissipation";
    "restitution_exact_at_this_dissipation" []
        "it is larger than the one asked for, because (13) is an approximation";
    "dissipation_for_exact_restitution_s_m" []
        "it is larger than the dissipation by (13), and is not what is written";
    "mass_kg" [] "it is what falls, which need not be what the contacts are made for";
    "sphere_count" ["n"]
        "it counts the spheres that share the weight, those of the limbs that stand, not all spheres of the model";
    "gravity_m_s2" ["g", "gravity"]
        "it is the size of the model's gravity; the paper's table is for 9.81, OpenSim's default is 9.80665";
    "height_m" ["h"] "it is the height of the spheres' lowest points above the ground, not that of the body";
    "duration_s" [] "a large body needs longer to come to rest: divide times by sqrt(R/g) to compare them";
    "reference_radius_m" []
        "with spheres of several radii it is sqrt(mean of R²), which none of them need have";
    "reference_time_s" [] "divide times by it before animals of different size are compared";
    "final_relative_indentation" []
        "it is that of the last moment: a body that still bounces is not at rest there";
    "peak_force_n" [] "it is the force of all spheres together";
    "peak_force_bw" []
        "it depends on the height of the fall, so it describes the fall and the contact, not the contact alone";
    "equilibrium_stiffness_n_m" []
        "it is by the law of the file, smoothing included; hertz_stiffness_n_m is the k of the paper";
    "hertz_stiffness_n_m" []
        "it is the k of the paper's table, by the Hertz law even where the file's law is smoothed";
    "contact_time_s" [] "it is absent where the body does not leave the ground again, which is not 0";
    "rebound_speed_m_s" []
        "divided by the impact speed it is less than the restitution, because gravity acts during the contact";
    "time_s" ["t"] "samples are equally far apart, the steps of the integrator are not";
    "speed_m_s" [] "upwards is positive: an impact begins with a negative one";
    "force_n" ["F"]
        "it is the force of all spheres together, and above 0 before the ground is reached where it is smoothed";
    "force_bw" [] "the body weight is that of the falling body, not of the body that its contacts are made for";
    "dimensionless_time" []
        "it is the time divided by sqrt(R/g), so curves of similar contacts coincide in it and not in seconds";
};
