//! Places that are this model's own: those of a table, and those under its bones.

use std::cell::LazyCell;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

use osim_model::feet::{
    Bone, DefaultPose, FeetFault, MeshFolders, Sole, SoleRequest, TiltingCoordinate, bones, odd_size, soles,
};
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, four_significant, phrase, shown};
use osim_model::{Fault, Model, NeedsAnswer, Question, Side};
use osim_patch::{Layout, NewContact};
use osim_requests::options::AnswerOptions;

use super::bodies::{AddFault, meant, plain};
use super::reference::Numbers;
use crate::contact_table::{ContactRow, ContactTable, PlaceFault};
use crate::remarks::{Bones, pad_slip, parts_of_feet};

/// Feet whose poses differ by more than this are unequal, rad: a degree. At the fore end of a foot that is 2 % of its length.
const UNEQUAL: f64 = std::f64::consts::PI / 180.0;

pub(super) enum Places {
    Table(TablePlaces),
    Feet(FeetPlaces),
}

/// A table, read once for all models.
pub(super) struct TablePlaces {
    pub(super) name: String,
    pub(super) table: ContactTable,
    /// Whether places that are given in ground are those at the default pose.
    pub(super) posed: bool,
    /// Radius of all spheres, m, if the table has none and one was given.
    pub(super) radius_m: Option<f64>,
}

/// Bodies under whose meshes spheres are laid.
pub(super) struct FeetPlaces {
    pub(super) bodies: Vec<String>,
    pub(super) count: usize,
    pub(super) pad_m: f64,
    pub(super) geometry_dir: Option<PathBuf>,
    /// Radius of all spheres, m, if one was given.
    pub(super) radius_m: Option<f64>,
}

impl Places {
    /// Whether radii were given, in the table or for all.
    pub(super) fn has_radii(&self) -> bool {
        match self {
            Self::Table(table) => table.table.has_radii || table.radius_m.is_some(),
            Self::Feet(feet) => feet.radius_m.is_some(),
        }
    }

    /// The contacts of `model`, which is the file at `path`, with the numbers that they have before they are planned, and remarks
    /// about the places.
    pub(super) fn layout(
        &self,
        model: &Model,
        path: &Path,
        numbers: &Numbers,
        answers: &AnswerOptions,
        files: &dyn Files,
    ) -> Result<(Layout, Vec<Phrase>), AddFault> {
        let mut layout = Layout::default();
        let mut remarks = Vec::new();
        match self {
            Self::Table(table) => {
                layout.contacts = table.contacts(model, numbers, &mut remarks)?;
                answers.ask(table.place_slip(model, &layout)).map_err(Fault::new)?;
            }
            Self::Feet(feet) => {
                let radius_m = match feet.radius_m {
                    Some(said) => said,
                    None => numbers.radius(None)? * numbers.growth(model)?,
                };
                let soles = feet.soles((model, path), radius_m, (answers, files), &mut remarks)?;
                for sole in &soles {
                    answers.ask(pad_slip(sole, feet.pad_m)).map_err(Fault::new)?;
                    answers.ask(tilted(sole, model)).map_err(Fault::new)?;
                    layout.contacts.extend(under(sole, numbers)?);
                }
                answers.ask(unequal(&soles, model)).map_err(Fault::new)?;
                remarks.extend(parts_of_feet(model, &soles));
            }
        }
        if !self.has_radii() {
            remarks.extend(radii_of_reference(&layout));
        }
        Ok((layout, remarks))
    }
}

/// How large spheres are, if no radius was given.
fn radii_of_reference(layout: &Layout) -> Option<Phrase> {
    let radii = || layout.contacts.iter().map(|contact| contact.radius_m);
    let (least, most) = (radii().reduce(f64::min)?, radii().reduce(f64::max)?);
    let radii = match four_significant(least) == four_significant(most) {
        true => four_significant(least),
        false => format!("{} to {}", four_significant(least), four_significant(most)),
    };
    let text = format!("radii are the reference's, times the cube root of the masses' ratio (8): {radii} m");
    Some(text.into())
}

