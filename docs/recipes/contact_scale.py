"""Run osim-contact-scale from Python; what it says, as dictionaries. Needs Python 3.8 and nothing else."""

import json
import subprocess


class UsageError(Exception):
    """The call was not understood; nothing was done."""


class ModelError(Exception):
    """A model could not be done."""

    def __init__(self, model, error):
        super().__init__(f"{model}: {error['message']}")
        self.model = model
        self.code = error["code"]
        self.line = error["line"]


def contact_scale(*arguments, check=True):
    """Results of one call, one dictionary for each model.

    Arguments are texts, numbers or paths; nothing needs quotation marks. A model that failed raises ModelError, after
    the other models are done; with check=False its dictionary, with a key "error", is among the results instead.
    """
    call = ["osim-contact-scale", *map(str, arguments), "--format", "json"]
    run = subprocess.run(call, capture_output=True, encoding="utf-8")
    if run.returncode not in (0, 1):
        raise UsageError(run.stderr.strip())
    results = [json.loads(line) for line in run.stdout.splitlines()]
    failed = [result for result in results if "error" in result]
    if check and failed:
        raise ModelError(failed[0]["model"], failed[0]["error"])
    return results
