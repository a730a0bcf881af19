//! The components of a model and their paths: which elements OpenSim turns into objects, and what they are called.
//!
//! One pass over the elements in file order gives every element its role. Components are the items of `<objects>`,
//! `<components>`, `<frames>` and of a Body's `<Joint>`, sets, and ground; everything else is a property. `<defaults>` of the data root is left out: its objects are not part of the model.

use std::collections::{HashMap, HashSet};

use super::classes;
use crate::document::Document;
use crate::fault::FileId;
use osim_xml::{ElementId, KeptElements};

/// Sets of a model that may hold contacts or what they are attached to; markers, muscles' path points and the like are
/// skipped, which keeps large models fast.
const MODEL_SETS: [&str; 6] =
    ["ForceSet", "ContactGeometrySet", "BodySet", "JointSet", "ConstraintSet", "ComponentSet"];
/// Sets inside a contact force.
const CONTACT_PARAMETERS_SETS: [&str; 2] =
    ["HuntCrossleyForce::ContactParametersSet", "ElasticFoundationForce::ContactParametersSet"];

/// Index of an object among all files read together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct ComponentId(u32);

/// One component.
#[derive(Debug, Clone)]
pub(crate) struct Component {
    /// Which of the files.
    pub file: FileId,
    pub element: ElementId,
    pub parent: Option<ComponentId>,
    /// Last segment of the path: OpenSim's name of it, numbered where siblings share a name.
    pub segment: String,
}

/// All components of the files read together, with look-up by path and by name.
#[derive(Debug, Clone, Default)]
pub(crate) struct ComponentTree {
    list: Vec<Component>,
    roots: Vec<ComponentId>,
    by_parent: HashMap<(Option<ComponentId>, String), ComponentId>,
    by_segment: HashMap<String, Vec<ComponentId>>,
    /// The numbers tried for a name among siblings: they are taken.
    tried: HashMap<(Option<ComponentId>, String), usize>,
    /// Members of `<components>` of a class that OpenSim does not know: file and element.
    pub(crate) skipped: Vec<(FileId, ElementId)>,
}

#[derive(Clone, Copy)]
enum Role {
    /// Nothing below here is an object.
    Nothing,
    Object(ComponentId),
    /// The children of this element are objects that belong to this one.
    Items(ComponentId),
    /// As `Items`, but a class that OpenSim does not know is skipped.
    Components(ComponentId),
}

impl ComponentTree {
    /// Adds all objects of `document`. A file other than the model hangs below `mount`, the object that includes it.
    pub(crate) fn add(&mut self, file: FileId, document: &Document, mount: Option<ComponentId>) {
        let tree = document.tree();
        let mut roles = vec![Role::Nothing; tree.element_count()];
        let mut seen: HashSet<(ComponentId, String)> = HashSet::new();
        for id in tree.elements() {
            let Some(parent) = tree.parent(id) else { continue };
            let is_root = id == document.data_root();
            let above = roles.get(parent.index()).copied().unwrap_or(Role::Nothing);
            // Most elements are properties of properties: they cost no further look.
            if matches!(above, Role::Nothing) && !is_root {
                continue;
            }
            let tag = tree.name(id);
            // What is in another file hangs here once that file is added.
            let role = if document.file_of(id).is_some() {
                Role::Nothing
            } else if is_root {
                Role::Object(self.push_root(file, document, mount))
            } else {
                match above {
                    Role::Nothing => Role::Nothing,
                    Role::Components(_) if !classes::is_known(tag) => {
                        self.skipped.push((file, id));
                        Role::Nothing
                    }
                    Role::Items(owner) | Role::Components(owner) => {
                        let name = tree.attribute(id, "name").unwrap_or_default();
                        // OpenSim calls a component without a name after its class.
                        let segment = if name.is_empty() { tag.to_lowercase() } else { name.into_owned() };
                        Role::Object(self.push(Component { file, element: id, parent: Some(owner), segment }))
                    }
                    Role::Object(owner) => self.role_of_property(file, document, id, tag, owner, &mut seen),
                }
            };
            if let Some(slot) = roles.get_mut(id.index()) {
                *slot = role;
            }
        }
    }

