//! Contacts along a motion: in words, as tables, and as files for OpenSim.

use std::ops::Range;
use std::path::{Path, PathBuf};

use osim_model::messages::{Dialect, four_significant, readable, shortest, shown};
use osim_model::{DVec3, Side};
use osim_motion::correct::Correction;
use osim_motion::{
    CORRECTED_HEADER_LINE, Comparison, ContactPair, ContactState, SphereSummary, TOUCH_DOWN_BW,
    TouchedSurface, Wrench,
};
use osim_planning::{MotionRemark, MotionResult};

use crate::report::layout::{WIDTH, table, wrapped};
pub use crate::report::results::motion_record::{
    MotionComparisonRecord, MotionFootRecord, MotionRecord, MotionRemarkRecord, MotionSphereRecord,
    MotionStanceRecord, MotionTouchDownRecord,
};

// A motion in words, with figures of each foot and sphere.

/// The summary of contacts along a motion: sentences, then tables.
pub fn motion_text(
    result: &MotionResult,
    remarks: &[MotionRemark],
    dialect: &dyn Dialect,
    columns: Option<usize>,
) -> String {
    let states = &result.states;
    let (first, last) = (states.time_s.first().copied(), states.time_s.last().copied());
    let mut text = format!(
        "{}, {}: {} frames from {} to {} s, {} kg, {} m/s2\n\n",
        result.opened.name(),
        result.motion,
        states.frames(),
        readable(first.unwrap_or_default()),
        readable(last.unwrap_or_default()),
        readable(result.mass_kg),
        readable(result.gravity_m_s2)
    );
    for remark in remarks {
        let is_result = ["foot", "consistency", "agree", "large-correction", "disagree", "horizontal-error"];
        let mark = if is_result.contains(&remark.code) { "" } else { "remark: " };
        text.push_str(&wrapped(
            &format!("{mark}{}", remark.message.spelled(dialect)),
            "",
            columns.unwrap_or(WIDTH),
        ));
        text.push('\n');
    }
    text.push_str(&table_of_feet(result, columns));
    text.push('\n');
    text.push_str(&table_of_spheres(result, columns));
    text.push('\n');
    for sentence in [stress_in_words(result), loss_in_words(result)].into_iter().flatten() {
        text.push_str(&wrapped(&sentence, "", columns.unwrap_or(WIDTH)));
    }
    text
}

/// The largest stress under a sphere, in words.
fn stress_in_words(result: &MotionResult) -> Option<String> {
    let spheres = result.summary.feet.iter().flat_map(|foot| &foot.spheres);
    let stresses = spheres.filter_map(|sphere| Some((sphere, sphere.largest_stress_n_m2?)));
    let (sphere, (mean, time_s)) = stresses.max_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    let name = result.opened.model.sphere(result.states.pairs.get(sphere.pair)?.sphere)?.name.as_str();
    Some(format!(
        "largest mean stress on a contact patch (15): {} kPa ({}, {time_s:.3} s); at its middle, by Hertz, {}",
        four_significant(mean / 1e3),
        shown(name),
        four_significant(1.5 * mean / 1e3)
    ))
}

/// The energy that the contacts of each foot take up in a stride, in words.
fn loss_in_words(result: &MotionResult) -> Option<String> {
    let feet = result.summary.feet.iter();
    let lost = feet.filter_map(|foot| {
        Some(format!("{} {} J", shown(&foot.foot.name), four_significant(foot.lost_in_stride_j?)))
    });
    let lost: Vec<String> = lost.collect();
    (!lost.is_empty())
        .then(|| format!("energy lost by contacts and friction in a stride: {}", lost.join(", ")))
}

fn table_of_feet(result: &MotionResult, columns: Option<usize>) -> String {
    let (headings, rows) = motion_feet(result);
    let mut all = table(&headings);
    for row in rows {
        all.add_row(row);
    }
    all.right_aligned(&(1..headings.len()).collect::<Vec<_>>());
    format!("{}\n", all.into_lines(columns))
}

