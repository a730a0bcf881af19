//! Random tables of contacts in the forms that people and spreadsheets write. Every cell is read as intended, and a wrong cell is named.

use osim_planning::contact_table::{ContactTable, TablePlace};

use crate::random::{Random, seeds};

/// The form in which a table is written.
struct TableStyle {
    delimiter: char,
    decimal: char,
    end: &'static str,
    bom: bool,
    last_end: bool,
}

impl TableStyle {
    fn of(random: &mut Random) -> Self {
        let delimiter = [',', ';', '\t'][random.index(3)];
        let decimal = if delimiter != ',' && random.integer_below(2) == 0 { ',' } else { '.' };
        let end = ["\n", "\r\n"][random.index(2)];
        Self {
            delimiter,
            decimal,
            end,
            bom: random.integer_below(4) == 0,
            last_end: random.integer_below(4) > 0,
        }
    }

    fn line(&self, cells: &[String], random: &mut Random) -> String {
        let quoted = |cell: &String, random: &mut Random| {
            let needs = cell.contains(self.delimiter);
            if needs || random.integer_below(6) == 0 { format!("\"{cell}\"") } else { cell.clone() }
        };
        let cells: Vec<String> = cells.iter().map(|cell| quoted(cell, random)).collect();
        cells.join(&self.delimiter.to_string())
    }
}

/// A random number with few digits, and a text of this number.
fn number(random: &mut Random, above_0: bool, decimal: char) -> (f64, String) {
    let whole = random.integer_below(2_000_000) as f64 + if above_0 { 1.0 } else { -1e6 };
    let digits = random.index(7);
    let value = whole / 10_f64.powi(i32::try_from(digits).unwrap());
    let text = match random.integer_below(4) {
        0 => format!("{value:e}"),
        1 => format!("{value:.8}"),
        2 if value >= 0.0 => format!("+{value}"),
        _ => value.to_string(),
    };
    // What is written is what counts.
    (text.parse().unwrap(), text.replace('.', &decimal.to_string()))
}

struct RandomTable {
    text: String,
    rows: Vec<(String, String, [f64; 3], Option<f64>)>,
    columns: Vec<&'static str>,
    style: TableStyle,
}

fn random_table(random: &mut Random) -> RandomTable {
    let style = TableStyle::of(random);
    let mut columns = vec!["name", "body", "x", "y", "z"];
    if random.integer_below(3) > 0 {
        columns.push("radius");
    }
    if random.integer_below(3) == 0 {
        columns.push("#remark");
    }
    for last in (1..columns.len()).rev() {
        columns.swap(last, random.index(last + 1));
    }
    let header = columns.iter().map(|column| match random.integer_below(6) {
        0 => column.to_uppercase(),
        1 if !["name", "body", "#remark"].contains(column) => format!("{column} [m]"),
        _ => (*column).to_owned(),
    });
    let header: Vec<String> = header.collect();
    let mut lines = vec![style.line(&header, random)];
    let mut rows = Vec::new();
    for row in 0..1 + random.index(6) {
        let mut own = (
            format!("{}_{row}", random.one_of(&["heel", "t\u{f6}e", "a.b", "1"])),
            String::new(),
            [0.0; 3],
            None,
        );
        own.1 = random.one_of(&["calcn_r", "toes l", "Fu\u{df}"]).to_owned();
        let cells = columns.iter().map(|column| match *column {
            "name" => own.0.clone(),
            "body" => own.1.clone(),
            "radius" => {
                let (value, text) = number(random, true, style.decimal);
                own.3 = Some(value);
                text
            }
            "#remark" => random.one_of(&["", "seen", "left, and up", "x;y"]).to_owned(),
            axis => {
                let (value, text) = number(random, false, style.decimal);
                own.2[["x", "y", "z"].iter().position(|name| *name == axis).unwrap()] = value;
                text
            }
        });
        let cells: Vec<String> = cells.collect();
        lines.push(style.line(&cells, random));
        rows.push(own);
    }
    let mut text = lines.join(style.end);
    if style.last_end {
        text.push_str(style.end);
    }
    if style.bom {
        text.insert(0, '\u{feff}');
    }
    RandomTable { text, rows, columns, style }
}

#[test]
fn every_cell_of_a_random_table_is_read_as_intended() {
    for seed in seeds() {
        let made = random_table(&mut Random::of(seed));
        let table = ContactTable::read(made.text.as_bytes());
        let table = table.unwrap_or_else(|fault| panic!("seed {seed}: {}\n{}", fault.message, made.text));
        let read: Vec<_> = table
            .rows
            .iter()
            .map(|row| (row.name.clone(), row.body.clone(), row.place.clone(), row.radius_m))
            .collect();
        let meant: Vec<_> = made
            .rows
            .iter()
            .map(|(name, body, place, radius)| {
                (name.clone(), body.clone(), TablePlace::OfBody(*place), *radius)
            })
            .collect();
        assert_eq!(read, meant, "seed {seed}\n{}", made.text);
    }
}

/// A wrong cell gives a message with its line, whatever else is in the table. No text that is not a number is read as a number.
#[test]
fn a_wrong_cell_of_a_random_table_is_reported() {
    for seed in seeds() {
        let mut random = Random::of(seed);
        let made = random_table(&mut random);
        let column =
            made.columns.iter().position(|column| ["x", "y", "z", "radius"].contains(column)).unwrap();
        let row = random.index(made.rows.len());
        let bad = random.one_of(&[
            "#REF!", "#N/A", "#DIV/0!", "two", "1 cm", "0x10", "", "nan", "inf", "1e999", "--1", "1.2.3",
        ]);
        let mut lines: Vec<String> = made.text.split(made.style.end).map(str::to_owned).collect();
        let line = &mut lines[row + 1];
        // Only lines without quotes can be divided like that.
        if line.contains('"') {
            continue;
        }
        let mut cells: Vec<&str> = line.split(made.style.delimiter).collect();
        cells[column] = bad;
        *line = cells.join(&made.style.delimiter.to_string());
        let text = lines.join(made.style.end);
        let fault = ContactTable::read(text.as_bytes()).err();
        let fault = fault.unwrap_or_else(|| panic!("seed {seed}: '{bad}' was read\n{text}"));
        assert_eq!(fault.line, Some(row as u64 + 2), "seed {seed}: {}\n{text}", fault.message);
        let is_formula = bad.starts_with('#');
        assert_eq!(
            is_formula,
            fault.message.to_string().contains("broken formula"),
            "seed {seed}: {}",
            fault.message
        );
    }
}
