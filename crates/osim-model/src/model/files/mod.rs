//! The files that a model or a request names, on a disk, in memory or in a browser.

mod source;

use std::path::{Path, PathBuf};

use crate::messages::Phrase;
use crate::model::document::{Document, may_include};
use crate::model::{Companion, Excerpt, Fault, FaultKind, FileId, Model};
use crate::xml::ElementId;
pub use source::{FileError, FileName, Files, InMemory};

/// Why a model or one of its files could not be read or changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    pub model: FileName,
    /// Stable short name, as in the JSON `code`.
    pub code: &'static str,
    /// The message: what is wrong, what was expected, and advice.
    pub message: Phrase,
    /// Line of the error in its file, from 1.
    pub line: Option<usize>,
    /// Column of the error in its line, in letters, from 1.
    pub column: Option<usize>,
    pub excerpt: Option<Excerpt>,
    /// Whether the call would succeed if the caller gave a fact that the program must not guess.
    pub needs_answer: bool,
}

impl Failure {
    /// A failure for `fault` in the file `model`, with the place of the fault after [`located`](Fault::located).
    pub fn from_fault(model: impl Into<FileName>, fault: Fault) -> Self {
        let unplaced = Self::outside(model, fault.code(), fault.phrase());
        Self {
            line: fault.position.map(|position| position.line),
            column: fault.position.map(|position| position.column),
            needs_answer: matches!(fault.kind, FaultKind::MissingFact(_) | FaultKind::Suspicion(_)),
            excerpt: fault.excerpt,
            ..unplaced
        }
    }

    /// A failure outside the contents of the file: folders, permissions, other files.
    pub fn outside(model: impl Into<FileName>, code: &'static str, message: impl Into<Phrase>) -> Self {
        Self {
            model: model.into(),
            code,
            message: message.into(),
            line: None,
            column: None,
            excerpt: None,
            needs_answer: false,
        }
    }
}

/// Files that belong to a set in a separate file. The caller gives them with the set.
#[derive(Debug, Clone, Copy, Default)]
pub struct CompanionPaths<'p> {
    /// The geometry set (or model) that contains the spheres.
    pub geometry: Option<&'p Path>,
    /// The model that contains masses and joints.
    pub model: Option<&'p Path>,
}

/// The bytes of a model and of all files that belong to it.
///
/// ```
/// use std::path::Path;
/// use osim_model::files::{CompanionPaths, InMemory, ModelFiles};
///
/// let model = r#"<OpenSimDocument Version="40000"><Model name="walker">
/// <ForceSet file="forces.xml"/></Model></OpenSimDocument>"#;
/// let forces = r#"<OpenSimDocument Version="40000"><ForceSet><objects/></ForceSet></OpenSimDocument>"#;
///
/// let path = Path::new("models/walker.osim");
/// let files = InMemory::from_iter([("models/forces.xml", forces)]);
/// let open = ModelFiles::read(path, model.into(), CompanionPaths::default(), &files)?.open()?;
/// assert_eq!(open.model.name, "walker");
/// let names: Vec<&str> = open.files().map(|(name, _)| name).collect();
/// assert_eq!(names, ["models/walker.osim", "models/forces.xml"]);
///
/// // Without the other file: the line that names it.
/// let failure = ModelFiles::read(path, model.into(), CompanionPaths::default(), &InMemory::default()).unwrap_err();
/// assert_eq!((failure.code, failure.line), ("unreadable", Some(2)));
/// # Ok::<(), osim_model::files::Failure>(())
/// ```
#[derive(Debug, Clone)]
pub struct ModelFiles {
    name: FileName,
    main: MainFile,
    companions: Vec<CompanionFile>,
}

/// The main file of a model. It is parsed only if its include statements have to be found.
#[derive(Debug, Clone)]
enum MainFile {
    Bytes(Vec<u8>),
    /// The bytes of a model that includes no other file.
    WithoutIncludes(Vec<u8>),
    Parsed(Box<Document>),
}

/// A file beside the main file of a model, with its bytes.
#[derive(Debug, Clone)]
struct CompanionFile {
    path: PathBuf,
    bytes: Vec<u8>,
    included_by: Option<ElementId>,
    /// Name of the file in the model's `file="…"`.
    include_name: Option<String>,
}

impl ModelFiles {
    /// The model at `path`, whose bytes are known, with the files that it includes (beside `path`) and the `given` files.
    ///
    /// # Errors
    /// A file cannot be read, or a model that includes files is not an OpenSim document.
    pub fn read(
        path: &Path,
        bytes: Vec<u8>,
        beside: CompanionPaths<'_>,
        files: &dyn Files,
    ) -> Result<Self, Failure> {
        let name = FileName::from(path);
        let mut companions = Vec::new();
        for path in [beside.geometry, beside.model].into_iter().flatten() {
            let what = "a file that belongs to the model: ";
            companions.push(read_companion(path.to_owned(), None, files, what)?);
        }
        if !may_include(&bytes) {
            return Ok(Self { name, main: MainFile::WithoutIncludes(bytes), companions });
        }
        let document = Document::parse(bytes).map_err(|fault| Failure::from_fault(&name, fault))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        for (element, file) in document.included_files() {
            let included =
                read_companion(folder.join(&file), Some(element), files, "").map_err(|failure| {
                    let place = document.position(document.tree().span(element).start);
                    Failure {
                        // What the user can change is the place in the model.
                        model: name.clone(),
                        line: Some(place.line),
                        column: Some(place.column),
                        message: format!("it includes file=\"{file}\": {}", failure.message).into(),
                        ..failure
                    }
                })?;
            companions.push(CompanionFile { include_name: Some(file), ..included });
        }
        Ok(Self { name, main: MainFile::Parsed(Box::new(document)), companions })
    }

