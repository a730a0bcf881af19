//! The components of a model and their paths: the elements that OpenSim makes into objects, and the names of these objects.
//!
//! One pass in file order decides for each element what it is. Components are the members of `<objects>`, `<components>`, `<frames>` and of
//! a Body's `<Joint>`, also sets and ground; every other element is a property. `<defaults>` of the data root is left out: its objects are
//! not part of the model.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};

use crate::model::components::classes::{self, CountedSets};
use crate::model::{Document, FileId};
use crate::xml::ElementId;

/// Sets of a model that may hold contacts, or bodies and frames for them. Other sets, such as markers, are skipped, so that large models
/// are read fast.
const MODEL_SETS: [&str; 6] =
    ["ForceSet", "ContactGeometrySet", "BodySet", "JointSet", "ConstraintSet", "ComponentSet"];
/// Names of the sets of parameters inside a contact force.
const CONTACT_PARAMETERS_SETS: [&str; 2] =
    ["HuntCrossleyForce::ContactParametersSet", "ElasticFoundationForce::ContactParametersSet"];

/// Index of an object among the objects of all files of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ComponentId(u32);

/// An object of a model that has a component path, such as a body or a force.
#[derive(Debug)]
pub struct Component {
    pub file: FileId,
    /// Element of the component in its file.
    pub element: ElementId,
    /// The component that contains this component; `None` for a root.
    pub parent: Option<ComponentId>,
    /// Last part of the object's path: its name in OpenSim, with a number if siblings have the same name.
    pub segment: Arc<str>,
    /// The name without the added number; `None` if no number was added.
    pub unnumbered_name: Option<Arc<str>>,
    /// Whether the component is in `<components>`, which OpenSim reads before other properties.
    is_member: bool,
    children: ChildList,
    next: Option<ComponentId>,
}

/// The children of a component, in file order.
#[derive(Debug, Clone, Copy, Default)]
struct ChildList {
    count: u32,
    first: Option<ComponentId>,
    last: Option<ComponentId>,
    /// Whether the children are entered in [`ComponentTree::by_parent`].
    are_listed: bool,
}

/// Up to this number of children are searched one by one; for more, a map is made.
const MOST_CHILDREN_WITHOUT_MAP: u32 = 12;

/// All components in the files of a model, with search by path and by name.
#[derive(Debug, Default)]
pub struct ComponentTree {
    list: Vec<Component>,
    roots: Vec<ComponentId>,
    /// Children by name, for components with many children or with numbered children.
    by_parent: HashMap<ComponentId, HashMap<Arc<str>, ComponentId>>,
    /// All components by their names without numbers. Made at the first search by name.
    by_name: OnceLock<HashMap<Arc<str>, Vec<ComponentId>>>,
    /// Components with two children of one name, whose children have to be numbered.
    with_repeated_names: HashSet<ComponentId>,
    /// Members of `<components>` whose class OpenSim does not know, with file and element.
    pub skipped: Vec<(FileId, ElementId)>,
}

/// What an XML element means for the tree of components.
#[derive(Clone, Copy)]
enum ElementRole {
    /// The element contains no objects.
    Nothing,
    Object(ComponentId),
    /// The children of this element are objects that belong to this component.
    Items(ComponentId),
    /// The children are members of a set of this component. Members whose class OpenSim does not know are skipped.
    Components(ComponentId),
}

