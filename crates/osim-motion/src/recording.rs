//! Makes values and speeds of all coordinates of a model from a table, with a low-pass filter on request.

use butterworth::{Cutoff, Filter};
use gcv_spline::GcvSpline;
use osim_model::Model;
use osim_model::feet::{Coupler, Couplers};
use osim_model::messages::counted;

use crate::coordinates::{
    CoordinateColumns, CoordinateKind, ModelCoordinate, columns_by_coordinate, model_coordinates,
};
use crate::table::{AngleUnit, MotionFault, Table};

/// The smallest number of rows for a quintic spline.
const LEAST_ROWS: usize = 6;
/// The largest number of rounds in which couplers that depend on each other are applied.
const MOST_COUPLER_PASSES: usize = 8;
/// Largest angle, rad, that is plausible in radians; if a file has larger angles, its unit is in doubt.
const LARGEST_PLAUSIBLE_ANGLE_RAD: f64 = std::f64::consts::TAU;

/// An angle is far outside its range by more than this, rad: right motions are not, in most frames.
const FAR_OUTSIDE_RAD: f64 = 0.0873;

/// Nothing turns or moves as far as this between two rows, rad or m, and as fast, rad/s or m/s.
const JUMP: (f64, f64) = (0.5, 50.0);

/// The options with which a motion file is read.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RecordingOptions {
    /// The unit of angles; `None`: the unit that the file declares.
    pub angles: Option<AngleUnit>,
    /// The unit that OpenSim assumes if the file declares none: degrees for a `.mot`, radians for a `.sto`.
    pub undeclared: Option<AngleUnit>,
    /// Cutoff of a zero-lag Butterworth low-pass filter of 4th order for the values, Hz. Speeds are then derivatives of the values.
    pub low_pass_hz: Option<f64>,
}

/// Values and speeds of all coordinates of a model in each frame.
#[derive(Debug, Clone)]
pub struct Recording {
    pub time_s: Vec<f64>,
    /// The coordinates of all joints, in the order of the joints.
    pub coordinates: Vec<ModelCoordinate>,
    pub facts: RecordingFacts,
    /// Value of the coordinate in each frame, rad or m.
    values: Vec<f64>,
    /// Speed of the coordinate in each frame, rad/s or m/s.
    speeds: Vec<f64>,
    /// For each joint, whether its speeds are OpenSim's generalised speeds; if not, they are derivatives of the values.
    pub(crate) has_opensim_speeds: Vec<bool>,
}

/// Facts about the reading of a recording, for reports.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordingFacts {
    pub angles: AngleUnit,
    /// Whether the file or the caller gives the unit of angles.
    pub declared: bool,
    /// Names of columns without a coordinate, as in the file.
    pub unused: Vec<String>,
    /// Coordinates without a column: they have their default value, or the value of the function that prescribes them.
    pub kept: Vec<String>,
    /// Angles that are far outside the range of their coordinate in most frames.
    pub outside: Vec<String>,
    /// The first coordinate that jumps, and the time before, s.
    pub jump: Option<(String, f64)>,
    /// Coordinates that a coupler computes from other coordinates.
    pub coupled: Vec<String>,
    /// Constraints of the model that this program ignores.
    pub unenforced: Vec<String>,
}

impl Recording {
    /// Reads the coordinates of `model` from `table`.
    ///
    /// # Errors
    /// No column of a coordinate; angles whose unit is in doubt; a missing number; too few rows for speeds; or rows at
    /// unequal distances in time, if they are to be filtered.
    pub fn of(model: &Model, table: &Table, options: &RecordingOptions) -> Result<Self, MotionFault> {
        let joints = model.joints();
        let coordinates = model_coordinates(model, joints);
        let (columns, unused) = columns_by_coordinate(&coordinates, table);
        if columns.iter().all(|column| column.value.is_none()) {
            return Err(no_column_fits(&coordinates, table));
        }
        let angles = angle_unit(&coordinates, &columns, table, options)?;
        // Coordinates without a column have speed 0.
        let has_speed = |columns: &CoordinateColumns<'_>| columns.value.is_none() || columns.speed.is_some();
        let are_given = |columns: &[CoordinateColumns<'_>]| {
            options.low_pass_hz.is_none() && columns.iter().all(has_speed)
        };
        let mut recording = Self {
            time_s: table.time_s.clone(),
            facts: RecordingFacts {
                angles,
                declared: options.angles.or(table.declared).is_some(),
                unused,
                kept: Vec::new(),
                outside: Vec::new(),
                jump: None,
                coupled: Vec::new(),
                unenforced: Vec::new(),
            },
            values: vec![0.0; table.rows() * coordinates.len()],
            speeds: vec![0.0; table.rows() * coordinates.len()],
            has_opensim_speeds: Vec::new(),
            coordinates,
        };
        let mut start = 0;
        for joint in joints {
            let end = start + joint.coordinates.len();
            let of_joint = columns.get(start..end).unwrap_or_default();
            let given = are_given(of_joint);
            recording.has_opensim_speeds.push(given && !of_joint.is_empty());
            for (index, columns) in (start..end).zip(of_joint) {
                recording.read_coordinate(table, index, columns, given, options)?;
            }
            start = end;
        }
        recording.apply_couplers(Couplers::of(model))?;
        recording.facts.outside = recording.outside_ranges();
        recording.facts.jump = recording.first_jump();
        Ok(recording)
    }

