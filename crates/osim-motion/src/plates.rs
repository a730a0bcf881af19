//! Reads ground reaction forces and centres of pressure of force plates: from the columns of a table, by their names or by an
//! `ExternalLoads` file.

use osim_model::{DVec3, Document, ElementId, opensim_text};

use crate::{Column, Gap, MotionFault, Table, Wrench, gaps};

/// A force plate with its measurements.
#[derive(Debug, Clone, PartialEq)]
pub struct Plate {
    /// Common beginning of the names of the plate's columns in the file.
    pub name: String,
    /// The body on which the plate's force acts, if an `ExternalLoads` file names it.
    pub body: Option<String>,
    /// Whether the file has centres of pressure of the plate, or moments about a fixed point. If all centres are 0, it has none, and
    /// the moments have no meaning.
    pub has_points: bool,
    time_s: Vec<f64>,
    /// The force and moment at each time.
    wrenches: Vec<Wrench>,
    /// Gaps in which the force is not known.
    gaps: Vec<Gap>,
}

/// In gaps of at most this length, s, forces are taken along straight lines. In longer ones, no force is known.
pub const LONGEST_BRIDGED_GAP_S: f64 = 0.05 + 1e-6;

impl Plate {
    /// The plates of a table of ground reactions, by the names of its columns.
    ///
    /// # Errors
    /// No columns of a force, or a missing number.
    pub fn from_columns(table: &Table) -> Result<Vec<Self>, MotionFault> {
        let triples = columns_of_plates(table);
        let forces = || triples.iter().filter(|one| one.quantity == PlateQuantity::Force);
        if forces().next().is_none() {
            return Err(MotionFault::new(
                "it has no columns of a force that are known, such as ground_force_vx, ground_force_vy and ground_force_vz: an \
                 ExternalLoads file says which columns are forces",
            ));
        }
        let plate = |force: &ColumnTriple<'_>| {
            let columns = |quantity: PlateQuantity| {
                let other = triples.iter().find(|one| one.quantity == quantity && one.plate == force.plate);
                other.map(|one| one.columns)
            };
            let [point, torque] = [PlateQuantity::CentreOfPressure, PlateQuantity::Moment].map(columns);
            Self::new(table, &force.stem, None, [Some(force.columns), point, torque])
        };
        forces().map(plate).collect()
    }

    /// The plates that an `ExternalLoads` file lists.
    ///
    /// # Errors
    /// Missing columns, a frame other than ground, or a missing number.
    pub fn from_loads(table: &Table, loads: &ExternalLoads) -> Result<Vec<Self>, MotionFault> {
        let mut plates = Vec::new();
        for load in loads.loads.iter().filter(|load| load.applies) {
            let columns = |prefix: &Option<String>| {
                prefix.as_deref().map(|prefix| columns_with_prefix(table, prefix)).transpose()
            };
            let mut frames = [&load.force_frame, &load.point_frame].into_iter();
            if let Some(frame) = frames.find(|frame| !["", "ground", "/ground"].contains(&frame.as_str())) {
                let text = format!("load '{}' is expressed in '{frame}'", load.name);
                return Err(MotionFault::new(format!("{text}: only loads in ground are understood")));
            }
            let triples = [columns(&load.force)?, columns(&load.point)?, columns(&load.torque)?];
            let name = load.force.as_deref().unwrap_or(&load.name);
            plates.push(Self::new(table, name, load.body.clone(), triples)?);
        }
        if plates.is_empty() {
            return Err(MotionFault::new("none of the loads of the ExternalLoads file is applied"));
        }
        Ok(plates)
    }

    /// Reads the plate `name` from its three columns each of force, point and torque.
    fn new(
        table: &Table,
        name: &str,
        body: Option<String>,
        [force, point, torque]: [Option<[&Column; 3]>; 3],
    ) -> Result<Self, MotionFault> {
        for column in [force, point, torque].into_iter().flatten().flatten() {
            table.check_finite(column)?;
        }
        let at = |columns: Option<[&Column; 3]>, row: usize| {
            columns.map_or(DVec3::ZERO, |columns| columns.map(|column| column.values[row]).into())
        };
        let is_point = |column: &Column| {
            let is_electrical_centre = column.name.to_ascii_lowercase().starts_with(ELECTRICAL_CENTRE_PREFIX);
            is_electrical_centre || column.values.iter().any(|&at| at != 0.0)
        };
        let has_points = point.into_iter().flatten().any(is_point);
        let wrenches = (0..table.rows())
            .map(|row| {
                let free = Wrench { moment_n_m: at(torque, row), ..Wrench::default() };
                free.with_force(at(force, row), at(point, row))
            })
            .collect();
        let gaps =
            gaps(&table.time_s).into_iter().filter(|gap| gap.length_s() > LONGEST_BRIDGED_GAP_S).collect();
        Ok(Self { name: name.to_owned(), body, has_points, time_s: table.time_s.clone(), wrenches, gaps })
    }

    /// The force at a time, interpolated linearly; `None` before the first and after the last measurement, and in a long gap.
    pub fn at(&self, time_s: f64) -> Option<Wrench> {
        /// Times of two files that differ by no more than this are the same, s: by rounding, motion data can begin before the plates.
        const SAME_TIME_S: f64 = 1e-6;
        if self.gaps.iter().any(|gap| gap.from_s < time_s && time_s < gap.to_s) {
            return None;
        }
        let after = self.time_s.partition_point(|&time| time < time_s);
        match (after.checked_sub(1).and_then(|before| self.wrench_of_row(before)), self.wrench_of_row(after))
        {
            (Some((t0, w0)), Some((t1, w1))) => Some(w0.interpolate(&w1, (time_s - t0) / (t1 - t0))),
            (None, Some((first, wrench))) if first - time_s <= SAME_TIME_S => Some(wrench),
            (Some((last, wrench)), None) if time_s - last <= SAME_TIME_S => Some(wrench),
            _ => None,
        }
    }

    /// Whether the plate measures nothing but noise at these times.
    pub(crate) fn is_idle(&self, time_s: &[f64]) -> bool {
        const NOISE_N: f64 = 20.0;
        time_s.iter().filter_map(|&time_s| self.at(time_s)).all(|wrench| wrench.force_n.length() <= NOISE_N)
    }

    /// The time of the measurement `row`, and its force and moment; `None` after the last measurement.
    fn wrench_of_row(&self, row: usize) -> Option<(f64, Wrench)> {
        Some((*self.time_s.get(row)?, *self.wrenches.get(row)?))
    }
}