impl ComponentTree {
    /// Adds the objects of `document` that are read. Objects of a file other than the main file become children of `mount`, the component
    /// that includes the file.
    pub(super) fn add(
        &mut self,
        file: FileId,
        document: &Document,
        mount: Option<ComponentId>,
        counted: CountedSets,
    ) {
        self.by_name = OnceLock::new();
        let (tree, is_model) = (document.tree(), document.is_model());
        let mut roles = vec![ElementRole::Nothing; tree.element_count()];
        let mut seen: HashSet<(ComponentId, &str)> = HashSet::new();
        // Most elements are properties of properties: they cost no look.
        tree.walk(document.data_root(), |id| {
            let Some(parent) = tree.parent(id) else { return false };
            let is_root = id == document.data_root();
            let above = roles.get(parent.index()).copied().unwrap_or(ElementRole::Nothing);
            let tag = tree.name(id);
            // The objects of another file become children of this element once that file is added.
            let role = if document.file_of(id).is_some() {
                ElementRole::Nothing
            } else if is_root {
                ElementRole::Object(self.push_root(file, document, mount))
            } else if is_model && parent == document.data_root() && !counted.includes(tag) {
                ElementRole::Nothing
            } else {
                match above {
                    ElementRole::Nothing => ElementRole::Nothing,
                    ElementRole::Components(_) if !classes::is_component_class(tag) => {
                        self.skipped.push((file, id));
                        ElementRole::Nothing
                    }
                    ElementRole::Items(owner) | ElementRole::Components(owner) => {
                        // OpenSim calls a component without a name after its class.
                        let name = name_in_paths(document, id);
                        let segment = if name.is_empty() { tag.to_lowercase().into() } else { name.into() };
                        let is_member = matches!(above, ElementRole::Components(_));
                        ElementRole::Object(self.push(file, id, Some(owner), segment, is_member))
                    }
                    ElementRole::Object(owner) => {
                        self.role_of_property(file, document, id, tag, owner, &mut seen)
                    }
                }
            };
            if let Some(slot) = roles.get_mut(id.index()) {
                *slot = role;
            }
            !matches!(role, ElementRole::Nothing)
        });
        self.number_siblings();
    }

    fn push_root(&mut self, file: FileId, document: &Document, mount: Option<ComponentId>) -> ComponentId {
        let tree = document.tree();
        let element = document.data_root();
        let tag = tree.name(element);
        let segment = if tag == "Model" {
            Arc::default()
        } else if tag.ends_with("Set") {
            tag.to_lowercase().into()
        } else {
            tree.attribute(element, "name").unwrap_or_default().into()
        };
        // A set that stands alone belongs to a model elsewhere; its paths are those it has there.
        self.push(file, element, mount, segment, false)
    }

    fn role_of_property<'d>(
        &mut self,
        file: FileId,
        document: &'d Document,
        id: ElementId,
        tag: &'d str,
        owner: ComponentId,
        seen: &mut HashSet<(ComponentId, &'d str)>,
    ) -> ElementRole {
        let tree = document.tree();
        let owner_tag = || self.get(owner).map(|object| tree.name(object.element)).unwrap_or_default();
        let holds_items = match tag {
            "components" => true,
            "objects" => owner_tag().ends_with("Set"),
            "frames" => ["Joint", "Constraint", "Force"].iter().any(|class| owner_tag().ends_with(class)),
            "Joint" => owner_tag() == "Body",
            _ => false,
        };
        let is_set = (MODEL_SETS.contains(&tag) && owner_tag() == "Model")
            || (CONTACT_PARAMETERS_SETS.contains(&tag) && owner_tag() != "Model");
        let is_ground = tag == "Ground" && owner_tag() == "Model";
        // OpenSim reads the first of duplicated properties.
        if !(holds_items || is_set || is_ground) || !seen.insert((owner, tag)) {
            return ElementRole::Nothing;
        }
        if holds_items {
            return if tag == "components" {
                ElementRole::Components(owner)
            } else {
                ElementRole::Items(owner)
            };
        }
        // Sets (and ground) are called after their class, whatever name their element has.
        ElementRole::Object(self.push(file, id, Some(owner), tag.to_lowercase().into(), false))
    }

    /// Adds a component; `segment` is the last part of its path.
    fn push(
        &mut self,
        file: FileId,
        element: ElementId,
        parent: Option<ComponentId>,
        segment: Arc<str>,
        is_member: bool,
    ) -> ComponentId {
        let id = ComponentId(self.list.len() as u32);
        match parent {
            None => self.roots.push(id),
            Some(owner) if self.child(owner, &segment).is_some() => {
                self.with_repeated_names.insert(owner);
            }
            Some(_) => {}
        }
        let (children, next) = (ChildList::default(), None);
        self.list.push(Component {
            file,
            element,
            parent,
            segment,
            unnumbered_name: None,
            is_member,
            children,
            next,
        });
        if let Some(owner) = parent {
            self.append_child(owner, id);
        }
        id
    }

