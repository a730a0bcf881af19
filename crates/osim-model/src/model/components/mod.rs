//! The files that make up one model, and what sockets mean: read as one tree of components.
//!
//! Usually one file makes up a model. A model whose sets are in other files (`file="…"`), or a `ForceSet` with the
//! `ContactGeometrySet` and the model it belongs to, are several, read as one tree.

mod classes;
mod tree;

use std::borrow::Cow;

use crate::model::components::classes::CountedSets;
use crate::model::document::Document;
use crate::model::fault::{Fault, FaultKind, FileId};
use crate::xml::ElementId;
pub use tree::{Component, ComponentId, ComponentTree};

/// A file that belongs to the model beside its main one, for [`Model::read_with`](crate::model::Model::read_with).
///
/// [`ModelFiles`](crate::model::files::ModelFiles) finds and reads them.
#[derive(Debug, Clone)]
pub struct Companion {
    pub document: Document,
    /// The element of the main file whose `file="…"` names it; `None` for a set or model given beside a set.
    pub included_by: Option<ElementId>,
}

#[derive(Debug)]
pub struct Components {
    main: Document,
    companions: Vec<Companion>,
    pub tree: ComponentTree,
}

/// The text of a socket, and where it is.
#[derive(Debug, Clone)]
pub(crate) struct Connectee {
    pub text: String,
    pub element: ElementId,
    /// Whether the socket is spelled as in documents that name bodies instead of giving paths.
    pub legacy: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Base {
    Ground,
    Body(ComponentId),
    /// The body is in a file that was not given (standalone sets only).
    Unknown,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct FoundFrame {
    /// `None` is ground, which no file spells out.
    pub component: Option<ComponentId>,
    /// Whether the path as written led nowhere, so that the only component with that last segment was taken.
    pub by_name: bool,
}

/// The first version that keeps ground out of the BodySet: a body there that is called so is one like others.
const FIRST_WITHOUT_GROUND: u32 = 30505;
/// The ending of a socket's tag in older spellings.
const CONNECTEE_NAME: &str = "_connectee_name";
/// Offset frames on offset frames, at most; deeper is a cycle.
pub(crate) const MAX_FRAME_CHAIN: usize = 64;

impl Components {
    pub(crate) fn new(main: Document, companions: Vec<Companion>) -> Self {
        let mut tree = ComponentTree::default();
        tree.add(FileId::MAIN, &main, None, CountedSets::All);
        let beside = companions.iter().filter(|companion| companion.included_by.is_none()).count();
        for (index, companion) in companions.iter().enumerate() {
            let mount = companion.included_by.and_then(|element| component_above(&main, &tree, element));
            let counted = match companion.included_by {
                Some(_) => CountedSets::All,
                None => CountedSets::beside_set(index, beside),
            };
            tree.add(FileId::companion(index), &companion.document, mount, counted);
        }
        Self { main, companions, tree }
    }

    pub(crate) fn main(&self) -> &Document {
        &self.main
    }

    pub(crate) fn companions(&self) -> &[Companion] {
        &self.companions
    }

    /// The file of the model itself: beside a set, the last one that is a model, because geometry comes first.
    pub(crate) fn model_file(&self) -> Option<FileId> {
        if self.main.is_model() {
            return Some(FileId::MAIN);
        }
        let is_model = |companion: &Companion| companion.document.is_model();
        self.companions.iter().rposition(is_model).map(FileId::companion)
    }

    /// The document of a file of the model; the main one where the handle is another model's.
    pub fn document(&self, file: FileId) -> &Document {
        let companion = file.companion_index().and_then(|index| self.companions.get(index));
        companion.map_or(&self.main, |companion| &companion.document)
    }

    pub(crate) fn file_of(&self, id: ComponentId) -> FileId {
        self.tree.get(id).map_or(FileId::MAIN, |component| component.file)
    }

    /// The element of an object in its file.
    pub fn element(&self, id: ComponentId) -> ElementId {
        self.tree.get(id).map_or(ElementId::ROOT, |component| component.element)
    }

    /// The file in which an object is.
    pub fn doc(&self, id: ComponentId) -> &Document {
        self.document(self.file_of(id))
    }

    /// The class of an object, as the file has it.
    pub fn tag(&self, id: ComponentId) -> &str {
        self.doc(id).tree().name(self.element(id))
    }

    /// The `name` as the file has it.
    pub fn name(&self, id: ComponentId) -> Cow<'_, str> {
        self.doc(id).tree().attribute(self.element(id), "name").unwrap_or_default()
    }

    /// The text of a socket of `owner`, in any spelling of any document version, else that in `<defaults>`.
    pub(crate) fn connectee(&self, owner: ComponentId, socket: &str, legacy: &[&str]) -> Option<Connectee> {
        let document = self.doc(owner);
        let owner_element = self.element(owner);
        let in_element = |element| self.connectee_of(document, element, socket, legacy);
        in_element(owner_element).or_else(|| in_element(document.defaults_of(owner_element)?))
    }

    /// # Errors
    /// The text of a socket, or of a place, with something in the middle of it, which OpenSim refuses.
    pub(crate) fn refuse_broken_texts(&self) -> Result<(), Fault> {
        let is_checked = |tag: &str| {
            ["socket_", "connector_"].iter().any(|spelling| tag.starts_with(spelling))
                || ["mass_center", "body_name"].contains(&tag)
        };
        for (id, _) in self.tree.iter() {
            let document = self.doc(id);
            let (tree, element) = (document.tree(), self.element(id));
            for child in tree.children(element) {
                let tag = tree.name(child);
                if is_checked(tag)
                    && let Err(fault) = document.whole_text(child)
                    // OpenSim reads the first of a name.
                    && tree.child(element, tag) == Some(child)
                {
                    return Err(fault.at_element(self.tree.path(id)).in_file(self.file_of(id)));
                }
            }
        }
        Ok(())
    }

    fn connectee_of(
        &self,
        document: &Document,
        element: ElementId,
        socket: &str,
        legacy: &[&str],
    ) -> Option<Connectee> {
        let tree = document.tree();
        // The first spelling that is there counts.
        let direct =
            ["socket_", "socket_", "connector_"].into_iter().zip(["", CONNECTEE_NAME, CONNECTEE_NAME]);
        let spelled = direct.filter_map(|(before, after)| {
            let is_spelled = |tag: &str| {
                let middle = tag.strip_prefix(before).and_then(|rest| rest.strip_suffix(after));
                middle == Some(socket)
            };
            tree.children(element).find(|&child| is_spelled(tree.name(child)))
        });
        let legacy = legacy.iter().filter_map(|tag| tree.child(element, tag));
        let first = spelled.map(|found| (found, false)).chain(legacy.map(|found| (found, true))).next();
        let (found, legacy) = first.or_else(|| {
            let connectors = tree.child(element, "connectors")?;
            let connector = tree
                .children(connectors)
                .find(|&id| tree.attribute(id, "name").as_deref() == Some(socket))?;
            Some((tree.child(connector, "connectee_name")?, false))
        })?;
        let text = tree.text_of(found).into_owned();
        (!text.is_empty()).then_some(Connectee { text, element: found, legacy })
    }

    /// Finds the component that `text` means, seen from `owner`: by path, else as the only one with that name.
    pub(crate) fn resolve(
        &self,
        owner: ComponentId,
        text: &str,
        accept: impl Fn(ComponentId) -> bool,
    ) -> Option<(ComponentId, bool)> {
        if let Some(id) = self.tree.at_path(owner, text).filter(|&id| accept(id)) {
            return Some((id, false));
        }
        let last = text.rsplit('/').next().unwrap_or(text);
        let mut named = self.tree.with_name(last, &accept);
        let only = named.next()?;
        named.next().is_none().then_some((only, true))
    }

    fn is_frame(&self, id: ComponentId) -> bool {
        let tag = self.tag(id);
        tag == "Body" || tag == "Ground" || tag.ends_with("Frame")
    }

    pub(crate) fn frame(&self, owner: ComponentId, connectee: &Connectee) -> Option<FoundFrame> {
        let text = connectee.text.as_str();
        let exact = self.tree.at_path(owner, text).filter(|&id| self.is_frame(id));
        if exact.is_none() && (text == "ground" || text.ends_with("/ground")) {
            // Ground is at the top of every model, whether the file spells it out or not.
            let exact =
                connectee.legacy || self.tree.absolute_path(owner, text).as_deref() == Some("/ground");
            return Some(FoundFrame { component: None, by_name: !exact });
        }
        // Documents that name bodies mean those of the BodySet.
        let body = || self.tree.at_path(owner, &format!("/bodyset/{text}")).filter(|&id| self.is_frame(id));
        if let Some(component) = connectee.legacy.then(body).flatten() {
            return Some(FoundFrame { component: Some(component), by_name: false });
        }
        let (component, by_name) = self.resolve(owner, text, |id| self.is_frame(id))?;
        Some(FoundFrame { component: Some(component), by_name: by_name && !connectee.legacy })
    }

    /// Whether `body` is the one that older documents have for ground.
    pub(crate) fn is_ground(&self, body: ComponentId) -> bool {
        self.doc(body).version() < FIRST_WITHOUT_GROUND && self.name(body) == "ground"
    }

    /// The body (or ground) that carries a frame, through any number of offset frames.
    ///
    /// # Errors
    /// An offset frame whose parent is missing, or whose chain of parents leads back to it.
    pub(crate) fn base(&self, frame: Option<ComponentId>) -> Result<Base, Fault> {
        let mut at = frame;
        for _ in 0..MAX_FRAME_CHAIN {
            let Some(id) = at else { return Ok(Base::Ground) };
            match self.tag(id) {
                "Ground" => return Ok(Base::Ground),
                "Body" if self.is_ground(id) => return Ok(Base::Ground),
                "Body" => return Ok(Base::Body(id)),
                _ => {}
            }
            let Some(parent) = self.connectee(id, "parent", &["parent_frame"]) else {
                return Err(self.unresolved(id, "", "frame it is attached to"));
            };
            at = match self.frame(id, &parent) {
                Some(found) => found.component,
                None => return Err(self.unresolved(id, &parent.text, "frame it is attached to")),
            };
        }
        let path = frame.map(|id| self.tree.path(id)).unwrap_or_default();
        Err(Fault::refused(format!(
            "frame {path} is attached to itself, expected a chain of frames to a body"
        )))
    }

    pub(crate) fn unresolved(&self, owner: ComponentId, connectee: &str, wanted: &'static str) -> Fault {
        let path = self.tree.path(owner);
        let kind = FaultKind::Unresolved { owner: path.clone(), connectee: connectee.to_owned(), wanted };
        let span = self.doc(owner).tree().open_span(self.element(owner));
        Fault::at_span(kind, span).at_element(path).in_file(self.file_of(owner))
    }

    /// Line of an object's start tag.
    pub fn line(&self, id: ComponentId) -> usize {
        self.doc(id).line(self.doc(id).tree().span(self.element(id)).start)
    }
}

/// The component of the main file that contains `element`.
fn component_above(main: &Document, components: &ComponentTree, element: ElementId) -> Option<ComponentId> {
    let tree = main.tree();
    let mut at = tree.parent(element);
    while let Some(id) = at {
        if let Some(component) = components.component_at(FileId::MAIN, id) {
            return Some(component);
        }
        at = tree.parent(id);
    }
    None
}
