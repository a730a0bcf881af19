//! Lets a body fall on its contacts.

use std::path::Path;

use contact_scaling::drop_test::{DropError, DropTest, DropValues, compare};
use contact_scaling::{Contact, ContactValues, Law, Preset, Spheres};
use osim_inspect::series::standing_spheres;
use osim_inspect::{LoadSharing, MassMismatch, Stance, unexplained_slip, weight_share};
use osim_model::files::{Failure, FileName, Files, OpenModel};
use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{CountOf, Fault, GravityFor, MassRequest, Model, Needed};
use osim_requests::{Count, DropTestRequest, Kilograms, NotNegative, Positive, RequestError, RequestFault};

use super::register::DropColumn;
use super::result::{ComparedDrop, DropResult};
use crate::gravity::STANDARD_GRAVITY_M_S2;
use crate::subject::Subject;

/// A body about to fall.
struct Falling {
    name: FileName,
    test: DropTest,
    sphere_count: f64,
    mismatch: Option<MassMismatch>,
}

/// What the request says about one of the two bodies; what is about the first does not count for the other.
struct Own {
    mass_kg: Option<f64>,
    spheres: Option<f64>,
    stance_limbs: Option<f64>,
    gravity_m_s2: Option<f64>,
    count_of: CountOf,
}

impl Own {
    /// Limbs that share the weight of `model`.
    fn limbs_of(&self, model: &Model) -> f64 {
        Stance { limbs: self.stance_limbs, ..Stance::default() }.limbs_of(model)
    }
}

/// Lets the body fall.
///
/// # Errors
/// Numbers that are missing or contradict a model, a model that cannot be read, or a drop that cannot be followed.
pub fn run_drop_test(request: &DropTestRequest, files: &dyn Files) -> Result<DropResult, RequestError> {
    let falling = subject(request, files)?;
    let other = match &request.compare {
        Some(path) => Some(named(request, path, &about_other(request), files)?),
        None => None,
    };
    let failed = |error: DropError| Failure::outside(&falling.name, "drop-test", error.to_string());
    let report = falling.test.run().map_err(failed)?;
    let is_finite = |sample| DropColumn::ALL.iter().all(|column| column.value(&report, sample).is_finite());
    if !report.series.iter().all(is_finite) {
        let why = "the series of this drop is not finite, expected a shorter duration, or masses, radii and gravity of a real body";
        return Err(Failure::outside(&falling.name, "drop-test", why).into());
    }
    let compared = match &other {
        Some(other) => {
            let difference = compare(&falling.test, &other.test).map_err(failed)?;
            Some(ComparedDrop { name: other.name.clone(), difference })
        }
        None => None,
    };
    let values = falling.test.values();
    let both = [Some(&falling), other.as_ref()].into_iter().flatten();
    let mismatches = both.filter_map(|one| Some((one.name.to_string(), one.mismatch.clone()?))).collect();
    let (name, sphere_count) = (falling.name.clone(), falling.sphere_count);
    Ok(DropResult { name, values, sphere_count, report, compared, mismatches })
}

fn about_subject(request: &DropTestRequest) -> Own {
    Own {
        mass_kg: request.masses.mass.map(Kilograms::get),
        spheres: request.counts.spheres(),
        stance_limbs: request.counts.stance_limbs.map(Count::get),
        gravity_m_s2: request.numbers.gravity(),
        count_of: CountOf::Model,
    }
}

fn about_other(request: &DropTestRequest) -> Own {
    Own {
        mass_kg: None,
        spheres: request.compare_spheres.map(Count::get),
        stance_limbs: None,
        gravity_m_s2: None,
        count_of: CountOf::Compared,
    }
}

/// The model, preset or numbers to drop.
fn subject(request: &DropTestRequest, files: &dyn Files) -> Result<Falling, RequestError> {
    let Some(path) = &request.subject else { return Ok(of_numbers(request)?) };
    let given = request.numbers.given();
    if !given.is_empty() {
        let mut message = phrase!["a model or preset has its own numbers: leave out "];
        push_listed(&mut message, &given);
        return Err(RequestFault::general(message).into());
    }
    named(request, path, &about_subject(request), files)
}

fn named(
    request: &DropTestRequest,
    path: &Path,
    own: &Own,
    files: &dyn Files,
) -> Result<Falling, RequestError> {
    match Subject::find(path, request.presets.as_deref(), &request.set_files, files)? {
        Subject::Preset(preset) => Ok(of_preset(request, &preset, own)?),
        Subject::Model(open) => Ok(of_model(request, &open, own).map_err(|fault| open.failure(fault))?),
    }
}

