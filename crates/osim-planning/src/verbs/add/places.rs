//! The places of new contacts: from a table, or under the bones of the model.

use std::cell::LazyCell;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use osim_model::feet::{
    DefaultPose, FeetFault, MeshFolders, Sole, SoleRequest, TiltingCoordinate, bones, odd_size, soles,
};
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, four_significant, phrase, shown};
use osim_model::{Fault, Model, Side, Suspicion, YesQuestion};
use osim_patch::{ContactLayout, NewContact};
use osim_requests::options::AnswerOptions;

use super::bodies::{AddFault, name_without_path, nearest_name_hint};
use super::reference::ContactNumbers;
use crate::contact_table::{ContactRow, ContactTable, PlaceFault};
use crate::remarks::{JointPositions, question_about_pad, remarks_on_parts_of_feet};

/// If the poses of two feet differ by more than this, rad, the program asks about it. One degree is 2 % of the length of the foot at its
/// front end.
const UNEQUAL_POSES_RAD: f64 = std::f64::consts::PI / 180.0;

/// Where the places of new spheres come from, if not from the reference.
pub(super) enum NewSpherePlaces {
    Table(TablePlaces),
    Feet(FeetPlaces),
}

/// A table of contacts, read once for all models.
pub(super) struct TablePlaces {
    pub(super) name: String,
    pub(super) table: ContactTable,
    /// Whether places in ground were measured at the default pose of the model.
    pub(super) at_default_pose: bool,
    /// Radius of all spheres, m, if the table has no radii and the caller gave a radius.
    pub(super) radius_m: Option<f64>,
}

/// The bodies that get spheres under their bone meshes.
pub(super) struct FeetPlaces {
    pub(super) bodies: Vec<String>,
    pub(super) count: usize,
    pub(super) pad_m: f64,
    pub(super) geometry_dir: Option<PathBuf>,
    /// Radius of all spheres, m, if the caller gave one.
    pub(super) radius_m: Option<f64>,
}

impl NewSpherePlaces {
    /// Whether the table or the request has radii of spheres.
    pub(super) fn has_radii(&self) -> bool {
        match self {
            Self::Table(table) => table.table.has_radii || table.radius_m.is_some(),
            Self::Feet(feet) => feet.radius_m.is_some(),
        }
    }

    /// The new contacts of `model` (the file at `path`), with preliminary numbers, and remarks about their places.
    pub(super) fn layout(
        &self,
        model: &Model,
        path: &Path,
        numbers: &ContactNumbers,
        answers: &AnswerOptions,
        files: &dyn Files,
    ) -> Result<(ContactLayout, Vec<Phrase>), AddFault> {
        let mut layout = ContactLayout::default();
        let mut remarks = Vec::new();
        match self {
            Self::Table(table) => {
                layout.contacts = table.contacts_of_table(model, numbers, &mut remarks)?;
                answers.require_yes(table.question_about_place(model, &layout)).map_err(Fault::new)?;
            }
            Self::Feet(feet) => {
                let radius_m = match feet.radius_m {
                    Some(given_radius) => given_radius,
                    None => numbers.radius(None)? * numbers.radius_ratio(model)?,
                };
                let soles = feet.soles_of_feet((model, path), radius_m, (answers, files), &mut remarks)?;
                for sole in &soles {
                    answers.require_yes(question_about_pad(sole, feet.pad_m)).map_err(Fault::new)?;
                    answers.require_yes(question_about_tilt(sole, model)).map_err(Fault::new)?;
                    layout.contacts.extend(contacts_of_sole(sole, numbers)?);
                }
                answers.require_yes(question_about_unequal_feet(&soles, model)).map_err(Fault::new)?;
                remarks.extend(remarks_on_parts_of_feet(model, &soles));
            }
        }
        if !self.has_radii() {
            remarks.extend(remark_on_scaled_radii(&layout));
        }
        Ok((layout, remarks))
    }
}

