//! Reads OpenSim's tables over time, `.mot` and `.sto` files.

use osim_model::messages::named;

/// A table over time from a `.mot` or `.sto` file of OpenSim.
///
/// ```
/// use osim_motion::Table;
///
/// let text = "name walk\ninDegrees=yes\nendheader\ntime\tknee_angle_r\n0.0\t10\n0.1\t12\n";
/// let table = Table::read(text.as_bytes())?;
/// assert_eq!((table.time_s.as_slice(), table.column("knee_angle_r").unwrap().values.as_slice()), ([0.0, 0.1].as_slice(), [10.0, 12.0].as_slice()));
/// # Ok::<(), osim_motion::MotionFault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// The time of each row, s; times rise.
    pub time_s: Vec<f64>,
    /// All columns except the time, in the order of the file.
    pub columns: Vec<Column>,
    /// The unit of angles, if the header declares it.
    pub declared: Option<AngleUnit>,
    /// Whether the header has a `version`. If it has, and declares no unit of angles, OpenSim assumes radians.
    pub has_version: bool,
    /// Whether the header says that contacts corrected the motion.
    pub corrected: bool,
    /// The line of each row in the file, from 1.
    pub lines: Vec<usize>,
    /// The lines of rows that were left out, because they repeat the row before them.
    pub repeated: Vec<usize>,
}

/// A column of a motion file.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    pub name: String,
    /// The number of the column in each row; NaN where the file has NaN.
    pub values: Vec<f64>,
}

/// The begin of a line in the header of a corrected motion.
pub const CORRECTED_HEADER_LINE: &str = "corrected to contacts";

impl Table {
    /// A table without columns; times must rise.
    #[cfg(test)]
    pub(crate) fn from_times(time_s: Vec<f64>) -> Result<Self, MotionFault> {
        let lines: Vec<usize> = (1..=time_s.len()).collect();
        refuse_falling_times(&time_s, &lines)?;
        Ok(Self { time_s, declared: Some(AngleUnit::Radians), has_version: true, lines, ..Self::default() })
    }

    /// The first column called `name`.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// Keeps the rows of these times.
    pub fn keep_window(&mut self, start_s: f64, end_s: f64) {
        let first = self.time_s.partition_point(|&time| time < start_s);
        let end = self.time_s.partition_point(|&time| time <= end_s).max(first);
        self.time_s = self.time_s[first..end].to_vec();
        self.lines = self.lines[first..end].to_vec();
        self.columns.iter_mut().for_each(|column| column.values = column.values[first..end].to_vec());
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.time_s.len()
    }

    /// Checks that a column has a finite number in each row.
    ///
    /// # Errors
    /// The first row without a finite number in the column.
    pub(crate) fn check_finite(&self, column: &Column) -> Result<(), MotionFault> {
        let first_odd = column.values.iter().zip(&self.lines).find(|(value, _)| !value.is_finite());
        let Some((value, line)) = first_odd else { return Ok(()) };
        let text = format!("column '{}' is {value}, expected a finite number", column.name);
        Err(MotionFault::at(*line, text))
    }

    /// The time between rows, s, if all steps are equal within one percent, or but for times that are rounded to milliseconds; else
    /// `None`.
    pub(crate) fn even_step_s(&self) -> Option<f64> {
        let (first, last) = (self.time_s.first()?, self.time_s.last()?);
        let mean = (last - first) / self.rows().checked_sub(1).filter(|&steps| steps > 0)? as f64;
        let is_even = |pair: &[f64]| matches!(pair, [a, b] if ((b - a) - mean).abs() <= 0.01 * mean);
        let rounded_s = (0.125 * mean).min(1e-3);
        let is_rounded = |(row, time): (usize, &f64)| (time - first - row as f64 * mean).abs() <= rounded_s;
        let is_even = self.time_s.windows(2).all(is_even) || self.time_s.iter().enumerate().all(is_rounded);
        is_even.then_some(mean)
    }

    /// Reads the header and returns the index of its line `endheader` in the file, from 0.
    fn read_header(&mut self, text: &str) -> Result<usize, MotionFault> {
        for (index, line) in text.lines().enumerate() {
            let line = line.trim_ascii();
            if line.eq_ignore_ascii_case("endheader") {
                return Ok(index);
            }
            self.read_line_of_header(line);
        }
        let is_xml = text.trim_ascii_start().starts_with('<');
        let xml = "this is XML, expected a .mot or .sto file of OpenSim: ExternalLoads go with `loads`";
        let other = "it has no line `endheader`: a motion is a .mot or .sto file of OpenSim, with a header that ends so";
        Err(MotionFault::new(if is_xml { xml } else { other }))
    }

