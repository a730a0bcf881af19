//! Rules about the components of a model: their files, classes, names, connections and joints.

use std::cell::LazyCell;
use std::collections::BTreeMap;

use foldhash::{HashSet, HashSetExt};
use osim_model::messages::{listed, shown};
use osim_model::opensim_text::list_words;
use osim_model::{
    Class, Component, ComponentId, ElementId, Example, FileId, Finding, Irregularity, Model, ModelJoint,
    NoteDoubt, OTHER_CONTACT_CLASSES, Repair, refuse_name_in_paths,
};
use osim_requests::{ConvertRequest, Request};

use crate::findings::Remedies;
use crate::rules::refused_or_ignored::path_of_component;
use crate::rules::spheres::other_cases_in_words;
use osim_model::rule;

rule! { pub(super) CONNECTEE_BY_NAME: ConnecteeByName, Error;
    what: "A path leads nowhere, and only one component has its last name.",
    why: "OpenSim looks for paths only, so it refuses the model.",
    advice: "Write the path that the message says",
    repair: Repair::Command("writes the paths of sockets that OpenSim finds, and changes no other byte"),
    example: Example::ElementText { tag: "socket_frame", good: "/bodyset/calcn_r", bad: "calcn_r" },
}

/// The request that writes the paths of sockets, if a socket in question can be written.
pub(super) fn connect_sockets(remedies: &Remedies<'_>, model: &Model) -> Option<Request> {
    let can_be_written =
        |one: &Irregularity| matches!(one, Irregularity::TakenByName { socket: Some(_), .. });
    let models = vec![remedies.file.clone()?];
    let request = ConvertRequest { models, sockets: true, ..ConvertRequest::default() };
    model.irregularities.iter().any(can_be_written).then(|| request.into())
}

