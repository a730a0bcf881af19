//! The typed view of a model: bodies, limbs, contact spheres and contact forces with their effective values.

mod classes;
mod contacts;
mod files;
mod limbs;
mod objects;
mod read_contacts;
mod skeleton;
mod traps;

use crate::document::Document;
use crate::error::{Fault, FaultKind};
use crate::note::Note;
use crate::warning::{Warning, WarningCode};
use crate::xml::ElementId;

pub(crate) use contacts::Dialect;
pub use contacts::{Force, ForceKind, ParameterSet, Sphere};
pub(crate) use files::{Base, Files, MAX_FRAME_CHAIN};
pub use limbs::{Limb, Limbs, Side};
pub(crate) use objects::ObjectId;
pub(crate) use read_contacts::ContactReader;
pub use skeleton::Body;
pub(crate) use skeleton::Skeleton;

/// OpenSim's `gravity` where a model gives none, m/s².
const DEFAULT_GRAVITY: [f64; 3] = [0.0, -9.80665, 0.0];

/// A file that belongs to the model beside its main one.
#[derive(Debug, Clone, Copy)]
pub struct Part<'d, 'a> {
    /// Its contents.
    pub document: &'d Document<'a>,
    /// The element of the main file whose `file="…"` names it; `None` for a set or model given beside a set.
    pub included_by: Option<ElementId>,
}

/// Everything this crate knows about a model.
#[derive(Debug)]
pub struct Model<'d, 'a> {
    files: Files<'d, 'a>,
    skeleton: Skeleton,
    /// Name of the model.
    pub name: String,
    /// Gravity vector, m/s²; `None` where its text is not three numbers.
    pub gravity_m_s2: Option<[f64; 3]>,
    /// Contact spheres, in file order.
    pub spheres: Vec<Sphere>,
    /// Contact forces, in file order.
    pub forces: Vec<Force>,
    /// The note this tool left in the file.
    pub note: Option<Note>,
    /// Traps found while reading.
    pub warnings: Vec<Warning>,
    /// A comment that begins like the note and cannot be read, or a pair whose notes differ.
    pub(crate) note_fault: Option<&'static str>,
    /// For each part, the `file="…"` that names it, where one does.
    included: Vec<Option<String>>,
}

impl<'d, 'a> Model<'d, 'a> {
    /// Reads a model from one file.
    ///
    /// # Errors
    /// See [`Model::read_with`].
    pub fn read(document: &'d Document<'a>) -> Result<Self, Fault> {
        Self::read_with(document, &[])
    }

    /// Reads a model from its main file and the parts that belong to it.
    ///
    /// # Errors
    /// A document that is no model and no force set with its geometry, or a connection that leads nowhere.
    pub fn read_with(document: &'d Document<'a>, parts: &[Part<'d, 'a>]) -> Result<Self, Fault> {
        let read = Self::read_unlocated(document, parts);
        read.map_err(|fault| {
            let source = fault.source_file.checked_sub(1).and_then(|part| parts.get(part));
            let bytes = source.map_or(document.bytes(), |part| part.document.bytes());
            fault.located(bytes)
        })
    }

    fn read_unlocated(document: &'d Document<'a>, parts: &[Part<'d, 'a>]) -> Result<Self, Fault> {
        check_data_root(document, parts)?;
        let sources: Vec<_> = parts.iter().map(|part| (part.document, part.included_by)).collect();
        let files = Files::new(document, &sources);
        let skeleton = Skeleton::read(&files);
        let mut reader = ContactReader::new(&files, &skeleton);
        reader.read()?;
        let ContactReader { spheres, forces, warnings, .. } = reader;
        let model_document =
            std::iter::once(document).chain(parts.iter().map(|part| part.document)).find(|d| is_model(d));
        let gravity_m_s2 = model_document
            .and_then(|document| document.triple(document.data_root(), "gravity"))
            .or(Some(DEFAULT_GRAVITY));
        let name = document.tree().attribute(document.data_root(), "name").unwrap_or_default().into_owned();
        let note = Note::find(document);
        let note_fault =
            (note.is_none() && Note::is_there(document)).then_some("the note in the file cannot be read");
        let included = parts
            .iter()
            .map(|part| {
                document.tree().attribute(part.included_by?, "file").map(|file| file.trim().to_owned())
            })
            .collect();
        let mut model = Self {
            files,
            skeleton,
            name,
            gravity_m_s2,
            spheres,
            forces,
            note,
            warnings,
            note_fault,
            included,
        };
        model.find_traps();
        model.compare_notes(parts);
        Ok(model)
    }

    /// A force set and a geometry set that were written together carry the same digest.
    fn compare_notes(&mut self, parts: &[Part<'d, 'a>]) {
        for part in parts.iter().filter(|part| part.included_by.is_none() && !is_model(part.document)) {
            let (ours, theirs) =
                (self.note.as_ref().map(|n| &n.digest), Note::find(part.document).map(|n| n.digest));
            if ours != theirs.as_ref() {
                let text = "the force set and its geometry set were not written by the same run";
                self.note_fault = Some(text);
                self.warnings.push(Warning::new(WarningCode::MixedPair, text));
            }
        }
    }

    /// The name under which the model includes file number `file`, if it does.
    pub(crate) fn included_file(&self, file: usize) -> Option<&str> {
        self.included.get(file.checked_sub(1)?)?.as_deref()
    }

    /// The main file.
    #[must_use]
    pub fn document(&self) -> &'d Document<'a> {
        self.files.main()
    }

    /// File number `file`: 0 is the main one, then the parts in the order given.
    #[must_use]
    pub fn file(&self, file: usize) -> &'d Document<'a> {
        self.files.document(file)
    }

    /// Bodies in file order, ground left out.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.skeleton.bodies
    }

    /// Magnitude of gravity, m/s²; 0 or `None` makes figures by body weight meaningless.
    #[must_use]
    pub fn gravity(&self) -> Option<f64> {
        self.gravity_m_s2.map(|[x, y, z]| (x * x + y * y + z * z).sqrt())
    }

    /// Gravity that the contacts stand for: the note's, else the model's.
    #[must_use]
    pub fn contacts_gravity(&self) -> Option<f64> {
        self.note.as_ref().and_then(|note| note.gravity_m_s2).or(self.gravity())
    }

    /// Why the note's word on the contacts cannot be taken; `None` where it can, or where there is no note.
    #[must_use]
    pub fn doubt_about_note(&self) -> Option<&'static str> {
        self.note_fault.or_else(|| self.note.as_ref()?.doubt(self))
    }

    pub(crate) fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    pub(crate) fn files(&self) -> &Files<'d, 'a> {
        &self.files
    }
}

fn is_model(document: &Document<'_>) -> bool {
    document.tree().name(document.data_root()) == "Model"
}

fn check_data_root(document: &Document<'_>, parts: &[Part<'_, '_>]) -> Result<(), Fault> {
    let tree = document.tree();
    let root = document.data_root();
    let kind = match tree.name(root) {
        "ForceSet" if parts.is_empty() => FaultKind::Incomplete(
            "this is a ForceSet that stands alone: its spheres are in another file, name it with --geometry FILE".into(),
        ),
        "Model" | "ForceSet" => return Ok(()),
        "ContactGeometrySet" => FaultKind::Incomplete(
            "this is a ContactGeometrySet, which has no forces: name the ForceSet file and give this one as --geometry FILE"
                .into(),
        ),
        tag => FaultKind::WrongDataRoot { tag: tag.to_owned() },
    };
    Err(Fault::over(kind, tree.open_span(root)))
}