    /// The name of the model's main file.
    pub fn name(&self) -> &FileName {
        &self.name
    }

    /// The files, with another name of the main file.
    pub fn with_name(self, name: impl Into<FileName>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// Bytes of the model's main file.
    pub fn bytes(&self) -> &[u8] {
        match &self.main {
            MainFile::Bytes(bytes) | MainFile::WithoutIncludes(bytes) => bytes,
            MainFile::Parsed(document) => document.bytes(),
        }
    }

    /// Handles, names and bytes of the files beside the main file: first those that the caller gave with a set, then those that the model
    /// includes, in file order.
    pub fn companions(&self) -> impl Iterator<Item = (FileId, &Path, &[u8])> {
        let companions = self.companions.iter().enumerate();
        companions.map(|(index, file)| (FileId::companion(index), file.path.as_path(), file.bytes.as_slice()))
    }

    /// The names of the files that the model includes, as it writes them.
    pub fn included(&self) -> impl Iterator<Item = &str> {
        self.companions.iter().filter_map(|companion| companion.include_name.as_deref())
    }

    /// The same files with other `bytes` of the main file.
    pub fn with_bytes(&self, bytes: Vec<u8>) -> Self {
        Self { name: self.name.clone(), main: MainFile::Bytes(bytes), companions: self.companions.clone() }
    }

    /// Replaces the bytes of one of the files beside the main file; does nothing for [`FileId::MAIN`].
    pub fn replace_companion(&mut self, file: FileId, bytes: Vec<u8>) {
        if let Some(companion) = file.companion_index().and_then(|index| self.companions.get_mut(index)) {
            companion.bytes = bytes;
        }
    }

    /// Parses all files and reads the model.
    pub fn open(self) -> Result<OpenModel, Failure> {
        let name_of =
            |companion: &CompanionFile| (companion.path.as_path().into(), companion.included_by.is_some());
        let companions_with_names = self.companions.iter().map(name_of).collect();
        let names = FileNames { main: self.name, companions: companions_with_names };
        let document = match self.main {
            MainFile::Bytes(bytes) => {
                Document::parse(bytes).map_err(|fault| Failure::from_fault(&names.main, fault))?
            }
            MainFile::WithoutIncludes(bytes) => Document::parse(bytes)
                .map_err(|fault| Failure::from_fault(&names.main, fault))?
                .known_to_include_nothing(),
            MainFile::Parsed(document) => *document,
        };
        let mut companions = Vec::new();
        for (index, companion) in self.companions.into_iter().enumerate() {
            let included_by = companion.included_by;
            let document = Document::parse(companion.bytes).map_err(|fault| {
                let mut failure = names.failure(Fault { file: FileId::companion(index), ..fault });
                if included_by.is_some() {
                    failure.message = NOT_INCLUDABLE.into();
                }
                failure
            })?;
            companions.push(Companion { document, included_by });
        }
        match Model::read_with(document, companions) {
            Ok(model) => Ok(OpenModel { model, names }),
            Err(fault) => Err(names.failure(fault)),
        }
    }
}

/// The message about an included file that cannot be read. It has nothing of the file: a model from elsewhere could name any file.
const NOT_INCLUDABLE: &str = "a model includes this file, and it is not an OpenSim document that can be read: get it again from where the model came";

fn read_companion(
    path: PathBuf,
    included_by: Option<ElementId>,
    files: &dyn Files,
    what: &str,
) -> Result<CompanionFile, Failure> {
    let failed = |error: FileError| Failure::outside(path.as_path(), "unreadable", format!("{what}{error}"));
    let read = if included_by.is_some() { files.read_included(&path) } else { files.read(&path) };
    let bytes = read.map_err(failed)?;
    Ok(CompanionFile { path, bytes, included_by, include_name: None })
}

/// A model that was read, with the names of its files: from [`ModelFiles::open`].
pub struct OpenModel {
    pub model: Model,
    names: FileNames,
}

/// The names of all files of a model, for messages.
struct FileNames {
    main: FileName,
    /// The name of each file, and whether the model includes it.
    companions: Vec<(FileName, bool)>,
}

impl FileNames {
    fn name(&self, file: FileId) -> &FileName {
        self.companion(file).map_or(&self.main, |(name, _)| name)
    }

    fn companion(&self, file: FileId) -> Option<&(FileName, bool)> {
        file.companion_index().and_then(|index| self.companions.get(index))
    }

    /// The failure for `fault`, whose file has no excerpt if the model names that file, because it could name any.
    fn failure(&self, fault: Fault) -> Failure {
        let is_included = self.companion(fault.file).is_some_and(|(_, is_included)| *is_included);
        let failure = Failure::from_fault(self.name(fault.file), fault);
        Failure { excerpt: failure.excerpt.filter(|_| !is_included), ..failure }
    }
}

impl OpenModel {
    /// The name of the model's main file.
    pub fn name(&self) -> &FileName {
        &self.names.main
    }

    /// The names and bytes of all files, the main file first.
    pub fn files(&self) -> impl Iterator<Item = (&str, &[u8])> {
        let companions = self.model.companions().map(|(file, _)| file);
        let all = std::iter::once(FileId::MAIN).chain(companions);
        all.map(|file| (&**self.names.name(file), self.model.file(file).bytes()))
    }

    pub fn name_of(&self, file: FileId) -> &str {
        self.names.name(file)
    }

    /// A failure for `fault` in this model, with the name of its file and its place.
    pub fn failure(&self, fault: Fault) -> Failure {
        let bytes = self.model.file(fault.file).bytes();
        self.names.failure(fault.located(bytes))
    }
}