/// The headers and the rows of the table of feet: a row for each foot, and a row for all feet together.
pub(crate) fn motion_feet(result: &MotionResult) -> (Vec<&'static str>, Vec<Vec<String>>) {
    let weight_n = result.summary.weight_n;
    let bw = |force_n: f64| format!("{:.3}", force_n / weight_n);
    let with_plates = result.measured.is_some();
    let mut columns = vec!["foot", "stances", "peak, BW"];
    if with_plates {
        columns.extend(["plates, BW", "rms, N", "rms, BW", "COP, mm"]);
    }
    let mut rows = Vec::new();
    let mut add = |name: &str, stances: Option<usize>, peak_n: f64, comparison: Option<&Comparison>| {
        let stances = stances.map(|count| count.to_string()).unwrap_or_default();
        // If there are plates, only the frames count in which they measured.
        let peak_n = comparison.map_or(peak_n, |one| one.peak_n);
        let mut row = vec![shown(name).to_string(), stances, bw(peak_n)];
        if with_plates {
            let cell = |value: Option<String>| value.unwrap_or_else(|| "-".to_owned());
            row.push(cell(comparison.map(|one| bw(one.measured_peak_n))));
            row.push(cell(comparison.map(|one| format!("{:.0}", one.normal_rms_n))));
            row.push(cell(comparison.map(|one| bw(one.normal_rms_n))));
            row.push(cell(
                comparison.and_then(|one| one.cop_rms_m).map(|cop_m| format!("{:.0}", 1e3 * cop_m)),
            ));
        }
        rows.push(row);
    };
    for foot in &result.summary.feet {
        add(&foot.foot.name, Some(foot.stances.len()), foot.peak_n, foot.comparison.as_ref());
    }
    add("all feet", None, result.summary.peak_n, result.summary.comparison.as_ref());
    (columns, rows)
}

fn table_of_spheres(result: &MotionResult, columns: Option<usize>) -> String {
    let headings = "sphere|peak, N|x/R|at, s|x/R > 0.16, s|slip, m/s|impact, m/s|restitution";
    let mut all = table(&headings.split('|').collect::<Vec<_>>());
    for foot in &result.summary.feet {
        for sphere in &foot.spheres {
            all.add_row(sphere_row(result, sphere));
        }
    }
    all.right_aligned(&[1, 2, 3, 4, 5, 6, 7]);
    format!("{}\n", all.into_lines(columns))
}

fn sphere_row(result: &MotionResult, sphere: &SphereSummary) -> Vec<String> {
    let pair = result.states.pairs.get(sphere.pair);
    let name =
        pair.and_then(|pair| result.opened.model.sphere(pair.sphere)).map(|sphere| sphere.name.as_str());
    let fastest = sphere.touch_downs.iter().max_by(|a, b| a.impact_speed_m_s.total_cmp(&b.impact_speed_m_s));
    let cell = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3}"));
    vec![
        shown(name.unwrap_or_default()).to_string(),
        format!("{:.0}", sphere.peak_n),
        format!("{:.3}", sphere.largest_relative_indentation),
        format!("{:.3}", sphere.largest_at_s),
        format!("{:.3}", sphere.beyond_hertz_s),
        cell(sphere.slip_m_s),
        cell(fastest.map(|touch| touch.impact_speed_m_s)),
        cell(fastest.and_then(|touch| touch.restitution)),
    ]
}

// One row per frame, sphere and force: as columns, and as CSV.

/// A column of the table of a motion, with a value for each row.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionColumn {
    /// Name of the column. It ends in the unit, if the values have one.
    pub name: &'static str,
    pub cells: MotionCells,
}

/// The values of one column in the table of a motion.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionCells {
    Numbers(Vec<f64>),
    Texts(Vec<String>),
    /// For each row, true or false.
    Flags(Vec<bool>),
}

/// A function that computes the number of a row.
type NumberOfRow = fn(&ContactPair, &ContactState) -> f64;

/// The columns with numbers, after the columns for time, sphere and body.
const NUMBER_COLUMNS: [(&str, NumberOfRow); 15] = [
    ("centre_x_m", |_, state| state.centre_m[0]),
    ("centre_y_m", |_, state| state.centre_m[1]),
    ("centre_z_m", |_, state| state.centre_m[2]),
    ("velocity_x_m_s", |_, state| state.velocity_m_s[0]),
    ("velocity_y_m_s", |_, state| state.velocity_m_s[1]),
    ("velocity_z_m_s", |_, state| state.velocity_m_s[2]),
    ("indentation_m", |_, state| state.indentation_m),
    ("relative_indentation", |pair, state| state.indentation_m / pair.radius_m),
    ("force_x_n", |_, state| state.force_n[0]),
    ("force_y_n", |_, state| state.force_n[1]),
    ("force_z_n", |_, state| state.force_n[2]),
    ("point_x_m", |_, state| state.point_m[0]),
    ("point_y_m", |_, state| state.point_m[1]),
    ("point_z_m", |_, state| state.point_m[2]),
    ("slip_speed_m_s", |_, state| state.slip_speed_m_s()),
];

