//! Prepares the data for a figure: bodies, feet, a recorded motion, or columns of a table.

use std::collections::HashSet;
use std::path::Path;

use contact_scaling::Ratios;
use osim_inspect::series::ContactBody;
use osim_inspect::{ContactsOrigin, Stance, find_misplaced_spheres, unexplained_mass};
use osim_model::feet::{AttachedBones, DefaultPose, FeetFault, Foot, FootBodies, MeshFolders};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, phrase, readable};
use osim_model::{Anatomy, Fault, Finding, ForceId, MassRequest, Model, Selection, SphereId};
use osim_requests::{HeatOptions, MotionRequest, PlotRequest, RequestFault, Result};

use crate::motion::{MotionResult, run_motion};
use crate::opening::ModelOrPreset;
use crate::sheet::Sheet;

/// The feet that a figure shows, in one or two states, the later state last: the feet of a model, the same feet with radii scaled to the
/// target mass, or the feet of a second model.
///
/// # Errors
/// A preset, which has no places, too many models, or a model that cannot be read or has no feet.
pub fn plot_feet(request: &PlotRequest, files: &dyn Files) -> Result<Vec<ModelFeet>> {
    let states = request.models.len() + usize::from(request.target_mass.is_some());
    if states > 2 {
        return Err(RequestFault::general(phrase![
            "feet are drawn for one model, or two (before and after): name one or two; {} goes with one only";
            Input::TargetMass
        ])
        .into());
    }
    let mut feet = Vec::new();
    for path in &request.models {
        let (feet_of_model, scaled) = feet_and_scaled_feet(request, path, files)?;
        feet.push(feet_of_model);
        feet.extend(scaled);
    }
    Ok(feet)
}

/// The feet of a model, and the same feet with radii scaled to the target mass if there is one.
fn feet_and_scaled_feet(
    request: &PlotRequest,
    path: &Path,
    files: &dyn Files,
) -> Result<(ModelFeet, Option<ModelFeet>)> {
    let open = match ModelOrPreset::find(path, request.presets.as_deref(), &request.set_files, files)? {
        ModelOrPreset::Model(open) => open,
        ModelOrPreset::Preset(preset) => {
            let why = format!("{} is a preset, which has no feet: name a model", preset.name);
            return Err(RequestFault::general(why).into());
        }
    };
    let name = short_name(path);
    let mut feet = ModelFeet::of_selection(&name, &open, &request.choice.selection())?;
    let geometry = request.geometry_dir.as_deref();
    // For a standalone set, the bones are those of the model beside it.
    let beside = request.set_files.model.as_deref().unwrap_or(path);
    feet.add_bones(&open.model, beside, geometry, files);
    let Some(target_mass) = request.target_mass else { return Ok((feet, None)) };
    let failed = |fault| open.failure(fault);
    let selected = request.choice.selection().apply(&open.model).map_err(failed)?;
    let origin =
        ContactsOrigin::find(&open.model, &selected.forces, &request.masses.request(), &Stance::default());
    let contacts_mass = origin.map_err(failed)?.mass;
    let ratios =
        Ratios::isometric(target_mass.get() / contacts_mass.kg).map_err(|error| failed(Fault::new(error)))?;
    let scaled = feet.with_radii(format!("scaled to {} kg", readable(target_mass.get())), ratios.radius());
    Ok((feet, Some(scaled)))
}

/// Computes the motion that a figure of motion shows.
///
/// # Errors
/// More than one model, or none; a recording that cannot be read.
pub fn plot_motion(request: &PlotRequest, files: &dyn Files) -> Result<MotionResult> {
    let [model] = request.models.as_slice() else {
        return Err(RequestFault::general("a figure of motion shows one model: name it alone").into());
    };
    let motion = MotionRequest {
        subject: Some(model.clone()),
        motion: request.motion.clone(),
        plates: request.plates.clone(),
        loads: request.loads.clone(),
        angles: request.angles,
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        set_files: request.set_files.clone(),
        ..MotionRequest::default()
    };
    run_motion(&motion, files)
}

