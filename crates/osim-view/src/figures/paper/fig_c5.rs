//! Fig. C.5: what smoothing does.

use contact_plots::{Figure, ForceFigure, Panel, StateCurve, StateFigure, Width, force_panel, state_panel};
use contact_scaling::{Contact, ContactValues, Scale, SmoothingValues};
use osim_inspect::series::{self, Body, ForceUnit, IndentationUnit, SphereKind, Units};
use osim_model::files::Failure;

use super::animals::{animal, failure};
use crate::figures::axes::{force_axis, indentation_axis};
use crate::figures::force::curves;
use crate::figures::limits::{hertz_limit, thresholds};

/// Whose sphere the figure is taken to show.
const EMU: &str = "emu";

/// Radii that curves go to either side.
const REACH: f64 = 0.5;

const UNITS: Units = Units { indentation: IndentationUnit::Relative, force: ForceUnit::Newton };

/// The smoothed law of a sphere of 15 mm (the emu of ten spheres) with OpenSim's own cf and bd, and with scaled ones.
///
/// # Errors
/// None with the numbers of Table 1.
pub fn fig_c5(title: Option<&str>) -> Result<Figure, Failure> {
    let animal = animal(EMU)?;
    let (emu, values) = (animal.scale(), animal.contact().map_err(failure)?.values());
    let default = ContactValues { smoothing: Some(SmoothingValues::OPENSIM_DEFAULT), ..values };
    let mut bodies = Vec::new();
    for (name, values) in [("default cf, bd", default), ("scaled cf, bd", values)] {
        bodies.push((name, body(&emu, Contact::new(values).map_err(failure)?)));
    }
    let mut panels = Vec::new();
    for (name, body) in &bodies {
        panels.push(forces(name, body)?);
    }
    for (name, body) in &bodies {
        panels.push(states(name, body)?);
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
    let unknown = Failure::outside(EMU, "plot", "Fig. C.5 says nothing of weight");
    Body::without_weight(EMU.to_owned(), vec![SphereKind::new(scale.radius_m(), contact)], &unknown)
}

fn forces(title: &str, body: &Body) -> Result<Panel, Failure> {
    let mut bodies = Vec::new();
    for (body, kind) in series::kinds(std::slice::from_ref(body)) {
        let reach_m = (-REACH * kind.radius_m, REACH * kind.radius_m);
        bodies.push(curves(body.name.clone(), series::force(body, kind, UNITS, reach_m)?));
    }
    let figure = ForceFigure {
        title: String::new(),
        indentation: indentation_axis(UNITS),
        force: force_axis(UNITS),
        bodies,
        top: None,
        limits: hertz_limit(UNITS),
    };
    Ok(Panel { title: title.to_owned(), ..force_panel(&figure).map_err(failure)? })
}

fn states(title: &str, body: &Body) -> Result<Panel, Failure> {
    let mut bodies = Vec::new();
    let mut limits = Vec::new();
    for (body, kind) in series::kinds(std::slice::from_ref(body)) {
        let points = series::state(body, kind, UNITS, None)?;
        bodies.extend(points.map(|points| StateCurve { name: body.name.clone(), points }));
        limits.extend(thresholds(kind, UNITS));
    }
    let figure = StateFigure { title: String::new(), indentation: indentation_axis(UNITS), bodies, limits };
    Ok(Panel { title: title.to_owned(), ..state_panel(&figure).map_err(failure)? })
}