    /// The first coordinate that jumps, and the time before, s.
    fn first_jump(&self) -> Option<(String, f64)> {
        let (least, least_rate) = JUMP;
        let jump = |(index, coordinate): (usize, &ModelCoordinate)| {
            let by = |frame: usize| (self.values(frame)[index] - self.values(frame - 1)[index]).abs();
            let step_s = |frame: usize| self.time_s[frame] - self.time_s[frame - 1];
            let mut frames = 1..self.frames();
            let frame = frames.find(|&frame| by(frame) > f64::max(least, least_rate * step_s(frame)))?;
            Some((coordinate.name.clone(), self.time_s[frame - 1]))
        };
        self.coordinates.iter().enumerate().find_map(jump)
    }

    /// The names of measured angles that are far outside the range of their coordinate in most frames.
    fn outside_ranges(&self) -> Vec<String> {
        let is_outside = |(index, coordinate): &(usize, &ModelCoordinate)| {
            let is_angle = coordinate.kind == CoordinateKind::Rotational;
            let is_measured = is_angle && !self.facts.kept.contains(&coordinate.name);
            let Some([least, most]) = coordinate.range.filter(|_| is_measured) else { return false };
            let usual = least - FAR_OUTSIDE_RAD..=most + FAR_OUTSIDE_RAD;
            let values = (0..self.frames()).map(|frame| self.values(frame)[*index]);
            // A body may walk in any direction: only with the other sign does a wrong angle fit.
            let outside = values.filter(|value| !usual.contains(value) && usual.contains(&-value));
            2 * outside.count() > self.frames()
        };
        let outside = self.coordinates.iter().enumerate().filter(is_outside);
        outside.map(|(_, coordinate)| coordinate.name.clone()).collect()
    }

    /// The number of frames.
    pub fn frames(&self) -> usize {
        self.time_s.len()
    }

    /// The values of all coordinates in a frame, rad or m.
    pub fn values(&self, frame: usize) -> &[f64] {
        row_of_frame(&self.values, frame, self.coordinates.len())
    }

    /// The speeds of all coordinates in a frame, rad/s or m/s. For joints with `has_opensim_speeds` they are OpenSim's generalised
    /// speeds, for other joints derivatives of the values.
    pub fn speeds(&self, frame: usize) -> &[f64] {
        row_of_frame(&self.speeds, frame, self.coordinates.len())
    }

    /// One frame in which all coordinates have their default values.
    pub(crate) fn default_pose(&self, couplers: &Couplers) -> Result<Self, MotionFault> {
        let mut pose = self.clone();
        pose.time_s.truncate(1);
        pose.values = self.coordinates.iter().map(|one| one.default.unwrap_or_default()).collect();
        pose.speeds = vec![0.0; pose.values.len()];
        pose.apply_couplers(couplers)?;
        Ok(pose)
    }

    /// The recording after `change` of the values and speeds of each frame; dependent coordinates follow.
    pub(crate) fn changed(
        &self,
        couplers: &Couplers,
        mut change: impl FnMut(usize, &mut [f64], &mut [f64]),
    ) -> Result<Self, MotionFault> {
        let mut changed = self.clone();
        let count = self.coordinates.len();
        let speeds = changed.speeds.chunks_exact_mut(count);
        for (frame, (values, speeds)) in changed.values.chunks_exact_mut(count).zip(speeds).enumerate() {
            change(frame, values, speeds);
        }
        changed.apply_couplers(couplers)?;
        Ok(changed)
    }

    /// Every frame whose number is a multiple of `step`.
    pub(crate) fn thinned(&self, step: usize) -> Self {
        let count = self.coordinates.len().max(1);
        let thinned =
            |all: &[f64]| -> Vec<f64> { all.chunks_exact(count).step_by(step).flatten().copied().collect() };
        let time_s = self.time_s.iter().copied().step_by(step).collect();
        Self { time_s, values: thinned(&self.values), speeds: thinned(&self.speeds), ..self.clone() }
    }

