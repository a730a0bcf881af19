//! Records for scripts: one JSON object for each model and line. `docs/reference/json.md` describes every field.

use std::collections::{BTreeMap, HashMap};
use std::io::{self, Write};
use std::path::Path;

use osim_inspect::{ContactsMass, FindingRecord, SCHEMA_VERSION};
use osim_model::Model;
use osim_model::files::{Failure, FileName};
use osim_model::messages::{Dialect, Phrase, is_visible};
use osim_patch::{
    FittedFoot, FittedNumber, NewSphere, NumberChange, ObjectAction, ObjectChange, PlaceChange, Plan,
    RecordingErrors,
};
use serde::Serialize;
use serde_json::ser::{CharEscape, CompactFormatter, Formatter, Serializer};

/// A value as one JSON object and a line end. Numbers that are not finite become null.
///
/// Invisible letters, which names in models may have, are written as escapes of JSON: a terminal shows the whole line, and a program
/// reads back the text as it was.
pub fn line(value: &impl Serialize) -> String {
    let mut bytes = Vec::new();
    // Serialising owned strings, numbers and lists cannot fail; an empty line would be seen at once if it did.
    let written = value.serialize(&mut Serializer::with_formatter(&mut bytes, VisibleLetters));
    let mut text = written.ok().and_then(|()| String::from_utf8(bytes).ok()).unwrap_or_default();
    text.push('\n');
    text
}

/// Writes compact JSON in which invisible letters are escaped.
struct VisibleLetters;

impl Formatter for VisibleLetters {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        if fragment.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
            return writer.write_all(fragment.as_bytes());
        }
        fragment.chars().try_for_each(|letter| match is_visible(letter) {
            true => write!(writer, "{letter}"),
            false => {
                letter.encode_utf16(&mut [0; 2]).iter().try_for_each(|unit| write!(writer, "\\u{unit:04x}"))
            }
        })
    }

    fn write_char_escape<W: ?Sized + Write>(&mut self, writer: &mut W, escape: CharEscape) -> io::Result<()> {
        CompactFormatter.write_char_escape(writer, escape)
    }
}

// The JSON contract of what went wrong.

osim_inspect::json_records! {
    /// One model that could not be done.
    FailureRecord from (failure, dialect): (&Failure, &dyn Dialect) {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// The file, as the caller named it.
        model: String = failure.model.clone().into_parts().0,
        /// The model's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        model_bytes: Option<Vec<u8>> = failure.model.clone().into_parts().1,
        /// The error of the model.
        error: ErrorRecord = (failure, dialect).into(),
    }

    /// An error of a model or a call.
    ErrorRecord from (failure, dialect): (&Failure, &dyn Dialect) {
        /// Stable short name of the error.
        code: &'static str = failure.code,
        /// The message: what is wrong, what was expected, and a way out.
        message: String = failure.message.spelled(dialect),
        /// Line of the place, from 1.
        line: Option<usize> = failure.line,
        /// Column of the place in characters, from 1.
        column: Option<usize> = failure.column,
    }
}

impl FailureRecord {
    /// The record of a failure, with texts in the words of `dialect`.
    pub fn new(failure: &Failure, dialect: &dyn Dialect) -> Self {
        (failure, dialect).into()
    }
}

// The JSON contract of a change.

