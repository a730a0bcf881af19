//! Checks a request to add contacts, and reads its reference or table once for all models.

use std::path::Path;

use osim_inspect::ReferenceState;
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, Verb, phrase, readable};
use osim_model::{ForceKind, Selection};
use osim_patch::reference_of_layout;
use osim_requests::options::InspectionOptions;
use osim_requests::{AddRequest, DesignRequest, Metres, NewRadius, RequestFault, Result};

use super::bodies::{body_names, table_failure};
use super::places::{FeetPlaces, NewSpherePlaces, TablePlaces};
use super::reference::{
    ContactNumbers, DesignedNumbers, FromReference, ReferenceNumbers, layout, open_reference,
    refuse_bad_maps, transfer, wanted_contacts,
};
use super::{AddPlanner, ContactSource};
use crate::contact_table::ContactTable;
use crate::prepared_change::PreparedChange;
use crate::verbs::reference::{MassOfPublished, reference_of_opened};

/// The largest accepted distance between the bones and the sole below them, m.
const LARGEST_PAD: f64 = 1e9;
/// Advice in messages that ask for the distance between bones and sole: how far published spheres reach below the bones.
const PAD_ADVICE: &str = "bones have no skin, so give the distance from their lowest point down to the sole, in metres: 0.033 under a human heel in \
                    the contacts of Falisse et al. (2022), 0 to 0.013 in others";

