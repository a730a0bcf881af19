//! Rules about what OpenSim refuses or ignores: objects in the wrong places, names that it does not know, and forms of other document
//! versions.

use foldhash::{HashMap, HashMapExt};
use osim_model::messages::shown;
use osim_model::xml::Tree;
use osim_model::{
    Class, ComponentId, Document, ElementId, Example, FileId, Finding, ForceKind, GEOMETRY_CLASSES,
    LAST_VERSION_WITH_IS_DISABLED, Model, Repair, component_classes, nearest_names, opensim_text,
};

use crate::rules::spheres::other_cases_in_words;
use osim_model::rule;

/// Finds objects, names and forms of documents that OpenSim refuses or ignores.
pub(super) fn find_unread(model: &Model) -> Vec<Finding> {
    let rules =
        [find_body_without_joint, find_version_against_form, find_misplaced_objects, find_unknown_classes];
    let of_file = |file| [find_ignored_contacts(model, file), find_unknown_properties(model, file)];
    let of_model = rules.iter().map(|find| find(model));
    of_model.chain(files_of_model(model).flat_map(of_file)).flatten().collect()
}

rule! { pub(super) BODY_WITHOUT_JOINT: BodyWithoutJoint, Error, Mass;
    what: "A body has no joint.",
    why: "OpenSim refuses the model: each body hangs on a joint. The mass of such a body would count in the sum.",
    advice: "Give the body a joint, or take it out of the model",
    repair: Repair::NotPossible("only you know where the body belongs"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/body_without_joint.osim" },
}

/// One finding for all bodies without a joint. Documents in the form of another version are left out.
fn find_body_without_joint(model: &Model) -> Vec<Finding> {
    let (components, bodies) = (model.components(), &model.skeleton().without_joint);
    let Some(&first) = bodies.first().filter(|_| find_version_against_form(model).is_empty()) else {
        return Vec::new();
    };
    let path = components.tree.path(first);
    let others = other_cases_in_words(bodies.len(), "another body, too", "other bodies, too");
    let text = format!("{path} has no joint: OpenSim refuses the model{others}");
    vec![Finding::at(&BODY_WITHOUT_JOINT, components.position_of(first), text).with_place(&path)]
}

rule! { pub(super) VERSION_AGAINST_FORM: OtherVersion, Error;
    what: "The document is written in another way than its Version says.",
    why: "Joints, connections and muscle paths are written in other ways from version to version. OpenSim reads a document as its Version says, and does not find what is written in another way.",
    advice: "Write the version with which the file was saved: the number at the beginning of the file was changed",
    repair: Repair::NotPossible("only you know the version with which the file was saved"),
    example: Example::Piece { model: "format/v40000.osim", good: "Version=\"40000\"",
        bad: "Version=\"30000\"" },
}

/// The first version whose joints are in a JointSet.
const FIRST_VERSION_WITH_JOINT_SET: u32 = 30501;

/// The last version whose contact geometry names a body; in later ones it names a frame.
const LAST_VERSION_WITH_BODY_NAME: u32 = 30504;

/// Finds a document whose form is that of another version than it says.
fn find_version_against_form(model: &Model) -> Vec<Finding> {
    let document = model.document();
    if !document.is_model() {
        return Vec::new();
    }
    let (tree, version) = (document.tree(), document.version());
    let joints = || tree.child(tree.child(document.data_root(), "JointSet")?, "objects");
    let joint = joints().filter(|_| version < FIRST_VERSION_WITH_JOINT_SET).map(|all| tree.children(all));
    let early = joint
        .and_then(|mut all| Some((all.next()?, "its joints are in a JointSet, as from 30501 on".into())));
    let mut late = None;
    tree.walk(document.data_root(), |id| {
        let tag = tree.name(id);
        let last = last_version_with(tree, id, tag).filter(|last| version > *last);
        let is_early = tag == "socket_frame" && version <= LAST_VERSION_WITH_BODY_NAME;
        let versions = match last {
            Some(last) => Some(format!("up to {last}")),
            None if is_early && is_only_frame(tree, id) => Some("from 30505 on".to_owned()),
            None => None,
        };
        if let (Some(versions), None) = (versions, &late) {
            late = Some((id, format!("{tag} is written as in documents {versions}")));
        }
        late.is_none() && tag != "defaults"
    });
    let finding = |(element, form): (ElementId, String)| {
        let text = format!("the document says Version {version}, and {form}");
        Finding::at(&VERSION_AGAINST_FORM, document.position_of(element), text)
    };
    early.or(late).map(finding).into_iter().collect()
}

/// The last version whose documents have an element `tag` of this form; `None` if all later ones can have it, too.
fn last_version_with(tree: &Tree, element: ElementId, tag: &str) -> Option<u32> {
    let above = |steps| {
        let mut all = std::iter::successors(Some(element), |&id| tree.parent(id));
        all.nth(steps).map_or("", |id| tree.name(id))
    };
    match tag {
        "location" if above(2) == "Joint" => Some(30499),
        "Joint" if above(1) == "Body" => Some(30500),
        "body_name" if is_only_frame(tree, element) => Some(LAST_VERSION_WITH_BODY_NAME),
        "connectors" => Some(30507),
        "GeometryPath" if !["path", "components", "objects"].contains(&above(1)) => {
            let name = tree.attribute(element, "name").unwrap_or_default();
            (!["", "path"].contains(&&*name)).then_some(40499)
        }
        _ if !tag.ends_with("_connectee_name") => None,
        _ if tag.starts_with("connector_") => Some(30509),
        _ => tag.starts_with("socket_").then_some(30516),
    }
}

/// Whether `element` alone says what the contact geometry around it is attached to.
fn is_only_frame(tree: &Tree, element: ElementId) -> bool {
    let geometry = tree.parent(element).filter(|&id| GEOMETRY_CLASSES.contains(&tree.name(id)));
    let is_frame = |id: &ElementId| {
        ["body_name", "socket_", "connector"].iter().any(|begin| tree.name(*id).starts_with(begin))
    };
    geometry.is_some_and(|geometry| tree.children(geometry).filter(is_frame).count() == 1)
}

rule! { pub(super) MISPLACED_OBJECT: MisplacedObject, Error;
    what: "A force, contact geometry, a joint, a body or a set is in the set of another kind.",
    why: "OpenSim refuses a set with an object of another kind.",
    advice: "Move the object to its own set",
    repair: Repair::NotPossible("only numbers are changed, and the object has to move"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/sphere_in_force_set.osim" },
}

const SETS: [&str; 5] = ["BodySet", "JointSet", "ContactGeometrySet", "ForceSet", "ConstraintSet"];

/// One finding for each set that has objects of another kind.
fn find_misplaced_objects(model: &Model) -> Vec<Finding> {
    let components = model.components();
    let is_misplaced = |id: ComponentId, set: ComponentId| {
        let tag = components.tag(id);
        let set_of_kind = match tag {
            "Body" => "BodySet",
            _ if tag.ends_with("Joint") => "JointSet",
            _ if GEOMETRY_CLASSES.contains(&tag) => "ContactGeometrySet",
            _ if FORCE_CLASSES.contains(&tag) => "ForceSet",
            // A set is a part of the model.
            _ if SETS.contains(&tag) => "Model",
            _ => components.tag(set),
        };
        let is_of_other_kind = SETS.contains(&components.tag(set)) && set_of_kind != components.tag(set);
        let tree = components.document_of(id).tree();
        is_of_other_kind
            && tree.parent(components.element(id)).is_some_and(|list| tree.name(list) == "objects")
    };
    let misplaced = components
        .tree
        .iter()
        .filter_map(|(id, component)| Some((id, component.parent.filter(|&set| is_misplaced(id, set))?)));
    let finding = |(id, set, count)| {
        let path = components.tree.path(id);
        let others = other_cases_in_words(count, "another object, too", "other objects, too");
        let text = format!("a {} is in the {}: {path}{others}", components.tag(id), components.tag(set));
        Finding::at(&MISPLACED_OBJECT, components.position_of(id), text).with_place(&path)
    };
    count_neighbours(misplaced).into_iter().map(finding).collect()
}

rule! { pub(super) IGNORED_CONTACTS: IgnoredContacts, Warning;
    what: "Objects are where OpenSim does not read them.",
    why: "OpenSim reads the first set of each kind, and of a set what is in its first <objects>. What is elsewhere is in the file, but not in the simulation.",
    advice: "Move them into the <objects> of the set that OpenSim reads",
    repair: Repair::NotPossible("only numbers are changed, and the objects have to move"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/forceset_no_objects.osim" },
}

/// The main file and the files that it includes.
fn files_of_model(model: &Model) -> impl Iterator<Item = FileId> {
    let included = model.companions().filter(|(_, companion)| companion.included_by.is_some());
    std::iter::once(FileId::MAIN).chain(included.map(|(file, _)| file))
}

/// The first of neighbouring `items` with one parent, the parent, and the number of these items; for each run of such neighbours.
fn count_neighbours<T: PartialEq>(items: impl IntoIterator<Item = (T, T)>) -> Vec<(T, T, usize)> {
    let mut counted: Vec<(T, T, usize)> = Vec::new();
    for (item, parent) in items {
        match counted.last_mut().filter(|(_, known, _)| *known == parent) {
            Some((.., count)) => *count += 1,
            None => counted.push((item, parent, 1)),
        }
    }
    counted
}

/// One finding for each place in one file with contacts or joints that OpenSim does not read.
fn find_ignored_contacts(model: &Model, file: FileId) -> Vec<Finding> {
    let (document, components) = (model.file(file), model.components());
    let tree = document.tree();
    // Objects of classes that OpenSim does not know have a finding of their own.
    let left_out = |id: ElementId| {
        let mut above = std::iter::successors(Some(id), |&id| tree.parent(id));
        above.any(|id| tree.name(id) == "defaults" || components.tree.skipped.contains(&(file, id)))
    };
    let is_contact_or_joint = |id: ElementId| {
        let tag = tree.name(id);
        // Most elements are none of these.
        let is_class = (tag.ends_with("Force") && FORCE_CLASSES.contains(&tag))
            || (tag.starts_with("Contact") && GEOMETRY_CLASSES.contains(&tag))
            || (tag.ends_with("Joint") && component_classes().binary_search(&tag).is_ok());
        is_class && tree.attribute(id, "name").is_some()
    };
    let is_ignored = |id| is_contact_or_joint(id) && components.at(file, id).is_none() && !left_out(id);
    let mut ignored = Vec::new();
    // OpenSim reads the first element of a document alone.
    tree.walk(ElementId::ROOT, |id| {
        ignored.extend(is_ignored(id).then(|| Some((id, tree.parent(id)?))).flatten());
        // Most of a model is muscles, in which no contacts are lost.
        !tree.name(id).ends_with("Muscle")
    });
    let finding = |(first, parent, count)| {
        let name = tree.attribute(first, "name").unwrap_or_default();
        let others = other_cases_in_words(count, "another object, too", "other objects, too");
        let place = place_in_words(document, parent);
        let text = format!("OpenSim does not read {} {}, {place}{others}", tree.name(first), shown(&name));
        Finding::at(&IGNORED_CONTACTS, document.position_of(first), text)
    };
    count_neighbours(ignored).into_iter().map(finding).collect()
}

/// Where an object stands that OpenSim does not read, if `parent` is the element around it.
fn place_in_words(document: &Document, parent: ElementId) -> String {
    let tree = document.tree();
    let set = if tree.name(parent) == "objects" { tree.parent(parent).unwrap_or(parent) } else { parent };
    let tag = tree.name(set);
    let first = tree.parent(set).and_then(|above| tree.child(above, tag));
    let mut above = std::iter::successors(Some(set), |&id| tree.parent(id));
    match first {
        _ if above.all(|id| id != document.data_root()) => {
            format!("which is outside of <{}>", tree.name(document.data_root()))
        }
        Some(first) if first != set => format!("which is in a second <{tag}>: only the first counts"),
        _ if set != parent => format!("which is in a second <objects> of <{tag}>"),
        _ => format!("which is in <{tag}>, outside of its <objects>"),
    }
}

rule! { pub(super) UNKNOWN_NAME: UnknownName, Error;
    what: "A class, or a property on which contacts depend, has a name that OpenSim does not know.",
    why: "OpenSim refuses an unknown class, and ignores an unknown property: the default of the property that was meant counts.",
    advice: "Write the name that OpenSim knows",
    repair: Repair::NotPossible("only numbers are changed, and names are left alone"),
    example: Example::Piece { model: "format/v40000.osim", good: "<dissipation>2.25</dissipation>",
        bad: "<disipation>2.25</disipation>" },
}

const PARAMETERS_TAG: &str = "HuntCrossleyForce::ContactParameters";
const FOUNDATION_TAG: &str = "ElasticFoundationForce::ContactParameters";
static FORCE_CLASSES: [&str; 3] =
    [ForceKind::HuntCrossley.as_str(), ForceKind::SmoothSphereHalfSpace.as_str(), "ElasticFoundationForce"];
/// Classes of early versions of Moco that OpenSim does not have, with the classes that took their place.
const RENAMED_CLASSES: [(&str, &str); 1] = [("AckermannVanDenBogert2010Force", "SmoothSphereHalfSpaceForce")];

/// Finds classes whose names are nearly those of OpenSim.
fn find_unknown_classes(model: &Model) -> Vec<Finding> {
    let components = model.components();
    let members = components.tree.iter().map(|(_, component)| (component.file, component.element));
    // Models have many objects of few classes.
    let mut known: HashMap<&str, Option<&str>> = HashMap::new();
    let all = members.chain(components.tree.skipped.iter().copied());
    let finding = |(file, element)| {
        let tree = components.document(file).tree();
        let class = tree.name(element);
        let near = || {
            let is_known = component_classes().binary_search(&class).is_ok();
            let near = || probable_property_name(class, component_classes());
            (!is_known).then(|| near().or_else(|| shortened_contact_class(class))).flatten()
        };
        let meant = (*known.entry(class).or_insert_with(near))?;
        Some(finding_about_unknown_name(model, file, element, element, meant))
    };
    all.filter_map(finding).collect()
}

/// The class of contacts of which `class`, which OpenSim does not know, is the begin or the end.
fn shortened_contact_class(class: &str) -> Option<&'static str> {
    /// Fewer letters do not say which class is meant.
    const FEWEST_LETTERS: usize = 10;
    let mut all = FORCE_CLASSES.into_iter().chain([PARAMETERS_TAG, FOUNDATION_TAG]);
    let is_part = |whole: &str| whole != class && (whole.starts_with(class) || whole.ends_with(class));
    all.find(|whole| class.len() >= FEWEST_LETTERS && is_part(whole))
}

/// The finding about the name of `element`, which is in the component at `owner` or is that component.
fn finding_about_unknown_name(
    model: &Model,
    file: FileId,
    owner: ElementId,
    element: ElementId,
    meant: &str,
) -> Finding {
    let (document, path) = (model.file(file), path_of_component(model, file, owner));
    let what = if owner == element { "class" } else { "element" };
    let (name, span) = (document.tree().name(element), document.tree().span(element));
    let of = if path == "/" { "the model" } else { &path };
    let text = format!("the {what} {name} of {of} has a name that OpenSim does not know: {meant} is meant");
    Finding::at(&UNKNOWN_NAME, document.position(span.start), text).with_place(&path)
}

/// The path of the component that is, or is around, an element.
pub(super) fn path_of_component(model: &Model, file: FileId, element: ElementId) -> String {
    let (tree, components) = (model.file(file).tree(), model.components());
    let mut above = std::iter::successors(Some(element), |&id| tree.parent(id));
    let component = above.find_map(|id| components.at(file, id));
    component.map(|id| components.tree.path(id)).unwrap_or_default()
}

/// Finds names of properties in one file that are nearly those of OpenSim: of contacts, and of the sets around them.
fn find_unknown_properties(model: &Model, file: FileId) -> Vec<Finding> {
    let document = model.file(file);
    let tree = document.tree();
    let (mut found, mut meant) = (Vec::new(), MeantNames::new());
    tree.walk(document.data_root(), |id| {
        let Some(known) = known_children(document, id) else { return false };
        found.extend(find_unknown_children(model, file, id, (known, &mut meant)));
        found.extend(ignored_flag(document, id).map(|flag| {
            let path = path_of_component(model, file, id);
            let tag = tree.name(flag);
            let text = if document.version() > LAST_VERSION_WITH_IS_DISABLED {
                let first = LAST_VERSION_WITH_IS_DISABLED + 1;
                format!("{tag} of {path} is true, but documents from version {first} on have appliesForce instead: the force is on")
            } else {
                format!("{tag} of {path} is ignored, because the first of isDisabled and appliesForce counts: the force is on")
            };
            Finding::at(&UNKNOWN_NAME, document.position_of(flag), text).with_place(&path)
        }));
        true
    });
    found
}

/// The property that was probably meant by the name of an element in an object of a class. A model has many objects of few classes.
type MeantNames<'a> = HashMap<(&'a str, &'a str), Option<&'static str>>;

/// One finding for each element inside of `owner` whose name is nearly that of a property among `known` that is not there.
fn find_unknown_children<'a>(
    model: &'a Model,
    file: FileId,
    owner: ElementId,
    (known, meant): (&[&'static str], &mut MeantNames<'a>),
) -> Vec<Finding> {
    let tree = model.file(file).tree();
    let finding = |child| {
        let (class, name) = (tree.name(owner), tree.name(child));
        let meant = (*meant.entry((class, name)).or_insert_with(|| probable_property_name(name, known)))?;
        find_unknown_name(model, file, owner, child, meant)
    };
    let is_unknown = |child: &ElementId| !known.is_empty() && !known.contains(&tree.name(*child));
    tree.children(owner).filter(is_unknown).filter_map(finding).collect()
}

/// The finding about the element `child` of `owner`, by whose name `meant` is meant; `None` if `owner` has that, too.
pub(super) fn find_unknown_name(
    model: &Model,
    file: FileId,
    owner: ElementId,
    child: ElementId,
    meant: &str,
) -> Option<Finding> {
    let tree = model.file(file).tree();
    // A list can have other members with the right name.
    let is_list = ["objects", "coordinates", "SpatialTransform"].contains(&tree.name(owner));
    (is_list || tree.child(owner, meant).is_none())
        .then(|| finding_about_unknown_name(model, file, owner, child, meant))
}

/// The properties of contacts, and of the sets around them, directly inside of `id`; `None` if `id` is not one of these.
pub(super) fn known_children(document: &Document, id: ElementId) -> Option<&'static [&'static str]> {
    const SET_TAGS: [&str; 2] =
        ["HuntCrossleyForce::ContactParametersSet", "ElasticFoundationForce::ContactParametersSet"];
    let tree = document.tree();
    let classes = [
        Class::SmoothSphereHalfSpaceForce,
        Class::ContactParameters,
        Class::ContactSphere,
        Class::ContactHalfSpace,
    ];
    Some(match tree.name(id) {
        "Model" => &[
            "ForceSet",
            "ContactGeometrySet",
            "BodySet",
            "JointSet",
            "ConstraintSet",
            "ComponentSet",
            "Ground",
            "ground",
            "components",
        ],
        "ForceSet" | "ContactGeometrySet" | "BodySet" | "JointSet" | "ConstraintSet" => &["objects"],
        "groups" => &["ObjectGroup"],
        tag if SET_TAGS.contains(&tag) => &["objects"],
        "objects" if SET_TAGS.contains(&tree.name(tree.parent(id)?)) => &[PARAMETERS_TAG, FOUNDATION_TAG],
        "objects" | "components" => &[],
        "HuntCrossleyForce" | "ElasticFoundationForce" => {
            &["appliesForce", "contact_parameters", SET_TAGS[0], SET_TAGS[1], "transition_velocity"]
        }
        "contact_parameters" => &SET_TAGS,
        FOUNDATION_TAG => Class::ContactParameters.element_order(),
        tag => classes.into_iter().find(|class| class.as_str() == tag)?.element_order(),
    })
}

/// The name among `known` that was probably meant by `name`; `None` if OpenSim knows `name`, or no known name is near.
pub(super) fn probable_property_name(name: &str, known: &[&'static str]) -> Option<&'static str> {
    if known.contains(&name) {
        return None;
    }
    let old = RENAMED_CLASSES.iter().find(|(old, _)| *old == name).map(|(_, new)| *new);
    old.or_else(|| nearest_names(name, known.iter().copied(), 2).first().copied())
}

/// The flag of a contact force that OpenSim ignores although it would switch the force off.
fn ignored_flag(document: &Document, force: ElementId) -> Option<ElementId> {
    let tree = document.tree();
    if !FORCE_CLASSES.contains(&tree.name(force)) {
        return None;
    }
    let disabled = tree.child(force, "isDisabled")?;
    let is_disabled = opensim_text::is_disabled(&tree.text_of(disabled));
    let is_off = document.flag(force, "appliesForce").is_ok_and(|applies| applies == Some(false));
    if document.version() > LAST_VERSION_WITH_IS_DISABLED {
        return (is_disabled && !is_off).then_some(disabled);
    }
    let applies = tree.child(force, "appliesForce").filter(|_| is_disabled != is_off)?;
    let [first, second] = if is_disabled { [applies, disabled] } else { [disabled, applies] };
    (first < second).then_some(second)
}