/// All bodies of a figure of curves: the bodies that the request names, each followed by the scaled body if a target mass is given.
///
/// # Errors
/// A name that is neither a model's nor a preset's, or a model that cannot be read.
pub fn plot_bodies(request: &PlotRequest, files: &dyn Files) -> Result<Vec<ContactBody>> {
    let mut bodies = Vec::new();
    for path in &request.models {
        let body = plotted_body(request, path, &unique_name(request, path), files)?;
        let scaled =
            request.target_mass_kg().map(|target_mass_kg| body.scaled(target_mass_kg)).transpose()?;
        bodies.push(body);
        bodies.extend(scaled);
    }
    Ok(bodies)
}

/// The name of a model; with its folder if another model of the request has the same name.
fn unique_name(request: &PlotRequest, path: &Path) -> String {
    let name = short_name(path);
    let alike = request.models.iter().filter(|other| short_name(other) == name).count() > 1;
    match path.parent().and_then(Path::file_name).filter(|_| alike) {
        Some(folder) => format!("{}/{name}", folder.to_string_lossy()),
        None => name,
    }
}

/// The contacts to plot as `name`: those of the model at `path`, or a preset.
fn plotted_body(request: &PlotRequest, path: &Path, name: &str, files: &dyn Files) -> Result<ContactBody> {
    let masses = request.masses.request();
    let stance = Stance::from(&request.counts.stance_options(None, request.gravity));
    match ModelOrPreset::find(path, request.presets.as_deref(), &request.set_files, files)? {
        ModelOrPreset::Preset(preset) => {
            let body = ContactBody::from_preset(&preset, &masses, &stance);
            Ok(body.map_err(|error| RequestFault::general(error.to_string()))?)
        }
        ModelOrPreset::Model(open) => {
            let given_masses = MassRequest { target_mass_kg: request.target_mass_kg(), ..masses.clone() };
            let selection = request.choice.selection();
            let asked = request.answers.require_yes(unexplained_mass(&given_masses, &open.model, &selection));
            asked.map_err(|kind| open.failure(Fault::new(kind)))?;
            let selected = selection.apply(&open.model).map_err(|fault| open.failure(fault))?;
            let (name, forces, failed) = (name.to_owned(), &selected.forces, |fault| open.failure(fault));
            Ok(ContactBody::from_model(name, &open.model, forces, &masses, &stance, &failed)?)
        }
    }
}

