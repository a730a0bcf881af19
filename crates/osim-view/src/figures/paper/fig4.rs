//! Fig. 4: what scaling the dissipation does.

use contact_plots::{DropCurve, Figure, Panel, TimeAxis, Width, drop_panel};
use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::table1::{Animal, HEIGHT_RADII};
use contact_scaling::{Contact, ContactValues, falisse2022};
use osim_model::files::Failure;
use osim_model::messages::readable;

use super::animals::{animal, failure};

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
    let drops = |scale_dissipation: bool| -> Result<Vec<DropCurve>, Failure> {
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
            panel(&same, &before, TimeAxis::Second)?,
            panel("α scaled by (14)", &after, TimeAxis::Second)?,
            panel(&same, &before, TimeAxis::Dimensionless)?,
            panel("α scaled by (14)", &after, TimeAxis::Dimensionless)?,
        ],
    })
}

fn panel(title: &str, bodies: &[DropCurve], time: TimeAxis) -> Result<Panel, Failure> {
    let shown = (time == TimeAxis::Second).then_some(SHOWN_S);
    let mut panel = Panel { title: title.to_owned(), ..drop_panel(bodies, time, shown).map_err(failure)? };
    // One scale for all, so that the eye can compare them.
    panel.y.range = Some((0.0, TOP));
    Ok(panel)
}

/// The drop of one animal by the law that the paper's tests used, which has no smoothing.
fn drop(animal: &Animal, scale_dissipation: bool) -> Result<DropCurve, Failure> {
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
    Ok(DropCurve {
        name: animal.taxon().to_owned(),
        points: points.collect(),
        time_unit_s: report.reference_time_s,
    })
}