fn of_model(request: &DropTestRequest, open: &OpenModel, own: &Own) -> Result<Falling, Fault> {
    let model = &open.model;
    let masses = MassRequest { model_kg: own.mass_kg, ..request.masses.request() };
    let slip = unexplained_slip(&masses, model, &request.choice.selection());
    request.answers.ask(slip).map_err(Fault::new)?;
    let selected = request.choice.selection().apply(model)?;
    let mass = masses.of_model(model)?;
    let sharing = LoadSharing::of(model, &selected.forces);
    let count = sharing.count(own.spheres, own.limbs_of(model), own.count_of)?;
    let spheres = standing_spheres(model, &selected.forces, count)?;
    let gravity = own.gravity_m_s2.or(model.gravity().filter(|&gravity| gravity > 0.0));
    let Some(gravity) = gravity else {
        // `gravity` is about the first body alone.
        let purpose = match own.count_of {
            CountOf::Compared => GravityFor::Compared,
            _ => GravityFor::Weight,
        };
        return Err(Fault::new(Needed::Gravity { purpose }));
    };
    // It falls along the normal of its floor.
    let along_normal = gravity * weight_share(model, sharing.forces());
    let weight = Weight { mass_kg: mass.kg, gravity_m_s2: along_normal, sphere_count: count };
    let falling =
        falling(request, open.name(), spheres, &weight).map_err(|error| Fault::refused(error.to_string()))?;
    let mismatch = MassMismatch::find(model, &masses);
    Ok(Falling { mismatch, ..falling })
}

fn of_preset(request: &DropTestRequest, preset: &Preset, own: &Own) -> Result<Falling, RequestFault> {
    let scale = &preset.scale;
    let on_limbs = scale.sphere_count() * own.stance_limbs.unwrap_or(1.0);
    let count = own.spheres.unwrap_or(on_limbs);
    let weight = Weight {
        mass_kg: own.mass_kg.unwrap_or(scale.mass_kg()),
        gravity_m_s2: own.gravity_m_s2.unwrap_or(scale.gravity_m_s2()),
        sphere_count: count,
    };
    let spheres = Law::of(&preset.contact, scale.radius_m()).and_then(|law| Spheres::new(law, count));
    let spheres = vec![spheres.map_err(refused)?];
    falling(request, &*preset.name, spheres, &weight).map_err(refused)
}

fn of_numbers(request: &DropTestRequest) -> Result<Falling, RequestFault> {
    let numbers = &request.numbers;
    let needed = [
        (Input::Mass, request.masses.mass.map(Kilograms::get)),
        (Input::Spheres, request.counts.spheres()),
        (Input::Radius, numbers.radius.map(Positive::get)),
        (Input::Stiffness, numbers.stiffness.map(Positive::get)),
        (Input::Dissipation, numbers.dissipation.map(NotNegative::get)),
    ];
    let missing: Vec<Input> =
        needed.iter().filter(|(_, value)| value.is_none()).map(|(input, _)| *input).collect();
    let [Some(mass), Some(count), Some(radius), Some(plane_strain_modulus), Some(dissipation)] =
        needed.map(|(_, value)| value)
    else {
        let mut message =
            phrase!["nothing to drop: name a model or a preset, or give the numbers; missing: "];
        push_listed(&mut message, &missing);
        return Err(RequestFault::general(message));
    };
    let values = ContactValues { plane_strain_modulus, dissipation, smoothing: numbers.smoothing()? };
    let law = Contact::new(values).and_then(|contact| Law::of(&contact, radius));
    let spheres = vec![law.and_then(|law| Spheres::new(law, count)).map_err(refused)?];
    let gravity_m_s2 = numbers.gravity().unwrap_or(STANDARD_GRAVITY_M_S2);
    let weight = Weight { mass_kg: mass, gravity_m_s2, sphere_count: count };
    falling(request, "the numbers given", spheres, &weight).map_err(refused)
}

/// What falls: a mass, under a gravity, on so many spheres.
struct Weight {
    mass_kg: f64,
    gravity_m_s2: f64,
    sphere_count: f64,
}

/// A body of this weight.
fn falling(
    request: &DropTestRequest,
    name: impl Into<FileName>,
    spheres: Vec<Spheres>,
    weight: &Weight,
) -> Result<Falling, DropError> {
    let values = DropValues {
        mass_kg: weight.mass_kg,
        gravity_m_s2: weight.gravity_m_s2,
        height_m: 0.0,
        duration_s: request.duration.get(),
        samples: request.samples.get() as usize,
    };
    let on_ground = DropTest::new(spheres, values)?;
    let height_m = request.height.get().metres(on_ground.reference_radius_m());
    let test = DropTest::new(on_ground.spheres().to_vec(), DropValues { height_m, ..values })?;
    Ok(Falling { name: name.into(), test, sphere_count: weight.sphere_count, mismatch: None })
}

fn refused(error: impl std::fmt::Display) -> RequestFault {
    RequestFault::general(error.to_string())
}

fn push_listed(message: &mut Phrase, inputs: &[Input]) {
    for (index, input) in inputs.iter().enumerate() {
        if index > 0 {
            message.push(", ");
        }
        message.push(*input);
    }
}
