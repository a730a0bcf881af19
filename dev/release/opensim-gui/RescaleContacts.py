"""Makes the contacts of the model that is open in OpenSim's GUI fit another mass. In the GUI: Scripts, Run..., this file.

The program osim-contact-scale does the work, and docs/work.md explains it. Jython 2 runs this file; swing and lang are its modules.
"""
from java.awt import Font
from java.io import File
from java.util import Scanner
from java.util.prefs import Preferences


def choose_file(title, suggestion):
    """The path that the user chooses, or None."""
    chooser = swing.JFileChooser(dialogTitle=title, selectedFile=File(suggestion))
    return chooser.getSelectedFile().getPath() if chooser.showDialog(None, "OK") == chooser.APPROVE_OPTION else None


def find_program():
    """The program: in the folder of scripts, in PATH, or where the user said that it is."""
    name = "osim-contact-scale" + (".exe" if File.separator == "\\" else "")
    settings = Preferences.userRoot().node("osim-contact-scale")
    folders = [getScriptsPath()] + (lang.System.getenv("PATH") or "").split(File.pathSeparator)
    for file in [File(folder, name) for folder in folders] + [File(settings.get("program", ""))]:
        if file.isFile():
            return file.getPath()
    path = choose_file("Where is " + name + "?", name)
    settings.put("program", path or "")
    return path


def run_program(*arguments):
    """The exit status of the program, and what it prints."""
    process = lang.ProcessBuilder(arguments).redirectErrorStream(True).start()
    process.getOutputStream().close()
    text = "".join(Scanner(process.getInputStream(), "UTF-8").useDelimiter("\\A"))
    return process.waitFor(), text


def show_text(text):
    area = swing.JTextArea(text, 30, 90, font=Font("Monospaced", Font.PLAIN, 12))
    swing.JOptionPane.showMessageDialog(None, swing.JScrollPane(area))


def change_contacts(model, words, check):
    """Runs the program on the model as it is now: after the Scale Tool, its file may be old, or missing."""
    program, suggestion = find_program(), model.getInputFileName().replace(".osim", "") + "_contacts.osim"
    output = program and choose_file("Save the new model as", suggestion)
    if output:
        current = File.createTempFile("current-", ".osim", File(output).getParentFile())
        try:
            model.print(current.getPath())
            status, text = run_program(program, words[0], current.getPath(), *(words[1:] + ["--output", output]))
        finally:
            current.delete()
        if status == 0:
            loadModel(output)
            text += "\n" + run_program(program, "check", output, *check)[1]
        show_text(text)


model = getCurrentModel()
mass = model and swing.JOptionPane.showInputDialog("For which mass, in kg? Options of rescale may follow: 50 --contacts-mass 62")
if mass:
    change_contacts(model, ["rescale", "--target-mass"] + mass.split(), [])
elif not model:
    show_text("Open a model first.")
