//! The figures of the paper, from its Table 1.

use std::fmt::Display;

use contact_plots::{Figure, Panel, Point, Width};
use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::table1::{self, Animal, HEIGHT_RADII};
use contact_scaling::{Contact, ContactValues, Scale, SmoothingValues, falisse2022};
use osim_inspect::series::{self, Body, ForceUnit, IndentationUnit, SphereKind, Units};
use osim_model::files::Failure;
use osim_model::messages::readable;

use crate::figures::axes::thresholds;
use crate::figures::curves::{DIMENSIONLESS, Laws, SECONDS, drop_panel, force_panel, state_panel};

/// The animal of Table 1 that is called `taxon` and stands on the most spheres.
fn animal(taxon: &str) -> Result<Animal, Failure> {
    let spheres = |animal: &Animal| animal.scale().sphere_count();
    let most = table1::called(taxon).max_by(|a, b| spheres(a).total_cmp(&spheres(b)));
    most.ok_or_else(|| failure(format!("there is no {taxon}")))
}

/// Something that went wrong with numbers of the table.
fn failure(error: impl Display) -> Failure {
    Failure::outside("Table 1", "plot", error.to_string())
}

// Fig. 4: what scaling the dissipation does.

/// How long the drop is followed for the time axis, in s.
const DURATION_S: f64 = 1.1;
/// Where the time axis ends, in s: both animals are at rest.
const SHOWN_S: f64 = 0.5;
/// Points for each √(R/g): as many for the mouse as for the giraffe in their own time.
const SAMPLES_PER_UNIT: f64 = 40.0;

/// Where the force axes end, in body weights.
const TOP: f64 = 3.0;

/// Drops of the mouse and the giraffe, with α = 2 s/m for both and with α scaled by (14).
///
/// # Errors
/// None with the numbers of Table 1.
pub fn fig4(title: Option<&str>) -> Result<Figure, Failure> {
    let animals = [animal("mouse")?, animal("giraffe")?];
    let drops = |scale_dissipation: bool| -> Result<Vec<Fall>, Failure> {
        animals.iter().map(|animal| drop(animal, scale_dissipation)).collect()
    };
    let (before, after) = (drops(false)?, drops(true)?);
    let base = falisse2022().contact.dissipation();
    let same = format!("α = {} s/m for both", readable(base));
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
            panel(&same, SECONDS, &before),
            panel("α scaled by (14)", SECONDS, &after),
            panel(&same, DIMENSIONLESS, &before),
            panel("α scaled by (14)", DIMENSIONLESS, &after),
        ],
    })
}

/// The fall of one animal.
struct Fall {
    taxon: &'static str,
    /// Time in s, force in body weights.
    points: Vec<Point>,
    /// √(R/g), in s.
    time_unit_s: f64,
}

fn panel(title: &str, time: &str, falls: &[Fall]) -> Panel {
    let in_seconds = time == SECONDS;
    let unit_s = |fall: &Fall| if in_seconds { 1.0 } else { fall.time_unit_s };
    let drawn = falls.iter().map(|fall| (fall.taxon, fall.points.as_slice(), unit_s(fall)));
    let mut panel = drop_panel(drawn, time, in_seconds.then_some(SHOWN_S));
    panel.title = title.to_owned();
    // One scale for all, so that the eye can compare them.
    panel.y.range = Some((0.0, TOP));
    panel
}

/// The drop of one animal by the law that the paper's tests used, which has no smoothing.
fn drop(animal: &Animal, scale_dissipation: bool) -> Result<Fall, Failure> {
    let (scale, values) = (animal.scale(), animal.plain_contact().map_err(failure)?.values());
    let dissipation =
        if scale_dissipation { values.dissipation } else { falisse2022().contact.dissipation() };
    let contact = Contact::new(ContactValues { dissipation, ..values }).map_err(failure)?;
    let test = DropTest::of(&contact, &scale, HEIGHT_RADII, DURATION_S).map_err(failure)?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand points")]
    let samples = (SAMPLES_PER_UNIT * DURATION_S / scale.time_s()) as usize;
    let values = DropValues { samples, ..test.values() };
    let test = DropTest::new(test.spheres().iter().copied(), values).map_err(failure)?;
    let report = test.run().map_err(failure)?;
    let points = report.series.iter().map(|sample| (sample.time_s, sample.force_n / report.body_weight_n));
    Ok(Fall { taxon: animal.taxon(), points: points.collect(), time_unit_s: report.reference_time_s })
}

// Fig. C.5: what smoothing does.

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
    let mut laws = Vec::new();
    for (body, kind) in series::bodies_and_kinds(std::slice::from_ref(body)) {
        let reach_m = (-REACH * kind.radius_m, REACH * kind.radius_m);
        let series = series::force(body, kind, UNITS, reach_m)?;
        laws.push(Laws { name: body.name.clone(), series, remark: String::new() });
    }
    Ok(Panel { title: title.to_owned(), ..force_panel(laws, UNITS) })
}

fn states(title: &str, body: &Body) -> Result<Panel, Failure> {
    let mut states = Vec::new();
    let mut limits = Vec::new();
    for (body, kind) in series::bodies_and_kinds(std::slice::from_ref(body)) {
        let points = series::contact_state(body, kind, UNITS, None)?;
        states.extend(points.map(|points| (body.name.clone(), points)));
        limits.extend(thresholds(kind, UNITS));
    }
    Ok(Panel { title: title.to_owned(), limits, ..state_panel(states, UNITS) })
}
