//! A request to add contacts, checked, and what it reads once for all models.

use std::path::{Path, PathBuf};

use osim_model::files::Files;
use osim_model::wording::{Input, Phrase, phrase};
use osim_model::{ForceKind, Selection, readable};
use osim_patch::reference_of_layout;
use osim_values::contact_table::ContactTable;
use osim_values::{Metres, NewRadius};
use serde_json::json;

use super::super::asking::Asking;
use super::super::reference::{KnownMass, of_opened};
use super::bodies::listed;
use super::fault::of_table;
use super::numbers::{Numbers, OfReference, Wanted};
use super::places::{FeetPlaces, Places, TablePlaces};
use super::reference::{FromReference, reference};
use super::{Adding, Source};
use crate::planner::Change;
use crate::request::{AddRequest, DesignRequest};
use osim_options::{RequestError, RequestFault};

/// No sole is farther below the bones, in whatever unit, m.
const LARGEST_PAD: f64 = 1e9;
/// How far published spheres reach below the bones.
const PADS: &str = "bones have no skin, so say how far below their lowest point the sole is, in metres: 0.033 under a human heel in \
                    the contacts of Falisse et al. (2022), 0 to 0.013 in others";

impl AddRequest {
    /// Checks the request and reads the reference or the table once, for all models.
    ///
    /// # Errors
    /// Nothing says where the contacts are, or their numbers; the reference is neither a preset with places nor a model with
    /// contacts; a table that cannot be read; or options that say nothing.
    pub fn prepare(self, files: &dyn Files) -> Result<Change, RequestError> {
        self.check()?;
        let mut remarks = Vec::new();
        let mut is_file = false;
        let (source, masses) = match (self.places(files)?, self.from.clone()) {
            (None, None) => return Err(no_source().into()),
            (None, Some(from)) => {
                let (own, said);
                (own, is_file, said) = self.whole_reference(&from, files)?;
                remarks.extend(said);
                let masses = own.transferring.masses.clone();
                (Source::Reference(Box::new(own)), masses)
            }
            (Some(places), Some(from)) => {
                let own;
                (own, is_file) = self.numbers_of(&from, files)?;
                let masses = own.transferring.masses.clone();
                (Source::Placed(places, Numbers::Reference(Box::new(own))), masses)
            }
            (Some(places), None) => {
                if !places.has_radii() {
                    return Err(no_radius().into());
                }
                let masses = self.masses.request();
                (Source::Placed(places, Numbers::Wanted(Box::new(self.wanted()?))), masses)
            }
        };
        let settings = self.settings(is_file);
        let reads = self.from.clone().filter(|_| is_file).into_iter().chain(self.contacts.clone());
        let planner = Adding {
            source,
            replace: self.replace,
            own: self.choice.selection(),
            body_scale: self.body_scale.clone(),
            answers: self.answers.clone(),
            remarks,
            reads: reads.collect(),
            settings,
        };
        let asking = Asking { planner, masses, answers: self.answers };
        Ok(Change::new(self.models, self.output, crate::options::SetFiles::default(), asking))
    }

    /// Whether it says itself where the spheres are.
    pub(super) fn has_places(&self) -> bool {
        self.contacts.is_some() || !self.feet.is_empty()
    }

    fn check(&self) -> Result<(), RequestFault> {
        if self.masses.contacts_mass.is_some() {
            let message = match self.from {
                Some(_) => phrase![
                    Input::ContactsMass,
                    " says nothing here: the reference's mass is ",
                    Input::ReferenceMass,
                    ", this model's ",
                    Input::Mass,
                ],
                None => {
                    phrase![Input::ContactsMass, " says nothing here: contacts are made for ", Input::Mass]
                }
            };
            return Err(RequestFault::refused(Input::ContactsMass, message));
        }
        if self.has_places() && self.radius == NewRadius::Follow {
            let message = phrase![
                Input::Radius.being("follow"),
                " says nothing here: nothing is scaled where places are given; expected metres",
            ];
            return Err(RequestFault::refused(Input::Radius, message));
        }
        if !self.feet.is_empty() && self.count.is_none() {
            let message =
                phrase![Input::Count.like("N"), " is missing: how many spheres are to be under each foot?"];
            return Err(RequestFault::refused(Input::Count, message));
        }
        if !self.feet.is_empty() && self.pad.is_none() {
            return Err(RequestFault::refused(
                Input::Pad,
                phrase![Input::Pad.like("METRES"), " is missing: ", PADS],
            ));
        }
        if let Some(pad) = self.pad.map(Metres::get).filter(|pad| *pad > LARGEST_PAD) {
            let message = phrase![Input::Pad.being(readable(pad)), ": expected metres, at most 1e9; ", PADS];
            return Err(RequestFault::refused(Input::Pad, message));
        }
        Ok(())
    }