/// The name of the file without folders and ending, which would be too long for a legend.
fn short_name(path: &Path) -> String {
    path.file_stem().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// The largest number of spheres in a model whose feet a page shows.
const MOST_SPHERES_ON_PAGE: usize = 200;
/// The largest number of bodies in a model whose feet a page shows.
const MOST_BODIES_ON_PAGE_OF_FEET: usize = 1000;

/// The feet of a model in one state, for figures.
#[derive(Debug, Clone)]
pub struct ModelFeet {
    pub name: String,
    pub feet: Vec<Foot>,
    /// The finding that spheres are in wrong places.
    pub misplaced: Option<Finding>,
    /// A fault for each bone that could not be read.
    pub missing: Vec<FeetFault>,
    anatomy: Anatomy,
    pose: DefaultPose,
    bodies: Vec<FootBodies>,
}

impl ModelFeet {
    /// The feet of a model without their bones. If `selection` chooses forces, only their spheres are shown.
    ///
    /// # Errors
    /// A number that cannot be read, no force that is chosen, or no feet.
    fn of_selection(name: &str, opened: &OpenModel, selection: &Selection) -> Result<Self, Failure> {
        let feet = Self::find(name, &opened.model, selection).map_err(|fault| opened.failure(fault))?;
        if feet.feet.is_empty() {
            let why = "there are no feet to draw: the model has no contact sphere that moves, and no body near the ground has \
                       a side in its name, such as calcn_r";
            return Err(opened.failure(Fault::refused(why)));
        }
        Ok(feet)
    }

    /// The feet for a page; `None` if the model has no feet, or too many spheres or bodies for a page.
    pub fn for_page(name: &str, opened: &OpenModel, selection: &Selection) -> Option<Self> {
        let model = &opened.model;
        let few = model.spheres().len() <= MOST_SPHERES_ON_PAGE
            && model.bodies().len() <= MOST_BODIES_ON_PAGE_OF_FEET;
        few.then(|| Self::of_selection(name, opened, selection).ok()).flatten()
    }

    /// The feet of `model` at its default pose, without bones.
    fn find(name: &str, model: &Model, selection: &Selection) -> Result<Self, Fault> {
        let anatomy = Anatomy::of(model)?;
        let pose = DefaultPose::of(model);
        let (spheres, forces) = spheres_and_forces(model, selection)?;
        let bodies = FootBodies::find(model, &anatomy, &spheres, &forces, &pose);
        let mut feet = Foot::all(model, &anatomy, &bodies, &pose);
        let misplaced = find_misplaced_spheres(model);
        if let Some(finding) = &misplaced {
            let names: HashSet<&String> = finding.spheres.iter().collect();
            for sphere in feet.iter_mut().flat_map(|foot| &mut foot.spheres) {
                sphere.misplaced = names.is_empty() || names.contains(&sphere.name);
            }
        }
        Ok(Self { name: name.to_owned(), feet, misplaced, missing: Vec::new(), anatomy, pose, bodies })
    }

    /// Adds the bones whose meshes are in the folder of the model, in its subfolder `Geometry`, or in `geometry_dir`.
    pub fn add_bones(&mut self, model: &Model, path: &Path, geometry_dir: Option<&Path>, files: &dyn Files) {
        let mut folders = MeshFolders::of_model(path);
        if let Some(folder) = geometry_dir {
            folders = folders.with_folder(folder);
        }
        let attached = AttachedBones::of(model);
        for (foot, bodies) in self.feet.iter_mut().zip(&self.bodies) {
            let mut bones_of_foot = Vec::new();
            for body in foot.bodies_with_bones(&self.anatomy, bodies) {
                match attached.bones(&body, &folders, files) {
                    Ok(bones) => bones_of_foot.extend(bones),
                    Err(FeetFault::NoMesh { .. }) => {}
                    Err(fault) => self.missing.push(fault),
                }
            }
            foot.add_bones(&self.anatomy, bodies, &bones_of_foot, &self.pose);
        }
    }

    /// The feet with all radii multiplied by `ratio`. The centres of the spheres stay.
    pub(crate) fn with_radii(&self, name: String, ratio: f64) -> Self {
        let mut scaled = Self { name, ..self.clone() };
        for sphere in scaled.feet.iter_mut().flat_map(|foot| &mut foot.spheres) {
            sphere.radius_m *= ratio;
        }
        scaled
    }

    pub fn has_spheres(&self) -> bool {
        self.feet.iter().any(|foot| !foot.spheres.is_empty())
    }

    /// Whether both feet have the same spheres at the same places.
    pub(crate) fn has_same_spheres(&self, other: &Self) -> bool {
        let spheres = |feet: &Self| -> Vec<_> { feet.feet.iter().map(|foot| foot.spheres.clone()).collect() };
        spheres(self) == spheres(other)
    }
}

/// The spheres to draw, and the forces by which limbs are found.
fn spheres_and_forces(model: &Model, selection: &Selection) -> Result<(Vec<SphereId>, Vec<ForceId>), Fault> {
    let moving = |id: &SphereId| model.sphere(*id).is_some_and(|sphere| !sphere.fixed);
    if *selection == Selection::default() {
        let spheres = model.spheres().iter().map(|sphere| sphere.id).filter(moving).collect();
        return Ok((spheres, model.force_ids()));
    }
    let forces = selection.apply(model)?.forces;
    let used = forces.iter().filter_map(|&id| model.force(id)).flat_map(osim_model::Force::spheres);
    let mut spheres: Vec<SphereId> = used.copied().filter(moving).collect();
    spheres.sort_unstable();
    spheres.dedup();
    Ok((spheres, forces))
}

/// The beginning of the names of columns with the values of a sweep's grid.
const GRID_PREFIX: &str = "grid_";

/// A column of numbers in a table, for a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct TableColumn {
    pub name: String,
    /// A number for each row; `None` for an empty cell.
    pub values: Vec<Option<f64>>,
}

/// A column of a table over one or two other columns, such as a result over the grid of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatTable {
    /// The name of the file without its folders.
    pub name: String,
    /// The column of the table that is drawn along the horizontal axis.
    pub x: TableColumn,
    /// The column along the vertical axis; `None` if the table varies only one quantity.
    pub y: Option<TableColumn>,
    /// The quantity that is drawn as a colour, or as the height of a curve.
    pub value: TableColumn,
}