impl TablePlaces {
    fn contacts(
        &self,
        model: &Model,
        numbers: &Numbers,
        remarks: &mut Vec<Phrase>,
    ) -> Result<Vec<NewContact>, AddFault> {
        let bodies: HashSet<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
        let pose = LazyCell::new(|| DefaultPose::of(model));
        let mut growth = None;
        let (mut contacts, mut moved) = (Vec::new(), Vec::new());
        for row in &self.table.rows {
            let body = plain(&row.body);
            if !bodies.contains(body) {
                return Err(self.no_body(row, model));
            }
            let place = row.place.on_body(body, || &pose, self.posed);
            let place = place.map_err(|fault| self.refused(row, &fault))?;
            if place.from_default_pose {
                moved.push(row.name.as_str());
            }
            let radius_m = match (row.radius_m.or(self.radius_m), growth) {
                (Some(said), _) => said,
                (None, Some(growth)) => numbers.radius(Some(&row.name))? * growth,
                (None, None) => numbers.radius(Some(&row.name))? * *growth.insert(numbers.growth(model)?),
            };
            let mut contact = numbers.contact(&row.name, radius_m)?;
            contact.body = body.to_owned();
            contact.location_m = place.location_m;
            contacts.push(contact);
        }
        if !moved.is_empty() {
            let text = format!(
                "the table has these in ground only; they are where they stand there at the default pose: {}",
                moved.join(", ")
            );
            remarks.push(text.into());
        }
        Ok(contacts)
    }

    /// Which of its places is farthest from its bones, if that is too far.
    fn place_slip(&self, model: &Model, layout: &Layout) -> Option<NeedsAnswer> {
        let bones = Bones::of(model);
        let far = |contact: &NewContact| bones.distance(&contact.body, contact.location_m);
        let contacts = self.table.rows.iter().zip(&layout.contacts);
        let far = contacts.filter_map(|(row, contact)| Some((row, far(contact)?)));
        let (row, far) = far.max_by(|(_, a), (_, b)| a.times().total_cmp(&b.times()))?;
        far.place_slip(&self.at(row), &row.name, plain(&row.body))
    }

    fn no_body(&self, row: &ContactRow, model: &Model) -> AddFault {
        let bodies: Vec<String> = model.bodies().iter().map(|body| body.name.clone()).collect();
        let meant = meant(plain(&row.body), &bodies);
        let fault = FeetFault::NoBody { body: row.body.clone(), bodies };
        AddFault::Beside(fault.code(), phrase![self.at(row), &fault.phrase(), meant])
    }

    fn refused(&self, row: &ContactRow, fault: &PlaceFault) -> AddFault {
        let name = &row.name;
        match fault {
            PlaceFault::Pose(why) => {
                let why =
                    format!("{why}; give its place in columns x, y and z, in the frame of {}", row.body);
                AddFault::Beside("unknown-pose", phrase![self.at(row), why])
            }
            PlaceFault::OnlyGlobal => AddFault::Beside(
                "table",
                phrase![
                    self.at(row),
                    format!(
                        "{name} has a place in ground only, and {} is elsewhere: give its place in the frame of ",
                        row.body
                    ),
                    format!(
                        "{} (columns x, y, z, or pos_x_in_local and so on), or, if it was measured at the default pose, say ",
                        row.body
                    ),
                    Input::DefaultPose,
                ],
            ),
            PlaceFault::Disagree(apart_m) => {
                let text = format!(
                    "{name} has two places, and in this model they are {:.1} mm apart: remove the columns that are not meant (those in \
                     global, or those in local)",
                    1e3 * apart_m
                );
                AddFault::Beside("table", phrase![self.at(row), text])
            }
        }
    }

    fn at(&self, row: &ContactRow) -> String {
        format!("{}, line {}: ", self.name, row.line)
    }
}

impl FeetPlaces {
    fn soles(
        &self,
        (model, path): (&Model, &Path),
        radius_m: f64,
        (answers, files): (&AnswerOptions, &dyn Files),
        remarks: &mut Vec<Phrase>,
    ) -> Result<Vec<Sole>, AddFault> {
        let mut folders = MeshFolders::of_model(path);
        if let Some(folder) = &self.geometry_dir {
            folders = folders.with_folder(folder);
        }
        let bodies: Vec<&str> = self.bodies.iter().map(String::as_str).collect();
        let bones = bones(model, &bodies, &folders, files)?;
        answers.ask(bones.iter().find_map(|bone| size_slip(model, bone))).map_err(Fault::new)?;
        let nothing = |folder: &&PathBuf| !bones.iter().any(|bone| bone.file.starts_with(folder));
        if let Some(folder) =
            self.geometry_dir.as_ref().filter(nothing).filter(|folder| !files.exists(folder))
        {
            let folder = folder.display().to_string();
            remarks.push(phrase![
                Input::GeometryDir.with_value(folder),
                ": there is no such folder; the meshes are beside the model",
            ]);
        }
        let request = SoleRequest { count: self.count, radius_m, pad_m: self.pad_m };
        Ok(soles(model, &bones, &request)?)
    }
}