/// The remark that the radii were scaled from the radii of the reference, if the caller gave no radius.
fn remark_on_scaled_radii(layout: &ContactLayout) -> Option<Phrase> {
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
    /// The new contacts that the table gives a model.
    fn contacts_of_table(
        &self,
        model: &Model,
        numbers: &ContactNumbers,
        remarks: &mut Vec<Phrase>,
    ) -> Result<Vec<NewContact>, AddFault> {
        let bodies: HashSet<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
        let pose = LazyCell::new(|| DefaultPose::of(model));
        let mut growth = None;
        let (mut contacts, mut moved) = (Vec::new(), Vec::new());
        for row in &self.table.rows {
            let body = name_without_path(&row.body);
            if !bodies.contains(body) {
                return Err(self.fault_of_missing_body(row, model));
            }
            let place = row.place.on_body(body, || &pose, self.at_default_pose);
            let place = place.map_err(|fault| self.fault_of_place(row, &fault))?;
            if place.from_default_pose {
                moved.push(row.name.as_str());
            }
            let radius_m = match (row.radius_m.or(self.radius_m), growth) {
                (Some(given_radius), _) => given_radius,
                (None, Some(growth)) => numbers.radius(Some(&row.name))? * growth,
                (None, None) => {
                    numbers.radius(Some(&row.name))? * *growth.insert(numbers.radius_ratio(model)?)
                }
            };
            let mut contact = numbers.contact(&row.name, radius_m)?;
            contact.body = body.to_owned();
            contact.location_m = place.location_m;
            contacts.push(contact);
        }
        if !moved.is_empty() {
            let text = format!(
                "the table gives these places in ground only; they were converted to their bodies at the default pose: {}",
                moved.join(", ")
            );
            remarks.push(text.into());
        }
        Ok(contacts)
    }

    /// The question about the place that is farthest from the bones of its body, if it is too far.
    fn question_about_place(&self, model: &Model, layout: &ContactLayout) -> Option<Suspicion> {
        let bones = JointPositions::of(model);
        let distance = |contact: &NewContact| bones.distance(&contact.body, contact.location_m);
        let contacts = self.table.rows.iter().zip(&layout.contacts);
        let distance = contacts.filter_map(|(row, contact)| Some((row, distance(contact)?)));
        let (row, distance) = distance.max_by(|(_, a), (_, b)| a.relative().total_cmp(&b.relative()))?;
        distance.question_about_place(&self.table_and_line(row), &row.name, name_without_path(&row.body))
    }

    fn fault_of_missing_body(&self, row: &ContactRow, model: &Model) -> AddFault {
        let bodies: Vec<String> = model.bodies().iter().map(|body| body.name.clone()).collect();
        let meant = nearest_name_hint(name_without_path(&row.body), &bodies);
        let fault = FeetFault::NoBody { body: row.body.clone(), bodies };
        AddFault::OutsideModel(fault.code(), phrase![self.table_and_line(row), &fault.phrase(), meant])
    }

    fn fault_of_place(&self, row: &ContactRow, fault: &PlaceFault) -> AddFault {
        let name = &row.name;
        match fault {
            PlaceFault::Pose(why) => {
                let why =
                    format!("{why}; give its place in columns x, y and z, in the frame of {}", row.body);
                AddFault::OutsideModel("unknown-pose", phrase![self.table_and_line(row), why])
            }
            PlaceFault::OnlyGlobal => AddFault::OutsideModel(
                "table",
                phrase![
                    "{}{name} has a place in ground only, and {} is elsewhere: give its place in the frame of {} \
                    (columns x, y, z, or pos_x_in_local and so on), or, if it was measured at the default pose, \
                    give {}";
                    self.table_and_line(row), row.body.to_string(), row.body.to_string(), Input::DefaultPose
                ],
            ),
            PlaceFault::Disagree(apart_m) => {
                let text = format!(
                    "{name} has two places, and in this model they are {:.1} mm apart: remove the wrong columns (those in \
                     global, or those in local)",
                    1e3 * apart_m
                );
                AddFault::OutsideModel("table", phrase![self.table_and_line(row), text])
            }
        }
    }

    fn table_and_line(&self, row: &ContactRow) -> String {
        format!("{}, line {}: ", self.name, row.line)
    }
}

impl FeetPlaces {
    /// The soles under the bones of a model, with the spheres on them.
    fn soles_of_feet(
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
        // A mesh that is probably in another unit, or from another animal.
        let odd = bones.iter().find_map(|bone| odd_size(model, bone));
        let question = YesQuestion::ImplausibleScale;
        let doubt = odd.map(|odd| Suspicion::Other { question, text: odd.text.into() });
        answers.require_yes(doubt).map_err(Fault::new)?;
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

/// The question about a foot that does not lie flat.
fn question_about_tilt(sole: &Sole, model: &Model) -> Option<Suspicion> {
    let mut text: Phrase = sole.describe_tilt()?.into();
    let tilting = sole.tilting_coordinates(model);
    text.push(&match tilting.is_empty() {
        false => phrase![format!(
            ": set default values of its joints at which it does, such as 0 (now {})",
            TiltingCoordinate::listed(&tilting)
        )],
        true => phrase![
            ": name the bodies that touch the ground with {}, or give the places in a table, {}";
            Input::Feet.with_placeholder("BODY,BODY"), Input::Contacts.with_placeholder("TABLE")
        ],
    });
    Some(Suspicion::Other { question: YesQuestion::TiltedFoot, text })
}

/// The question about two feet that are not posed as mirror images.
fn question_about_unequal_feet(soles: &[Sole], model: &Model) -> Option<Suspicion> {
    let pairs = soles
        .iter()
        .enumerate()
        .flat_map(|(at, one)| soles.iter().skip(at + 1).map(move |other| (one, other)));
    let at_default_pose =
        pairs.filter_map(|(one, other)| Some((one, other, one.pose_asymmetry(other, model)?)));
    let (sole, other, apart_rad) =
        at_default_pose.max_by(|a, b| a.2.total_cmp(&b.2)).filter(|pair| pair.2 > UNEQUAL_POSES_RAD)?;
    let angles = |sole: &Sole| match TiltingCoordinate::listed(&sole.tilting_coordinates(model)) {
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
        angles(sole),
        angles(other),
    );
    Some(Suspicion::Other { question: YesQuestion::UnequalFeet, text: text.into() })
}

/// The new contacts of one sole. Each has the name of the body that carries it, and a number.
fn contacts_of_sole(sole: &Sole, numbers: &ContactNumbers) -> Result<Vec<NewContact>, AddFault> {
    let mut counts: HashMap<&str, usize> = HashMap::new();
    let mut contacts = Vec::new();
    for sphere in &sole.spheres {
        let count = counts.entry(&sphere.body).or_default();
        *count += 1;
        let mut contact = numbers.contact(&sphere_name(&sphere.body, *count), sphere.radius_m)?;
        contact.body.clone_from(&sphere.body);
        contact.location_m = sphere.centre_m.into();
        contacts.push(contact);
    }
    Ok(contacts)
}

/// The name of sphere `number` on a body, such as `calcn_1_r` for the first sphere of `calcn_r`.
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