impl Wrench {
    /// The linear interpolation between two wrenches; `part` 0 gives `self`, 1 gives `other`.
    fn interpolate(&self, other: &Self, part: f64) -> Self {
        let mixed = |a: DVec3, b: DVec3| a + part * (b - a);
        Self {
            force_n: mixed(self.force_n, other.force_n),
            moment_n_m: mixed(self.moment_n_m, other.moment_n_m),
        }
    }
}

// OpenSim's `ExternalLoads`: which columns act on which body.

/// The content of an `ExternalLoads` file, which says where the force plates' columns are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExternalLoads {
    pub loads: Vec<ExternalLoad>,
    /// Name of the file of forces, from the element `<datafile>`.
    pub data_file: Option<String>,
}

/// An element `<ExternalForce>` of an `ExternalLoads` file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExternalLoad {
    pub name: String,
    pub applies: bool,
    /// The body on which the force acts.
    pub body: Option<String>,
    /// The frame in which the force is given; empty for ground.
    pub force_frame: String,
    pub point_frame: String,
    /// Common beginning of the names of the force columns.
    pub force: Option<String>,
    /// Common beginning of the names of the columns of the point where the force acts.
    pub point: Option<String>,
    /// Common beginning of the names of the moment columns.
    pub torque: Option<String>,
}

