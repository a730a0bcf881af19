//! Finds parts of a model that are written wrongly and were read all the same.

use foldhash::{HashSet, HashSetExt};

use crate::model::components::{CONNECTEE_ENDING, ComponentId, Connectee};
use crate::model::contacts::read::{CONTACT_PARAMETERS_SET, ContactReader, GEOMETRY_CLASSES, Irregularity};
use crate::model::document::Document;
use crate::model::fault::FileId;
use crate::xml::opensim_text::list_words;
use crate::xml::{ElementId, Tree};

/// The first version of documents that write all connections as sockets.
const FIRST_VERSION_WITH_SOCKETS: u32 = 40000;

/// Whether `socket`, the end of a tag, is the name of the socket of a frame.
fn is_of_frame(socket: &str) -> bool {
    let is_frame = socket == "parent" || ["frame", "body"].iter().any(|word| socket.contains(word));
    is_frame && !socket.ends_with(CONNECTEE_ENDING)
}

/// A relative path of `object` as it is from the component at `whole` that contains it: each object between them is a step of a path in
/// OpenSim, but sets of a component are none. `None` if the path does not leave the component.
fn seen_from_whole<'t>(tree: &Tree, object: ElementId, whole: ElementId, text: &'t str) -> Option<&'t str> {
    let inside = std::iter::successors(Some(object), |&id| tree.parent(id)).take_while(|&id| id != whole);
    let is_step = |tag: &str| {
        tag.starts_with(|letter: char| letter.is_ascii_uppercase())
            && (tree.name(whole) == "Model" || !tag.ends_with("Set"))
    };
    let mut steps = inside.filter(|&id| is_step(tree.name(id)));
    steps.try_fold(text.trim_start_matches("./"), |rest, _| {
        rest.strip_prefix("..").map(|rest| rest.strip_prefix('/').unwrap_or(rest))
    })
}

/// The sockets of frames that each object of the class `tag` needs, with their names in documents that name bodies; none of a class that is
/// not known.
fn needed_sockets(tag: &str) -> &'static [(&'static str, &'static [&'static str])] {
    match tag {
        "PhysicalOffsetFrame" => &[("parent", &[])],
        _ if tag == "WeldConstraint" || tag.ends_with("BushingForce") => &[("frame1", &[]), ("frame2", &[])],
        _ if tag.ends_with("Joint") => {
            &[("parent_frame", &["parent_body"]), ("child_frame", &["child_body"])]
        }
        _ => &[],
    }
}

