//! What a figure shows: bodies, units, the fall.

use std::path::Path;

use contact_scaling::Ratios;
use osim_inspect::series::{Body, HeatRequest};
use osim_inspect::unexplained_slip;
use osim_model::files::Files;
use osim_model::wording::{Input, Phrase, phrase};
use osim_model::{Fault, MassRequest, readable};
use osim_values::{Kilograms, Positive};

use crate::feet::ModelFeet;
use crate::fig1::fig1;
use crate::heat_table::HeatTable;
use crate::request::{PlotKind, PlotRequest};
use crate::subject::Subject;
use osim_options::{RequestError, RequestFault};

impl PlotRequest {
    /// `true` for a figure of the paper, which shows its own animals.
    #[must_use]
    pub fn is_of_paper(&self) -> bool {
        matches!(self.kind, Some(PlotKind::Fig4 | PlotKind::FigC5))
    }

    /// Refuses models too many, or none, and the figure that cannot be drawn.
    ///
    /// # Errors
    /// They are.
    pub fn check_models(&self) -> Result<(), RequestFault> {
        if self.kind == Some(PlotKind::Fig1) {
            return Err(RequestFault::general(Phrase::joined(fig1(), " ").unwrap_or_default()));
        }
        if self.is_of_paper() && (!self.models.is_empty() || self.target_mass.is_some()) {
            return Err(RequestFault::general(phrase![
                "fig4 and fig-c5 redraw the paper's own animals: leave out models and ",
                Input::TargetMass,
            ]));
        }
        if self.heat.table.is_some() {
            return self.check_table();
        }
        if !self.is_of_paper() && self.models.is_empty() {
            return Err(RequestFault::general(
                "nothing to draw: name a model, or a preset such as falisse2022",
            ));
        }
        Ok(())
    }

    /// Refuses what says nothing beside a table.
    ///
    /// # Errors
    /// A model, or a figure of another kind.
    fn check_table(&self) -> Result<(), RequestFault> {
        if self.kind != Some(PlotKind::Sweep) || !self.models.is_empty() || self.target_mass.is_some() {
            return Err(RequestFault::refused(
                Input::Table,
                Phrase::template(
                    "a table is drawn by `plot kind=sweep`, without a model: leave out models and the target mass",
                ),
            ));
        }
        Ok(())
    }

    /// The table of which a column is drawn, where that is wanted.
    ///
    /// # Errors
    /// As [`HeatTable::read`].
    pub fn table(&self, files: &dyn Files) -> Result<Option<HeatTable>, RequestError> {
        let Some(path) = self.heat.table.as_deref() else { return Ok(None) };
        Ok(Some(HeatTable::read(path, &self.heat, files)?))
    }

    /// `true` for a figure of feet, which shows where spheres are and not what they do.
    #[must_use]
    pub fn is_of_feet(&self) -> bool {
        self.kind == Some(PlotKind::Feet)
    }

    /// The states of the feet that a figure shows, the later one last: those of a model, of the same with radii scaled to the
    /// target mass, or of two models.
    ///
    /// # Errors
    /// A preset, which has no places, too many models, or a model that cannot be read or has no feet.
    pub fn feet(&self, files: &dyn Files) -> Result<Vec<ModelFeet>, RequestError> {
        let states = self.models.len() + usize::from(self.target_mass.is_some());
        if states > 2 {
            return Err(RequestFault::general(phrase![
                "a figure of feet shows one model, or two (before and after): leave out others, and ",
                Input::TargetMass,
                " beside two",
            ])
            .into());
        }
        let mut feet = Vec::new();
        for path in &self.models {
            let (own, scaled) = self.feet_of(path, files)?;
            feet.push(own);
            feet.extend(scaled);
        }
        Ok(feet)
    }