/// The table of a motion by columns. It has a row for each sphere on each plane in each frame.
pub fn motion_columns(result: &MotionResult) -> Vec<MotionColumn> {
    let (states, model) = (&result.states, &result.opened.model);
    let sphere =
        |pair: &ContactPair| model.sphere(pair.sphere).map(|sphere| sphere.name.clone()).unwrap_or_default();
    let force =
        |pair: &ContactPair| model.force(pair.force).map(|force| force.name.clone()).unwrap_or_default();
    let touched = |pair: &ContactPair| match pair.touched {
        TouchedSurface::Plane(plane) => {
            states.planes.get(plane).map(|plane| plane.name.clone()).unwrap_or_default()
        }
        TouchedSurface::Sphere(other) => {
            model.sphere(other).map(|other| other.name.clone()).unwrap_or_default()
        }
    };
    let side = |pair: &ContactPair| {
        let side = Side::of_name(&pair.body).or_else(|| Side::of_name(&sphere(pair)));
        side.map_or("", Side::as_str).to_owned()
    };
    let frames = states.frames();
    let repeated = |text: &dyn Fn(&ContactPair) -> String| {
        let once: Vec<String> = states.pairs.iter().map(text).collect();
        MotionCells::Texts((0..frames).flat_map(|_| once.iter().cloned()).collect())
    };
    let times = states.time_s.iter().flat_map(|&time_s| states.pairs.iter().map(move |_| time_s)).collect();
    let numbers = NUMBER_COLUMNS.iter().map(|(name, number)| {
        let of_frame = |frame: usize| {
            // Adding 0 removes the sign of a negative zero.
            states.pairs.iter().zip(states.frame(frame)).map(|(pair, state)| number(pair, state) + 0.0)
        };
        MotionColumn { name, cells: MotionCells::Numbers((0..frames).flat_map(of_frame).collect()) }
    });
    let applies = (0..frames).flat_map(|_| states.pairs.iter().map(|pair| pair.applies)).collect();
    let column = |name, cells| MotionColumn { name, cells };
    [
        column("time_s", MotionCells::Numbers(times)),
        column("sphere", repeated(&sphere)),
        column("body", repeated(&|pair| pair.body.clone())),
    ]
    .into_iter()
    .chain(numbers)
    .chain([
        column("side", repeated(&side)),
        column("force", repeated(&force)),
        column("plane", repeated(&touched)),
        column("applies", MotionCells::Flags(applies)),
    ])
    .collect()
}