osim_inspect::json_records! {
    /// The changes of a model, and the files of the result.
    PlanRecord from (plan, model, path, output, geometry_output):
        (&Plan, &Model, &Path, Option<&Path>, Option<&Path>) {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32 = SCHEMA_VERSION,
        /// The model, as the caller named it.
        model: String = FileName::from(path).into_parts().0,
        /// The model's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        model_bytes: Option<Vec<u8>> = FileName::from(path).into_parts().1,
        /// The file that was written.
        output: Option<String> = output.map(|path| FileName::from(path).into_parts().0),
        /// The output's name in bytes, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        output_bytes: Option<Vec<u8>> = output.and_then(|path| FileName::from(path).into_parts().1),
        /// The geometry set that was written with a force set.
        #[serde(skip_serializing_if = "Option::is_none")]
        geometry_output: Option<String> = geometry_output.map(|path| FileName::from(path).into_parts().0),
        /// The name in bytes of the output for geometry, if it is not UTF-8.
        #[serde(skip_serializing_if = "Option::is_none")]
        geometry_output_bytes: Option<Vec<u8>> =
            geometry_output.and_then(|path| FileName::from(path).into_parts().1),
        /// The mass that the contacts were made for before; null where nobody knows.
        contacts_mass_kg: Option<ContactsMass> =
            plan.masses.as_ref().map(|masses| ContactsMass::from(&masses.contacts_mass)),
        /// The mass that the contacts are made for afterwards, kg; null where `contacts_mass_kg` is.
        target_mass_kg: Option<f64> = plan.masses.as_ref().map(|masses| masses.target_mass_kg),
        /// Whole objects that are added or removed. Numbers of objects that are added change `from` what they are made from.
        objects: Vec<ObjectRecord> = object_records(plan),
        /// Numbers that change, then sphere centres that move.
        changes: Vec<ChangeRecord> =
            plan.changes.iter().map(ChangeRecord::from)
                .chain(plan.moves.iter().map(ChangeRecord::from)).collect(),
        /// Of a fit to recordings: how far its forces are from the plates'.
        #[serde(skip_serializing_if = "Option::is_none")]
        errors: Option<RecordingErrorsRecord> = plan.errors.as_ref().map(RecordingErrorsRecord::from),
        /// Of a fit of the height: how far the floor of each recording is above that of the model as it was, m. The model gets the first.
        #[serde(skip_serializing_if = "Option::is_none")]
        floor_up_m: Option<Vec<f64>> = (!plan.floor_up_m.is_empty()).then(|| plan.floor_up_m.clone()),
        /// Things the user should know.
        findings: Vec<FindingRecord> = plan.findings.iter().map(FindingRecord::from).collect(),
        /// Remarks on every change of this kind.
        remarks: Vec<String> = plan.remarks.iter().map(Phrase::to_string).collect(),
        /// The credits of the new model as OpenSim reads them, with the note about its contacts; null where it has none. Set them, too,
        /// where changes are made in a model in memory.
        credits: Option<String> = plan.credits(model),
    }

    /// One object that is added or removed.
    ObjectRecord from (object, sphere): (&ObjectChange, Option<&NewSphere<'_>>) {
        /// Whether the object was `added` or `removed`.
        change: &'static str = object.action.as_str(),
        /// OpenSim's class, such as `ContactSphere`.
        class: &'static str = object.class,
        /// Name of the object.
        name: String = object.name.clone(),
        /// Component path of the object.
        path: String = object.path.clone(),
        /// The body that carries the object, or the sphere of the object; null for a floor.
        body: Option<String> = object.body.clone(),
        /// Centre of a sphere that is added, in the frame of that body, m; null for all else.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<[Option<f64>; 3]>"))]
        location_m: Option<[f64; 3]> = sphere.map(|sphere| sphere.centre_m),
        /// Radius of a sphere, m; null for all else.
        radius_m: Option<f64> = sphere.map(|sphere| sphere.radius_m),
        /// OpenSim's parameters of a force that `convert` writes, by name and in OpenSim's units; null for all others.
        parameters: Option<BTreeMap<&'static str, f64>> = parameters_by_name(object),
    }

    /// How far the forces of a fit are from those that plates measured: the worst foot of the first trial; vertically also all feet of each
    /// other trial.
    RecordingErrorsRecord from errors: &RecordingErrors {
        /// Root mean square along the normal of the floor, body weights.
        vertical_rms_bw: f64 = errors.vertical_rms_bw,
        /// Root mean square along the normal in frames that were not fitted, body weights.
        held_out_vertical_rms_bw: Option<f64> = errors.held_out_vertical_rms_bw,
        /// Root mean square along the normal of the floor if nothing touched, body weights.
        null_vertical_rms_bw: f64 = errors.null_vertical_rms_bw,
        /// Root mean square across the normal, body weights.
        horizontal_rms_bw: f64 = errors.horizontal_rms_bw,
        /// Root mean square of the distance between the centres of pressure, m.
        cop_rms_m: Option<f64> = errors.cop_rms_m,
        /// The largest x/R in the recording.
        largest_relative_indentation: f64 = errors.largest_relative_indentation,
        /// Each foot of the first trial under which the plates measured a force.
        feet: Vec<FittedFootRecord> = errors.feet.iter().map(FittedFootRecord::from).collect(),
        /// What was fitted: first what is written to the model.
        parameters: Vec<FittedParameterRecord> =
            errors.parameters.iter().map(FittedParameterRecord::from).collect(),
        /// The correlation of each two parameters.
        correlations: Vec<CorrelationRecord> =
            errors.correlations.iter().map(CorrelationRecord::from).collect(),
    }

    /// The forces of one foot after a fit, compared with those of its plates.
    FittedFootRecord from foot: &FittedFoot {
        /// `right foot`, `left foot`, or the name of the limb's first body.
        name: String = foot.name.clone(),
        /// Root mean square of the difference along the normal of the floor, body weights.
        vertical_rms_bw: f64 = foot.vertical_rms_bw,
        /// Root mean square of the vertical force's difference from the plates before the fit, body weights.
        vertical_rms_before_bw: f64 = foot.vertical_rms_before_bw,
        /// Root mean square of the difference across the normal, body weights.
        horizontal_rms_bw: f64 = foot.horizontal_rms_bw,
        /// Root mean square of the distance between both centres of pressure, m.
        cop_rms_m: Option<f64> = foot.cop_rms_m,
        /// The model's largest force along the normal, body weights.
        peak_bw: f64 = foot.peak_bw,
        /// The largest measured force, body weights.
        measured_peak_bw: f64 = foot.measured_peak_bw,
    }

    /// One fitted parameter.
    FittedParameterRecord from one: &FittedNumber {
        /// `stiffness_factor`, `dissipation_s_m`, `spheres_down_m`, `floor_up_m`, or, for the second trial, `floor_2_up_m`.
        name: String = one.name.clone(),
        /// The value with which the forces fit best.
        value: f64 = one.value,
        /// The smallest value that fits nearly as well.
        low: f64 = one.nearly_as_good.0,
        /// The largest value that fits nearly as well.
        high: f64 = one.nearly_as_good.1,
        /// Whether the value is at a bound of the search.
        at_bound: bool = one.at_bound,
        /// Whether the model gets the value: not where the recordings do not determine it, nor the floor of a further trial.
        written: bool = one.is_written,
    }

    /// The correlation of two fitted parameters.
    CorrelationRecord from (names, value): &([String; 2], f64) {
        /// Name of the one parameter.
        first: String = names[0].clone(),
        /// Name of the other parameter.
        second: String = names[1].clone(),
        /// The correlation; null where one of them is at its bound.
        value: Option<f64> = Some(*value).filter(|value| value.is_finite()),
    }

    /// One number that changes, or one centre that moves.
    ChangeRecord from change: &NumberChange {
        /// Name of the force; null for a sphere's radius and location.
        force: Option<String> = change.force.clone(),
        /// Component path of the force or sphere.
        path: String = change.path.clone(),
        /// Number of the `ContactParameters`, where there are several.
        set: Option<usize> = change.set,
        /// Name of the sphere whose radius or location changes.
        sphere: Option<String> = change.sphere.clone(),
        /// OpenSim's name of the property that changes.
        property: &'static str = change.name(),
        /// Effective value now, in OpenSim's unit.
        from: Amount = change.radii_m.map_or(Amount::Number(change.from), |[old, _]| Amount::Location(old)),
        /// Value that is written.
        to: Amount = change.radii_m.map_or(Amount::Number(change.to), |[_, new]| Amount::Location(new)),
        /// The factor by which the value was multiplied, where it was.
        factor: Option<f64> = change.factor,
        /// Number of the equation in the paper, or a word where there is none.
        equation: &'static str = change.by.as_str(),
        /// Line of the number, or of the object that gets it.
        line: usize = change.line,
        /// Whether the element was absent and is inserted.
        inserted: bool = change.inserted,
    }
}

