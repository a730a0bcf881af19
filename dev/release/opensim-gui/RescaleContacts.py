"""Makes the contacts of the model that is open in OpenSim's GUI fit another mass. In the GUI: Scripts, Run..., this file.

The program osim-contact-scale does the work, and docs/work.md explains it. Jython 2 runs this file; swing and lang are its modules.
"""
import os

from java.awt import Font
from java.io import File
from java.util import Scanner
from java.util.prefs import Preferences


def choose_file(title, suggestion, is_new=False):
    """The path that the user chooses, or None."""
    chooser = swing.JFileChooser()
    chooser.setDialogTitle(title)
    chooser.setSelectedFile(File(suggestion))
    answer = chooser.showSaveDialog(None) if is_new else chooser.showOpenDialog(None)
    return chooser.getSelectedFile().getPath() if answer == swing.JFileChooser.APPROVE_OPTION else None


def find_program():
    """The program: in the folder of scripts, in PATH, or where the user said that it is."""
    name = "osim-contact-scale" + (".exe" if File.separator == "\\" else "")
    settings = Preferences.userRoot().node("osim-contact-scale")
    folders = [getScriptsPath()] + (lang.System.getenv("PATH") or "").split(File.pathSeparator)
    for path in [os.path.join(folder, name) for folder in folders] + [settings.get("program", "")]:
        if File(path).isFile():
            return path
    path = choose_file("Where is " + name + "?", name)
    if path:
        settings.put("program", path)
    return path


def run_program(*arguments):
    """The exit status of the program, and what it prints."""
    process = lang.ProcessBuilder(arguments).redirectErrorStream(True).start()
    process.getOutputStream().close()
    printed = Scanner(process.getInputStream(), "UTF-8").useDelimiter("\\A")
    text = printed.next() if printed.hasNext() else ""
    return process.waitFor(), text


def show_text(text):
    area = swing.JTextArea(text, 30, 90)
    area.setFont(Font("Monospaced", Font.PLAIN, 12))
    swing.JOptionPane.showMessageDialog(None, swing.JScrollPane(area))


def change_contacts(model, words, check):
    """Runs the program on the model as it is now: after the Scale Tool, its file may be old, or missing."""
    program = find_program()
    suggestion = model.getInputFileName().replace(".osim", "") + "_contacts.osim"
    output = program and choose_file("Save the new model as", suggestion, True)
    if not output:
        return
    current = File.createTempFile("current-", ".osim", File(output).getParentFile())
    try:
        # A method called print is a fault of syntax elsewhere than in Jython.
        getattr(model, "print")(current.getPath())
        status, text = run_program(program, words[0], current.getPath(), *(words[1:] + ["--output", output]))
    finally:
        current.delete()
    if status == 0:
        loadModel(output)
        text += "\n" + run_program(program, "check", output, *check)[1]
    show_text(text)


def main():
    model = getCurrentModel()
    if not model:
        return show_text("Open a model first.")
    mass = swing.JOptionPane.showInputDialog("For which mass, in kg? Options of rescale may follow: 50 --contacts-mass 62")
    if mass:
        change_contacts(model, ["rescale", "--target-mass"] + mass.split(), [])


main()