/// The table of a motion as CSV. Numbers have the fewest digits that read back exactly.
///
/// # Errors
/// Never, for text in memory.
pub fn motion_csv(result: &MotionResult) -> Result<String, csv::Error> {
    let columns = motion_columns(result);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns.iter().map(|column| column.name))?;
    for row in 0..result.states.frames() * result.states.pairs.len() {
        writer.write_record(columns.iter().map(|column| column.cells.text(row)))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

impl MotionCells {
    fn text(&self, row: usize) -> String {
        match self {
            Self::Numbers(numbers) => numbers.get(row).copied().map(shortest).unwrap_or_default(),
            Self::Texts(texts) => texts.get(row).cloned().unwrap_or_default(),
            Self::Flags(flags) => flags.get(row).map(bool::to_string).unwrap_or_default(),
        }
    }
}

// The ground reactions of a model as OpenSim reads them: a table, and which of its columns act on which body.

/// The contact forces on one body.
struct BodyLoad {
    body: String,
    /// The part of the column names between `ground_force_` and `_vx`.
    label: String,
    pairs: Vec<usize>,
}

/// The bodies that contacts press on, with their contact forces. A foot with a single body is called by its side.
fn loads_on_bodies(result: &MotionResult) -> Vec<BodyLoad> {
    let mut loads: Vec<BodyLoad> = Vec::new();
    for foot in &result.summary.feet {
        for body in &foot.foot.bodies {
            let is_own = |pair: &usize| result.states.pairs.get(*pair).is_some_and(|pair| &pair.body == body);
            let side = match (foot.foot.side, foot.foot.bodies.len()) {
                (Some(Side::Right), 1) => Some("r"),
                (Some(Side::Left), 1) => Some("l"),
                _ => None,
            };
            let label = match side.filter(|side| loads.iter().all(|load| load.label != *side)) {
                Some(side) => side.to_owned(),
                None => body.clone(),
            };
            let pairs = foot.foot.pairs.iter().copied().filter(is_own).collect();
            loads.push(BodyLoad { body: body.clone(), label, pairs });
        }
    }
    loads
}

/// The ground reactions as a `.sto` file: force, point and free moment for each body, in ground.
pub fn ground_reactions_sto(result: &MotionResult, name: &str) -> String {
    let loads = loads_on_bodies(result);
    let labels: Vec<&str> = loads.iter().map(|load| load.label.as_str()).collect();
    reactions_sto(&result.states.time_s, &labels, name, |load, frame| {
        let states = result.states.frame(frame);
        let own = || loads[load].pairs.iter().filter_map(|&pair| states.get(pair));
        let wrench = Wrench::from_states(own());
        (wrench, point_of_force(result, own().next(), &wrench))
    })
}

/// The measured ground reactions in `frames`, without those in which no foot's force is known, at points that have moved back by the way
/// of a belt. Each foot's force acts on its first body.
pub(super) fn plates_sto(result: &MotionResult, frames: Range<usize>, way_m: &[DVec3], name: &str) -> String {
    let feet = || result.summary.feet.iter().map(|foot| &foot.foot);
    let labels: Vec<&str> = feet().filter_map(|foot| Some(foot.bodies.first()?.as_str())).collect();
    let measured = |foot: usize, frame: usize| *result.measured.as_ref()?.feet.get(foot)?.get(frame)?;
    let is_known = |frame: &usize| (0..labels.len()).any(|foot| measured(foot, *frame).is_some());
    let (frames, times): (Vec<usize>, Vec<f64>) =
        frames.filter(is_known).map(|frame| (frame, result.states.time_s[frame])).unzip();
    reactions_sto(&times, &labels, name, |foot, row| {
        let frame = frames[row];
        let wrench = measured(foot, frame).unwrap_or_default();
        let way_m = way_m.get(frame).copied().unwrap_or_default();
        let back = Wrench { moment_n_m: wrench.moment_n_m - way_m.cross(wrench.force_n), ..wrench };
        let first = feet().nth(foot).and_then(|foot| result.states.frame(frame).get(*foot.pairs.first()?));
        (back, point_of_force(result, first, &back))
    })
}

/// A table of forces, points and free moments, for each load and each time.
fn reactions_sto(
    time_s: &[f64],
    labels: &[&str],
    name: &str,
    reaction: impl Fn(usize, usize) -> (Wrench, Option<DVec3>),
) -> String {
    let of_label = |label: &&str| {
        [
            format!("ground_force_{label}_v"),
            format!("ground_force_{label}_p"),
            format!("ground_torque_{label}_"),
        ]
    };
    let columns = labels.iter().flat_map(of_label);
    let columns = columns.flat_map(|columns| ["x", "y", "z"].map(|axis| format!("{columns}{axis}")));
    let mut points = vec![None; labels.len()];
    storage_file_text(name, "", &columns.collect::<Vec<_>>(), time_s, |frame| {
        let mut row = Vec::new();
        for (load, last) in points.iter_mut().enumerate() {
            let (wrench, point) = reaction(load, frame);
            let point = point.or(*last).unwrap_or_default();
            *last = Some(point);
            let moment = wrench.moment_n_m - point.cross(wrench.force_n);
            row.extend([wrench.force_n, point, moment].into_iter().flat_map(<[f64; 3]>::from));
        }
        row
    })
}

/// The text of a `.sto` file; `about` is a line of its header, or empty.
pub(super) fn storage_file_text(
    name: &str,
    about: &str,
    columns: &[String],
    time_s: &[f64],
    mut row: impl FnMut(usize) -> Vec<f64>,
) -> String {
    let (name, count) = (name.lines().next().unwrap_or_default(), columns.len() + 1);
    let rows = time_s.len();
    let mut text =
        format!("{name}\nversion=1\nnRows={rows}\nnColumns={count}\ninDegrees=no\n{about}endheader\ntime");
    columns.iter().for_each(|column| text.extend(["\t", column]));
    // Adding 0 removes the sign of a negative zero.
    for (frame, time_s) in time_s.iter().enumerate() {
        text.push_str(&format!("\n{}", shortest(*time_s)));
        row(frame).into_iter().for_each(|value| text.push_str(&format!("\t{}", shortest(value + 0.0))));
    }
    text.push('\n');
    text
}

/// The point at which the force on a body acts; `None` if the force is too small.
fn point_of_force(result: &MotionResult, first: Option<&ContactState>, wrench: &Wrench) -> Option<DVec3> {
    let state = first?;
    let down = (state.centre_m - state.point_m).dot(state.normal);
    let on_plane = state.centre_m - down * state.normal;
    // Below, forces act where they did last.
    let least_n = TOUCH_DOWN_BW * result.summary.weight_n;
    wrench.centre_of_pressure(state.normal, on_plane, least_n).map(|centre| centre.point_m)
}

/// The corrected motion at `path`; beside it the moved plates and their loads, which a treadmill needs. Empty without a correction.
pub fn corrected_files(result: &MotionResult, path: &Path) -> Vec<(PathBuf, String)> {
    let Some(correction) = result.correction() else { return Vec::new() };
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut files = vec![(path.to_owned(), corrected_motion(result, correction, &name(path)))];
    if correction.belt_m_s.length() > 0.0 {
        let plates = path.with_extension("plates.sto");
        let loads = (plates.with_extension("xml"), moved_plates_xml(result, &name(&plates)));
        let frames = 0..result.states.frames();
        let table = plates_sto(result, frames, &correction.belt_way_m, &name(&plates));
        files.extend([(plates, table), loads]);
    }
    files
}

/// The text of the corrected motion. Its header says what was done.
pub(super) fn corrected_motion(result: &MotionResult, correction: &Correction, name: &str) -> String {
    let figures = &correction.figures;
    let about = format!(
        "{CORRECTED_HEADER_LINE} of {}: loaded spheres move up or down by {:.1} mm (95 %), joints by {:.1} degrees (rms), the floor by {:.1} mm; no \
         evidence that the contacts are right\n",
        shown(&result.opened.name().to_string()),
        1e3 * figures.lift_p95_m,
        figures.largest_of_feet(|foot| foot.joint_rms_rad).to_degrees(),
        1e3 * correction.floor_up_m
    );
    let recording = &correction.recording;
    let columns = recording.coordinates.iter().map(|coordinate| coordinate.name.clone());
    storage_file_text(name, &about, &columns.collect::<Vec<_>>(), &recording.time_s, |frame| {
        recording.values(frame).to_vec()
    })
}

/// OpenSim's `ExternalLoads` file for the output of [`ground_reactions_sto`], which is in the same folder under the name `data_file`.
pub fn external_loads_xml(result: &MotionResult, data_file: &str) -> String {
    let loads = loads_on_bodies(result);
    loads_xml("contacts", loads.iter().map(|load| (load.label.as_str(), load.body.as_str())), data_file)
}

/// OpenSim's `ExternalLoads` file for the output of [`plates_sto`], which is in the same folder under the name `data_file`.
pub(super) fn moved_plates_xml(result: &MotionResult, data_file: &str) -> String {
    let bodies = result.summary.feet.iter().filter_map(|foot| foot.foot.bodies.first());
    loads_xml("plates", bodies.map(|body| (body.as_str(), body.as_str())), data_file)
}

/// An `ExternalLoads` file for loads, each with the label of its columns and its body.
fn loads_xml<'l>(name: &str, loads: impl Iterator<Item = (&'l str, &'l str)>, data_file: &str) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<OpenSimDocument Version=\"40000\">\n\t<ExternalLoads name=\"{name}\">\n\t\t<objects>\n"
    );
    for (label, body) in loads {
        let (label, body) = (escaped(label), escaped(body));
        text.push_str(&format!("\t\t\t<ExternalForce name=\"{name}_{body}\">\n"));
        for (tag, value) in [
            ("applied_to_body", body),
            ("force_expressed_in_body", "ground".to_owned()),
            ("point_expressed_in_body", "ground".to_owned()),
            ("force_identifier", format!("ground_force_{label}_v")),
            ("point_identifier", format!("ground_force_{label}_p")),
            ("torque_identifier", format!("ground_torque_{label}_")),
        ] {
            text.push_str(&format!("\t\t\t\t<{tag}>{value}</{tag}>\n"));
        }
        text.push_str("\t\t\t</ExternalForce>\n");
    }
    text.push_str(&format!(
        "\t\t</objects>\n\t\t<groups />\n\t\t<datafile>{}</datafile>\n\t</ExternalLoads>\n</OpenSimDocument>\n",
        escaped(data_file)
    ));
    text
}

fn escaped(text: &str) -> String {
    maud::html! { (text) }.into_string()
}