    /// Adds `id` as the last child of `owner`.
    fn append_child(&mut self, owner: ComponentId, id: ComponentId) {
        let Some(Component { children, .. }) = self.list.get_mut(owner.0 as usize) else { return };
        let last = children.last.replace(id);
        children.first = children.first.or(Some(id));
        children.count += 1;
        let (were_listed, are_many) = (children.are_listed, children.count >= MOST_CHILDREN_WITHOUT_MAP);
        children.are_listed = were_listed || are_many;
        if let Some(last) = last.and_then(|last| self.list.get_mut(last.0 as usize)) {
            last.next = Some(id);
        }
        if were_listed {
            let segment = self.get(id).map(|child| Arc::clone(&child.segment)).unwrap_or_default();
            self.by_parent.entry(owner).or_default().entry(segment).or_insert(id);
        } else if are_many {
            let mut by_segment = HashMap::new();
            for (id, child) in self.children(owner) {
                by_segment.entry(Arc::clone(&child.segment)).or_insert(id);
            }
            self.by_parent.insert(owner, by_segment);
        }
    }

    /// The children of `owner`, in file order.
    fn children(&self, owner: ComponentId) -> impl Iterator<Item = (ComponentId, &Component)> {
        let first = self.get(owner).and_then(|object| object.children.first);
        let ids = std::iter::successors(first, |&id| self.get(id)?.next);
        ids.filter_map(|id| Some((id, self.get(id)?)))
    }

    /// Gives numbers to siblings of one name. OpenSim calls the second of two siblings `f` `f_0`, the third `f_1`, in the order in which it
    /// reads them.
    fn number_siblings(&mut self) {
        for owner in
            std::mem::take(&mut self.with_repeated_names).into_iter().collect::<BTreeSet<ComponentId>>()
        {
            let (members, others): (Vec<_>, Vec<_>) =
                self.children(owner).partition(|(_, object)| object.is_member);
            let children: Vec<ComponentId> = members.into_iter().chain(others).map(|(id, _)| id).collect();

            self.number_children(owner, &children);
        }
    }

    /// Gives numbers to those `children` of `owner` that share a name. OpenSim reads the children in this order.
    fn number_children(&mut self, owner: ComponentId, children: &[ComponentId]) {
        // Hundreds of equal names are a mistake, not a model: no need to number them all.
        const MOST_EQUAL_NAMES: usize = 64;
        let mut tried: HashMap<Arc<str>, usize> = HashMap::new();
        let mut by_segment: HashMap<Arc<str>, ComponentId> = HashMap::new();
        for &id in children {
            let Some(object) = self.list.get_mut(id.0 as usize) else { continue };
            // What an earlier file numbered is numbered again, with what this one has.
            let name = object.unnumbered_name.take().unwrap_or_else(|| Arc::clone(&object.segment));
            object.segment = Arc::clone(&name);
            if by_segment.contains_key(&name) {
                let tried = tried.entry(Arc::clone(&name)).or_default();
                loop {
                    object.segment = format!("{name}_{tried}").into();
                    if *tried >= MOST_EQUAL_NAMES || !by_segment.contains_key(&object.segment) {
                        break;
                    }
                    *tried += 1;
                }
                object.unnumbered_name = Some(name);
            }
            by_segment.entry(Arc::clone(&object.segment)).or_insert(id);
        }
        self.by_parent.insert(owner, by_segment);
        if let Some(object) = self.list.get_mut(owner.0 as usize) {
            object.children.are_listed = true;
        }
    }

    pub(crate) fn get(&self, id: ComponentId) -> Option<&Component> {
        self.list.get(id.0 as usize)
    }

    /// All components, file by file, in the order of their elements.
    pub fn iter(&self) -> impl Iterator<Item = (ComponentId, &Component)> {
        self.list.iter().enumerate().map(|(index, object)| (ComponentId(index as u32), object))
    }

    /// The component that is written as `element` of `file`.
    pub(crate) fn component_at(&self, file: FileId, element: ElementId) -> Option<ComponentId> {
        // Files are in the order of their numbers, and components of one file in that of their elements.
        let place = |object: &Component| (object.file, object.element);
        let at = self.list.binary_search_by_key(&(file, element), place).ok()?;
        u32::try_from(at).ok().map(ComponentId)
    }

    /// The absolute path of a component, as OpenSim prints it.
    pub fn path(&self, id: ComponentId) -> String {
        let upwards = || std::iter::successors(self.get(id), |object| self.get(object.parent?));
        let segments = || {
            let named = upwards().filter(|object| object.parent.is_some() || !object.segment.is_empty());
            named.map(|object| object.segment.as_bytes())
        };
        // Every message and every contact has one: a path is allocated once, and filled from its end.
        let mut path = vec![b'/'; segments().map(|segment| segment.len() + 1).sum::<usize>().max(1)];
        let mut rest = path.as_mut_slice();
        for segment in segments() {
            let (before, own) = rest.split_at_mut(rest.len() - segment.len());
            own.copy_from_slice(segment);
            rest = before.split_last_mut().map(|(_, before)| before).unwrap_or_default();
        }
        String::from_utf8(path).unwrap_or_default()
    }