    /// Places that are the models' own, where they are given.
    fn places(&self, files: &dyn Files) -> Result<Option<Places>, RequestError> {
        let radius_m = match self.radius {
            NewRadius::Metres(metres) => Some(metres),
            _ => None,
        };
        if let Some(path) = &self.contacts {
            let bytes = crate::opening::read(path, files)?;
            let table = ContactTable::read(&bytes).map_err(|fault| of_table(path, &fault))?;
            if table.has_radii && radius_m.is_some() {
                let message = phrase![
                    Input::Radius.like("METRES"),
                    " and the table's column radius say different things: leave one out",
                ];
                return Err(RequestFault::refused(Input::Radius, message).into());
            }
            let name = path.display().to_string();
            return Ok(Some(Places::Table(TablePlaces { name, table, posed: self.default_pose, radius_m })));
        }
        let (false, Some(count), Some(pad)) = (self.feet.is_empty(), self.count, self.pad.map(Metres::get))
        else {
            return Ok(None);
        };
        Ok(Some(Places::Feet(FeetPlaces {
            bodies: listed(&self.feet)?,
            count: usize::from(count.get()),
            pad_m: pad,
            geometry_dir: self.geometry_dir.clone(),
            radius_m,
        })))
    }

    fn whole_reference(
        &self,
        from: &Path,
        files: &dyn Files,
    ) -> Result<(FromReference, bool, Vec<Phrase>), RequestError> {
        let (opened, is_file) = reference(from, files)?;
        let transfer = self.transfer(from);
        let referenced = of_opened(&transfer, from, (&opened, KnownMass::Asked), files)?;
        let (_, _, Some(generic)) = &referenced else {
            return Err(RequestFault::Missing { field: "from" }.into());
        };
        let generic = generic.clone();
        let model = &opened.model;
        let selected = self.selection().apply(model).map_err(|fault| opened.failure(fault))?;
        self.check_maps(model, &selected)?;
        let (layout, mut anatomy, remarks) =
            self.layout(model, &selected).map_err(|fault| opened.failure(fault))?;
        // Presets have the bodies with spheres and their joint.
        anatomy.is_fragment = !is_file;
        let transferring = transfer.planner(referenced, is_file);
        let maps = self.body_map.clone();
        Ok((FromReference { layout, anatomy, transferring, generic, maps }, is_file, remarks))
    }

    /// The reference's contacts without its places.
    fn numbers_of(&self, from: &Path, files: &dyn Files) -> Result<(OfReference, bool), RequestError> {
        let (opened, is_file) = reference(from, files)?;
        let transfer = self.transfer(from);
        let referenced = of_opened(&transfer, from, (&opened, KnownMass::Asked), files)?;
        let layout = self
            .selection()
            .apply(&opened.model)
            .and_then(|selected| self.contacts_of(&opened.model, &selected))
            .map_err(|fault| opened.failure(fault))?;
        let transferring = transfer.planner(referenced, is_file);
        let known = &transferring.reference;
        let facts = (known.mass.clone(), known.sphere_count, known.gravity_m_s2);
        let reference =
            reference_of_layout(&known.name, &layout, facts).map_err(|fault| opened.failure(fault))?;
        Ok((OfReference { layout, reference, transferring }, is_file))
    }

    fn selection(&self) -> Selection {
        Selection { select: self.reference.reference_select.clone(), ..Selection::default() }
    }