rule! { pub(super) SOCKET_NOWHERE: SocketNowhere, Error;
    what: "The socket of an object leads to no component.",
    why: "OpenSim refuses the model: it looks for the component at the path, and no component has the path or its last name.",
    advice: "Write the path of the frame or body that is meant",
    repair: Repair::NotPossible("only you know what is to be connected"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/socket_of_joint.osim" },
}

rule! { pub(super) MISNAMED_PARAMETER_SET: MisnamedParameterSet, Error;
    what: "A ContactParametersSet has a name under which OpenSim does not find it.",
    why: "OpenSim finds the set by its name: with another name the force has no parameters and never pushes.",
    advice: "Name the set contact_parameters",
    repair: Repair::NotPossible("the program changes numbers, not names"),
    example: Example::Piece { model: "format/v40000.osim",
        good: r#"<HuntCrossleyForce::ContactParametersSet name="contact_parameters">"#,
        bad: r#"<HuntCrossleyForce::ContactParametersSet name="parameters">"# },
}

/// Finds connections that were resolved by name or lead nowhere, and parameter sets that OpenSim does not find, in the order in which the
/// file was read. There is one finding for all objects of a class whose connections were resolved by name.
pub(super) fn find_irregularities(model: &Model) -> Vec<Finding> {
    let mut found: Vec<Finding> = Vec::new();
    let mut by_class: BTreeMap<&str, usize> = BTreeMap::new();
    for irregularity in &model.irregularities {
        match irregularity {
            Irregularity::TakenByName { owner, class, text, taken, position, .. } => {
                let text =
                    format!("'{text}' of {owner} leads nowhere; took {taken}, the only one of that name");
                let index = *by_class.entry(class).or_insert_with(|| {
                    found.push(Finding::at(&CONNECTEE_BY_NAME, *position, text.clone()).with_place(owner));
                    found.len() - 1
                });
                if let Some(finding) = found.get_mut(index) {
                    finding.details.push(text);
                    finding.places.push(owner.clone());
                }
            }
            Irregularity::LeadsNowhere { owner, socket, text, position } => {
                let text = match text.as_str() {
                    "" => format!(
                        "{socket} of {owner} is empty or missing, expected the path of a body or frame"
                    ),
                    text => {
                        let what = if socket == "geometry" { "contact geometry" } else { "frame" };
                        format!("{socket} of {owner} is '{text}', which is the path of no {what}")
                    }
                };
                found.push(Finding::at(&SOCKET_NOWHERE, *position, text).with_place(owner));
            }
            Irregularity::MisnamedSet { force, name, position } => {
                let text = format!(
                    "{force}: the parameter set is called '{name}', so OpenSim reads no parameters at all; call it contact_parameters"
                );
                found.push(Finding::at(&MISNAMED_PARAMETER_SET, *position, text).with_place(force));
            }
        }
    }
    for index in by_class.into_values() {
        let Some(finding) = found.get_mut(index) else { continue };
        match finding.details.len() {
            1 => {
                finding.details.clear();
                finding.places.clear();
            }
            count => finding.message.push(other_cases_in_words(
                count,
                "another of this class, too",
                "others of this class, too",
            )),
        }
    }
    found
}

/// Finds names and paths of coordinates, in constraints, forces and path points, that no coordinate has: OpenSim refuses the model.
pub(super) fn find_lost_coordinates(model: &Model) -> Vec<Finding> {
    const TAGS: [&str; 3] = ["coordinate", "dependent_coordinate_name", "independent_coordinate_names"];
    const OWNERS: [&str; 3] = ["Actuator", "Force", "CouplerConstraint"];
    const NEED_COORDINATE: [&str; 2] = ["CoordinateActuator", "CoordinateLimitForce"];
    let (components, document) = (model.components(), model.document());
    let is_of_joint = |one: &Irregularity| matches!(one, Irregularity::LeadsNowhere { .. });
    // The coordinates of a set are in another file, and a joint that hangs nowhere has none here.
    if !document.is_model() || model.irregularities.iter().any(is_of_joint) {
        return Vec::new();
    }
    let read = model.joints().iter().flat_map(|joint| &joint.coordinates).map(|one| one.name.as_str().into());
    let (mut known, mut owners): (HashSet<_>, _) = (read.collect(), Vec::new());
    for (id, _) in components.tree.iter() {
        match components.tag(id) {
            "Coordinate" => drop(known.insert(components.name(id))),
            tag if OWNERS.iter().any(|class| tag.ends_with(class)) => owners.push(id),
            _ => {}
        }
    }
    let lost = owners.into_iter().flat_map(|id| {
        let document = components.document_of(id);
        let (tree, element) = (document.tree(), components.element(id));
        let wrong = |child: ElementId| {
            let (text, tag) = (tree.text_of(child), tree.name(child));
            // A coupler may follow no coordinate; the other elements need a name.
            let is_empty = tag != "independent_coordinate_names" && list_words(&text).next().is_none();
            let name = list_words(&text).chain(is_empty.then_some("")).find(|name| !known.contains(*name))?;
            Some((child, tag, format!("is '{}', which is the name of no coordinate", shown(name))))
        };
        let named = tree.children(element).filter(|&child| TAGS.contains(&tree.name(child)));
        let named: Vec<_> = named.collect();
        let is_missing = named.is_empty()
            && NEED_COORDINATE.iter().any(|class| components.tag(id).ends_with(class))
            && document.inherited_element(element, TAGS[0]).is_none();
        let missing = is_missing.then(|| (element, TAGS[0], "is missing".to_owned()));
        let finding = |(at, tag, words): (ElementId, &str, String)| {
            let path = components.tree.path(id);
            let text = format!("{tag} of {path} {words}");
            Finding::at(&SOCKET_NOWHERE, document.position_of(at), text).with_place(&path)
        };
        named.into_iter().filter_map(wrong).chain(missing).map(finding).collect::<Vec<_>>()
    });
    let of_axes = model.joints().iter().filter_map(|joint| find_lost_coordinate_of_axis(model, joint));
    lost.chain(of_axes).chain(find_lost_sockets_of_coordinates(model)).collect()
}

/// Finds an axis that names a coordinate that its joint does not have. OpenSim adds such coordinates at the end of the joint's list, and
/// refuses the joint if the order of the list is then not that of the axes.
fn find_lost_coordinate_of_axis(model: &Model, joint: &ModelJoint) -> Option<Finding> {
    let document = model.file(joint.file);
    let tree = document.tree();
    let transform = tree.child(joint.element, "SpatialTransform")?;
    let lists = tree.children(transform).filter_map(|axis| tree.child(axis, "coordinates"));
    let lists: Vec<_> = lists.map(|list| (list, tree.text_of(list))).collect();
    let names = || lists.iter().flat_map(|(list, text)| list_words(text).map(move |name| (*list, name)));
    let has = |name: &str| joint.coordinates.iter().any(|one| one.name == name);
    let (list, lost) = names().find(|(_, name)| !has(name))?;
    let is_before = |name: &str| names().take_while(|(_, one)| has(one)).any(|(_, one)| one == name);
    if joint.coordinates.iter().all(|one| is_before(&one.name)) {
        return None;
    }
    let (path, lost) = (path_of_component(model, joint.file, list), shown(lost));
    let text = format!("an axis of {path} names the coordinate '{lost}', which the joint does not have");
    Some(Finding::at(&SOCKET_NOWHERE, document.position_of(list), text).with_place(&path))
}

/// One finding for all sockets of coordinates that lead to none.
fn find_lost_sockets_of_coordinates(model: &Model) -> Option<Finding> {
    let (components, document) = (model.components(), model.document());
    let paths = model.joints().iter().flat_map(|joint| {
        let path = components.at(joint.file, joint.element).map(|id| components.tree.path(id));
        joint.coordinates.iter().filter_map(move |one| Some(format!("{}/{}", path.as_deref()?, one.name)))
    });
    // Few models have such a socket.
    let known = LazyCell::new(|| paths.collect::<HashSet<String>>());
    let tree = document.tree();
    let sockets = document.sockets().iter().filter(|id| tree.name(**id).ends_with("coordinate"));
    let is_lost = |text: &str| (!text.contains('/') || text.starts_with('/')) && !known.contains(text);
    let with_text = sockets.map(|&id| (id, tree.text_of(id)));
    let lost: Vec<_> = with_text.filter(|(_, text)| is_lost(text)).collect();
    let (first, text) = lost.first()?;
    let path = path_of_component(model, FileId::MAIN, *first);
    let others = other_cases_in_words(lost.len(), "another socket, too", "other sockets, too");
    let what = format!("{} of {path} is '{}'", tree.name(*first), shown(text));
    let text = format!("{what}, which is the path of no coordinate{others}");
    Some(Finding::at(&SOCKET_NOWHERE, document.position_of(*first), text).with_place(&path))
}

rule! { pub(super) MIXED_PAIR: MixedPair, Error;
    what: "The force set and its geometry set are from different runs.",
    why: "The notes in the force set and in the geometry set are from different runs, so their stiffnesses and radii do not fit together.",
    advice: "Write both files again in one run",
    repair: Repair::NotPossible("only you know which of the two files is the right one"),
    example: Example::InWords { good: "force set and geometry set as one run wrote them",
        bad: "the geometry set of another run, with a note of its own" },
}

/// Finds a force set and a geometry set whose notes were not written together.
pub(super) fn find_mixed_pair(model: &Model) -> Vec<Finding> {
    let doubt = model.doubt_about_note().filter(|doubt| *doubt == NoteDoubt::MixedPair);
    doubt.map(|doubt| Finding::new(&MIXED_PAIR, doubt.as_str())).into_iter().collect()
}

rule! { pub(super) CONTACT_DEFAULTS: ContactDefaults, Warning;
    what: "The defaults of the document hold contact objects.",
    why: "OpenSim keeps the defaults of one model for every model loaded later in the same session, so another model can silently take these values.",
    advice: "Write the values into the forces themselves, or load the model in a fresh OpenSim",
    repair: Repair::NotPossible("<defaults> are left alone, because other models may depend on them"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/defaults_smooth.osim" },
}

/// Finds contact objects in `<defaults>`, which OpenSim keeps for models that it loads later.
pub(super) fn find_contact_defaults(model: &Model) -> Vec<Finding> {
    let document = model.document();
    let tree = document.tree();
    let classes = [
        Class::SmoothSphereHalfSpaceForce,
        Class::HuntCrossleyForce,
        Class::ContactParameters,
        Class::ContactSphere,
    ];
    let finding = |class: Class| {
        let default = tree.child(document.defaults()?, class.as_str())?;
        // OpenSim itself writes defaults without content; those carry nothing.
        tree.children(default).next()?;
        let text = format!("<defaults> holds a {}: OpenSim keeps it for models loaded later", class.as_str());
        Some(Finding::at(&CONTACT_DEFAULTS, document.position_of(default), text))
    };
    classes.into_iter().filter_map(finding).collect()
}

rule! { pub(super) INCLUDED_FILE: IncludedFile, Remark;
    what: "Contacts are in a file that the model includes.",
    why: "The contacts were read from the file that the model names; a change would have to go into that file too.",
    advice: "Save the model in OpenSim as one file before rescaling it",
    repair: Repair::NotPossible("the file may serve other models, too"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/file_forceset.osim" },
}

/// Finds contacts in included files, which can be read but not changed.
pub(super) fn find_included_file(model: &Model) -> Vec<Finding> {
    let forces = model.forces().iter().map(|force| (force.file, &force.path));
    let spheres = model.spheres().iter().map(|sphere| (sphere.file, &sphere.path));
    let mut reported: HashSet<FileId> = HashSet::new();
    let finding = |(file, path): (FileId, &String)| {
        let name = model.included_file(file).filter(|_| reported.insert(file))?;
        let text = format!("{path} and others are in the file '{name}' that the model includes");
        Some(Finding::new(&INCLUDED_FILE, text))
    };
    forces.chain(spheres).filter_map(finding).collect()
}

rule! { pub(super) UNKNOWN_CLASS: UnknownClass, Error;
    what: "Contacts are in a component of a class that OpenSim does not know.",
    why: "OpenSim skips a component of a class it does not know, with everything in it, so these contacts do not exist for it. They were not changed. A plugin may know the class.",
    advice: "Move the contacts into the ForceSet, or out of the component of that class",
    repair: Repair::NotPossible("only numbers are changed, and the contacts have to move"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/components_unknown_class.osim" },
}

/// Finds contacts in components whose classes OpenSim does not know.
pub(super) fn find_unknown_class(model: &Model) -> Vec<Finding> {
    let components = model.components();
    let finding = |&(file, element): &(FileId, ElementId)| {
        let document = components.document(file);
        let tree = document.tree();
        let written = tree.slice(tree.span(element));
        let mut tags = ["<HuntCrossleyForce ", "<SmoothSphereHalfSpaceForce "].into_iter();
        tags.find(|tag| written.contains(tag))?;
        let class = tree.name(element);
        let text = format!("contacts inside a <{class}> are not changed: OpenSim does not know that class");
        Some(Finding::at(&UNKNOWN_CLASS, document.position_of(element), text))
    };
    components.tree.skipped.iter().filter_map(finding).collect()
}

/// Applies the rules about single components, in the order of the component tree.
pub(super) fn apply_component_rules(model: &Model) -> Vec<Finding> {
    let carriers = model.carriers_of_other_classes();
    let found = model.components().tree.iter().flat_map(|(id, object)| {
        [
            find_not_hertz(model, id, &carriers),
            find_duplicate_name(model, id, object),
            find_refused_name(model, id, object),
        ]
    });
    found.flatten().collect()
}

rule! { pub(super) NOT_HERTZ: NotHertz, Remark;
    what: "Contacts of a class that does not follow the Hertz law.",
    why: "ElasticFoundationForce, ExponentialContactForce and MeyerFregly2016Force do not follow the equations used here, so they are not changed. On feet they carry the body, so `add` adds nothing beside them.",
    advice: "Scale them by their own equations, or replace them",
    repair: Repair::NotPossible("such a force has other equations"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/elastic_foundation.osim" },
}

/// A remark on each force of another class; one for all that carry the body.
fn find_not_hertz(model: &Model, id: ComponentId, carriers: &[ComponentId]) -> Option<Finding> {
    let components = model.components();
    let tag = components.tag(id);
    // Carriers are in the order of the tree.
    let is_later = carriers.binary_search(&id).is_ok_and(|at| at > 0);
    if !OTHER_CONTACT_CLASSES.contains(&tag) || is_later {
        return None;
    }
    let path = components.tree.path(id);
    let text = match carriers.first() == Some(&id) {
        true => model.describe_other_carriers()?,
        false => format!("{path} is of the class {tag}: it is not changed"),
    };
    Some(Finding::at(&NOT_HERTZ, components.position_of(id), text).with_place(&path))
}

rule! { pub(super) DUPLICATE_NAMES: DuplicateNames, Warning;
    what: "Two components have the same name.",
    why: "OpenSim renames the second one when it loads the model, so a path or a name means the first one only.",
    advice: "Give each a name of its own",
    repair: Repair::NotPossible("the program changes numbers, not names"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/same_sphere_name_twice.osim" },
}

/// Finds a body or a contact whose name another object beside it has, too.
fn find_duplicate_name(model: &Model, id: ComponentId, object: &Component) -> Option<Finding> {
    let components = model.components();
    let tag = components.tag(id);
    let is_relevant =
        ["Contact", "HuntCrossleyForce", "SmoothSphere", "Body"].iter().any(|class| tag.starts_with(class));
    if !is_relevant || tag == Class::ContactParameters.as_str() || object.unnumbered_name.is_none() {
        return None;
    }
    // OpenSim names an object without a name after its class.
    let is_named = tag.ends_with("Set") || !components.name(id).is_empty();
    is_named.then(|| {
        let path = components.tree.path(id);
        let text = format!("OpenSim calls this {tag} {path}, because its name appears twice");
        Finding::at(&DUPLICATE_NAMES, components.position_of(id), text).with_place(&path)
    })
}

rule! { pub(super) REFUSED_NAME: RefusedName, Error;
    what: "An object has a name with which OpenSim refuses the model.",
    why: "OpenSim finds objects by paths, in which a name must be one step: it has no blank and none of / * + and the backslash in it, and is neither . nor ..",
    advice: "Give the object another name, and replace the old name everywhere in the file",
    repair: Repair::NotPossible("the program changes numbers, not names"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/name_with_blank.osim" },
}

/// Finds a name that OpenSim refuses in paths.
fn find_refused_name(model: &Model, id: ComponentId, object: &Component) -> Option<Finding> {
    object.parent?;
    let components = model.components();
    let name_in_paths = object.unnumbered_name.as_ref().unwrap_or(&object.segment);
    // Joints of old documents refer to bodies by the names in the file.
    let written = (components.tag(id) == "Body").then(|| components.name(id)).filter(|name| !name.is_empty());
    let why = refuse_name_in_paths(written.as_deref().unwrap_or(name_in_paths)).err()?;
    let path = components.tree.path(id);
    Some(Finding::at(&REFUSED_NAME, components.position_of(id), why.to_string()).with_place(&path))
}

rule! { pub(super) LOOP_OF_JOINTS: LoopOfJoints, Warning;
    what: "A body has more than one joint: joints form a loop, or OpenSim ignores some.",
    why: "In documents up to version 3 joints are written inside bodies: OpenSim takes the first joint of a body and ignores the others. In later documents it cuts a loop of joints: it divides a body into equal parts that a constraint holds together, and the parts together have the mass of the body. If a WeldJoint or a FreeJoint between two bodies is in the loop, OpenSim divides nothing, and counts the mass of a body twice. Left, right and limbs follow the first joint of each body.",
    advice: "Give the mass of the model with `mass=KG` where the program asks for it; in OpenSim, close a loop with a constraint instead of a joint",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/loop_of_joints.osim" },
}

/// The largest number of joints that a message about a loop names.
const MOST_JOINTS_NAMED: usize = 6;

/// Finds joints that close a loop, which OpenSim has to break.
pub(super) fn find_loop_of_joints(model: &Model) -> Vec<Finding> {
    let (components, skeleton) = (model.components(), model.skeleton());
    let finding = |joint, text| Finding::at(&LOOP_OF_JOINTS, components.position_of(joint), text);
    let ignored = skeleton.ignored_joints.iter().map(|&joint| {
        let text =
            format!("{} is not the first joint of its body: OpenSim ignores it", components.tree.path(joint));
        finding(joint, text)
    });
    let loops = &skeleton.loops;
    let cut = loops.joints.first().map(|&first| {
        let joints: Vec<_> = loops.joints.iter().map(|&joint| components.name(joint).into_owned()).collect();
        let names = listed(&joints, MOST_JOINTS_NAMED);
        let what = if loops.mass_is_in_doubt {
            "counts the mass of one of their bodies twice"
        } else {
            "divides one of their bodies into parts, which together have the mass of the body"
        };
        finding(first, format!("joints form a loop ({names}): OpenSim {what}"))
    });
    ignored.chain(cut).collect()
}
