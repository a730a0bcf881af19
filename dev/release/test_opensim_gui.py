"""Runs the scripts for OpenSim's GUI in Jython 2.7, with stand-ins for models, dialogs and the calls of the GUI.

    python3 dev/release/test_opensim_gui.py [PROGRAM]

PROGRAM is target/release/osim-contact-scale by default. Needs Jython (`dev/install.sh programs`).
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "dev/release/opensim-gui"
FIXTURES = ROOT / "fixtures/scale_tool"
COMMAND = "osim-contact-scale"

# What the GUI gives to a script, by github.com/opensim-org/opensim-gui, commit 5a67a115a74be1bc1e5c2f9e70bfd36a9b6b877a, in
# Gui/opensim/scriptingShell/src/org/opensim/console/: JConsole.java, lines 126 to 129, imports javax.swing as swing, java.lang as lang and
# all functions of gui.java; line 167 runs a file by execfile, so that it has no __file__. In gui.java, line 78 is getCurrentModel(), which
# may be null, line 176 is loadModel(path), and line 352 getScriptsPath(), an absolute path. What models have is in
# github.com/opensim-org/opensim-core, commit 0435b081dc383498e217f92ca63bb97616145c14: print(path) in OpenSim/Common/Object.h, line 616,
# getInputFileName() in OpenSim/Simulation/Model/Model.h, line 626. Dialogs are Swing's own until they would be shown.
STAND_INS = r'''
import json
import java.lang as lang
from java.io import File, FileOutputStream
from javax.swing import JFileChooser, JScrollPane, JTextArea

class Model:
    def __init__(self, case):
        self.case = case
    def getInputFileName(self):
        return self.case["input_file"]

def print_model(self, path):
    stream = FileOutputStream(path)
    stream.write(open(self.case["live"].encode("utf-8"), "rb").read())
    stream.close()
setattr(Model, "print", print_model)

class FileChooser(JFileChooser):
    def showDialog(self, parent, button):
        seen["asked"].append(self.getDialogTitle())
        answer = case["answers"].pop(0)
        self.setSelectedFile(answer and File(answer))
        return self.APPROVE_OPTION if answer else self.CANCEL_OPTION

class OptionPane:
    @staticmethod
    def showInputDialog(text):
        seen["asked"].append(text)
        return case["answers"].pop(0)
    @staticmethod
    def showMessageDialog(parent, pane):
        seen["shown"].append(pane.getViewport().getView().getText())

class swing:
    JFileChooser, JOptionPane, JScrollPane, JTextArea = FileChooser, OptionPane, JScrollPane, JTextArea

def getCurrentModel():
    return Model(case) if case["live"] else None
def loadModel(path):
    seen["loaded"].append(path)
def getScriptsPath():
    return case["scripts"]

results = []
for case in json.load(open("cases.json")):
    seen = {"asked": [], "shown": [], "loaded": []}
    execfile(case["script"].encode("utf-8"), globals())
    results.append(seen)
json.dump(results, open("seen.json", "w"))
'''


def run(folder, cases):
    """What the user sees in each case: the questions, the texts, the models that are loaded."""
    work = folder / "work"
    work.mkdir()
    (work / "gui.py").write_text(STAND_INS, encoding="ascii")
    (work / "cases.json").write_text(json.dumps(cases), encoding="ascii")
    environment = os.environ | {"LC_ALL": "C.UTF-8", "JAVA_TOOL_OPTIONS": f"-Djava.util.prefs.userRoot={folder.parent} -Djava.awt.headless=true"}
    subprocess.run(["jython", "gui.py"], cwd=work, env=environment, check=True, timeout=300)
    return json.loads((work / "seen.json").read_text())


def main():
    program = Path(sys.argv[1] if len(sys.argv) == 2 else ROOT / "target/release" / COMMAND).resolve()
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder) / "é und Leerzeichen"
        scripts, nothing = folder / "Scripts é", folder / "nothing"
        models = folder / "Modèles 1"
        for new in (scripts, nothing, models):
            new.mkdir(parents=True)
        for path in [program, *SCRIPTS.iterdir()]:
            shutil.copy(path, scripts)
        live, generic = models / "live.osim", models / "generic é.osim"
        shutil.copy(FIXTURES / "scaled_smooth.osim", live)
        shutil.copy(FIXTURES / "generic_smooth.osim", generic)

        def case(script, *answers, model=live, folder=scripts):
            # The Scale Tool of the GUI names a file that may not exist.
            return {"script": f"{scripts}/{script}.py", "answers": [answer and str(answer) for answer in answers],
                    "live": model and str(model), "input_file": str(models / "not saved.osim"), "scripts": str(folder)}

        fixed, rescaled, found = models / "fixed é.osim", models / "50 kg é.osim", models / "found.osim"
        seen = run(folder, [
            case("FixContactsAfterScaling", generic, fixed),
            case("FixContactsAfterScaling", generic, fixed),
            case("RescaleContacts", "50 --contacts-mass 62", rescaled, model=generic),
            case("RescaleContacts", None),
            case("RescaleContacts", "50", None),
            case("RescaleContacts", model=None),
            case("RescaleContacts", "50", None, folder=nothing),
            case("RescaleContacts", "50 --contacts-mass 62", scripts / COMMAND, found, folder=nothing),
            case("FixContactsAfterScaling", generic, models / "remembered.osim", folder=nothing),
        ])
        loaded = [one["loaded"] for one in seen]
        remembered = models / "remembered.osim"
        assert loaded == [[str(fixed)], [], [str(rescaled)], [], [], [], [], [str(found)], [str(remembered)]], loaded
        shown = ["".join(one["shown"]) for one in seen]
        assert "contacts of generic é.osim (62 kg" in shown[0] and "good     floor" in shown[0], shown[0]
        assert "--force" in shown[1], shown[1]
        assert "scaled to 50 kg" in shown[2], shown[2]
        assert shown[3:7] == ["", "", "Open a model first.", ""], shown[3:7]
        assert seen[7]["asked"][1:] == [f"Where is {COMMAND}?", "Save the new model as"], seen[7]
        assert seen[8]["asked"][1:] == ["Save the new model as"], seen[8]
        assert fixed.read_bytes() != live.read_bytes() and b"contacts made for 52 kg" in fixed.read_bytes()
        written = sorted(path.name for path in models.iterdir())
        assert written == sorted(path.name for path in (live, generic, fixed, rescaled, found, remembered)), written
    texts = [path.read_text(encoding="ascii").split('"""', 2)[2].split("\nmodel = ")[0] for path in sorted(SCRIPTS.iterdir())]
    assert len(texts) == 2 and texts[0] == texts[1], "what the two scripts share differs"
    print("the scripts for OpenSim's GUI: as expected")


if __name__ == "__main__":
    main()
