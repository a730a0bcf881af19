//! The figures of the paper, from its Table 1.

use anyhow::Result;
use contact_plots::{
    DropCurve, Figure, ForceAxis, ForceFigure, IndentationAxis, Panel, StateFigure, TimeAxis, Width,
    drop_panel, force_panel, state_panel,
};
use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::{Contact, ContactValues, Ratios, Scale, ScaleValues, SmoothingValues, falisse2022};

use super::body::{Body, Kind};
use super::series::{self, Axes};
use crate::failure::Failure;

/// Where the numbers come from.
pub(super) const SOURCE: &str = "Table 1";

/// Gravity of Table 1, m/s².
const GRAVITY: f64 = 9.81;
/// Height of the drop, in radii, and its duration for the time axis, in s.
const HEIGHT_RADII: f64 = 0.25;
const DURATION_S: f64 = 1.1;
/// Where the time axis ends, in s: both animals are at rest.
const SHOWN_S: f64 = 0.5;
/// Points for each √(R/g): as many for the mouse as for the giraffe in their own time.
const SAMPLES_PER_UNIT: f64 = 40.0;

/// Where the force axes end, in body weights.
const TOP: f64 = 3.0;

/// Whose sphere Fig. C.5 is taken to show.
const EMU: &str = "emu";

/// An animal of Table 1: M in kg, n, R in m.
fn animal(mass_kg: f64, sphere_count: f64, radius_m: f64) -> Result<Scale> {
    Ok(Scale::new(ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2: GRAVITY })?)
}

/// The contact of the 62 kg human, scaled to an animal.
fn scaled(to: &Scale) -> Result<Contact> {
    let human = falisse2022();
    let from = Scale::new(ScaleValues { gravity_m_s2: GRAVITY, ..human.scale.values() })?;
    Ok(human.contact.scaled(&Ratios::between(&from, to)?))
}

/// Fig. 4: drops of the mouse and the giraffe, with α = 2 s/m for both and with α scaled by (14).
///
/// # Errors
/// None with the numbers of Table 1.
pub(super) fn fig4(title: Option<&str>) -> Result<Figure> {
    let animals = [("mouse", animal(0.0209, 2.0, 0.002)?), ("giraffe", animal(1190.0, 8.0, 0.030)?)];
    let drops = |scale_dissipation: bool| -> Result<Vec<DropCurve>> {
        animals.iter().map(|(name, scale)| drop(name, scale, scale_dissipation)).collect()
    };
    let (before, after) = (drops(false)?, drops(true)?);
    let panel = |title: &str, bodies: &[DropCurve], time| -> Result<Panel> {
        let mut panel = Panel { title: title.to_owned(), ..drop_panel(bodies, time)? };
        if time == TimeAxis::Second {
            for curve in &mut panel.curves {
                curve.points.retain(|(time, _)| *time <= SHOWN_S);
            }
        }
        // One scale for all, so that the eye can compare them.
        panel.y.range = Some((0.0, TOP));
        Ok(panel)
    };
    let base = falisse2022().contact.dissipation();
    let same = format!("α = {} s/m for both", osim_patch::readable(base));
    Ok(Figure {
        title: title.unwrap_or("Effect of scaling the dissipation α (Fig. 4)").to_owned(),
        description: "Drop tests of a mouse and a giraffe from a quarter of the sphere radius: normal force over body \
                      weight against time (above) and against non-dimensional time (below). Left with the same \
                      dissipation, where the mouse goes on oscillating; right with the dissipation scaled by \
                      equation 14, where both curves are one in non-dimensional time."
            .to_owned(),
        width: Width::Page,
        columns: 2,
        panels: vec![
            panel(&same, &before, TimeAxis::Second)?,
            panel("α scaled by (14)", &after, TimeAxis::Second)?,
            panel(&same, &before, TimeAxis::Dimensionless)?,
            panel("α scaled by (14)", &after, TimeAxis::Dimensionless)?,
        ],
    })
}

