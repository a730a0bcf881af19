//! One row per frame, sphere and force: as columns, and as CSV.

use osim_model::Side;
use osim_model::messages::shortest;
use osim_motion::{ContactPair, ContactState, Touched};
use osim_planning::MotionResult;

/// A column of the rows of a motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MotionColumn {
    /// Its name; it ends in the unit, where there is one.
    pub name: &'static str,
    /// One cell for each row.
    pub cells: MotionCells,
}

/// The cells of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionCells {
    /// Numbers.
    Numbers(Vec<f64>),
    /// Names.
    Texts(Vec<String>),
    /// Whether something holds.
    Flags(Vec<bool>),
}

/// How to get a number of a row.
type Number = fn(&ContactPair, &ContactState) -> f64;

/// The numbers after time, sphere and body.
const NUMBERS: [(&str, Number); 15] = [
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

/// Each sphere on each plane in each frame, column by column.
#[must_use]
pub fn motion_columns(result: &MotionResult) -> Vec<MotionColumn> {
    let (states, model) = (&result.states, &result.opened.model);
    let sphere =
        |pair: &ContactPair| model.sphere(pair.sphere).map(|sphere| sphere.name.clone()).unwrap_or_default();
    let force =
        |pair: &ContactPair| model.force(pair.force).map(|force| force.name.clone()).unwrap_or_default();
    let touched = |pair: &ContactPair| match pair.touched {
        Touched::Plane(plane) => states.planes.get(plane).map(|plane| plane.name.clone()).unwrap_or_default(),
        Touched::Sphere(other) => model.sphere(other).map(|other| other.name.clone()).unwrap_or_default(),
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
    let numbers = NUMBERS.iter().map(|(name, number)| {
        let of_frame = |frame: usize| {
            states.pairs.iter().zip(states.frame(frame)).map(|(pair, state)| number(pair, state))
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

/// The same as CSV. Numbers are the shortest that read back exactly.
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
    /// The cell of a row.
    fn text(&self, row: usize) -> String {
        match self {
            Self::Numbers(numbers) => numbers.get(row).copied().map(shortest).unwrap_or_default(),
            Self::Texts(texts) => texts.get(row).cloned().unwrap_or_default(),
            Self::Flags(flags) => flags.get(row).map(bool::to_string).unwrap_or_default(),
        }
    }
}
