//! A request to add contacts, checked, and what it reads once for all models.

use std::path::Path;

use osim_inspect::ReferenceState;
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, Verb, phrase, readable};
use osim_model::{ForceKind, Selection};
use osim_patch::reference_of_layout;
use osim_requests::options::InspectionOptions;
use osim_requests::{AddRequest, DesignRequest, Metres, NewRadius, RequestError, RequestFault};

use super::bodies::{failure_of_table, listed};
use super::places::{FeetPlaces, Places, TablePlaces};
use super::reference::{
    FromReference, Numbers, OfReference, Wanted, check_maps, contacts_of, layout, reference, transfer,
};
use super::{Adding, Source};
use crate::contact_table::ContactTable;
use crate::planner::Change;
use crate::verbs::reference::{KnownMass, of_opened};

/// No sole is farther below the bones, in whatever unit, m.
const LARGEST_PAD: f64 = 1e9;
/// How far published spheres reach below the bones.
const PADS: &str = "bones have no skin, so say how far below their lowest point the sole is, in metres: 0.033 under a human heel in \
                    the contacts of Falisse et al. (2022), 0 to 0.013 in others";

/// Checks the request and reads the reference or the table once, for all models.
///
/// # Errors
/// Nothing says where the contacts are, or their numbers; the reference is neither a preset with places nor a model with
/// contacts; a table that cannot be read; or options that say nothing.
pub(in crate::verbs) fn prepare(request: AddRequest, files: &dyn Files) -> Result<Change, RequestError> {
    check(&request)?;
    let (source, reference, is_file, remarks) = match (places(&request, files)?, request.from.as_deref()) {
        (None, None) => return Err(no_source().into()),
        (None, Some(from)) => {
            let (own, reference, is_file, remarks) = whole_reference(&request, from, files)?;
            (Source::Reference(Box::new(own)), Some(reference), is_file, remarks)
        }
        (Some(places), Some(from)) => {
            let (own, reference, is_file) = numbers_of(&request, from, files)?;
            let numbers = Numbers::Reference(Box::new(own));
            (Source::Placed(places, numbers), Some(reference), is_file, Vec::new())
        }
        (Some(places), None) => {
            if !places.has_radii() {
                return Err(no_radius().into());
            }
            let numbers = Numbers::Wanted(Box::new(wanted(&request)?));
            (Source::Placed(places, numbers), None, false, Vec::new())
        }
    };
    // Contacts that are designed are inspected under the load of the design.
    let (impact_speed, gravity) = match reference {
        Some(_) => (None, None),
        None => (request.numbers.impact_speed, request.load.gravity),
    };
    let reads = request.from.iter().filter(|_| is_file).chain(&request.contacts).cloned().collect();
    let planner = Adding {
        source,
        level: request.level,
        replace: request.replace,
        own: request.choice.selection(),
        body_scale: request.body_scale,
        answers: request.answers.clone(),
        friction: request.friction,
        remarks,
    };
    let inspection = InspectionOptions {
        stance: request.counts.stance_options(impact_speed, gravity),
        masses: request.masses,
        answers: request.answers,
        ..InspectionOptions::default()
    };
    let change = Change::new(Verb::Add, request.models, request.output, inspection, planner);
    Ok(Change { reference, reads, ..change })
}