    /// The same components, those of the main file at the places of `kept`.
    pub(crate) fn moved(&self, kept: &KeptElements) -> Self {
        let mut moved = self.clone();
        let own = moved.list.iter_mut().map(|component| (component.file, &mut component.element));
        let skipped = moved.skipped.iter_mut().map(|(file, element)| (*file, element));
        for (_, element) in own.chain(skipped).filter(|(file, _)| *file == FileId::MAIN) {
            *element = kept.place(*element);
        }
        moved
    }

    fn push_root(&mut self, file: FileId, document: &Document, mount: Option<ComponentId>) -> ComponentId {
        let tree = document.tree();
        let element = document.data_root();
        let tag = tree.name(element);
        let segment = if tag == "Model" {
            String::new()
        } else if tag.ends_with("Set") {
            tag.to_lowercase()
        } else {
            tree.attribute(element, "name").unwrap_or_default().into_owned()
        };
        // A set that stands alone belongs to a model elsewhere; its paths are those it has there.
        self.push(Component { file, element, parent: mount, segment })
    }

    fn role_of_property(
        &mut self,
        file: FileId,
        document: &Document,
        id: ElementId,
        tag: &str,
        owner: ComponentId,
        seen: &mut HashSet<(ComponentId, String)>,
    ) -> Role {
        let tree = document.tree();
        let owner_tag = self.get(owner).map(|object| tree.name(object.element)).unwrap_or_default();
        let holds_items = match tag {
            "components" => true,
            "objects" => owner_tag.ends_with("Set"),
            "frames" => owner_tag.ends_with("Joint"),
            "Joint" => owner_tag == "Body",
            _ => false,
        };
        let is_set = match owner_tag {
            "Model" => MODEL_SETS.contains(&tag),
            _ => CONTACT_PARAMETERS_SETS.contains(&tag),
        };
        let is_ground = tag == "Ground" && owner_tag == "Model";
        // OpenSim reads the first of duplicated properties.
        if !(holds_items || is_set || is_ground) || !seen.insert((owner, tag.to_owned())) {
            return Role::Nothing;
        }
        if holds_items {
            return if tag == "components" { Role::Components(owner) } else { Role::Items(owner) };
        }
        // Sets (and ground) are called after their class, whatever name their element has.
        let segment = tag.to_lowercase();
        Role::Object(self.push(Component { file, element: id, parent: Some(owner), segment }))
    }

