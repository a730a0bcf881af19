//! Models for what follows a correction: tracking with Moco, or NMSM's ground contact personalisation. The report writes their files, also
//! the script of Moco.

use osim_model::files::Files;
use osim_model::messages::shortest;
use osim_model::{Fault, FileId, Force, ForceKind, Model};
use osim_motion::correct::flat_feet;
use osim_patch::{Edit, splice};
use osim_requests::options::ClassChoice;
use osim_requests::{ConvertRequest, MotionRequest, RequestFault, Result};

use crate::motion::run_opened;
use crate::opening::open_with;
use crate::{MotionResult, prepare};

/// The models that a request wants beside the corrected motion; `None` where it wants none.
#[derive(Default)]
pub struct NextModels {
    pub moco: Option<MocoStart>,
    /// The model with soles that lie flat at the default pose.
    pub nmsm: Option<Model>,
}

/// What Moco starts from: smooth contacts, and the motion that is corrected to them.
pub struct MocoStart {
    /// The model with the root at the height at which the corrected motion starts.
    pub model: Model,
    /// The motion with smooth contacts; `None` if the contacts of the model are smooth already.
    pub smooth: Option<Box<MotionResult>>,
}

impl NextModels {
    /// The models that `request` wants, if the motion of `result` is corrected.
    ///
    /// # Errors
    /// Contacts that cannot become smooth.
    pub fn new(request: &MotionRequest, result: &MotionResult, files: &dyn Files) -> Result<Self> {
        let mut models = Self::default();
        let opened = &result.opened;
        if result.correction().is_none() {
            return Ok(models);
        }
        if request.moco.is_some() {
            models.moco = MocoStart::new(request, result, files)?;
        }
        if request.nmsm.is_some() {
            let feet: Vec<_> = result.summary.feet.iter().map(|foot| foot.foot.clone()).collect();
            let pose = flat_feet(&opened.model, &result.recording, &result.states, &feet)
                .map_err(|error| opened.failure(Fault::refused(error.to_string())))?;
            models.nmsm = Some(with_defaults(&opened.model, &pose).map_err(|fault| opened.failure(fault))?);
        }
        Ok(models)
    }
}

impl MocoStart {
    /// The start for Moco that `request` wants; `None` if it wants none.
    fn new(request: &MotionRequest, result: &MotionResult, files: &dyn Files) -> Result<Option<Self>> {
        let is_smooth = |force: &Force| !force.applies || force.kind == ForceKind::SmoothSphereHalfSpace;
        let smooth = match result.opened.model.forces().iter().all(is_smooth) {
            true => None,
            false => Some(Box::new(with_smooth_contacts(request, files)?)),
        };
        let start = smooth.as_deref().unwrap_or(result);
        let Some(correction) = start.correction() else { return Ok(None) };
        let recording = &correction.recording;
        let root = recording.coordinates.iter().position(|one| one.name == correction.root_height);
        let height = root.and_then(|root| recording.values(0).get(root).copied());
        let height = height.map(|start_m| (correction.root_height.clone(), start_m));
        let model = with_defaults(&start.opened.model, height.as_slice());
        Ok(Some(Self { model: model.map_err(|fault| start.opened.failure(fault))?, smooth }))
    }
}

/// The result of `request` for the model with smooth contacts, which press a little more than the contacts that they were converted from.
fn with_smooth_contacts(request: &MotionRequest, files: &dyn Files) -> Result<MotionResult> {
    let subject = request.subject.as_ref().ok_or(RequestFault::Missing { field: "subject" })?;
    let convert = ConvertRequest {
        models: vec![subject.clone()],
        to: Some(ClassChoice::Smooth),
        choice: request.choice.clone(),
        ..ConvertRequest::default()
    };
    let change = prepare(convert, files)?;
    let mut opened = open_with(subject, request.set_files.companion_paths(), files)?;
    let convert =
        |model: &Model| model.read_again(change.plan_alone(model)?.patched(model, FileId::MAIN)?, &[]);
    opened.model = convert(&opened.model).map_err(|fault| opened.failure(fault))?;
    run_opened(request, opened, files)
}

/// `model` with other default values of coordinates. A value outside of the range of a clamped coordinate is left out, because
/// OpenSim refuses it.
fn with_defaults(model: &Model, values: &[(String, f64)]) -> Result<Model, Fault> {
    let document = model.document();
    let tree = document.tree();
    let mut edits = Vec::new();
    for coordinate in
        model.joints().iter().filter(|joint| joint.file == FileId::MAIN).flat_map(|joint| &joint.coordinates)
    {
        let Some((_, value)) = values.iter().find(|(name, _)| *name == coordinate.name) else { continue };
        let allowed = |[least, most]: [f64; 2]| (least..=most).contains(value);
        if coordinate.clamped && !coordinate.range.is_none_or(allowed) {
            continue;
        }
        let element = coordinate.element;
        if let Some(default) = tree.child(element, "default_value") {
            edits.push(Edit { span: tree.raw_text(default).span, text: shortest(*value) });
        } else if tree.name(element) == "Coordinate" && !tree.is_empty_tag(element) {
            let at = tree.open_span(element).end;
            let text = format!("<default_value>{}</default_value>", shortest(*value));
            edits.push(Edit { span: at..at, text });
        }
    }
    model.read_again(splice(document.bytes(), &edits)?, &[])
}