/// The drop of one animal by the law that the paper's tests used, which has no smoothing.
fn drop(name: &str, scale: &Scale, scale_dissipation: bool) -> Result<DropCurve> {
    let values = scaled(scale)?.values();
    let dissipation =
        if scale_dissipation { values.dissipation } else { falisse2022().contact.dissipation() };
    let contact = Contact::new(ContactValues { dissipation, smoothing: None, ..values })?;
    let test = DropTest::of(&contact, scale, HEIGHT_RADII, DURATION_S)?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand points")]
    let samples = (SAMPLES_PER_UNIT * DURATION_S / scale.time_s()) as usize;
    let values = DropValues { samples, ..test.values() };
    let report = DropTest::new(test.spheres().iter().copied(), values)?.run()?;
    let points = report.series.iter().map(|sample| (sample.time_s, sample.force_n / report.body_weight_n));
    Ok(DropCurve { name: name.to_owned(), points: points.collect(), time_unit_s: report.reference_time_s })
}

/// Fig. C.5: the smoothed law of a sphere of 15 mm (the emu of ten spheres) with OpenSim's own cf and bd, and with scaled.
///
/// # Errors
/// None with the numbers of Table 1.
pub(super) fn fig_c5(title: Option<&str>) -> Result<Figure> {
    let emu = animal(37.80, 10.0, 0.015)?;
    let values = scaled(&emu)?.values();
    let default = ContactValues { smoothing: Some(SmoothingValues::OPENSIM_DEFAULT), ..values };
    let bodies = [("default cf, bd", Contact::new(default)?), ("scaled cf, bd", Contact::new(values)?)]
        .map(|(name, contact)| (name, body(&emu, contact)));
    let axes = Axes { indentation: IndentationAxis::Relative, force: ForceAxis::Newton };
    let mut panels = Vec::new();
    for (name, body) in &bodies {
        panels.push(forces(name, body, axes)?);
    }
    for (name, body) in &bodies {
        panels.push(states(name, body, axes)?);
    }
    // Both forces on one scale, so that the eye can compare them.
    let top = panels.iter().take(2).flat_map(|panel| panel.curves.iter().flat_map(|curve| &curve.points));
    let top = top.fold(0.0_f64, |most, (_, force)| most.max(*force));
    for panel in panels.iter_mut().take(2) {
        panel.y.range = Some((0.0, 1.06 * top));
    }
    Ok(Figure {
        title: title.unwrap_or("Smoothing of a sphere of R = 0.015 m (Fig. C.5)").to_owned(),
        description: "Force and contact state against relative indentation of one sphere of the emu with ten spheres, \
                      R = 0.015 m and E₁* = 1.66 MPa. Left with OpenSim's default smoothing, which pushes well before \
                      contact (shaded); right with cf and bd scaled by (C.2) and (C.5), where it does so much less."
            .to_owned(),
        width: Width::Page,
        columns: 2,
        panels,
    })
}

fn body(scale: &Scale, contact: Contact) -> Body {
    let kind = Kind { spheres: String::new(), radius_m: scale.radius_m(), contact };
    let unknown = Failure::outside(EMU, "plot", &anyhow::anyhow!("Fig. C.5 says nothing of weight"));
    Body::without_weight(EMU.to_owned(), vec![kind], &unknown)
}

fn forces(title: &str, body: &Body, axes: Axes) -> Result<Panel> {
    let curves = series::kinds(std::slice::from_ref(body))
        .map(|(body, kind)| series::force(body, kind, axes, 0.5))
        .collect::<Result<Vec<_>, Failure>>()
        .map_err(said)?;
    let figure = ForceFigure {
        title: String::new(),
        indentation: axes.indentation,
        force: axes.force,
        bodies: curves,
        limits: series::hertz_limit(axes),
    };
    Ok(Panel { title: title.to_owned(), ..force_panel(&figure)? })
}

fn states(title: &str, body: &Body, axes: Axes) -> Result<Panel> {
    let mut bodies = Vec::new();
    let mut limits = Vec::new();
    for (body, kind) in series::kinds(std::slice::from_ref(body)) {
        bodies.extend(series::state(body, kind, axes).map_err(said)?);
        limits.extend(series::thresholds(kind, axes));
    }
    let figure = StateFigure { title: String::new(), indentation: axes.indentation, bodies, limits };
    Ok(Panel { title: title.to_owned(), ..state_panel(&figure)? })
}

fn said(failure: Failure) -> anyhow::Error {
    anyhow::anyhow!(failure.message)
}