    /// Reads one line of the header: the unit of angles, the version, or that the motion was corrected.
    fn read_line_of_header(&mut self, line: &str) {
        let lower = line.to_ascii_lowercase();
        // `inDegrees=yes`, `inDegrees yes`, and a sentence that OpenSim writes for people.
        let (key, value) = lower.split_once(['=', ' ', '\t']).unwrap_or((lower.as_str(), ""));
        match key.trim_ascii() {
            "indegrees" => {
                let yes = matches!(value.trim_start_matches('=').trim_ascii(), "yes" | "true" | "1" | "y");
                self.declared = Some(if yes { AngleUnit::Degrees } else { AngleUnit::Radians });
            }
            "version" => self.has_version = true,
            _ if lower.starts_with(CORRECTED_HEADER_LINE) => self.corrected = true,
            _ => {
                let is_said = |unit: &AngleUnit| lower.contains(&format!("angles are in {}", unit.as_str()));
                // The sentence only counts if no header property gives the unit.
                self.declared = self.declared.or(AngleUnit::ALL.iter().copied().find(is_said));
            }
        }
    }

    /// Reads a table from the bytes of a file.
    ///
    /// # Errors
    /// No header, no times, a row whose number of cells differs from the number of column names, a cell that is not a number,
    /// or times that do not rise. The error has the line.
    pub fn read(bytes: &[u8]) -> Result<Self, MotionFault> {
        let text = String::from_utf8_lossy(bytes);
        let mut table = Self::default();
        let end = table.read_header(&text)?;
        table.read_rows(&text, end)?;
        Ok(table)
    }

    /// Reads what follows the line `end`, the last of the header.
    fn read_rows(&mut self, text: &str, end: usize) -> Result<(), MotionFault> {
        let mut lines =
            text.lines().enumerate().skip(end + 1).filter(|(_, line)| !line.trim_ascii().is_empty());
        let Some((above, names)) = lines.next() else {
            let why = "nothing follows its line `endheader`: the names of its columns are missing";
            return Err(MotionFault::new(why));
        };
        let mut names = split_names(names).into_iter();
        let first = names.next().unwrap_or_default();
        if !first.eq_ignore_ascii_case("time") {
            let text = format!("its first column is '{}', expected 'time'", shortened(&first));
            return Err(MotionFault::at(above + 1, text));
        }
        let mut columns: Vec<Column> = names.map(|name| Column { name, values: Vec::new() }).collect();
        let (mut time_s, mut numbers) = (Vec::new(), Vec::new());
        let mut before = "";
        for (index, line) in lines {
            let number = index + 1;
            if std::mem::replace(&mut before, line) == line {
                self.repeated.push(number);
                continue;
            }
            let mut cells = line.split_ascii_whitespace();
            let time = cells.next().unwrap_or_default();
            time_s.push(parse_number(time, "time", number)?);
            let mut count = 1;
            for column in &mut columns {
                let Some(cell) = cells.next() else { break };
                column.values.push(parse_number(cell, &column.name, number)?);
                count += 1;
            }
            count += cells.count();
            if count != columns.len() + 1 {
                let expected = columns.len() + 1;
                let line = above + 1;
                let text =
                    format!("it has {count} cells, but there are {expected} names of columns in line {line}");
                return Err(MotionFault::at(number, text));
            }
            numbers.push(number);
        }
        if time_s.is_empty() {
            return Err(MotionFault::new("it has no rows of numbers"));
        }
        refuse_falling_times(&time_s, &numbers)?;
        (self.time_s, self.columns, self.lines) = (time_s, columns, numbers);
        Ok(())
    }
}

