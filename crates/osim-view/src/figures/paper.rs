//! The figures of the paper, from its Table 1.

use std::fmt::Display;

use contact_plots::{Figure, Panel, Point, Width};
use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::table1::{self, Animal, DROP_HEIGHT_RADII};
use contact_scaling::{Contact, ContactValues, Scale, SmoothingValues, falisse2022};
use osim_inspect::series::{self, ContactBody, ForceUnit, IndentationUnit, PlotUnits, SphereKind};
use osim_model::files::Failure;
use osim_model::messages::readable;

use crate::figures::axes::{Result, threshold_limits};
use crate::figures::curves::{
    DIMENSIONLESS_TIME, KindOfSphereLaws, TIME_IN_SECONDS, drop_panel, force_panel, state_panel,
};

/// The animal of Table 1 with the name `taxon`; of several, the one that stands on the most spheres.
fn animal_of_table(taxon: &str) -> Result<Animal> {
    let spheres = |animal: &Animal| animal.scale().sphere_count();
    let most = table1::animals_called(taxon).max_by(|a, b| spheres(a).total_cmp(&spheres(b)));
    most.ok_or_else(|| table_failure(format!("there is no {taxon}")))
}

/// The failure for an error in the numbers of Table 1.
fn table_failure(error: impl Display) -> Failure {
    Failure::outside("Table 1", "plot", error.to_string())
}

/// Duration of the computed drops of Fig. 4, s.
const DURATION_OF_FALLS_S: f64 = 1.1;
/// End of the time axis of Fig. 4, s. At this time both animals are at rest.
const END_OF_FIG_4_S: f64 = 0.5;
/// Number of points for each √(R/g), so that the curves of all animals have equally many points.
const SAMPLES_PER_UNIT_OF_TIME: f64 = 40.0;

/// End of the force axes of Fig. 4, body weights.
const END_OF_FORCE_AXIS_BW: f64 = 3.0;

/// Fig. 4, the effect of scaling the dissipation: drops of the mouse and the giraffe, with α = 2 s/m for both and with α scaled by
/// (14).
///
/// # Errors
/// None with the numbers of Table 1.
pub fn fig4(title: Option<&str>) -> Result<Figure> {
    let animals = [animal_of_table("mouse")?, animal_of_table("giraffe")?];
    let drops = |scale_dissipation: bool| -> Result<Vec<AnimalDrop>> {
        animals.iter().map(|animal| drop_of_animal(animal, scale_dissipation)).collect()
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
            panel_of_fig_4(&same, TIME_IN_SECONDS, &before),
            panel_of_fig_4("α scaled by (14)", TIME_IN_SECONDS, &after),
            panel_of_fig_4(&same, DIMENSIONLESS_TIME, &before),
            panel_of_fig_4("α scaled by (14)", DIMENSIONLESS_TIME, &after),
        ],
    })
}

/// The fall of one animal of Table 1, as a curve of its force.
struct AnimalDrop {
    taxon: &'static str,
    /// Points of the drop: time in s, and force in body weights.
    points: Vec<Point>,
    /// Unit of time of the dimensionless axis, √(R/g), s.
    time_unit_s: f64,
}

fn panel_of_fig_4(title: &str, time: &str, falls: &[AnimalDrop]) -> Panel {
    let in_seconds = time == TIME_IN_SECONDS;
    let unit_s = |fall: &AnimalDrop| if in_seconds { 1.0 } else { fall.time_unit_s };
    let drawn = falls.iter().map(|fall| (fall.taxon, fall.points.as_slice(), unit_s(fall)));
    let mut panel = drop_panel(drawn, time, in_seconds.then_some(END_OF_FIG_4_S));
    panel.title = title.to_owned();
    // All panels have one scale, so that they can be compared.
    panel.y.range = Some((0.0, END_OF_FORCE_AXIS_BW));
    panel
}

