//! What is shown of a sphere, line by line: the table and the page share them.

use osim_inspect::{Figure, LoadFigures, SphereFigures};

/// One line of the sheet.
pub(crate) struct Row {
    pub name: &'static str,
    pub figure: Option<Figure>,
    pub value: fn(&SphereFigures) -> Option<f64>,
    pub when: When,
}

/// Where a line says something of its own.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum When {
    Always,
    /// The law of the file is not Hertz's.
    Smooth,
    /// Spheres of a limb differ.
    Mixed,
    MixedSmooth,
}

type Value = fn(&SphereFigures) -> Option<f64>;

const fn row(name: &'static str, value: Value) -> Row {
    Row { name, figure: None, value, when: When::Always }
}

const fn limited(name: &'static str, figure: Figure, value: Value) -> Row {
    Row { name, figure: Some(figure), value, when: When::Always }
}

const fn only(when: When, name: &'static str, figure: Figure, value: Value) -> Row {
    Row { name, figure: Some(figure), value, when }
}

fn at(sphere: &SphereFigures, body_weights: f64, of: fn(&LoadFigures) -> Option<f64>) -> Option<f64> {
    sphere.load(body_weights).and_then(of)
}

/// The row that says at which speed where that is known.
pub(crate) const RESTITUTION: &str = "restitution, exact";

/// All lines, in their order.
pub(crate) const ROWS: [Row; 20] = [
    row("radius, m", |s| Some(s.radius_m)),
    row("load at 1 BW, N", |s| at(s, 1.0, |load| Some(load.load_n))),
    limited("x/R at 1 BW, Hertz (11)", Figure::Hertz, |s| at(s, 1.0, |load| load.hertz)),
    only(When::Smooth, "  by the file's law (C.3)", Figure::Own, |s| at(s, 1.0, |load| load.own)),
    only(When::Mixed, "  level, Hertz", Figure::LevelHertz, |s| at(s, 1.0, |load| load.level_hertz)),
    only(When::MixedSmooth, "  level, the file's law", Figure::LevelOwn, |s| {
        at(s, 1.0, |load| load.level_own)
    }),
    limited("x/R at 2 BW, Hertz", Figure::HertzAtTwo, |s| at(s, 2.0, |load| load.hertz)),
    only(When::Smooth, "  by the file's law", Figure::OwnAtTwo, |s| at(s, 2.0, |load| load.own)),
    only(When::Mixed, "  level, Hertz", Figure::LevelHertzAtTwo, |s| at(s, 2.0, |load| load.level_hertz)),
    only(When::MixedSmooth, "  level, the file's law", Figure::LevelOwnAtTwo, |s| {
        at(s, 2.0, |load| load.level_own)
    }),
    row("stiffness k, N/m (B.2)", |s| s.contact_stiffness_n_m),
    row("k R n/F (B.3)", |s| s.dimensionless_stiffness),
    row("frequency f_n, Hz (B.4)", |s| s.natural_frequency_hz),
    row("mean stress, N/m2 (15)", |s| s.mean_contact_stress_n_m2),
    row(RESTITUTION, |s| s.restitution_exact),
    limited("  by (13)", Figure::Restitution, |s| s.restitution_approximate),
    limited("sqrt(cf)/R (C.2)", Figure::ConstantIndentation, |s| s.constant_indentation),
    limited("transition, in R (C.7)", Figure::TransitionWidth, |s| s.transition_width),
    row("force at touch, N (C.3)", |s| s.force_just_touching_n),
    limited("  over the load at 1 BW", Figure::TouchingShare, |s| s.touching_share),
];