/// The time spans in which rows at these times are missing: steps longer than 1.5 times the median step.
///
/// ```
/// let gaps = osim_motion::gaps(&[0.00, 0.01, 0.02, 0.05, 0.06]);
/// assert_eq!((gaps.len(), gaps[0].from_s, gaps[0].to_s), (1, 0.02, 0.05));
/// ```
pub fn gaps(time_s: &[f64]) -> Vec<Gap> {
    let steps = time_s.windows(2).map(|pair| Gap { from_s: pair[0], to_s: pair[1] });
    let mut lengths: Vec<f64> = steps.clone().map(|step| step.length_s()).collect();
    let middle = lengths.len() / 2;
    if lengths.is_empty() {
        return Vec::new();
    }
    let (_, usual_s, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
    let longest_usual_s = LEAST_GAP_IN_STEPS * *usual_s;
    steps.filter(|step| step.length_s() > longest_usual_s).collect()
}

named! {
    /// The unit of the angles of a file.
    pub enum AngleUnit {
        Degrees = "degrees",
        Radians = "radians",
    }
}

impl AngleUnit {
    /// The factor that converts an angle of this unit to rad.
    pub const fn radians(self) -> f64 {
        match self {
            Self::Degrees => std::f64::consts::PI / 180.0,
            Self::Radians => 1.0,
        }
    }
}

/// Checks that times are finite and rise.
fn refuse_falling_times(time_s: &[f64], lines: &[usize]) -> Result<(), MotionFault> {
    if let Some((time, line)) = time_s.iter().zip(lines).find(|(time, _)| !time.is_finite()) {
        return Err(MotionFault::at(*line, format!("its time is {time}, expected a finite number")));
    }
    let mut steps = time_s.windows(2).zip(lines.iter().skip(1));
    let Some((pair, line)) = steps.find(|(pair, _)| pair[1] <= pair[0]) else { return Ok(()) };
    let text = format!("its time is {} s, after {} s: times must rise", pair[1], pair[0]);
    Err(MotionFault::at(*line, text))
}

/// Nobody records forces in more rows than this at steps longer than this, s.
const MOST_SLOW_ROWS: (usize, f64) = (100, 0.2);

impl Table {
    /// Refuses many rows of plates that are so far apart that their times are not in seconds.
    ///
    /// # Errors
    /// The mean step.
    pub fn check_unit_of_time(&self) -> Result<(), MotionFault> {
        let (rows, step_s) = MOST_SLOW_ROWS;
        let all_s = self.time_s.last().zip(self.time_s.first()).map_or(0.0, |(last, first)| last - first);
        let mean_s = all_s / self.rows() as f64;
        let text = "s: are its times in milliseconds, or numbers of frames? They have to be in seconds";
        let is_slow = self.rows() > rows && mean_s > step_s;
        if is_slow { Err(MotionFault::new(format!("it has a row every {mean_s:.2} {text}"))) } else { Ok(()) }
    }
}

// Names and numbers below the header.

/// The largest number of letters of a text from the file in a message.
const MOST_LETTERS_SHOWN: usize = 40;

/// The names of columns: split at tabs, so that names may have spaces; without tabs, split at spaces.
fn split_names(line: &str) -> Vec<String> {
    let by_tabs = line.contains('\t');
    let names =
        line.split(|letter: char| if by_tabs { letter == '\t' } else { letter.is_ascii_whitespace() });
    names.map(str::trim_ascii).filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

/// Reads the number in a cell.
fn parse_number(cell: &str, column: &str, line: usize) -> Result<f64, MotionFault> {
    cell.parse().map_err(|_| {
        let (cell, column) = (shortened(cell), shortened(column));
        MotionFault::at(line, format!("column '{column}': '{cell}' is not a number"))
    })
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(MOST_LETTERS_SHOWN) {
        Some((end, _)) => format!("{}...", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

/// A time step counts as a gap if it is more than this many times as long as the usual step. A smaller difference can come from
/// rounding.
const LEAST_GAP_IN_STEPS: f64 = 1.5;

/// A time span in which rows are missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// The time of the row before the gap, s.
    pub from_s: f64,
    /// The time of the row after the gap, s.
    pub to_s: f64,
}

impl Gap {
    /// How long the gap is, s.
    pub fn length_s(&self) -> f64 {
        self.to_s - self.from_s
    }
}

/// An error in a motion file: the problem, its line, and advice.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct MotionFault {
    /// The line in the file, from 1; `None` if the error is about the whole file.
    pub line: Option<usize>,
    /// The message; it quotes texts from the file.
    pub message: String,
    /// Whether the caller has to give the unit of angles, because the file does not declare it.
    pub needs_angles: bool,
}

impl MotionFault {
    /// An error about no single line.
    pub fn new(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into(), needs_angles: false }
    }

    /// An error because the unit of the angles is in doubt.
    pub(crate) fn about_angle_unit(message: impl Into<String>) -> Self {
        Self { needs_angles: true, ..Self::new(message) }
    }

    /// An error about line `line` of the file.
    pub fn at(line: usize, message: impl Into<String>) -> Self {
        Self { line: Some(line), ..Self::new(message) }
    }
}

#[cfg(test)]
mod tests {
    use super::{AngleUnit, Table};

    fn error_of_table(text: &str) -> (Option<usize>, String) {
        let fault = Table::read(text.as_bytes()).unwrap_err();
        (fault.line, fault.message)
    }

    #[test]
    fn headers_of_all_kinds_are_read() {
        let simm = "name a.mot\ndatacolumns 2\ndatarows 7\nrange 0 1\nendheader\n time \t x y\t\t\n0 1\n\n1.5 -2e-3\n";
        let table = Table::read(simm.as_bytes()).unwrap();
        // A name between tabs keeps its spaces; the number of rows in the header is not believed.
        assert_eq!((table.columns[0].name.as_str(), table.rows(), table.declared), ("x y", 2, None));
        assert!(!table.has_version);
        let said = "Coordinates\n\nAngles are in degrees.\n\nendheader\ntime x\n0 1\n";
        assert_eq!(Table::read(said.as_bytes()).unwrap().declared, Some(AngleUnit::Degrees));
        let both = "version=1\ninDegrees=no\nAngles are in degrees.\nEndHeader\ntime x\n0 1\r\n";
        let table = Table::read(both.as_bytes()).unwrap();
        assert_eq!((table.declared, table.has_version), (Some(AngleUnit::Radians), true));
    }

    #[test]
    fn errors_and_repeated_rows_have_their_line() {
        let head = "endheader\ntime x\n";
        assert_eq!(error_of_table("time x\n0 1\n").0, None);
        assert_eq!(error_of_table("endheader\nt x\n0 1\n").0, Some(2));
        assert_eq!(
            error_of_table(&format!("{head}0 1\n1 2 3\n")),
            (Some(4), "it has 3 cells, but there are 2 names of columns in line 2".to_owned())
        );
        assert_eq!(error_of_table(&format!("{head}0 1\n1\n")).0, Some(4));
        assert_eq!(
            error_of_table(&format!("{head}0 1\n1 two\n")),
            (Some(4), "column 'x': 'two' is not a number".to_owned())
        );
        assert_eq!(
            error_of_table(&format!("{head}0 1\n0 2\n")),
            (Some(4), "its time is 0 s, after 0 s: times must rise".to_owned())
        );
        assert_eq!(error_of_table(&format!("{head}0 1\nnan 2\n")).0, Some(4));
        assert_eq!(error_of_table(&format!("{head}0 1\ninf 2\n")).0, Some(4));
        assert_eq!(error_of_table(&format!("{head}nan 2\n")).0, Some(3));
        assert_eq!(error_of_table(head).0, None);
        assert_eq!(error_of_table("").0, None);
        let table = Table::read(format!("{head}0 1\n0 1\n1 1\n2 nan\n2 nan\n").as_bytes()).unwrap();
        assert_eq!(
            (table.time_s.as_slice(), table.lines.as_slice()),
            ([0.0, 1.0, 2.0].as_slice(), [3, 5, 6].as_slice())
        );
        assert_eq!((table.columns[0].values.len(), table.repeated.as_slice()), (3, [4, 7].as_slice()));
        let table = Table::read(format!("{head}0 nan\n").as_bytes()).unwrap();
        assert_eq!(table.check_finite(&table.columns[0]).unwrap_err().line, Some(3));
    }

    #[test]
    fn times_in_milliseconds_or_frames_are_refused() {
        let read = |step: f64| {
            let rows = (0..150).map(|row| format!("{} 1\n", step * f64::from(row))).collect::<String>();
            Table::read(format!("endheader\ntime x\n{rows}").as_bytes()).unwrap().check_unit_of_time()
        };
        assert!(read(0.1).is_ok());
        for step in [1.0, 16.67] {
            assert!(read(step).unwrap_err().message.contains("in milliseconds, or numbers of frames?"));
        }
    }

    #[test]
    fn even_time_steps_are_recognised() {
        let table = |times: &[f64]| Table::from_times(times.to_vec()).unwrap();
        assert_eq!(table(&[0.0, 0.1, 0.3]).even_step_s(), None);
        assert!((table(&[1.0, 1.1, 1.2]).even_step_s().unwrap() - 0.1).abs() < 1e-12);
        assert_eq!(table(&[1.0]).even_step_s(), None);
        // 60 Hz in milliseconds, without and with a missing row.
        assert!((table(&[0.05, 0.067, 0.083, 0.1]).even_step_s().unwrap() - 1.0 / 60.0).abs() < 1e-12);
        assert_eq!(table(&[0.05, 0.067, 0.1, 0.117]).even_step_s(), None);
    }

    fn gaps(times: &[f64]) -> Vec<(f64, f64)> {
        super::gaps(times).iter().map(|gap| (gap.from_s, gap.to_s)).collect()
    }

    #[test]
    fn gaps_are_time_steps_with_missing_rows() {
        assert_eq!(gaps(&[]), []);
        assert_eq!(gaps(&[1.0]), []);
        assert_eq!(gaps(&[1.0, 2.0]), []);
        // 120 Hz with three digits: steps of 8 and 9 ms.
        assert_eq!(gaps(&[0.0, 0.008, 0.017, 0.025, 0.033, 0.042]), []);
        assert_eq!(gaps(&[0.0, 0.1, 0.2, 0.4, 0.5, 0.9, 1.0]), [(0.2, 0.4), (0.5, 0.9)]);
    }
}