/// The drop of one animal by the law of the paper's tests, which has no smoothing.
fn drop_of_animal(animal: &Animal, scale_dissipation: bool) -> Result<AnimalDrop> {
    let (scale, values) =
        (animal.scale(), animal.contact_without_smoothing().map_err(table_failure)?.values());
    let dissipation =
        if scale_dissipation { values.dissipation } else { falisse2022().contact.dissipation() };
    let contact = Contact::new(ContactValues { dissipation, ..values }).map_err(table_failure)?;
    let test =
        DropTest::of(&contact, &scale, DROP_HEIGHT_RADII, DURATION_OF_FALLS_S).map_err(table_failure)?;
    let samples = (SAMPLES_PER_UNIT_OF_TIME * DURATION_OF_FALLS_S / scale.time_s()) as usize;
    let values = DropValues { samples, ..test.values() };
    let test = DropTest::new(test.spheres().iter().copied(), values).map_err(table_failure)?;
    let report = test.run().map_err(table_failure)?;
    let points = report.series.iter().map(|sample| (sample.time_s, sample.force_n / report.body_weight_n));
    Ok(AnimalDrop { taxon: animal.taxon(), points: points.collect(), time_unit_s: report.reference_time_s })
}

/// The animal whose sphere Fig. C.5 shows.
const FIG_C5_ANIMAL: &str = "emu";

/// The curves of Fig. C.5 extend this far above and below the floor, in radii.
const WIDTH_OF_FIG_C5_RADII: f64 = 0.5;

/// The units of Fig. C.5.
const PLOT_UNITS: PlotUnits = PlotUnits { indentation: IndentationUnit::Relative, force: ForceUnit::Newton };

/// Fig. C.5, the effect of smoothing: the smoothed law of a sphere of 15 mm (the emu of ten spheres) with OpenSim's default cf and bd,
/// and with scaled ones.
///
/// # Errors
/// None with the numbers of Table 1.
pub fn fig_c5(title: Option<&str>) -> Result<Figure> {
    let animal = animal_of_table(FIG_C5_ANIMAL)?;
    let (emu, values) = (animal.scale(), animal.contact().map_err(table_failure)?.values());
    let default = ContactValues { smoothing: Some(SmoothingValues::OPENSIM_DEFAULT), ..values };
    let (mut panels, mut states) = (Vec::new(), Vec::new());
    for (name, values) in [("default cf, bd", default), ("scaled cf, bd", values)] {
        let contact = Contact::new(values).map_err(table_failure)?;
        let [force, state] = panels_of_fig_c5(name, &emu, contact)?;
        panels.push(force);
        states.push(state);
    }
    panels.append(&mut states);
    // Both force panels have one scale, so that they can be compared.
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

/// The panels of force and of contact state of a sphere with this contact.
fn panels_of_fig_c5(title: &str, scale: &Scale, contact: Contact) -> Result<[Panel; 2]> {
    let kind = SphereKind::new(scale.radius_m(), contact);
    let unknown = Failure::outside(FIG_C5_ANIMAL, "plot", "Fig. C.5 says nothing of weight");
    let name = FIG_C5_ANIMAL.to_owned();
    let body = ContactBody::without_weight(name.clone(), vec![kind.clone()], &unknown);
    let reach_m = WIDTH_OF_FIG_C5_RADII * kind.radius_m;
    let force = series::force(&body, &kind, PLOT_UNITS, (-reach_m, reach_m))?;
    let laws = vec![KindOfSphereLaws { name: name.clone(), series: force, remark: String::new() }];
    let state = series::contact_state(&body, &kind, PLOT_UNITS, None)?;
    let states = state.map(|points| (name, points)).into_iter().collect();
    let limits = threshold_limits(&kind, PLOT_UNITS);
    Ok([
        Panel { title: title.to_owned(), ..force_panel(laws, PLOT_UNITS) },
        Panel { title: title.to_owned(), limits, ..state_panel(states, PLOT_UNITS) },
    ])
}