    /// The component of the main file's data root.
    pub(crate) fn data_root(&self) -> Option<ComponentId> {
        (!self.list.is_empty()).then_some(ComponentId(0))
    }

    /// The component without parent that contains `id`: the root of the data of its file.
    pub(crate) fn root_of(&self, id: ComponentId) -> ComponentId {
        let mut at = id;
        while let Some(parent) = self.get(at).and_then(|object| object.parent) {
            at = parent;
        }
        at
    }

    fn child(&self, parent: ComponentId, segment: &str) -> Option<ComponentId> {
        if self.get(parent)?.children.are_listed {
            return self.by_parent.get(&parent)?.get(segment).copied();
        }
        self.children(parent).find(|(_, object)| *object.segment == *segment).map(|(id, _)| id)
    }

    /// Finds the component at `path`, absolute or relative to `owner`, exactly as OpenSim does.
    pub(crate) fn at_path(&self, owner: ComponentId, path: &str) -> Option<ComponentId> {
        match path.strip_prefix('/') {
            Some(absolute) => self.roots.iter().find_map(|&root| self.below_root(root, absolute)),
            // The path may lead out of a set that stands alone, into the model beside it.
            None => self.walk(owner, path).or_else(|| match self.roots.as_slice() {
                [_] => None,
                _ => self.at_path(owner, &self.absolute_path(owner, path)?),
            }),
        }
    }

    fn below_root(&self, root: ComponentId, path: &str) -> Option<ComponentId> {
        let segment = &self.get(root)?.segment;
        if segment.is_empty() {
            return self.walk(root, path);
        }
        // A set that stands alone: its own name is the first segment.
        let rest = path.strip_prefix(&**segment)?;
        match rest.strip_prefix('/') {
            Some(rest) => self.walk(root, rest),
            None => rest.is_empty().then_some(root),
        }
    }

    /// The absolute form of `path`, seen from `owner`. A component at this path need not exist.
    pub(crate) fn absolute_path(&self, owner: ComponentId, path: &str) -> Option<String> {
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

    /// Follows a relative path as OpenSim does: a name and the `..` after it cancel, even if no component has the name.
    fn walk(&self, from: ComponentId, path: &str) -> Option<ComponentId> {
        let segments = || path.split('/').filter(|segment| !segment.is_empty() && *segment != ".");
        if !path.as_bytes().windows(2).any(|pair| pair == b"..") {
            return segments().try_fold(from, |at, segment| self.child(at, segment));
        }
        let (mut at, mut down) = (from, Vec::new());
        for segment in segments() {
            match segment {
                ".." if down.pop().is_none() => at = self.get(at)?.parent?,
                ".." => {}
                segment => down.push(segment),
            }
        }
        down.into_iter().try_fold(at, |at, segment| self.child(at, segment))
    }

    /// All components with this last name of the path for which `accept` is true.
    pub(crate) fn with_name<'s>(
        &'s self,
        name: &str,
        accept: impl Fn(ComponentId) -> bool + 's,
    ) -> impl Iterator<Item = ComponentId> + 's {
        let by_name = self.by_name.get_or_init(|| {
            let mut by_name: HashMap<Arc<str>, Vec<ComponentId>> = HashMap::new();
            for (id, object) in self.iter() {
                let name = object.unnumbered_name.as_ref().unwrap_or(&object.segment);
                by_name.entry(Arc::clone(name)).or_default().push(id);
            }
            by_name
        });
        by_name.get(name).into_iter().flatten().copied().filter(move |&id| accept(id))
    }
}

/// The name of an element as it appears in paths. In documents before version 3.5, OpenSim removes blanks from names.
fn name_in_paths(document: &Document, id: ElementId) -> Cow<'_, str> {
    const FIRST_VERSION_WITH_BLANKS_IN_NAMES: u32 = 30500;
    let name = document.tree().attribute(id, "name").unwrap_or_default();
    let is_blank = |letter: char| letter.is_ascii_whitespace() || letter == '\u{b}';
    if document.version() >= FIRST_VERSION_WITH_BLANKS_IN_NAMES || !name.contains(is_blank) {
        return name;
    }
    Cow::Owned(name.chars().filter(|&letter| !is_blank(letter)).collect())
}
