//! Names and numbers below the header.

use super::data::{Column, Table};
use super::header::Header;
use super::times::rising;
use crate::fault::MotionFault;

/// Texts of a file are shown up to here.
const SHOWN: usize = 40;

impl Table {
    /// Reads one.
    ///
    /// # Errors
    /// No header, no times, a row with more or fewer cells than there are names, a cell that is not a number, or times that do not
    /// rise, with the line.
    pub fn read(bytes: &[u8]) -> Result<Self, MotionFault> {
        let text = String::from_utf8_lossy(bytes);
        let header = Header::read(&text)?;
        read(&text, &header)
    }
}

fn read(text: &str, header: &Header) -> Result<Table, MotionFault> {
    let mut lines =
        text.lines().enumerate().skip(header.end + 1).filter(|(_, line)| !line.trim_ascii().is_empty());
    let Some((above, names)) = lines.next() else {
        return Err(MotionFault::new(
            "nothing follows its line `endheader`: the names of its columns are missing",
        ));
    };
    let mut names = names_of(names).into_iter();
    match names.next() {
        Some(first) if first.eq_ignore_ascii_case("time") => {}
        first => {
            let first = shown(&first.unwrap_or_default());
            return Err(MotionFault::at(
                above + 1,
                format!("its first column is '{first}', expected 'time'"),
            ));
        }
    }
    let mut columns: Vec<Column> = names.map(|name| Column { name, values: Vec::new() }).collect();
    let (mut time_s, mut numbers) = (Vec::new(), Vec::new());
    for (index, line) in lines {
        let number = index + 1;
        let mut cells = line.split_ascii_whitespace();
        let time = cells.next().unwrap_or_default();
        time_s.push(value(time, "time", number)?);
        let mut count = 1;
        for column in &mut columns {
            let Some(cell) = cells.next() else { break };
            column.values.push(value(cell, &column.name, number)?);
            count += 1;
        }
        count += cells.count();
        if count != columns.len() + 1 {
            let expected = columns.len() + 1;
            return Err(MotionFault::at(
                number,
                format!(
                    "it has {count} cells, but there are {expected} names of columns in line {}",
                    above + 1
                ),
            ));
        }
        numbers.push(number);
    }
    if time_s.is_empty() {
        return Err(MotionFault::new("it has no rows of numbers"));
    }
    rising(&time_s, &numbers)?;
    let &Header { declared, has_version, .. } = header;
    Ok(Table { time_s, columns, declared, has_version, lines: numbers })
}

/// Names between tabs may have spaces; without tabs, spaces divide them.
fn names_of(line: &str) -> Vec<String> {
    let by_tabs = line.contains('\t');
    let names: Vec<&str> = match by_tabs {
        true => line.split('\t').map(str::trim_ascii).filter(|name| !name.is_empty()).collect(),
        false => line.split_ascii_whitespace().collect(),
    };
    names.into_iter().map(str::to_owned).collect()
}

fn value(cell: &str, column: &str, line: usize) -> Result<f64, MotionFault> {
    cell.parse().map_err(|_| {
        let (cell, column) = (shown(cell), shown(column));
        MotionFault::at(line, format!("column '{column}': '{cell}' is not a number"))
    })
}

fn shown(text: &str) -> String {
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}...", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use crate::table::{AngleUnit, Table};

    fn refused(text: &str) -> (Option<usize>, String) {
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
    fn what_is_wrong_has_its_line() {
        let head = "endheader\ntime x\n";
        assert_eq!(refused("time x\n0 1\n").0, None);
        assert_eq!(refused("endheader\nt x\n0 1\n").0, Some(2));
        assert_eq!(
            refused(&format!("{head}0 1\n1 2 3\n")),
            (Some(4), "it has 3 cells, but there are 2 names of columns in line 2".to_owned())
        );
        assert_eq!(refused(&format!("{head}0 1\n1\n")).0, Some(4));
        assert_eq!(
            refused(&format!("{head}0 1\n1 two\n")),
            (Some(4), "column 'x': 'two' is not a number".to_owned())
        );
        assert_eq!(
            refused(&format!("{head}0 1\n0 2\n")),
            (Some(4), "its time is 0 s, after 0 s: times must rise".to_owned())
        );
        assert_eq!(refused(&format!("{head}0 1\nnan 2\n")).0, Some(4));
        assert_eq!(refused(&format!("{head}0 1\ninf 2\n")).0, Some(4));
        assert_eq!(refused(&format!("{head}nan 2\n")).0, Some(3));
        assert_eq!(refused(head).0, None);
        assert_eq!(refused("").0, None);
        let table = Table::read(format!("{head}0 nan\n").as_bytes()).unwrap();
        assert_eq!(table.finite(&table.columns[0]).unwrap_err().line, Some(3));
    }

    #[test]
    fn even_steps_are_seen() {
        let table =
            |times: &[f64]| Table::of_columns(times.to_vec(), Vec::new(), AngleUnit::Radians).unwrap();
        assert_eq!(table(&[0.0, 0.1, 0.3]).even_step_s(), None);
        assert!((table(&[1.0, 1.1, 1.2]).even_step_s().unwrap() - 0.1).abs() < 1e-12);
        assert_eq!(table(&[1.0]).even_step_s(), None);
    }
}
