//! Plays a recorded motion on the web page, and corrects it.

use osim_model::files::Files;
use osim_planning::run_motion;
use osim_planning::scene::PlayedRecording;
use osim_requests::spell::Page;
use osim_requests::{MotionRequest, Request};
use osim_view::report::results::corrected_files;
use serde::Serialize;

use crate::given_files::GivenFiles;
use crate::problem::{Problem, Result};

fn motion_request(request: Request) -> Result<Box<MotionRequest>> {
    match request {
        Request::Motion(request) => Ok(request),
        other => Err(Problem::wrong_call(format!("{} follows no recording", other.verb().name()))),
    }
}

/// The motion of a model along a recording, frame by frame.
pub(crate) fn play_recording(request: Request, given_files: &GivenFiles) -> Result<PlayedRecording> {
    let request = motion_request(request)?;
    Ok(PlayedRecording::of(&run_motion(&request, given_files)?, &request, &Page))
}

/// A corrected recording as the page shows it.
#[derive(Debug, Serialize)]
pub(crate) struct CorrectedRecording {
    /// `agree`, `large-correction` or `disagree`.
    verdict: &'static str,
    /// The verdict in a sentence, and its figures.
    why: String,
    remarks: Vec<String>,
    /// The files that the command writes, with their texts; none if plates and motion cannot be compared.
    files: Vec<(String, String)>,
    /// The motion in these files.
    played: Option<PlayedRecording>,
}

impl CorrectedRecording {
    /// Corrects the recording. The new files are among `given_files` only while they are read again.
    ///
    /// # Errors
    /// The recording cannot be corrected, or a file has the name of a new one.
    pub(crate) fn correct(request: Request, given_files: &mut GivenFiles) -> Result<Self> {
        let mut request = motion_request(request)?;
        let result = run_motion(&request, given_files)?;
        let (Some(judged), Some(path)) = (&result.consistency, request.correct.take()) else {
            return Err(Problem::wrong_call("a correction needs the name of its file"));
        };
        let made = corrected_files(&result, &path);
        let files: Vec<(String, String)> =
            made.into_iter().map(|(path, text)| (path.display().to_string(), text)).collect();
        if let Some((name, _)) = files.iter().find(|(name, _)| given_files.exists(name.as_ref())) {
            return Err(Problem::wrong_call(format!("{name} exists already")));
        }
        if let [_, (plates, _), (loads, _)] = files.as_slice() {
            (request.plates, request.loads) = (Some(plates.into()), Some(loads.into()));
        }
        request.motion = Some(path);
        files.iter().for_each(|(name, text)| given_files.put(name, text.clone().into_bytes()));
        let play = |_| play_recording(Request::Motion(request), given_files);
        let played = files.first().map(play).transpose();
        files.iter().for_each(|(name, _)| given_files.remove(name));
        let verdict = judged.verdict.as_str();
        let others = judged.remarks.iter().filter(|remark| remark.code != verdict);
        let remarks = others.map(|remark| remark.message.spelled(&Page)).collect();
        Ok(Self { verdict, why: judged.why.spelled(&Page), remarks, files, played: played? })
    }
}