impl ContactReader<'_> {
    /// Records the needed sockets, such as those of joints and of their frames, that lead nowhere. OpenSim refuses such a model.
    pub(super) fn record_needed_sockets(&mut self) {
        for (id, _) in self.components.tree.iter() {
            let sockets = needed_sockets(self.components.tag(id));
            if sockets.is_empty() || self.components.tag(self.components.tree.root_of(id)) != "Model" {
                continue;
            }
            for &(socket, legacy) in sockets {
                self.record_socket(id, socket, legacy);
            }
        }
    }

    /// Records the sockets of all other objects, such as path points and markers, that lead to no frame.
    pub(super) fn record_other_sockets(&mut self) {
        let (components, document) = (self.components, self.components.main());
        let (tree, mut found_paths) = (document.tree(), HashSet::new());
        for &element in document.sockets().iter().filter(|_| document.is_model()) {
            let socket = tree.name(element).strip_prefix("socket_").unwrap_or_default();
            let text = tree.text_of(element);
            // The points of muscles are on a few bodies.
            if found_paths.contains(&text) || !is_of_frame(socket) {
                continue;
            }
            let Some(object) = tree.parent(element) else { continue };
            let mut above = std::iter::successors(Some(object), |&id| tree.parent(id));
            let Some(id) = above.find_map(|id| components.at(FileId::MAIN, id)) else { continue };
            let tag = tree.name(object);
            let is_component = components.element(id) == object;
            let is_relative =
                !text.starts_with('/') && (text.is_empty() || text.contains('/') || text.starts_with('.'));
            let is_elsewhere = is_relative && tag != "Marker" && !tag.ends_with("PathPoint");
            // Of geometry in frames OpenSim ignores the socket; where other objects inside components look from is not known.
            let is_unknown = !is_component && (is_elsewhere || components.is_frame(id));
            if !needed_sockets(tag).is_empty() || is_unknown {
                continue;
            }
            let seen = seen_from_whole(tree, object, components.element(id), &text);
            let is_exact = is_component || text.starts_with('/') || seen.is_some();
            let seen = Connectee { text: seen.unwrap_or(&text).into(), element, legacy: false };
            let written = Connectee { text: (&*text).into(), element, legacy: false };
            if self.record_if_lost(id, socket, (&written, &seen), is_exact) && text.starts_with('/') {
                found_paths.insert(text);
            }
        }
    }

    /// Records a surface of each `ElasticFoundationForce` that is nowhere. OpenSim refuses such a model.
    pub(super) fn record_surfaces_of_foundations(&mut self) {
        let components = self.components;
        let is_geometry = |id: ComponentId| GEOMETRY_CLASSES.contains(&components.tag(id));
        for (id, component) in components.tree.iter() {
            if components.tag(id) != "ElasticFoundationForce" || !components.main().is_model() {
                continue;
            }
            let tree = components.document(component.file).tree();
            tree.walk(component.element, |element| {
                if tree.name(element) != "geometry" {
                    return true;
                }
                let names = tree.text_of(element);
                let is_lost = |name: &&str| self.geometry_in_model(name, is_geometry).is_none();
                if let Some(lost) = list_words(&names).find(is_lost) {
                    self.record_nowhere(id, "geometry", lost, element);
                }
                true
            });
        }
    }

    fn record_socket(&mut self, id: ComponentId, socket: &'static str, legacy: &[&str]) {
        if let Some(connectee) = self.components.connectee(id, socket, legacy) {
            self.record_if_lost(id, socket, (&connectee, &connectee), true);
            return;
        }
        let (document, element) = (self.components.document_of(id), self.components.element(id));
        let empty = document.tree().child(element, &format!("socket_{socket}"));
        if empty.is_some() || document.version() >= FIRST_VERSION_WITH_SOCKETS {
            self.record_nowhere(id, socket, "", empty.unwrap_or(element));
        }
    }

    /// Records a socket that is not exact, was resolved by name, or leads nowhere: as it is written, and as seen from component `id`.
    /// Returns whether nothing was to be recorded.
    fn record_if_lost(
        &mut self,
        id: ComponentId,
        socket: &str,
        (written, seen): (&Connectee<'_>, &Connectee<'_>),
        is_exact: bool,
    ) -> bool {
        match self.components.frame_of(id, seen) {
            Some(found) if found.by_name || !is_exact => {
                self.record_component_taken_by_name(id, written, found.component);
            }
            Some(_) => return true,
            None => self.record_nowhere(id, socket, &written.text, written.element),
        }
        false
    }

    fn record_nowhere(&mut self, id: ComponentId, socket: &str, text: &str, at: ElementId) {
        let position = self.components.document_of(id).position_of(at);
        let owner = self.components.tree.path(id);
        let (socket, text) = (socket.to_owned(), text.to_owned());
        self.irregularities.push(Irregularity::LeadsNowhere { owner, socket, text, position });
    }

    pub(super) fn record_component_taken_by_name(
        &mut self,
        id: ComponentId,
        connectee: &Connectee<'_>,
        found: Option<ComponentId>,
    ) {
        if !self.taken_by_name.insert((id, connectee.element, connectee.text.to_string())) {
            return;
        }
        let path = found.map_or_else(|| "/ground".to_owned(), |id| self.components.tree.path(id));
        let (document, element) = (self.components.document_of(id), connectee.element);
        let tag = document.tree().name(element);
        let is_whole = self.components.file_of(id) == FileId::MAIN
            && (connectee.legacy || (tag.starts_with("socket_") && !tag.ends_with(CONNECTEE_ENDING)));
        let name = path.rsplit('/').next().unwrap_or_default().to_owned();
        self.irregularities.push(Irregularity::TakenByName {
            owner: self.components.tree.path(id),
            class: self.components.tag(id).to_owned(),
            text: connectee.text.to_string(),
            taken: if connectee.legacy { name } else { path },
            socket: is_whole.then_some(element),
            position: document.position_of(element),
        });
    }

    pub(super) fn record_misnamed_set(&mut self, id: ComponentId, document: &Document, element: ElementId) {
        let tree = document.tree();
        let set = tree.children(element).find(|&child| tree.name(child) == CONTACT_PARAMETERS_SET);
        if let Some(set) = set {
            let name = tree.attribute(set, "name").unwrap_or_default().into_owned();
            let force = self.components.tree.path(id);
            let position = document.position_of(set);
            self.irregularities.push(Irregularity::MisnamedSet { force, name, position });
        }
    }
}
