//! The files that form one model, read as one tree of components; and the components to which sockets refer.
//!
//! Usually a model is one file. A model whose sets are in other files (`file="…"`), or a `ForceSet` given with its `ContactGeometrySet` and
//! its model, has several files, which are read as one tree.

mod classes;
mod tree;

use std::borrow::Cow;

use crate::model::components::classes::CountedSets;
use crate::model::{Document, Fault, FaultKind, FileId, Result};
use crate::xml::{ElementId, TextPosition};
pub use classes::component_classes;
pub use tree::{Component, ComponentId, ComponentTree};

/// A file that belongs to a model in addition to its main file, for [`Model::read_with`](crate::model::Model::read_with).
///
/// [`ModelFiles`](crate::model::files::ModelFiles) finds and reads these files.
#[derive(Debug, Clone)]
pub struct Companion {
    pub document: Document,
    /// The element of the main file whose `file="…"` names this file; `None` for a set or model that the caller gave with a separate set.
    pub included_by: Option<ElementId>,
}

/// The documents of a model, and the tree of the components in them.
#[derive(Debug)]
pub struct Components {
    main: Document,
    companions: Vec<Companion>,
    pub tree: ComponentTree,
}

/// The text of a socket, and its place in the file.
#[derive(Debug, Clone)]
pub(crate) struct Connectee<'d> {
    pub text: Cow<'d, str>,
    pub element: ElementId,
    /// Whether the socket has the old form that names a body instead of giving a path.
    pub legacy: bool,
}

/// What carries a frame: ground, or the body to which it is fixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Carrier {
    Ground,
    Body(ComponentId),
    /// The body is in a file that was not given. Possible only for sets in separate files.
    Unknown,
}

/// The frame to which a socket is connected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ConnectedFrame {
    /// The component; `None` is ground, which has no element in any file.
    pub component: Option<ComponentId>,
    /// Whether the written path leads to no component, and the only component with its last name was taken instead.
    pub by_name: bool,
}

/// The first version in which ground is not a member of the BodySet. From then on, a body called `ground` there is an ordinary body.
const FIRST_VERSION_WITHOUT_GROUND_BODY: u32 = 30505;
/// The ending of a socket's tag in old documents.
pub(crate) const CONNECTEE_ENDING: &str = "_connectee_name";
/// The class of a frame whose origin and axes are given by stations on one body.
pub(crate) const STATION_DEFINED_FRAME: &str = "StationDefinedFrame";
/// The longest chain of offset frames on offset frames. A longer chain must be a cycle.
pub(crate) const MOST_FRAMES_IN_CHAIN: usize = 64;