impl HeatTable {
    /// Reads the columns that `options` name from the table at `path`.
    ///
    /// # Errors
    /// The table cannot be read, a column is missing (with those that are there) or is not clear, or a cell is not a number.
    pub fn read(path: &Path, options: &HeatOptions, files: &dyn Files) -> Result<Self, Failure> {
        let failed = |why: String| Failure::outside(path.display().to_string(), "table", why);
        let bytes = files.read(path).map_err(|error| failed(error.to_string()))?;
        let sheet = Sheet::read(&bytes).map_err(failed)?;
        let name = path.file_stem().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        Self::of_sheet(name, &sheet, options).map_err(failed)
    }

    /// Takes the columns of a figure from a table.
    fn of_sheet(name: String, sheet: &Sheet, options: &HeatOptions) -> Result<Self, String> {
        let grid: Vec<&str> =
            sheet.header.iter().map(String::as_str).filter(|name| name.starts_with(GRID_PREFIX)).collect();
        let (x, y) = match (options.x_column.as_deref(), options.y_column.as_deref()) {
            (Some(x), y) => (x, y),
            (None, y) => match (grid.as_slice(), y) {
                ([x], y) => (*x, y),
                ([x, y], None) => (*x, Some(*y)),
                _ => {
                    return Err(format!(
                        "the table has {} columns that begin with '{GRID_PREFIX}', expected one or two: choose the columns for the axes; there are {}",
                        grid.len(),
                        sheet.listed_columns()
                    ));
                }
            },
        };
        let value = options.value_column.as_deref().unwrap_or_default();
        let column = |name: &str| number_column(sheet, name);
        Ok(Self { name, x: column(x)?, y: y.map(column).transpose()?, value: column(value)? })
    }
}

/// The numbers of the column called `name`; empty cells have none.
fn number_column(sheet: &Sheet, name: &str) -> Result<TableColumn, String> {
    let index = sheet.column(name)?;
    let value = |row: &crate::sheet::Row| match row.cells.get(index).map(String::as_str) {
        None | Some("") => Ok(None),
        Some(cell) => sheet
            .number(cell)
            .map(Some)
            .map_err(|why| format!("line {}, column '{name}': '{cell}' {why}", row.line)),
    };
    let values = sheet.rows.iter().map(value).collect::<Result<_, _>>()?;
    Ok(TableColumn { name: sheet.header.get(index).cloned().unwrap_or_default(), values })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_heat_table(table: &str, x: Option<&str>, y: Option<&str>) -> Result<HeatTable, String> {
        let options = HeatOptions {
            value_column: Some("speed".to_owned()),
            x_column: x.map(str::to_owned),
            y_column: y.map(str::to_owned),
            ..HeatOptions::default()
        };
        HeatTable::of_sheet("t".to_owned(), &Sheet::read(table.as_bytes()).unwrap(), &options)
    }

    #[test]
    fn columns_of_the_grid_become_axes() {
        let table =
            read_heat_table("file,grid_stiffness,grid_dissipation,speed\na,1,2,3\nb,1,4,\n", None, None)
                .unwrap();
        assert_eq!(
            (table.x.name.as_str(), table.x.values.as_slice()),
            ("grid_stiffness", &[Some(1.0), Some(1.0)][..])
        );
        assert_eq!(table.y.unwrap().values, [Some(2.0), Some(4.0)]);
        assert_eq!(table.value.values, [Some(3.0), None]);
        assert!(read_heat_table("grid_stiffness,speed\n1,2\n", None, None).unwrap().y.is_none());
    }

    #[test]
    fn unclear_columns_are_refused() {
        let refused = |table: &str, x, words: &str| {
            let message = read_heat_table(table, x, None).unwrap_err();
            assert!(message.contains(words), "{message}");
        };
        refused("a,speed\n1,2\n", None, "0 columns that begin with 'grid_'");
        refused("grid_a,grid_b,grid_c,speed\n1,2,3,4\n", None, "choose the columns");
        refused("a,speed\n1,2\n", Some("b"), "no column 'b'");
        refused("a,speed\n1,fast\n", Some("a"), "line 2, column 'speed': 'fast' is not a number");
    }
}
