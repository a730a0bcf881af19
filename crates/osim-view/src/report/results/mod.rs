//! Results of requests that change no model: drops, fits and motions in files of their own; here presets, designs without a model, and
//! the end of a sweep, as text and JSON.

mod drop;
mod fit;
mod moco_and_nmsm;
mod motion;
mod motion_record;

use std::path::Path;

use contact_scaling::{DimensionlessContact, Preset};
use osim_inspect::{Dimensionless, SCHEMA_VERSION};
use osim_model::files::FileName;
use osim_model::messages::{four_significant, readable};
use osim_planning::{DesignQuantity, DesignSheet};

use crate::report::layout::{WIDTH, filled, table};

pub use drop::{DropDifferenceRecord, DropRecord, DropSeriesRecord, drop_chart, drop_csv, drop_text};
pub use fit::{EstimateRecord, FitRecord, FitWarningRecord, ResidualsRecord, fit_text};
pub use moco_and_nmsm::{MOCO_FILES, NMSM_FILES, moco_files, nmsm_files};
pub(crate) use motion::motion_feet;
pub use motion::{
    MotionCells, MotionColumn, MotionComparisonRecord, MotionFootRecord, MotionRecord, MotionRemarkRecord,
    MotionSphereRecord, MotionStanceRecord, MotionTouchDownRecord, corrected_files, external_loads_xml,
    ground_reactions_sto, motion_columns, motion_csv, motion_text,
};

osim_inspect::json_records! {
    /// A preset, as the JSON has it.
    PresetRecord from preset: &Preset {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// Name of the preset.
        name: String = preset.name.to_string(),
        /// Where the numbers of the preset are published.
        source: String = preset.source.to_string(),
        /// The mass that the contact was made for, kg.
        mass_kg: f64 = preset.scale.mass_kg(),
        /// Spheres that share the weight.
        spheres: f64 = preset.scale.sphere_count(),
        /// Radius of the preset's spheres, m.
        radius_m: f64 = preset.scale.radius_m(),
        /// Gravity that the contacts are made for, m/s².
        gravity_m_s2: f64 = preset.scale.gravity_m_s2(),
        /// OpenSim's `stiffness`, E₁* in N/m².
        stiffness: f64 = preset.contact.plane_strain_modulus(),
        /// OpenSim's `dissipation`, s/m.
        dissipation: f64 = preset.contact.dissipation(),
        /// OpenSim's `constant_contact_force`, m².
        constant_contact_force: Option<f64> = preset.contact.smoothing().map(|smoothing| smoothing.constant_contact_force),
        /// OpenSim's `hertz_smoothing`, 1/m.
        hertz_smoothing: Option<f64> = preset.contact.smoothing().map(|smoothing| smoothing.hertz_smoothing),
        /// OpenSim's `hunt_crossley_smoothing`, s/m.
        hunt_crossley_smoothing: Option<f64> = preset.contact.smoothing().map(|smoothing| smoothing.hunt_crossley_smoothing),
        /// The preset's contacts without dimensions.
        dimensionless: Dimensionless = (&DimensionlessContact::of(&preset.contact, &preset.scale)).into(),
    }
}