    /// The recording with the speeds that OpenSim computes from the values of coordinates whose values `have_changed`.
    pub(crate) fn with_splined_speeds(
        mut self,
        couplers: &Couplers,
        have_changed: impl Fn(&usize) -> bool,
    ) -> Result<Self, MotionFault> {
        let count = self.coordinates.len();
        for index in (0..count).filter(have_changed) {
            let values: Vec<f64> = self.values.iter().skip(index).step_by(count).copied().collect();
            let speeds = splined(&self.time_s, &values, 1, &self.coordinates[index].name)?;
            self.set_coordinate(index, &values, &speeds);
        }
        self.has_opensim_speeds.fill(false);
        self.apply_couplers(couplers)?;
        Ok(self)
    }

    /// The accelerations of all coordinates, as OpenSim computes them from the values: those of the first frame, then of the next.
    pub(crate) fn splined_accelerations(&self) -> Result<Vec<f64>, MotionFault> {
        let count = self.coordinates.len();
        let mut all = vec![0.0; self.values.len()];
        for (index, coordinate) in self.coordinates.iter().enumerate() {
            let values: Vec<f64> = self.values.iter().skip(index).step_by(count).copied().collect();
            let accelerations = splined(&self.time_s, &values, 2, &coordinate.name)?;
            let places = all.iter_mut().skip(index).step_by(count);
            places.zip(accelerations).for_each(|(place, value)| *place = value);
        }
        Ok(all)
    }

    /// Reads one coordinate from its column; without one it has its prescribed value or its default.
    fn read_coordinate(
        &mut self,
        table: &Table,
        index: usize,
        columns: &CoordinateColumns<'_>,
        given: bool,
        options: &RecordingOptions,
    ) -> Result<(), MotionFault> {
        let Some(coordinate) = self.coordinates.get(index) else { return Ok(()) };
        let (name, label) = (coordinate.name.clone(), format!("{}/{}", coordinate.joint, coordinate.name));
        let unit = match coordinate.kind {
            CoordinateKind::Rotational => self.facts.angles.radians(),
            _ => 1.0,
        };
        let in_si = |values: &[f64]| -> Vec<f64> { values.iter().map(|value| value * unit).collect() };
        let Some(column) = columns.value else {
            let (values, speeds): (Vec<f64>, Vec<f64>) = match &coordinate.prescribed {
                Some(Some(function)) => {
                    let at = |time: &f64| (function.value(*time), function.slope(*time));
                    self.time_s.iter().map(at).unzip()
                }
                Some(None) => (vec![f64::NAN; table.rows()], vec![f64::NAN; table.rows()]),
                None => (vec![coordinate.default.unwrap_or(f64::NAN); table.rows()], vec![0.0; table.rows()]),
            };
            self.facts.kept.push(name);
            self.set_coordinate(index, &values, &speeds);
            return Ok(());
        };
        table.check_finite(column)?;
        let mut values = in_si(&column.values);
        if let Some(cutoff_hz) = options.low_pass_hz {
            values = low_pass(table, &values, cutoff_hz)?;
        }
        let speeds = match columns.speed.filter(|_| given) {
            Some(column) => {
                table.check_finite(column)?;
                in_si(&column.values)
            }
            None => splined(&table.time_s, &values, 1, &label)?,
        };
        self.set_coordinate(index, &values, &speeds);
        Ok(())
    }

    /// Sets the values and speeds of one coordinate in all frames.
    fn set_coordinate(&mut self, index: usize, values: &[f64], speeds: &[f64]) {
        let count = self.coordinates.len();
        let places = self.values.iter_mut().skip(index).step_by(count);
        places.zip(values).for_each(|(place, value)| *place = *value);
        let places = self.speeds.iter_mut().skip(index).step_by(count);
        places.zip(speeds).for_each(|(place, speed)| *place = *speed);
    }