impl ExternalLoads {
    /// Reads an `ExternalLoads` file from its bytes.
    ///
    /// # Errors
    /// The bytes are not XML, or the root element is not `ExternalLoads`.
    pub fn read(bytes: &[u8]) -> Result<Self, MotionFault> {
        if !bytes.contains(&b'<') {
            return Err(MotionFault::new("it is not XML, expected an ExternalLoads file"));
        }
        let document =
            Document::parse(bytes.to_vec()).map_err(|fault| MotionFault::new(fault.to_string()))?;
        let tree = document.tree();
        let root = document.data_root();
        if tree.name(root) != "ExternalLoads" {
            let text = "not an <ExternalLoads>, which says which columns act on which body";
            return Err(MotionFault::new(format!("it is a <{}>, {text}", tree.name(root))));
        }
        let objects = tree.child(root, "objects");
        let forces = objects.into_iter().flat_map(|objects| tree.children(objects));
        let forces = forces.filter(|&id| matches!(tree.name(id), "ExternalForce" | "PrescribedForce"));
        let loads = forces.map(|force| ExternalLoad::read(&document, force)).collect();
        Ok(Self { loads, data_file: child_text(&document, root, "datafile") })
    }

    /// The file name in `datafile`, without its folders.
    pub fn data_file_name(&self) -> Option<&str> {
        self.data_file.as_deref().and_then(|path| path.rsplit(['/', '\\']).next())
    }
}

impl ExternalLoad {
    /// Reads an element `<ExternalForce>`.
    fn read(document: &Document, force: ElementId) -> Self {
        let tree = document.tree();
        let get = |tag| child_text(document, force, tag);
        // Before version 4, `isDisabled` said the opposite.
        let is_false = |text: &String| matches!(text.as_str(), "false" | "0");
        let applies = get("appliesForce").is_none_or(|text| !is_false(&text))
            && get("isDisabled").is_none_or(|text| is_false(&text));
        Self {
            name: tree.attribute(force, "name").unwrap_or_default().into_owned(),
            applies,
            body: get("applied_to_body"),
            force_frame: get("force_expressed_in_body").unwrap_or_default(),
            point_frame: get("point_expressed_in_body").unwrap_or_default(),
            force: get("force_identifier"),
            point: get("point_identifier"),
            torque: get("torque_identifier"),
        }
    }
}

/// The text of a child element; `None` if it is empty or `Unassigned`.
fn child_text(document: &Document, owner: ElementId, tag: &str) -> Option<String> {
    let tree = document.tree();
    let text = tree.text_of(tree.child(owner, tag)?);
    let text = opensim_text::trimmed(&text);
    (!text.is_empty() && text != "Unassigned").then(|| text.to_owned())
}

// Which columns are the components of a force, of its centre of pressure, and of its moment.

/// Three columns whose names differ only in x, y and z at the end.
struct ColumnTriple<'t> {
    /// Common beginning of the names of the three columns.
    stem: String,
    columns: [&'t Column; 3],
    quantity: PlateQuantity,
    /// The part of the column names by which plates differ: the stem without words such as `force`.
    plate: String,
}

/// The quantity in three columns of a plate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum PlateQuantity {
    Force,
    CentreOfPressure,
    Moment,
}

/// How the names of the three columns of a vector end; OpenSim's reader of C3D files numbers them.
const ENDS_OF_COLUMNS: [[&str; 3]; 3] = [["x", "y", "z"], ["X", "Y", "Z"], ["_1", "_2", "_3"]];

/// The columns of all plates in a table of ground reactions.
fn columns_of_plates(table: &Table) -> Vec<ColumnTriple<'_>> {
    let mut triples = Vec::new();
    for column in &table.columns {
        let named = ENDS_OF_COLUMNS.iter().find_map(|ends| Some((column.name.strip_suffix(ends[0])?, ends)));
        let Some((stem, ends)) = named else { continue };
        let Some((quantity, plate)) = quantity_and_plate(stem) else { continue };
        let [Some(y), Some(z)] = [ends[1], ends[2]].map(|end| table.column(&format!("{stem}{end}"))) else {
            continue;
        };
        triples.push(ColumnTriple { stem: stem.to_owned(), columns: [column, y, z], quantity, plate });
    }
    triples
}

/// The begin of the names of columns with a plate's electrical centre: moments are about it.
const ELECTRICAL_CENTRE_PREFIX: &str = "ec";