fn check(request: &AddRequest) -> Result<(), RequestFault> {
    if request.masses.contacts_mass.is_some() {
        let message = match request.from {
            Some(_) => phrase![
                Input::ContactsMass,
                " says nothing here: the reference's mass is ",
                Input::ReferenceMass,
                ", this model's ",
                Input::Mass,
            ],
            None => {
                phrase![Input::ContactsMass, " says nothing here: contacts are made for ", Input::Mass]
            }
        };
        return Err(RequestFault::refused(Input::ContactsMass, message));
    }
    if request.has_places() && request.radius == NewRadius::Follow {
        let message = phrase![
            Input::Radius.with_value("follow"),
            " says nothing here: nothing is scaled where places are given; expected metres",
        ];
        return Err(RequestFault::refused(Input::Radius, message));
    }
    if !request.feet.is_empty() && request.count.is_none() {
        let message = phrase![
            Input::Count.with_placeholder("N"),
            " is missing: how many spheres are to be under each foot?"
        ];
        return Err(RequestFault::refused(Input::Count, message));
    }
    if !request.feet.is_empty() && request.pad.is_none() {
        return Err(RequestFault::refused(
            Input::Pad,
            phrase![Input::Pad.with_placeholder("METRES"), " is missing: ", PADS],
        ));
    }
    if let Some(pad) = request.pad.map(Metres::get).filter(|pad| *pad > LARGEST_PAD) {
        let message = phrase![Input::Pad.with_value(readable(pad)), ": expected metres, at most 1e9; ", PADS];
        return Err(RequestFault::refused(Input::Pad, message));
    }
    Ok(())
}

/// Places that are the models' own, where they are given.
fn places(request: &AddRequest, files: &dyn Files) -> Result<Option<Places>, RequestError> {
    let radius_m = match request.radius {
        NewRadius::Metres(metres) => Some(metres),
        _ => None,
    };
    if let Some(path) = &request.contacts {
        let bytes = crate::opening::read(path, files)?;
        let table = ContactTable::read(&bytes).map_err(|fault| failure_of_table(path, &fault))?;
        if table.has_radii && radius_m.is_some() {
            let message = phrase![
                Input::Radius.with_placeholder("METRES"),
                " and the table's column radius say different things: leave one out",
            ];
            return Err(RequestFault::refused(Input::Radius, message).into());
        }
        let name = path.display().to_string();
        return Ok(Some(Places::Table(TablePlaces { name, table, posed: request.default_pose, radius_m })));
    }
    let (false, Some(count), Some(pad)) =
        (request.feet.is_empty(), request.count, request.pad.map(Metres::get))
    else {
        return Ok(None);
    };
    Ok(Some(Places::Feet(FeetPlaces {
        bodies: listed(&request.feet)?,
        count: usize::from(count.get()),
        pad_m: pad,
        geometry_dir: request.geometry_dir.clone(),
        radius_m,
    })))
}