    fn feet_of(
        &self,
        path: &Path,
        files: &dyn Files,
    ) -> Result<(ModelFeet, Option<ModelFeet>), RequestError> {
        let open = match Subject::find(path, self.presets.as_deref(), &self.set_files, files)? {
            Subject::Model(open) => open,
            Subject::Preset(preset) => {
                let why = format!("{} is a preset, which has no feet: name a model", preset.name);
                return Err(RequestFault::general(why).into());
            }
        };
        let name = short_name(path);
        let mut feet = ModelFeet::of(&name, &open, &self.choice.selection())?;
        let geometry = self.geometry_dir.as_deref();
        // Of a standalone set, the model beside it says where the bones are.
        let beside = self.set_files.model.as_deref().unwrap_or(path);
        feet.add_bones((&open.model, beside), geometry, files);
        let Some(target) = self.target_mass else { return Ok((feet, None)) };
        let failed = |fault| open.failure(fault);
        let (from, _) = self.masses.request().of_contacts(&open.model).map_err(failed)?;
        let ratios = Ratios::isometric(target.get() / from.kg).map_err(|error| failed(Fault::new(error)))?;
        let scaled = feet.with_radii(format!("scaled to {} kg", readable(target.get())), ratios.radius());
        Ok((feet, Some(scaled)))
    }

    /// All bodies of the figure: those that were named, each followed by its scaled self where one is asked for.
    ///
    /// # Errors
    /// A name that is neither a model's nor a preset's, or a model that cannot be read.
    pub fn bodies(&self, files: &dyn Files) -> Result<Vec<Body>, RequestError> {
        let mut bodies = Vec::new();
        for path in &self.models {
            let body = self.body(path, &self.name_of(path), files)?;
            let scaled = self.target_mass.map(|target| body.scaled(target.get())).transpose()?;
            bodies.push(body);
            bodies.extend(scaled);
        }
        Ok(bodies)
    }

    /// A model's name, with its folder where another model has the same.
    fn name_of(&self, path: &Path) -> String {
        let name = short_name(path);
        let alike = self.models.iter().filter(|other| short_name(other) == name).count() > 1;
        match path.parent().and_then(Path::file_name).filter(|_| alike) {
            Some(folder) => format!("{}/{name}", folder.to_string_lossy()),
            None => name,
        }
    }

    fn body(&self, path: &Path, name: &str, files: &dyn Files) -> Result<Body, RequestError> {
        let masses = self.masses.request();
        let stance = self.counts.stance(None, self.gravity);
        match Subject::find(path, self.presets.as_deref(), &self.set_files, files)? {
            Subject::Preset(preset) => {
                let body = Body::of_preset(&preset, &masses, &stance);
                Ok(body.map_err(|error| RequestFault::general(error.to_string()))?)
            }
            Subject::Model(open) => {
                let said = MassRequest { target_mass_kg: self.target_mass_kg(), ..masses.clone() };
                let selection = self.choice.selection();
                let asked = self.answers.ask(unexplained_slip(&said, &open.model, &selection));
                asked.map_err(|kind| open.failure(Fault::new(kind)))?;
                let selected = selection.apply(&open.model).map_err(|fault| open.failure(fault))?;
                let failed = |fault| open.failure(fault);
                Ok(Body::of_model(name.to_owned(), &open.model, &selected.forces, &masses, &stance, &failed)?)
            }
        }
    }

    /// What a heat map shows.
    #[must_use]
    pub fn heat_request(&self) -> HeatRequest {
        HeatRequest {
            quantity: self.heat.quantity.quantity(),
            height: self.fall.height.get(),
            duration_s: self.fall.duration.map(Positive::get),
        }
    }

    /// The mass to which contacts are drawn scaled, kg.
    #[must_use]
    pub fn target_mass_kg(&self) -> Option<f64> {
        self.target_mass.map(Kilograms::get)
    }
}

/// The file's name without its folders, which would fill a legend.
fn short_name(path: &Path) -> String {
    path.file_stem().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}