/// A preset with its source and its numbers, with dimensions and dimensionless, for a terminal with this many columns.
pub fn preset_text(preset: &Preset, columns: Option<usize>) -> String {
    let (scale, contact) = (&preset.scale, &preset.contact);
    let dimensionless = DimensionlessContact::of(contact, scale);
    let mut table = table(&["quantity", "value", "unit", "dimensionless"]);
    let mut row = |name: &str, value: f64, unit: &str, pure: Option<f64>| {
        let pure = pure.map(four_significant).unwrap_or_default();
        // Standard gravity is known with all its digits.
        let value = if unit == "m/s2" { readable(value) } else { four_significant(value) };
        table.add_row(vec![name.to_owned(), value, unit.to_owned(), pure]);
    };
    row("mass", scale.mass_kg(), "kg", None);
    row("spheres", scale.sphere_count(), "", None);
    row("radius", scale.radius_m(), "m", None);
    row("gravity", scale.gravity_m_s2(), "m/s2", None);
    row("stiffness", contact.plane_strain_modulus(), "N/m2", Some(dimensionless.modulus()));
    row("dissipation", contact.dissipation(), "s/m", Some(dimensionless.dissipation()));
    if let Some(smoothing) = contact.smoothing() {
        let cf = smoothing.constant_contact_force;
        row("constant_contact_force", cf, "m2", dimensionless.constant_indentation());
        row("hertz_smoothing", smoothing.hertz_smoothing, "1/m", dimensionless.hertz_smoothing());
        let bv = smoothing.hunt_crossley_smoothing;
        row("hunt_crossley_smoothing", bv, "s/m", dimensionless.hunt_crossley_smoothing());
    }
    format!(
        "{}\n{}\n\n{}\n\nrelative indentation at body weight: {}\n",
        preset.name,
        filled(&format!("source: {}", preset.source), columns.unwrap_or(WIDTH)),
        table.into_lines(columns),
        four_significant(dimensionless.relative_indentation())
    )
}

// A design without a model, as text.

/// All quantities of a design with their equations and limits, for a terminal with this many columns.
pub fn design_sheet_text(sheet: &DesignSheet, columns: Option<usize>) -> String {
    let mut table = table(&["quantity", "value", "unit", "equation", ""]);
    for figure in &sheet.figures {
        let limit = figure
            .limit
            .as_ref()
            .map(|limit| format!("{} {}", if limit.within_limit { "ok:" } else { "outside:" }, limit.text));
        let given = figure.given.then(|| "given".to_owned());
        let mark = given.into_iter().chain(limit).collect::<Vec<_>>().join("; ");
        let equation = if figure.equation == DesignQuantity::EXACT_LAW {
            "exact law".to_owned()
        } else {
            format!("({})", figure.equation)
        };
        table.add_row(vec![
            figure.quantity.info().label.to_owned(),
            four_significant(figure.value),
            figure.unit.to_owned(),
            equation,
            mark,
        ]);
    }
    table.right_aligned(&[1]);
    let mut text = format!("{}\n", table.fitted(columns.unwrap_or(usize::MAX)));
    for remark in &sheet.remarks {
        text.push_str(&format!("remark: {remark}\n"));
    }
    if sheet.figures.iter().any(|figure| figure.quantity == DesignQuantity::Stiffness) {
        text.push_str(
            "remark: 'stiffness' (E1*) is what to type into OpenSim, 2^(3/2) times the composite modulus E*\n",
        );
    }
    text
}

// The JSON contract of a sweep's end.

osim_inspect::json_records! {
    /// The end of a sweep, for scripts.
    SweepRecord from (model, folder, manifest): (&FileName, &Path, Option<&Path>) {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// The model, as the caller named it.
        model: String = model.clone().into_parts().0,
        /// The model's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        model_bytes: Option<Vec<u8>> = model.clone().into_parts().1,
        /// The table that says what is in which file; null if nothing was made.
        manifest: Option<String> = manifest.map(|path| FileName::from(path).into_parts().0),
        /// The manifest's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        manifest_bytes: Option<Vec<u8>> = manifest.and_then(|path| FileName::from(path).into_parts().1),
        /// The folder of the variants.
        folder: String = FileName::from(folder).into_parts().0,
        /// The folder's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        folder_bytes: Option<Vec<u8>> = FileName::from(folder).into_parts().1,
        /// How many points the grid has, or steps the ladder: they are counted from 1 to this number.
        points: usize = 0,
        /// With `point`, the file of that point, by its name in `folder`.
        file: Option<String> = None,
        /// How many models are complete, or would be: of all points, of the point that `point` names, or of a share.
        models: usize = 0,
        /// How many of the models an earlier sweep had made.
        done_before: usize = 0,
        /// How many variants could not be made.
        failed: usize = 0,
    }
}

impl SweepRecord {
    /// The record of a sweep of `model` into `folder`.
    pub fn new(model: &FileName, folder: &Path, manifest: Option<&Path>) -> Self {
        (model, folder, manifest).into()
    }
}