    /// What is wanted of contacts without a reference.
    fn wanted(&self) -> Result<Wanted, RequestFault> {
        let numbers = &self.numbers;
        if numbers.indentation.is_none() && numbers.young.is_none() {
            return Err(RequestFault::general(phrase![
                "nothing says how stiff the contacts are: say whose numbers they get with ",
                Input::From.like("MODEL|PRESET"),
                ", or what is wanted of them with ",
                Input::Indentation.like("X"),
                " (and ",
                Input::Restitution.like("CR"),
                "), or with ",
                Input::Young.like("E"),
                " and ",
                Input::Poisson.like("NU"),
            ]));
        }
        let Some(class) = self.class else {
            let message = phrase![
                Input::Class.like("smooth|hunt-crossley"),
                " is missing: without a reference nothing says of which class the forces are",
            ];
            return Err(RequestFault::refused(Input::Class, message));
        };
        let friction = numbers.friction();
        let request = DesignRequest {
            wanted: numbers.wanted(),
            load: self.load.clone(),
            masses: self.masses.clone(),
            counts: self.counts.clone(),
            ..DesignRequest::default()
        };
        Ok(Wanted {
            kind: class.kind(),
            friction: friction.iter().filter_map(|&(property, value)| Some((property, value?))).collect(),
            designing: request.planner()?,
            remarks: self.of_defaults(class.kind()),
        })
    }

    /// What OpenSim's defaults say, because nobody else does.
    fn of_defaults(&self, kind: ForceKind) -> Vec<Phrase> {
        let numbers = &self.numbers;
        let class = osim_model::Class::ContactParameters;
        let mut silent: Vec<String> = Vec::new();
        if numbers.restitution.is_none() {
            silent.push("dissipation 0".to_owned());
        }
        let friction = numbers.friction().into_iter().filter(|(_, value)| value.is_none());
        silent.extend(friction.map(|(property, _)| format!("{property} {}", class.default(property))));
        let mut remarks: Vec<Phrase> = Vec::new();
        if !silent.is_empty() {
            let slides = numbers.friction().iter().all(|(_, value)| value.is_none());
            let slides = if slides { "; without friction feet slide" } else { "" };
            let text = format!("not given, so OpenSim's defaults are written: {}{slides}", silent.join(", "));
            remarks.push(text.into());
        }
        let smoothing = [
            numbers.constant_indentation.is_some(),
            numbers.state_width.is_some(),
            numbers.speed_width.is_some(),
        ];
        if kind == ForceKind::SmoothSphereHalfSpace && smoothing.contains(&false) {
            let text = "smoothing that is not given is that of Falisse et al. (2022), without dimensions, at these radii";
            remarks.push(text.into());
        }
        remarks
    }

    /// The reference is identified by its contents; a preset by its name, which means the same numbers in one version.
    fn settings(&self, is_file: bool) -> String {
        let Self { from, radius, body_scale, replace, choice, counts, reference, masses, .. } = self;
        let preset = from.as_ref().filter(|_| !is_file).map(|from| from.to_string_lossy());
        let scales: Vec<String> = body_scale.iter().map(ToString::to_string).collect();
        let maps: Vec<String> = self.body_map.iter().map(ToString::to_string).collect();
        let geometry: Option<&PathBuf> = self.geometry_dir.as_ref();
        let places =
            json!([self.default_pose, self.feet, self.count, self.pad, geometry, self.mirror, self.class]);
        let numbers = json!([self.numbers, self.load]);
        json!([
            "add", preset, radius, scales, maps, replace, choice, counts, reference, masses, places, numbers
        ])
        .to_string()
    }
}

/// Only a reference has radii of its own.
fn no_radius() -> RequestFault {
    let message = phrase![
        Input::Radius.like("METRES"),
        " is missing: without a reference, and without a column radius in a table, nothing says how large the spheres are",
    ];
    RequestFault::refused(Input::Radius, message)
}

/// There are three ways to say where contacts are.
fn no_source() -> RequestFault {
    RequestFault::general(phrase![
        "nothing says where the contacts are: ",
        Input::From.like("MODEL|PRESET"),
        " takes those of another model at this one's size, ",
        Input::Contacts.like("TABLE"),
        " those of a table, and ",
        Input::Feet.like("BODY,BODY"),
        " lays spheres under bones",
    ])
}