/// The quantity and the plate of columns with this stem; examples are `ground_force_v`, `1_ground_force_p`, `ground_torque_r_`,
/// `l_ground_moment_m`, `F1`, `M1`, `COP1`; NMSM has moments about a fixed point, `EC1`.
fn quantity_and_plate(stem: &str) -> Option<(PlateQuantity, String)> {
    let lower = stem.to_ascii_lowercase();
    let numbered = lower.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    if !numbered.is_empty() && numbered.chars().all(|c| c.is_ascii_digit()) {
        let quantity = match lower.strip_suffix(numbered)? {
            "f" | "force" => PlateQuantity::Force,
            "p" | "cop" | ELECTRICAL_CENTRE_PREFIX => PlateQuantity::CentreOfPressure,
            "m" | "t" | "moment" => PlateQuantity::Moment,
            _ => return None,
        };
        return Some((quantity, numbered.to_owned()));
    }
    let is_moment = lower.contains("torque") || lower.contains("moment");
    let quantity = match lower.rsplit(['_', '.']).next()? {
        end if is_moment || end == "m" && lower.contains("force") => PlateQuantity::Moment,
        "v" if lower.contains("force") => PlateQuantity::Force,
        "p" if lower.contains("force") || lower.contains("cop") => PlateQuantity::CentreOfPressure,
        _ => return None,
    };
    let words = ["ground", "force", "torque", "moment", "v", "p", "m", "cop"];
    let rest: Vec<&str> =
        lower.split(['_', '.']).filter(|part| !part.is_empty() && !words.contains(part)).collect();
    Some((quantity, rest.join("_")))
}