/// A number, or the three of a location or of an ellipsoid's radii in m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Amount {
    /// A number; null where it is not finite.
    Number(#[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))] f64),
    /// A location, or radii, in m; null where one is not finite.
    Location(#[cfg_attr(feature = "schemas", schemars(with = "[Option<f64>; 3]"))] [f64; 3]),
}

impl PlanRecord {
    /// The record of the plan for `model`, whose file is `path`, with the names of the files that were written, if any. The texts of the
    /// plan are already in the words of the front end.
    pub fn new(
        plan: &Plan,
        model: &Model,
        path: &Path,
        output: Option<&Path>,
        geometry_output: Option<&Path>,
    ) -> Self {
        (plan, model, path, output, geometry_output).into()
    }
}

/// The objects that a plan adds or removes.
fn object_records(plan: &Plan) -> Vec<ObjectRecord> {
    let new = plan.new_spheres();
    let new: HashMap<&str, &NewSphere<'_>> = new.iter().map(|sphere| (sphere.path, sphere)).collect();
    let sphere = |object: &ObjectChange| {
        new.get(object.path.as_str()).copied().filter(|_| object.action == ObjectAction::Added)
    };
    plan.objects().iter().map(|object| (object, sphere(object)).into()).collect()
}

fn parameters_by_name(object: &ObjectChange) -> Option<BTreeMap<&'static str, f64>> {
    let parameters = object.parameters.iter();
    let parameters = parameters.map(|(property, value)| (property.as_str(), *value)).collect();
    (!object.parameters.is_empty()).then_some(parameters)
}

impl From<&PlaceChange> for ChangeRecord {
    fn from(moved: &PlaceChange) -> Self {
        Self {
            force: None,
            path: moved.path.clone(),
            set: None,
            sphere: Some(moved.geometry.clone()),
            property: "location",
            from: Amount::Location(moved.from),
            to: Amount::Location(moved.to),
            factor: None,
            equation: moved.by.as_str(),
            line: moved.line,
            inserted: moved.inserted,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn a_line_has_no_letter_that_is_not_seen_and_reads_back_the_same() {
        // A line end, ESC, C1's CSI, a mark that turns the direction, one beyond 16 bits, and letters that stay.
        let text = "a\nb\u{1b}\u{7f}\u{9b}\u{202e}\u{e0001} Füße x\u{302} \"\\";
        let written = line(&text);
        assert!(
            written.chars().all(|letter| letter == '\n' || osim_model::messages::is_visible(letter)),
            "{written:?}"
        );
        assert_eq!(written.matches('\n').count(), 1);
        assert!(written.contains("Füße x\u{302}"));
        assert_eq!(serde_json::from_str::<String>(&written).unwrap(), text);
    }
}