    fn push(&mut self, mut object: Component) -> ComponentId {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "no more objects than elements, and those are u32"
        )]
        let id = ComponentId(self.list.len() as u32);
        self.by_segment.entry(object.segment.clone()).or_default().push(id);
        if object.parent.is_none() {
            self.roots.push(id);
        } else {
            self.number(&mut object);
        }
        self.by_parent.entry((object.parent, object.segment.clone())).or_insert(id);
        self.list.push(object);
        id
    }

    /// OpenSim calls the second of two siblings `f` `f_0`, the third `f_1`.
    fn number(&mut self, object: &mut Component) {
        // Hundreds of equal names are a mistake, not a model: no need to number them all.
        const MOST: usize = 64;
        let mut key = (object.parent, object.segment.clone());
        if !self.by_parent.contains_key(&key) {
            return;
        }
        let tried = self.tried.entry(key.clone()).or_default();
        loop {
            key.1 = format!("{}_{tried}", object.segment);
            if *tried >= MOST || !self.by_parent.contains_key(&key) {
                break;
            }
            *tried += 1;
        }
        object.segment = key.1;
    }

    pub(crate) fn get(&self, id: ComponentId) -> Option<&Component> {
        self.list.get(id.0 as usize)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = (ComponentId, &Component)> {
        #[expect(clippy::cast_possible_truncation, reason = "see push")]
        self.list.iter().enumerate().map(|(index, object)| (ComponentId(index as u32), object))
    }

    /// The object that is written as `element` of `file`.
    pub(crate) fn of_element(&self, file: FileId, element: ElementId) -> Option<ComponentId> {
        // Components of one file are in element order.
        let start = self.list.partition_point(|object| object.file < file);
        let end = self.list.partition_point(|object| object.file <= file);
        let of_file = self.list.get(start..end)?;
        let at = of_file.binary_search_by_key(&element, |object| object.element).ok()?;
        u32::try_from(start + at).ok().map(ComponentId)
    }

    /// The absolute path, as OpenSim prints it.
    pub(crate) fn path(&self, id: ComponentId) -> String {
        let mut segments = Vec::new();
        let mut next = Some(id);
        while let Some(object) = next.and_then(|id| self.get(id)) {
            if object.parent.is_some() || !object.segment.is_empty() {
                segments.push(object.segment.as_str());
            }
            next = object.parent;
        }
        let mut path = String::new();
        for segment in segments.iter().rev() {
            path.push('/');
            path.push_str(segment);
        }
        if path.is_empty() { "/".to_owned() } else { path }
    }

    /// The data root of the model.
    pub(crate) fn first(&self) -> Option<ComponentId> {
        (!self.list.is_empty()).then_some(ComponentId(0))
    }

    /// The data root above `id`.
    pub(crate) fn root_of(&self, id: ComponentId) -> ComponentId {
        let mut at = id;
        while let Some(parent) = self.get(at).and_then(|object| object.parent) {
            at = parent;
        }
        at
    }

    fn child(&self, parent: ComponentId, segment: &str) -> Option<ComponentId> {
        self.by_parent.get(&(Some(parent), segment.to_owned())).copied()
    }

    /// Follows `path`, absolute or relative to `owner`, exactly as OpenSim does.
    pub(crate) fn at_path(&self, owner: ComponentId, path: &str) -> Option<ComponentId> {
        match path.strip_prefix('/') {
            Some(absolute) => self.roots.iter().find_map(|&root| self.below_root(root, absolute)),
            None => self.walk(owner, path),
        }
    }

    fn below_root(&self, root: ComponentId, path: &str) -> Option<ComponentId> {
        let segment = &self.get(root)?.segment;
        if segment.is_empty() {
            return self.walk(root, path);
        }
        // A set that stands alone: its own name is the first segment.
        let rest = path.strip_prefix(segment.as_str())?;
        match rest.strip_prefix('/') {
            Some(rest) => self.walk(root, rest),
            None => rest.is_empty().then_some(root),
        }
    }

    /// The absolute path that `path` means, seen from `owner`; it need not lead anywhere.
    pub(crate) fn absolute(&self, owner: ComponentId, path: &str) -> Option<String> {
        if path.starts_with('/') {
            return Some(path.to_owned());
        }
        let base = self.path(owner);
        let mut segments: Vec<&str> = base.split('/').filter(|segment| !segment.is_empty()).collect();
        for segment in path.split('/').filter(|segment| !segment.is_empty() && *segment != ".") {
            if segment == ".." {
                segments.pop()?;
            } else {
                segments.push(segment);
            }
        }
        Some(format!("/{}", segments.join("/")))
    }

    fn walk(&self, from: ComponentId, path: &str) -> Option<ComponentId> {
        let mut at = from;
        for segment in path.split('/').filter(|segment| !segment.is_empty() && *segment != ".") {
            at = if segment == ".." { self.get(at)?.parent? } else { self.child(at, segment)? };
        }
        Some(at)
    }

    /// All objects with this last segment that pass `accept`.
    pub(crate) fn named<'s>(
        &'s self,
        name: &str,
        accept: impl Fn(ComponentId) -> bool + 's,
    ) -> impl Iterator<Item = ComponentId> + 's {
        self.by_segment.get(name).into_iter().flatten().copied().filter(move |&id| accept(id))
    }
}