/// The three columns whose names begin with `prefix`; `ExternalLoads` files give such prefixes.
fn columns_with_prefix<'t>(table: &'t Table, prefix: &str) -> Result<[&'t Column; 3], MotionFault> {
    let exact = ["x", "y", "z"].map(|axis| table.column(&format!("{prefix}{axis}")));
    if let [Some(x), Some(y), Some(z)] = exact {
        return Ok([x, y, z]);
    }
    let found: Vec<&Column> = table.columns.iter().filter(|column| column.name.starts_with(prefix)).collect();
    match found.as_slice() {
        [x, y, z] => Ok([x, y, z]),
        _ => Err(MotionFault::new(format!(
            "the ExternalLoads file names three columns that begin with '{prefix}', and the table has {}",
            found.len()
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed_table(text: &str) -> Table {
        Table::read(text.as_bytes()).unwrap()
    }

    #[test]
    fn plates_are_found_by_their_columns() {
        let text = "endheader\ntime 1_ground_force_vx 1_ground_force_vy 1_ground_force_vz 1_ground_force_px 1_ground_force_py \
            1_ground_force_pz 1_ground_torque_x 1_ground_torque_y 1_ground_torque_z F2x F2y F2z other\n\
            0 0 100 0 0.5 0 0.1 0 7 0 1 2 3 9\n1 0 200 0 0.5 0 0.1 0 7 0 1 2 3 9\n";
        let plates = Plate::from_columns(&parsed_table(text)).unwrap();
        assert_eq!(
            plates.iter().map(|plate| (plate.name.as_str(), plate.has_points)).collect::<Vec<_>>(),
            [("1_ground_force_v", true), ("F2", false)]
        );
        // Halfway: 150 N up at (0.5, 0, 0.1), and 7 N m about y.
        let half = plates[0].at(0.5).unwrap();
        assert_eq!(
            (half.force_n, half.moment_n_m),
            (DVec3::new(0.0, 150.0, 0.0), DVec3::new(-15.0, 7.0, 75.0))
        );
        assert_eq!((plates[0].at(-0.1), plates[0].at(1.1)), (None, None));
        assert_eq!(plates[0].at(1.0).unwrap().force_n[1], 200.0);
        assert_eq!(plates[1].at(0.0).unwrap().force_n, DVec3::new(1.0, 2.0, 3.0));
    }

    #[test]
    fn no_force_is_known_in_a_long_gap() {
        let rows = [0.0, 0.01, 0.02, 0.06, 0.07, 0.14].map(|time| format!("{time} 0 {} 0\n", 1e3 * time));
        let text = format!("endheader\ntime F1x F1y F1z\n{}", rows.concat());
        let plate = Plate::from_columns(&parsed_table(&text)).unwrap().remove(0);
        let force_n = |time_s: f64| plate.at(time_s).map(|wrench| wrench.force_n[1].round());
        assert_eq!([0.04, 0.07, 0.1, 0.14].map(force_n), [Some(40.0), Some(70.0), None, Some(140.0)]);
    }

    #[test]
    fn columns_of_a_c3d_file_are_numbered() {
        let text = "endheader\ntime f1_1 f1_2 f1_3 p1_1 p1_2 p1_3 m1_1 m1_2 m1_3\n0 1 2 3 0.5 0 0 0 7 0\n";
        let plates = Plate::from_columns(&parsed_table(text)).unwrap();
        let wrench = plates[0].at(0.0).unwrap();
        assert_eq!((plates.len(), wrench.force_n), (1, DVec3::new(1.0, 2.0, 3.0)));
        // p x F + M
        assert_eq!(wrench.moment_n_m, DVec3::new(0.0, -1.5 + 7.0, 1.0));
    }

    /// 100 N up at the centre (0.2, 0, 0) add 20 N m about z to the moment there.
    #[test]
    fn moments_of_nmsm_are_about_the_electrical_centre() {
        let text = "endheader\ntime F1x F1y F1z M1x M1y M1z EC1x EC1y EC1z\n0 0 100 0 -10 7 30 0.2 0 0\n1 0 100 0 -10 7 30 0.2 0 0\n";
        let plates = Plate::from_columns(&parsed_table(text)).unwrap();
        assert!(plates[0].has_points);
        assert_eq!(plates[0].at(0.5).unwrap().moment_n_m, DVec3::new(-10.0, 7.0, 50.0));
        let at_origin = text.replace("0.2 0 0", "0 0 0");
        assert!(Plate::from_columns(&parsed_table(&at_origin)).unwrap()[0].has_points);
    }

    #[test]
    fn external_loads_name_the_columns_of_plates() {
        let xml = "<OpenSimDocument Version=\"40000\"><ExternalLoads><objects><ExternalForce name=\"R\"><applied_to_body>calcn_r\
           </applied_to_body><force_identifier>a_</force_identifier><point_identifier>b_</point_identifier>\
           </ExternalForce></objects></ExternalLoads></OpenSimDocument>";
        let loads = ExternalLoads::read(xml.as_bytes()).unwrap();
        let text = "endheader\ntime a_x a_y a_z b_x b_y b_z\n0 0 10 0 0 0 0\n";
        let plates = Plate::from_loads(&parsed_table(text), &loads).unwrap();
        assert_eq!((plates[0].body.as_deref(), plates[0].has_points), (Some("calcn_r"), false));
        let lost = Plate::from_loads(&parsed_table("endheader\ntime a_x a_y\n0 0 1\n"), &loads).unwrap_err();
        assert!(lost.message.contains("'a_'"), "{lost}");
        assert!(Plate::from_columns(&parsed_table(text)).is_err());
    }

    #[test]
    fn column_names_of_known_laboratories_are_understood() {
        let plate =
            |stem: &str| quantity_and_plate(stem).map(|(quantity, plate)| (quantity, plate.leak() as &str));
        assert_eq!(plate("ground_force_v"), Some((PlateQuantity::Force, "")));
        assert_eq!(plate("ground_force_p"), Some((PlateQuantity::CentreOfPressure, "")));
        assert_eq!(plate("ground_torque_"), Some((PlateQuantity::Moment, "")));
        assert_eq!(plate("l_ground_torque_"), Some((PlateQuantity::Moment, "l")));
        assert_eq!(plate("1_ground_force_v"), Some((PlateQuantity::Force, "1")));
        assert_eq!(plate("R_ground_force_v"), Some((PlateQuantity::Force, "r")));
        assert_eq!(plate("ground_force_r_v"), Some((PlateQuantity::Force, "r")));
        assert_eq!(plate("ground_torque_r_"), Some((PlateQuantity::Moment, "r")));
        assert_eq!(plate("ground_force_1_v"), Some((PlateQuantity::Force, "1")));
        assert_eq!(plate("ground_moment_1_m"), Some((PlateQuantity::Moment, "1")));
        assert_eq!(plate("1_ground_torque_m"), Some((PlateQuantity::Moment, "1")));
        assert_eq!(plate("F1"), Some((PlateQuantity::Force, "1")));
        assert_eq!(plate("M12"), Some((PlateQuantity::Moment, "12")));
        assert_eq!(plate("knee_"), None);
        assert_eq!(plate("emg1"), None);
    }
}
