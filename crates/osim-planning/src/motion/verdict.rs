//! Whether contacts fit a recording, as a verdict.

use std::path::Path;

use osim_inspect::{Sign, Verdict};
use osim_model::files::Files;
use osim_model::messages::{Input, Phrase, Verb, phrase};
use osim_requests::options::InspectionOptions;
use osim_requests::{CheckRequest, MotionRequest, RequestError};

use super::remarks::MotionRemark;
use super::result::MotionResult;
use super::run::run_motion;

/// What three fitted numbers reach on measured gaits, body weights (rms per foot): contacts as close as this fit.
const FITS_BW: f64 = 0.2;

/// The recording that `check` is asked about.
#[derive(Debug, Clone)]
pub(crate) struct CheckedMotion(MotionRequest);

impl CheckedMotion {
    /// That of the request, if it names one.
    pub(crate) fn of(request: &CheckRequest) -> Option<Self> {
        request.motion.as_ref()?;
        let InspectionOptions { masses, choice, set_files, .. } = request.options.clone();
        Some(Self(MotionRequest {
            motion: request.motion.clone(),
            plates: request.plates.clone(),
            loads: request.loads.clone(),
            angles: request.angles,
            masses,
            choice,
            set_files,
            ..MotionRequest::default()
        }))
    }

    /// What the contacts of the model at `path` do, and what should be known of it.
    ///
    /// # Errors
    /// As [`run_motion`].
    pub(crate) fn followed(
        &self,
        path: &Path,
        files: &dyn Files,
    ) -> Result<(MotionResult, Vec<MotionRemark>), RequestError> {
        let request = MotionRequest { subject: Some(path.to_owned()), ..self.0.clone() };
        let result = run_motion(&request, files)?;
        let remarks = result.remarks_without_belt(&request);
        Ok((result, remarks))
    }

    /// The verdict on the model at `path`.
    pub(crate) fn verdict(&self, path: &Path, files: &dyn Files) -> Verdict {
        match self.followed(path, files) {
            Ok((result, _)) => verdict(&result),
            Err(RequestError::Failure(failure)) => Verdict::on_recording(
                Sign::Unknown,
                phrase![failure.model.to_string(), ": ", &failure.message],
            ),
            Err(RequestError::Fault(fault)) => Verdict::on_recording(Sign::Unknown, fault.phrase()),
        }
    }
}

fn verdict(result: &MotionResult) -> Verdict {
    let weight_n = result.summary.weight_n;
    let feet = result.summary.feet.iter();
    let compared: Vec<_> = feet.filter_map(|foot| Some((foot, foot.comparison.as_ref()?))).collect();
    let worst = compared.iter().max_by(|a, b| a.1.normal_rms_n.total_cmp(&b.1.normal_rms_n));
    let Some((foot, worst)) = worst else {
        return Verdict::on_recording(
            Sign::Unknown,
            "no plate measured under a foot while it was recorded".into(),
        );
    };
    let rms: Vec<String> = compared
        .iter()
        .map(|(foot, one)| format!("{} {:.2}", foot.foot.name, one.normal_rms_n / weight_n))
        .collect();
    let rms = format!("errors of the force in body weights (rms): {}", rms.join(", "));
    if worst.normal_rms_n / weight_n <= FITS_BW {
        return Verdict::on_recording(Sign::Good, Phrase::from(rms));
    }
    let call = Verb::Fit.of_model().with(Input::Motion, "MOTION").with(Input::Plates, "PLATES");
    let text = phrase![
        format!(
            "{}: up to {:.2} body weights where the plates measured up to {:.2}; {rms}. ",
            foot.foot.name,
            worst.peak_n / weight_n,
            worst.measured_peak_n / weight_n
        ),
        call,
        " finds what would fit"
    ];
    Verdict::on_recording(Sign::Warn, text)
}