/// What is asked about a mesh in another unit, or of another animal.
fn size_slip(model: &Model, bone: &Bone) -> Option<NeedsAnswer> {
    let text = odd_size(model, bone)?.text;
    Some(NeedsAnswer::Other { question: Question::ImplausibleScale, text: text.into() })
}

/// What is asked about a foot that does not lie flat.
fn tilted(sole: &Sole, model: &Model) -> Option<NeedsAnswer> {
    let mut text: Phrase = sole.not_flat()?.into();
    let tilting = sole.tilted_by(model);
    text.push(&match tilting.is_empty() {
        false => phrase![format!(
            ": set default values of its joints at which it does, such as 0 (now {})",
            TiltingCoordinate::listed(&tilting)
        )],
        true => phrase![
            ": name the bodies that touch the ground with ",
            Input::Feet.with_placeholder("BODY,BODY"),
            ", or give the places in a table, ",
            Input::Contacts.with_placeholder("TABLE"),
        ],
    });
    Some(NeedsAnswer::Other { question: Question::TiltedFoot, text })
}

/// What is asked about a pair of feet of which one is turned otherwise than the other's mirror image.
fn unequal(soles: &[Sole], model: &Model) -> Option<NeedsAnswer> {
    let pairs = soles
        .iter()
        .enumerate()
        .flat_map(|(at, one)| soles.iter().skip(at + 1).map(move |other| (one, other)));
    let posed = pairs.filter_map(|(one, other)| Some((one, other, one.pose_asymmetry(other, model)?)));
    let (sole, other, apart_rad) =
        posed.max_by(|a, b| a.2.total_cmp(&b.2)).filter(|pair| pair.2 > UNEQUAL)?;
    let listed = |sole: &Sole| match TiltingCoordinate::listed(&sole.tilted_by(model)) {
        none if none.is_empty() => "0".to_owned(),
        values => values,
    };
    let name = |sole: &Sole| shown(sole.bodies.first().map(String::as_str).unwrap_or_default()).to_string();
    let text = format!(
        "{} and {} are not posed as mirror images at the default pose, by {:.1} degrees, so that spheres under their bones would differ: \
         give the coordinates of both legs the same default values (now {} and {})",
        name(sole),
        name(other),
        apart_rad.to_degrees(),
        listed(sole),
        listed(other),
    );
    Some(NeedsAnswer::Other { question: Question::UnequalFeet, text: text.into() })
}

/// The spheres that stand on one sole, each called after the body that carries it.
fn under(sole: &Sole, numbers: &Numbers) -> Result<Vec<NewContact>, AddFault> {
    let mut of_body: Vec<(&str, usize)> = Vec::new();
    let mut contacts = Vec::new();
    for sphere in &sole.spheres {
        let count = match of_body.iter_mut().find(|(body, _)| *body == sphere.body) {
            Some((_, count)) => {
                *count += 1;
                *count
            }
            None => {
                of_body.push((&sphere.body, 1));
                1
            }
        };
        let mut contact = numbers.contact(&sphere_name(&sphere.body, count), sphere.radius_m)?;
        contact.body.clone_from(&sphere.body);
        contact.location_m = sphere.centre_m.into();
        contacts.push(contact);
    }
    Ok(contacts)
}

/// `calcn_1_r` for the first sphere of `calcn_r`: the side stays last.
fn sphere_name(body: &str, number: usize) -> String {
    for mark in ["_r", "_l"] {
        if let Some(bone) = body.strip_suffix(mark) {
            return format!("{bone}_{number}{mark}");
        }
    }
    match Side::of_name(body) {
        Some(Side::Right) => format!("{body}_{number}_r"),
        Some(Side::Left) => format!("{body}_{number}_l"),
        None => format!("{body}_{number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spheres_are_called_after_their_body_and_side() {
        for (body, name) in
            [("calcn_r", "calcn_2_r"), ("toes_l", "toes_2_l"), ("RFoot", "RFoot_2_r"), ("hoof", "hoof_2")]
        {
            assert_eq!(sphere_name(body, 2), name);
        }
    }
}