/// Checks the request and reads the reference or the table once for all models.
///
/// # Errors
/// The places of the contacts or their numbers are not given; the reference is neither a preset with places nor a model with contacts;
/// a table cannot be read; or options have no effect.
pub(in crate::verbs) fn prepare(request: AddRequest, files: &dyn Files) -> Result<PreparedChange> {
    refuse_useless_options(&request)?;
    let (source, reference, is_file, remarks) =
        match (places_of_request(&request, files)?, request.from.as_deref()) {
            (None, None) => return Err(missing_source().into()),
            (None, Some(from)) => {
                let (numbers_or_contacts, reference, is_file, remarks) =
                    whole_reference(&request, from, files)?;
                (ContactSource::Reference(Box::new(numbers_or_contacts)), Some(reference), is_file, remarks)
            }
            (Some(places), Some(from)) => {
                let (numbers_or_contacts, reference, is_file) = reference_numbers(&request, from, files)?;
                let numbers = ContactNumbers::Reference(Box::new(numbers_or_contacts));
                (ContactSource::OwnPlaces(places, numbers), Some(reference), is_file, Vec::new())
            }
            (Some(places), None) => {
                if !places.has_radii() {
                    return Err(missing_radius().into());
                }
                let numbers = ContactNumbers::Designed(Box::new(designed_numbers(&request)?));
                (ContactSource::OwnPlaces(places, numbers), None, false, Vec::new())
            }
        };
    // Designed contacts are inspected under the load of the design.
    let (impact_speed, gravity) = match reference {
        Some(_) => (None, None),
        None => (request.numbers.impact_speed, request.load.gravity),
    };
    let extra_files = request.from.iter().filter(|_| is_file).chain(&request.contacts).cloned().collect();
    let planner = AddPlanner {
        source,
        level: request.level,
        replace: request.replace,
        replaced_forces: request.choice.selection(),
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
    let change = PreparedChange::new(Verb::Add, request.models, request.output, inspection, planner);
    Ok(PreparedChange { reference, extra_files, ..change })
}

/// Refuses options that have no effect in this request.
fn refuse_useless_options(request: &AddRequest) -> Result<(), RequestFault> {
    if request.masses.contacts_mass.is_some() {
        let message = match request.from {
            Some(_) => phrase![
                "{} has no effect here: the reference's mass is {}, this model's {}";
                Input::ContactsMass, Input::ReferenceMass, Input::Mass
            ],
            None => {
                phrase![Input::ContactsMass, " has no effect here: contacts are made for ", Input::Mass]
            }
        };
        return Err(RequestFault::refused(Input::ContactsMass, message));
    }
    if request.has_places() && request.radius == NewRadius::Follow {
        let message = phrase![
            Input::Radius.with_value("follow"),
            " has no effect here: nothing is scaled where places are given; expected metres",
        ];
        return Err(RequestFault::refused(Input::Radius, message));
    }
    let missing = (request.count.is_none(), request.pad.is_none());
    if !request.feet.is_empty() && missing != (false, false) {
        let count = Input::Count.with_placeholder("N");
        let count = phrase![count, " is missing: how many spheres are to be under each foot?"];
        let pad = phrase![Input::Pad.with_placeholder("METRES"), " is missing: ", PAD_ADVICE];
        return Err(match missing {
            (true, true) => RequestFault::refused(Input::Count, phrase![&count, " ", &pad]),
            (true, false) => RequestFault::refused(Input::Count, count),
            _ => RequestFault::refused(Input::Pad, pad),
        });
    }
    if let Some(pad) = request.pad.map(Metres::get).filter(|pad| *pad > LARGEST_PAD) {
        let message =
            phrase![Input::Pad.with_value(readable(pad)), ": expected metres, at most 1e9; ", PAD_ADVICE];
        return Err(RequestFault::refused(Input::Pad, message));
    }
    Ok(())
}

/// The places that the request gives by a table or by bodies of feet; `None` if the places come from the reference.
fn places_of_request(request: &AddRequest, files: &dyn Files) -> Result<Option<NewSpherePlaces>> {
    let radius_m = match request.radius {
        NewRadius::Metres(metres) => Some(metres),
        _ => None,
    };
    if let Some(path) = &request.contacts {
        let bytes = crate::opening::read(path, files)?;
        let table = ContactTable::read(&bytes).map_err(|fault| table_failure(path, &fault))?;
        if table.has_radii && radius_m.is_some() {
            let message = phrase![
                Input::Radius.with_placeholder("METRES"),
                " and the table's column radius give different values: leave one out",
            ];
            return Err(RequestFault::refused(Input::Radius, message).into());
        }
        let (name, at_default_pose) = (path.display().to_string(), request.default_pose);
        let places = TablePlaces { name, table, at_default_pose, radius_m };
        return Ok(Some(NewSpherePlaces::Table(places)));
    }
    let (false, Some(count), Some(pad)) =
        (request.feet.is_empty(), request.count, request.pad.map(Metres::get))
    else {
        return Ok(None);
    };
    Ok(Some(NewSpherePlaces::Feet(FeetPlaces {
        bodies: body_names(&request.feet)?,
        count: usize::from(count.get()),
        pad_m: pad,
        geometry_dir: request.geometry_dir.clone(),
        radius_m,
    })))
}

/// Reads a reference that gives the places and the numbers of the contacts.
fn whole_reference(
    request: &AddRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(FromReference, ReferenceState, bool, Vec<Phrase>)> {
    let (opened, is_file) = open_reference(from, files)?;
    let transfer = transfer(request, from);
    let (reference, state, Some(generic)) =
        reference_of_opened(&transfer, from, &opened, MassOfPublished::AskCaller, files)?
    else {
        return Err(RequestFault::Missing { field: "from" }.into());
    };
    let model = &opened.model;
    let selected = reference_selection(request).apply(model).map_err(|fault| opened.failure(fault))?;
    refuse_bad_maps(request, model, &selected)?;
    let (layout, mut anatomy, remarks) =
        layout(request, model, &selected).map_err(|fault| opened.failure(fault))?;
    // Presets have the bodies with spheres and their joint only.
    anatomy.is_fragment = !is_file;
    let planner = crate::verbs::transfer::planner(transfer, reference, Some(generic.clone()));
    let maps = request.body_map.clone();
    let forces = model.forces().iter().map(|force| {
        let moving = force.spheres().iter().filter_map(|&id| model.sphere(id)).filter(|sphere| !sphere.fixed);
        (force.name.clone(), moving.map(|sphere| sphere.name.clone()).collect::<Vec<_>>())
    });
    // A mirrored sphere has no force in the reference that could be left out.
    let forces = forces.filter(|(_, spheres)| !spheres.is_empty() && request.mirror.is_none()).collect();
    Ok((FromReference { layout, anatomy, planner, generic, maps, forces }, state, is_file, remarks))
}

/// Reads a reference that gives only the numbers of the contacts.
fn reference_numbers(
    request: &AddRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(ReferenceNumbers, ReferenceState, bool)> {
    let (opened, is_file) = open_reference(from, files)?;
    let transfer = transfer(request, from);
    let (reference, state, generic) =
        reference_of_opened(&transfer, from, &opened, MassOfPublished::AskCaller, files)?;
    let layout = reference_selection(request)
        .apply(&opened.model)
        .and_then(|selected| wanted_contacts(request, &opened.model, &selected))
        .map_err(|fault| opened.failure(fault))?;
    let planner = crate::verbs::transfer::planner(transfer, reference, generic);
    let known = &planner.reference;
    let (mass, sphere_count) = (known.mass.clone(), known.sphere_count);
    let reference = reference_of_layout(&known.name, &layout, mass, sphere_count, known.gravity_m_s2)
        .map_err(|fault| opened.failure(fault))?;
    Ok((ReferenceNumbers::new(layout, reference, planner), state, is_file))
}

/// The choice of the reference's forces.
fn reference_selection(request: &AddRequest) -> Selection {
    Selection { select: request.reference.reference_select.clone(), ..Selection::default() }
}

/// The numbers of contacts that are designed without a reference.
fn designed_numbers(request: &AddRequest) -> Result<DesignedNumbers, RequestFault> {
    let numbers = &request.numbers;
    if numbers.indentation.is_none() && numbers.young.is_none() {
        return Err(RequestFault::general(phrase![
            "the stiffness of the contacts is not known: name the model whose numbers they get with {}, or give the \
            behaviour that you want with {} (and {}), or with {} and {}";
            Input::From.with_placeholder("MODEL|PRESET"), Input::Indentation.with_placeholder("X"),
            Input::Restitution.with_placeholder("CR"), Input::Young.with_placeholder("E"),
            Input::Poisson.with_placeholder("NU")
        ]));
    }
    let Some(class) = request.class else {
        let message = phrase![
            Input::Class.with_placeholder("smooth|hunt-crossley"),
            " is missing: without a reference, the class of the forces is not known",
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
    Ok(DesignedNumbers {
        kind: class.kind(),
        friction: friction.iter().filter_map(|&(property, value)| Some((property, value?))).collect(),
        design_planner: crate::verbs::design::planner(design)?,
        remarks: remarks_on_defaults(request, class.kind()),
    })
}

/// Remarks on numbers that are OpenSim's defaults because the request does not give them.
fn remarks_on_defaults(request: &AddRequest, kind: ForceKind) -> Vec<Phrase> {
    let numbers = &request.numbers;
    let class = osim_model::Class::ContactParameters;
    let mut defaulted: Vec<String> = Vec::new();
    if numbers.restitution.is_none() {
        defaulted.push("dissipation 0".to_owned());
    }
    let friction = numbers.friction().into_iter().filter(|(_, value)| value.is_none());
    defaulted.extend(friction.map(|(property, _)| format!("{property} {}", class.default(property))));
    let mut remarks: Vec<Phrase> = Vec::new();
    if !defaulted.is_empty() {
        let slides = numbers.friction().iter().all(|(_, value)| value.is_none());
        let slides = if slides { "; without friction feet slide" } else { "" };
        let text = format!("not given, so OpenSim's defaults are written: {}{slides}", defaulted.join(", "));
        remarks.push(text.into());
    }
    let smoothing = [
        numbers.constant_indentation.is_some(),
        numbers.state_width.is_some(),
        numbers.speed_width.is_some(),
    ];
    if kind == ForceKind::SmoothSphereHalfSpace && smoothing.contains(&false) {
        let text = "smoothing that is not given is that of Falisse et al. (2022), scaled to these radii";
        remarks.push(text.into());
    }
    remarks
}

/// The fault that no radius is given or follows from anything.
fn missing_radius() -> RequestFault {
    let message = phrase![
        Input::Radius.with_placeholder("METRES"),
        " is missing: without a reference, and without a column radius in a table, the radius of the spheres is not known",
    ];
    RequestFault::refused(Input::Radius, message)
}

/// The fault that the request gives no places of contacts.
fn missing_source() -> RequestFault {
    RequestFault::general(phrase![
        "the places of the contacts are not given: {} takes those of another model at this one's size, {} those of a \
        table, and {} lays spheres under bones";
        Input::From.with_placeholder("MODEL|PRESET"), Input::Contacts.with_placeholder("TABLE"),
        Input::Feet.with_placeholder("BODY,BODY")
    ])
}