impl Components {
    /// Makes the component tree of the main file and its companions.
    pub(crate) fn new(main: Document, companions: Vec<Companion>) -> Self {
        let mut tree = ComponentTree::default();
        tree.add(FileId::MAIN, &main, None, CountedSets::All);
        let beside = companions.iter().filter(|companion| companion.included_by.is_none()).count();
        for (index, companion) in companions.iter().enumerate() {
            let mount = companion.included_by.and_then(|element| component_above(&main, &tree, element));
            let counted = match companion.included_by {
                Some(_) => CountedSets::All,
                None => CountedSets::of_file_beside_set(index, beside),
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

    /// The file of the model itself. If a separate set is given, the last file that is a model: the geometry comes first.
    pub(crate) fn model_file(&self) -> Option<FileId> {
        if self.main.is_model() {
            return Some(FileId::MAIN);
        }
        let is_model = |companion: &Companion| companion.document.is_model();
        self.companions.iter().rposition(is_model).map(FileId::companion)
    }

    /// The document of a file of this model. A handle of another model gives the main document.
    pub fn document(&self, file: FileId) -> &Document {
        let companion = file.companion_index().and_then(|index| self.companions.get(index));
        companion.map_or(&self.main, |companion| &companion.document)
    }

    pub fn file_of(&self, id: ComponentId) -> FileId {
        self.tree.get(id).map_or(FileId::MAIN, |component| component.file)
    }

    /// The element of an object in its file.
    pub fn element(&self, id: ComponentId) -> ElementId {
        self.tree.get(id).map_or(ElementId::ROOT, |component| component.element)
    }

    /// The file in which an object is.
    pub fn document_of(&self, id: ComponentId) -> &Document {
        self.document(self.file_of(id))
    }

    /// The component that is `element` of `file`.
    pub fn at(&self, file: FileId, element: ElementId) -> Option<ComponentId> {
        self.tree.component_at(file, element)
    }

    /// The class of an object, as the file writes it.
    pub fn tag(&self, id: ComponentId) -> &str {
        let (document, element) = self.place(id);
        document.tree().name(element)
    }

    /// The file and the element of an object.
    fn place(&self, id: ComponentId) -> (&Document, ElementId) {
        let place = |component: &Component| (self.document(component.file), component.element);
        self.tree.get(id).map_or((&self.main, ElementId::ROOT), place)
    }

    /// The `name` of an object, as the file writes it.
    pub fn name(&self, id: ComponentId) -> Cow<'_, str> {
        let (document, element) = self.place(id);
        document.tree().attribute(element, "name").unwrap_or_default()
    }

    /// The text of a socket of `owner`, in the spelling of any document version. Without an element of its own, the text in `<defaults>`.
    pub(crate) fn connectee(
        &self,
        owner: ComponentId,
        socket: &str,
        legacy: &[&str],
    ) -> Option<Connectee<'_>> {
        let (document, owner_element) = self.place(owner);
        let in_element = |element| self.connectee_of(document, element, socket, legacy);
        in_element(owner_element).or_else(|| in_element(document.defaults_of(owner_element)?))
    }

    /// Refuses a model with a text that OpenSim would refuse.
    ///
    /// # Errors
    /// A socket or a location contains an element or comment in its text; OpenSim refuses such a text.
    pub(crate) fn refuse_broken_texts(&self) -> Result<()> {
        let is_checked = |tag: &str| {
            ["socket_", "connector_"].iter().any(|spelling| tag.starts_with(spelling))
                || ["mass_center", "body_name"].contains(&tag)
        };
        for (id, _) in self.tree.iter() {
            let document = self.document_of(id);
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

    fn connectee_of<'d>(
        &self,
        document: &'d Document,
        element: ElementId,
        socket: &str,
        legacy: &[&str],
    ) -> Option<Connectee<'d>> {
        let tree = document.tree();
        // The first spelling that is there counts.
        let direct =
            ["socket_", "socket_", "connector_"].into_iter().zip(["", CONNECTEE_ENDING, CONNECTEE_ENDING]);
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
        let text = tree.text_of(found);
        (!text.is_empty()).then_some(Connectee { text, element: found, legacy })
    }

    /// Finds the component to which `text` refers, seen from `owner`: by its path, else the only component with this name.
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

    pub(crate) fn is_frame(&self, id: ComponentId) -> bool {
        let tag = self.tag(id);
        tag == "Body" || tag == "Ground" || tag.ends_with("Frame")
    }

    pub(crate) fn frame_of(&self, owner: ComponentId, connectee: &Connectee<'_>) -> Option<ConnectedFrame> {
        let text = &*connectee.text;
        let exact = self.tree.at_path(owner, text).filter(|&id| self.is_frame(id));
        if exact.is_none() && (text == "ground" || text.ends_with("/ground")) {
            // Ground is at the top of every model, whether the file spells it out or not.
            let exact = match connectee.legacy {
                true => text == "ground",
                false => self.tree.absolute_path(owner, text).as_deref() == Some("/ground"),
            };
            return Some(ConnectedFrame { component: None, by_name: !exact });
        }
        // Documents that name bodies mean those of the BodySet.
        let body = || self.tree.at_path(owner, &format!("/bodyset/{text}")).filter(|&id| self.is_frame(id));
        let component = if connectee.legacy { body() } else { exact };
        if component.is_some() {
            return Some(ConnectedFrame { component, by_name: false });
        }
        let (component, by_name) = self.resolve(owner, text, |id| self.is_frame(id))?;
        // An element that names a body takes no path.
        let by_name = if connectee.legacy { text.contains('/') } else { by_name };
        Some(ConnectedFrame { component: Some(component), by_name })
    }

    /// The frame that a socket of component `id` is connected to.
    pub(crate) fn frame_at(&self, id: ComponentId, socket: &str, legacy: &[&str]) -> Option<ConnectedFrame> {
        self.frame_of(id, &self.connectee(id, socket, legacy)?)
    }

    /// Whether `body` is the body that means ground in old documents.
    pub(crate) fn is_ground(&self, body: ComponentId) -> bool {
        self.document_of(body).version() < FIRST_VERSION_WITHOUT_GROUND_BODY && self.name(body) == "ground"
    }

    /// The body (or ground) that carries a frame, through any number of offset frames between them.
    ///
    /// # Errors
    /// An offset frame has no parent, or its chain of parents returns to itself.
    pub(crate) fn base(&self, frame: Option<ComponentId>) -> Result<Carrier> {
        let mut at = frame;
        for _ in 0..MOST_FRAMES_IN_CHAIN {
            let Some(id) = at else { return Ok(Carrier::Ground) };
            match self.tag(id) {
                "Ground" => return Ok(Carrier::Ground),
                "Body" if self.is_ground(id) => return Ok(Carrier::Ground),
                "Body" => return Ok(Carrier::Body(id)),
                _ => {}
            }
            let Some(parent) = self.parent_of_frame(id) else {
                let text = self.connectee(id, "parent", &["parent_frame"]).map(|parent| parent.text);
                return Err(match self.tag(id) {
                    STATION_DEFINED_FRAME => Fault::refused(format!(
                        "the points of {} are not found, expected the paths of four stations on one body, and two axes",
                        self.tree.path(id)
                    )),
                    _ => self.unresolved(id, &text.unwrap_or_default(), "frame it is attached to"),
                });
            };
            at = parent;
        }
        let path = frame.map(|id| self.tree.path(id)).unwrap_or_default();
        Err(Fault::refused(format!(
            "frame {path} is attached to itself, expected a chain of frames to a body"
        )))
    }

    pub(crate) fn unresolved(&self, owner: ComponentId, connectee: &str, wanted: &'static str) -> Fault {
        let (path, connectee) = (self.tree.path(owner), connectee.to_owned());
        let unread = self.unread_object(self.file_of(owner), &connectee);
        let kind = FaultKind::Unresolved { owner: path.clone(), connectee, wanted, unread };
        let span = self.document_of(owner).tree().open_span(self.element(owner));
        Fault::at_span(kind, span).at_element(path).in_file(self.file_of(owner))
    }

    /// The line and the class of the first object of a file with the last name of `connectee` that OpenSim does not read: its class is
    /// unknown, or it is in the wrong place.
    fn unread_object(&self, file: FileId, connectee: &str) -> Option<(usize, String)> {
        let name = connectee.rsplit('/').next().filter(|name| !name.is_empty())?;
        let tree = self.document(file).tree();
        let mut found = None;
        tree.walk(self.document(file).data_root(), |id| {
            let is_meant = found.is_none()
                && tree.attribute(id, "name").is_some_and(|own| own == name)
                && (self.at(file, id).is_none() || !classes::is_component_class(tree.name(id)));
            found = found.or(is_meant.then_some(id));
            found.is_none()
        });
        let line = |id| self.document(file).position_of(id).line;
        found.map(|id| (line(id), tree.name(id).to_owned()))
    }

    /// Place of an object's start tag in its file.
    pub fn position_of(&self, id: ComponentId) -> TextPosition {
        self.document_of(id).position_of(self.element(id))
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