fn whole_reference(
    request: &AddRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(FromReference, ReferenceState, bool, Vec<Phrase>), RequestError> {
    let (opened, is_file) = reference(from, files)?;
    let transfer = transfer(request, from);
    let (reference, state, Some(generic)) = of_opened(&transfer, from, &opened, KnownMass::Asked, files)?
    else {
        return Err(RequestFault::Missing { field: "from" }.into());
    };
    let model = &opened.model;
    let selected = selection(request).apply(model).map_err(|fault| opened.failure(fault))?;
    check_maps(request, model, &selected)?;
    let (layout, mut anatomy, remarks) =
        layout(request, model, &selected).map_err(|fault| opened.failure(fault))?;
    // Presets have the bodies with spheres and their joint.
    anatomy.is_fragment = !is_file;
    let transferring = crate::verbs::transfer::planner(transfer, reference, Some(generic.clone()));
    let maps = request.body_map.clone();
    Ok((FromReference { layout, anatomy, transferring, generic, maps }, state, is_file, remarks))
}

/// The reference's contacts without its places.
fn numbers_of(
    request: &AddRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(OfReference, ReferenceState, bool), RequestError> {
    let (opened, is_file) = reference(from, files)?;
    let transfer = transfer(request, from);
    let (reference, state, generic) = of_opened(&transfer, from, &opened, KnownMass::Asked, files)?;
    let layout = selection(request)
        .apply(&opened.model)
        .and_then(|selected| contacts_of(request, &opened.model, &selected))
        .map_err(|fault| opened.failure(fault))?;
    let transferring = crate::verbs::transfer::planner(transfer, reference, generic);
    let known = &transferring.reference;
    let (mass, sphere_count) = (known.mass.clone(), known.sphere_count);
    let reference = reference_of_layout(&known.name, &layout, mass, sphere_count, known.gravity_m_s2)
        .map_err(|fault| opened.failure(fault))?;
    Ok((OfReference { layout, reference, transferring }, state, is_file))
}

fn selection(request: &AddRequest) -> Selection {
    Selection { select: request.reference.reference_select.clone(), ..Selection::default() }
}

/// What is wanted of contacts without a reference.
fn wanted(request: &AddRequest) -> Result<Wanted, RequestFault> {
    let numbers = &request.numbers;
    if numbers.indentation.is_none() && numbers.young.is_none() {
        return Err(RequestFault::general(phrase![
            "nothing says how stiff the contacts are: say whose numbers they get with ",
            Input::From.with_placeholder("MODEL|PRESET"),
            ", or what is wanted of them with ",
            Input::Indentation.with_placeholder("X"),
            " (and ",
            Input::Restitution.with_placeholder("CR"),
            "), or with ",
            Input::Young.with_placeholder("E"),
            " and ",
            Input::Poisson.with_placeholder("NU"),
        ]));
    }
    let Some(class) = request.class else {
        let message = phrase![
            Input::Class.with_placeholder("smooth|hunt-crossley"),
            " is missing: only a reference would say which class the forces have",
        ];
        return Err(RequestFault::refused(Input::Class, message));
    };
    let friction = numbers.friction();
    let design = DesignRequest {
        wanted: numbers.wanted(),
        load: request.load.clone(),
        masses: request.masses.clone(),
        counts: request.counts.clone(),
        ..DesignRequest::default()
    };
    Ok(Wanted {
        kind: class.kind(),
        friction: friction.iter().filter_map(|&(property, value)| Some((property, value?))).collect(),
        designing: crate::verbs::design::planner(design)?,
        remarks: of_defaults(request, class.kind()),
    })
}

/// What comes from OpenSim's defaults, because nothing else gives it.
fn of_defaults(request: &AddRequest, kind: ForceKind) -> Vec<Phrase> {
    let numbers = &request.numbers;
    let class = osim_model::Class::ContactParameters;
    let mut silent: Vec<String> = Vec::new();
    if numbers.restitution.is_none() {
        silent.push("dissipation 0".to_owned());
    }
    let friction = numbers.friction().into_iter().filter(|(_, value)| value.is_none());
    silent.extend(friction.map(|(property, _)| format!("{property} {}", class.default(property))));
    let mut remarks: Vec<Phrase> = Vec::new();
    if !silent.is_empty() {
        let slides = numbers.friction().iter().all(|(_, value)| value.is_none());
        let slides = if slides { "; without friction feet slide" } else { "" };
        let text = format!("not given, so OpenSim's defaults are written: {}{slides}", silent.join(", "));
        remarks.push(text.into());
    }
    let smoothing = [
        numbers.constant_indentation.is_some(),
        numbers.state_width.is_some(),
        numbers.speed_width.is_some(),
    ];
    if kind == ForceKind::SmoothSphereHalfSpace && smoothing.contains(&false) {
        let text = "smoothing that is not given is that of Falisse et al. (2022), without dimensions, at these radii";
        remarks.push(text.into());
    }
    remarks
}

/// Only a reference has radii of its own.
fn no_radius() -> RequestFault {
    let message = phrase![
        Input::Radius.with_placeholder("METRES"),
        " is missing: without a reference, and without a column radius in a table, nothing says how large the spheres are",
    ];
    RequestFault::refused(Input::Radius, message)
}

/// There are three ways to say where contacts are.
fn no_source() -> RequestFault {
    RequestFault::general(phrase![
        "nothing says where the contacts are: ",
        Input::From.with_placeholder("MODEL|PRESET"),
        " takes those of another model at this one's size, ",
        Input::Contacts.with_placeholder("TABLE"),
        " those of a table, and ",
        Input::Feet.with_placeholder("BODY,BODY"),
        " lays spheres under bones",
    ])
}