    /// Computes the coordinates that couplers make depend on others, and overwrites their values in the file.
    fn apply_couplers(&mut self, couplers: &Couplers) -> Result<(), MotionFault> {
        self.facts.unenforced = couplers.unknown.iter().map(ToString::to_string).collect();
        let place = |name: &str| self.coordinates.iter().position(|coordinate| coordinate.name == name);
        let mut applied: Vec<(&Coupler, usize, usize)> = Vec::new();
        for coupler in &couplers.couplers {
            let Some((from, to)) = place(&coupler.independent).zip(place(&coupler.dependent)) else {
                continue;
            };
            if coupler.value_and_slope(0.0).is_none() {
                let (one, other) = (&coupler.dependent, &coupler.independent);
                let text = "the function of their coupler is not understood";
                let text = format!("it is not known how coordinate {one} follows from {other}: {text}");
                return Err(MotionFault::new(text));
            }
            applied.push((coupler, from, to));
        }
        self.facts.coupled = applied.iter().map(|(coupler, ..)| coupler.dependent.clone()).collect();
        self.facts.kept.retain(|name| !self.facts.coupled.contains(name));
        if applied.is_empty() {
            return Ok(());
        }
        let count = self.coordinates.len();
        for (values, speeds) in self.values.chunks_exact_mut(count).zip(self.speeds.chunks_exact_mut(count)) {
            for _ in 0..MOST_COUPLER_PASSES {
                let mut changed = false;
                for (coupler, from, to) in &applied {
                    let Some((follows, slope)) = coupler.value_and_slope(values[*from]) else { continue };
                    let next = (follows, slope * speeds[*from]);
                    changed |= (values[*to], speeds[*to]) != next;
                    (values[*to], speeds[*to]) = next;
                }
                if !changed {
                    break;
                }
            }
        }
        Ok(())
    }
}

/// The numbers of one frame among those of all frames.
fn row_of_frame(all: &[f64], frame: usize, count: usize) -> &[f64] {
    all.get(frame * count..(frame + 1) * count).unwrap_or_default()
}

/// The error that no column of the table is a coordinate of the model.
fn no_column_fits(coordinates: &[ModelCoordinate], table: &Table) -> MotionFault {
    let listed = |names: Vec<&str>| {
        let shown = names.iter().take(5).map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
        if names.len() > 5 { format!("{shown}, ...") } else { shown }
    };
    let (columns, names) = (
        listed(table.columns.iter().map(|column| column.name.as_str()).collect()),
        listed(coordinates.iter().map(|coordinate| coordinate.name.as_str()).collect()),
    );
    MotionFault::new(format!(
        "none of its columns ({columns}) is a coordinate of the model ({names}): is it the motion of this model, \
         not the plates?"
    ))
}

