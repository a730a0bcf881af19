//! What the columns of a table of contacts are.

use super::fault::TableFault;
use crate::sheet::Sheet;

/// What a column says of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Name,
    Body,
    Radius,
    /// A coordinate in the frame of the body.
    OfBody(usize),
    /// The same, as MuSkeMo exports it: a number only where a local frame was assigned.
    Local(usize),
    /// A coordinate in MuSkeMo's global frame.
    Global(usize),
    /// A remark of the user, or a name that nothing follows from.
    Remark,
}

/// Names of columns without their unit, in small letters. Those of MuSkeMo's export follow one's own.
const KNOWN: [(&str, Kind); 15] = [
    ("name", Kind::Name),
    ("body", Kind::Body),
    ("x", Kind::OfBody(0)),
    ("y", Kind::OfBody(1)),
    ("z", Kind::OfBody(2)),
    ("radius", Kind::Radius),
    ("contact_name", Kind::Name),
    ("parent_body", Kind::Body),
    ("pos_x_in_global", Kind::Global(0)),
    ("pos_y_in_global", Kind::Global(1)),
    ("pos_z_in_global", Kind::Global(2)),
    ("pos_x_in_local", Kind::Local(0)),
    ("pos_y_in_local", Kind::Local(1)),
    ("pos_z_in_local", Kind::Local(2)),
    ("parent_frame_name", Kind::Remark),
];
const EXPECTED: &str = "name, body, x, y, z and radius (remarks begin with #), or MuSkeMo's own";

/// Where each thing is in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) name: usize,
    pub(super) body: usize,
    pub(super) radius: Option<usize>,
    pub(super) of_body: Option<[usize; 3]>,
    pub(super) local: Option<[usize; 3]>,
    pub(super) global: Option<[usize; 3]>,
}

impl Columns {
    /// # Errors
    /// A column that is missing, appears twice or is not known, or one in another unit than metres.
    pub(super) fn of(sheet: &Sheet) -> Result<Self, TableFault> {
        let mut found: Vec<(Kind, usize)> = Vec::new();
        for (index, header) in sheet.header.iter().enumerate() {
            let kind = kind(header).map_err(|message| TableFault::of_header(index, message))?;
            if kind == Kind::Remark {
                continue;
            }
            if let Some((_, first)) = found.iter().find(|(known, _)| *known == kind) {
                let other = sheet.header.get(*first).map_or("", String::as_str);
                let message = format!("the columns '{other}' and '{header}' say the same: leave one out");
                return Err(TableFault::of_header(index, message));
            }
            found.push((kind, index));
        }
        let at = |kind: Kind| found.iter().find(|(known, _)| *known == kind).map(|(_, index)| *index);
        let missing = |what: &str| {
            TableFault::of_header(
                0,
                format!("no column '{what}' in the first row, which has {}", sheet.columns()),
            )
        };
        let triple =
            |kind: fn(usize) -> Kind, name: fn(&str) -> String| match [0, 1, 2].map(|axis| at(kind(axis))) {
                [None, None, None] => Ok(None),
                [Some(x), Some(y), Some(z)] => Ok(Some([x, y, z])),
                [x, y, _] => Err(missing(&name(if x.is_none() {
                    "x"
                } else if y.is_none() {
                    "y"
                } else {
                    "z"
                }))),
            };
        let columns = Self {
            name: at(Kind::Name).ok_or_else(|| missing("name"))?,
            body: at(Kind::Body).ok_or_else(|| missing("body"))?,
            radius: at(Kind::Radius),
            of_body: triple(Kind::OfBody, str::to_owned)?,
            local: triple(Kind::Local, |axis| format!("pos_{axis}_in_local"))?,
            global: triple(Kind::Global, |axis| format!("pos_{axis}_in_global"))?,
        };
        match (columns.of_body, columns.local.or(columns.global)) {
            (None, None) => Err(missing("x")),
            (Some(_), Some([other, ..])) => {
                let message = "there are the columns x, y, z and those of MuSkeMo: leave one kind out";
                Err(TableFault::of_header(other, message.to_owned()))
            }
            _ => Ok(columns),
        }
    }
}

fn kind(header: &str) -> Result<Kind, String> {
    if header.is_empty() || header.starts_with('#') {
        return Ok(Kind::Remark);
    }
    let lower = header.to_ascii_lowercase();
    let (name, unit) = without_unit(&lower);
    let Some((_, kind)) = KNOWN.iter().find(|(known, _)| *known == name) else {
        return Err(format!("the column '{header}' is not known, expected {EXPECTED}"));
    };
    match unit {
        None | Some("m") => Ok(*kind),
        Some(_) => Err(format!(
            "the column '{header}' is not in metres: write its numbers in metres, and [m] or no unit"
        )),
    }
}

/// `radius [m]` and `radius(m)` as `radius` and `m`.
fn without_unit(header: &str) -> (&str, Option<&str>) {
    for (open, close) in [('(', ')'), ('[', ']')] {
        let parts = header.strip_suffix(close).and_then(|rest| rest.split_once(open));
        if let Some((name, unit)) = parts {
            return (name.trim_ascii_end(), Some(unit.trim_ascii()));
        }
    }
    (header, None)
}
