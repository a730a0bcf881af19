//! A request to add contacts, checked, and what it reads once for all models.

use std::path::{Path, PathBuf};

use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{ForceKind, Selection};
use osim_patch::reference_of_layout;
use osim_requests::{AddRequest, DesignRequest, Metres, NewRadius, RequestError, RequestFault};
use serde_json::json;

use super::bodies::{failure_of_table, listed};
use super::places::{FeetPlaces, Places, TablePlaces};
use super::reference::{
    FromReference, Numbers, OfReference, Wanted, check_maps, contacts_of, layout, reference, transfer,
};
use super::{Adding, Source};
use crate::contact_table::ContactTable;
use crate::planner::Change;
use crate::verbs::asking::Asking;
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
    let mut remarks = Vec::new();
    let mut is_file = false;
    let (source, masses) = match (places(&request, files)?, request.from.clone()) {
        (None, None) => return Err(no_source().into()),
        (None, Some(from)) => {
            let (own, said);
            (own, is_file, said) = whole_reference(&request, &from, files)?;
            remarks.extend(said);
            let masses = own.transferring.masses.clone();
            (Source::Reference(Box::new(own)), masses)
        }
        (Some(places), Some(from)) => {
            let own;
            (own, is_file) = numbers_of(&request, &from, files)?;
            let masses = own.transferring.masses.clone();
            (Source::Placed(places, Numbers::Reference(Box::new(own))), masses)
        }
        (Some(places), None) => {
            if !places.has_radii() {
                return Err(no_radius().into());
            }
            let masses = request.masses.request();
            (Source::Placed(places, Numbers::Wanted(Box::new(wanted(&request)?))), masses)
        }
    };
    let settings = settings(&request, is_file);
    let reads = request.from.clone().filter(|_| is_file).into_iter().chain(request.contacts.clone());
    let planner = Adding {
        source,
        level: request.level,
        replace: request.replace,
        own: request.choice.selection(),
        body_scale: request.body_scale.clone(),
        answers: request.answers.clone(),
        friction: request.friction,
        remarks,
        reads: reads.collect(),
        settings,
    };
    let asking = Asking { planner, masses, answers: request.answers };
    Ok(Change::new(request.models, request.output, osim_requests::options::SetFiles::default(), asking))
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
            Input::Radius.being("follow"),
            " says nothing here: nothing is scaled where places are given; expected metres",
        ];
        return Err(RequestFault::refused(Input::Radius, message));
    }
    if !request.feet.is_empty() && request.count.is_none() {
        let message =
            phrase![Input::Count.like("N"), " is missing: how many spheres are to be under each foot?"];
        return Err(RequestFault::refused(Input::Count, message));
    }
    if !request.feet.is_empty() && request.pad.is_none() {
        return Err(RequestFault::refused(
            Input::Pad,
            phrase![Input::Pad.like("METRES"), " is missing: ", PADS],
        ));
    }
    if let Some(pad) = request.pad.map(Metres::get).filter(|pad| *pad > LARGEST_PAD) {
        let message = phrase![Input::Pad.being(readable(pad)), ": expected metres, at most 1e9; ", PADS];
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
                Input::Radius.like("METRES"),
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
) -> Result<(FromReference, bool, Vec<Phrase>), RequestError> {
    let (opened, is_file) = reference(from, files)?;
    let transfer = transfer(request, from);
    let referenced = of_opened(&transfer, from, &opened, KnownMass::Asked, files)?;
    let (_, _, Some(generic)) = &referenced else {
        return Err(RequestFault::Missing { field: "from" }.into());
    };
    let generic = generic.clone();
    let model = &opened.model;
    let selected = selection(request).apply(model).map_err(|fault| opened.failure(fault))?;
    check_maps(request, model, &selected)?;
    let (layout, mut anatomy, remarks) =
        layout(request, model, &selected).map_err(|fault| opened.failure(fault))?;
    // Presets have the bodies with spheres and their joint.
    anatomy.is_fragment = !is_file;
    let transferring = crate::verbs::transfer::planner(transfer, referenced, is_file);
    let maps = request.body_map.clone();
    Ok((FromReference { layout, anatomy, transferring, generic, maps }, is_file, remarks))
}

/// The reference's contacts without its places.
fn numbers_of(
    request: &AddRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(OfReference, bool), RequestError> {
    let (opened, is_file) = reference(from, files)?;
    let transfer = transfer(request, from);
    let referenced = of_opened(&transfer, from, &opened, KnownMass::Asked, files)?;
    let layout = selection(request)
        .apply(&opened.model)
        .and_then(|selected| contacts_of(request, &opened.model, &selected))
        .map_err(|fault| opened.failure(fault))?;
    let transferring = crate::verbs::transfer::planner(transfer, referenced, is_file);
    let known = &transferring.reference;
    let (mass, sphere_count) = (known.mass.clone(), known.sphere_count);
    let reference = reference_of_layout(&known.name, &layout, mass, sphere_count, known.gravity_m_s2)
        .map_err(|fault| opened.failure(fault))?;
    Ok((OfReference { layout, reference, transferring }, is_file))
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
            Input::From.like("MODEL|PRESET"),
            ", or what is wanted of them with ",
            Input::Indentation.like("X"),
            " (and ",
            Input::Restitution.like("CR"),
            "), or with ",
            Input::Young.like("E"),
            " and ",
            Input::Poisson.like("NU"),
        ]));
    }
    let Some(class) = request.class else {
        let message = phrase![
            Input::Class.like("smooth|hunt-crossley"),
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

/// The reference is identified by its contents; a preset by its name, which means the same numbers in one version.
fn settings(request: &AddRequest, is_file: bool) -> String {
    let AddRequest { from, radius, body_scale, replace, choice, counts, reference, masses, .. } = request;
    let preset = from.as_ref().filter(|_| !is_file).map(|from| from.to_string_lossy());
    let scales: Vec<String> = body_scale.iter().map(ToString::to_string).collect();
    let maps: Vec<String> = request.body_map.iter().map(ToString::to_string).collect();
    let geometry: Option<&PathBuf> = request.geometry_dir.as_ref();
    let places = json!([
        request.default_pose,
        request.feet,
        request.count,
        request.pad,
        geometry,
        request.mirror,
        request.class,
        request.friction,
        request.level
    ]);
    let numbers = json!([request.numbers, request.load]);
    json!(["add", preset, radius, scales, maps, replace, choice, counts, reference, masses, places, numbers])
        .to_string()
}

/// Only a reference has radii of its own.
fn no_radius() -> RequestFault {
    let message = phrase![
        Input::Radius.like("METRES"),
        " is missing: without a reference, and without a column radius in a table, nothing says how large the spheres are",
    ];
    RequestFault::refused(Input::Radius, message)
}

/// There are three ways to say where contacts are.
fn no_source() -> RequestFault {
    RequestFault::general(phrase![
        "nothing says where the contacts are: ",
        Input::From.like("MODEL|PRESET"),
        " takes those of another model at this one's size, ",
        Input::Contacts.like("TABLE"),
        " those of a table, and ",
        Input::Feet.like("BODY,BODY"),
        " lays spheres under bones",
    ])
}