/// The unit of angles: from the caller, else from the file, else the unit that OpenSim assumes. An error if the numbers
/// contradict it.
fn angle_unit(
    coordinates: &[ModelCoordinate],
    columns: &[CoordinateColumns<'_>],
    table: &Table,
    options: &RecordingOptions,
) -> Result<AngleUnit, MotionFault> {
    if let Some(unit) = options.angles.or(table.declared) {
        return Ok(unit);
    }
    let assumed = match (table.has_version, options.undeclared) {
        (false, Some(unit)) => unit,
        _ => AngleUnit::Radians,
    };
    let angles = coordinates.iter().zip(columns);
    let angles = angles.filter(|(coordinate, _)| coordinate.kind == CoordinateKind::Rotational);
    let mut largest: Option<(f64, &str)> = None;
    for column in angles.filter_map(|(_, columns)| columns.value) {
        let most = column.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if largest.is_none_or(|(value, _)| most > value) {
            largest = Some((most, &column.name));
        }
    }
    match (largest, assumed) {
        (Some((value, name)), AngleUnit::Radians) if value > LARGEST_PLAUSIBLE_ANGLE_RAD => {
            Err(MotionFault::about_angle_unit(format!(
                "its header does not say whether angles are in degrees or radians. OpenSim takes them for radians, but column '{name}' \
             goes to {value}, more than a full turn"
            )))
        }
        (Some((value, name)), AngleUnit::Degrees) if value > 0.0 && value <= LARGEST_PLAUSIBLE_ANGLE_RAD => {
            Err(MotionFault::about_angle_unit(format!(
                "its header does not say whether angles are in degrees or radians. OpenSim takes them for degrees, but the largest angle, \
             {value} in column '{name}', would be a small movement"
            )))
        }
        _ => Ok(assumed),
    }
}

/// Derivatives of this order of the natural quintic spline through all rows, as OpenSim's tools compute them.
fn splined(time_s: &[f64], values: &[f64], order: usize, label: &str) -> Result<Vec<f64>, MotionFault> {
    if time_s.len() < LEAST_ROWS {
        return Err(MotionFault::new(format!(
            "it has {}: speeds follow from a spline through at least {LEAST_ROWS}, or from columns such as /jointset/{label}/speed",
            counted(time_s.len(), "row")
        )));
    }
    // Woltring's spline takes vectors.
    let (times, points) = (time_s.to_vec(), values.to_vec());
    let spline = GcvSpline::from_data(&times, &points)
        .map_err(|_| MotionFault::new(format!("no spline goes through the values of {label}")))?;
    Ok(spline.derivative(&times, order))
}

// The low-pass filter of movement analysis.

/// The order of the filter in one direction. It runs forward and backward, so that it delays nothing and has order 4 in total.
const FILTER_ORDER: usize = 2;
/// The number of rows that the filter mirrors at both ends; a table needs at least one row more.
const MIRRORED_ROWS: usize = 3 * FILTER_ORDER;

/// `values` after a zero-lag Butterworth low-pass filter of 4th order; `table` gives the times of the rows.
///
/// # Errors
/// Rows at unequal distances in time, or too few rows, or rows too far apart, for the cutoff.
fn low_pass(table: &Table, values: &[f64], cutoff_hz: f64) -> Result<Vec<f64>, MotionFault> {
    let Some(step_s) = table.even_step_s() else {
        return Err(MotionFault::new("its times are not equally far apart: a filter needs rows that are"));
    };
    let rate_hz = 1.0 / step_s;
    if !(cutoff_hz > 0.0 && cutoff_hz < rate_hz / 2.0) {
        let (rate, half) = (three_decimals(rate_hz), three_decimals(rate_hz / 2.0));
        let text =
            format!("it has {rate} rows a second: a cutoff is above 0 and below half of that, {half} Hz");
        return Err(MotionFault::new(format!("{text}, and not {} Hz", short_number(cutoff_hz))));
    }
    let too_few = || MotionFault::new(format!("its {} rows are too few for a filter", values.len()));
    if values.len() <= MIRRORED_ROWS {
        return Err(too_few());
    }
    let filter = Filter::new(FILTER_ORDER, rate_hz, Cutoff::LowPass(cutoff_hz));
    let filtered = filter.and_then(|filter| filter.bidirectional(&values.to_vec()));
    let filtered = filtered.map_err(|_| too_few())?;
    if !filtered.iter().all(|value| value.is_finite()) {
        let (cutoff, rows) = (short_number(cutoff_hz), values.len());
        return Err(MotionFault::new(format!("a cutoff of {cutoff} Hz is too low for its {rows} rows")));
    }
    Ok(filtered)
}

/// A number for messages; very large and very small numbers in exponential form.
fn short_number(value: f64) -> String {
    if (1e-6..1e9).contains(&value) { value.to_string() } else { format!("{value:e}") }
}

/// A number for messages, rounded to three decimals like the times in a file.
fn three_decimals(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table_with_rows(rows: usize) -> Table {
        let times = (0..rows).map(|row| row as f64 / 100.0).collect();
        Table::from_times(times).unwrap()
    }

    /// A cosine of 2 Hz passes a cutoff of 6 Hz, and a cosine of 30 Hz does not.
    #[test]
    fn slow_movement_passes_and_fast_does_not() {
        let wave = |hertz: f64| -> Vec<f64> {
            (0..200).map(|row| (std::f64::consts::TAU * hertz * f64::from(row) / 100.0).cos()).collect()
        };
        let (slow, fast) = (
            low_pass(&table_with_rows(200), &wave(2.0), 6.0).unwrap(),
            low_pass(&table_with_rows(200), &wave(30.0), 6.0).unwrap(),
        );
        // Twice through |H|² = 1/(1 + (tan(π f/fs)/tan(π fc/fs))⁴), nothing delayed.
        let gain = |hertz: f64| {
            let tangent = |f: f64| (std::f64::consts::PI * f / 100.0).tan();
            1.0 / (1.0 + (tangent(hertz) / tangent(6.0)).powi(4))
        };
        assert!((slow[100] - gain(2.0) * wave(2.0)[100]).abs() < 1e-6, "{}", slow[100]);
        assert!((fast[100] - gain(30.0) * wave(30.0)[100]).abs() < 1e-6, "{}", fast[100]);
    }

    #[test]
    fn a_filter_needs_enough_rows_at_equal_distances() {
        assert!(low_pass(&table_with_rows(6), &[0.0; 6], 6.0).is_err());
        assert!(low_pass(&table_with_rows(7), &[0.0; 7], 6.0).is_ok());
        assert!(low_pass(&table_with_rows(20), &[0.0; 20], 50.0).is_err());
        let uneven = Table::from_times(vec![0.0, 0.1, 0.3]).unwrap();
        assert!(low_pass(&uneven, &[0.0; 3], 1.0).is_err());
    }
}
