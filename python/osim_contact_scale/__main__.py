"""`python -m osim_contact_scale`: the command that comes with this package."""

import os
import shutil
import subprocess
import sys
import sysconfig

name = "osim-contact-scale" + (".exe" if os.name == "nt" else "")
schemes = {sysconfig.get_default_scheme(), sysconfig.get_preferred_scheme("user")}
folders = [sysconfig.get_path("scripts", scheme) for scheme in schemes]
program = shutil.which(name, path=os.pathsep.join(folders)) or shutil.which(name)
if program is None:
    sys.exit(f"{name} is not in {' or '.join(folders)}, where pip puts it: install the package again")
sys.exit(subprocess.run([program, *sys.argv[1:]]).returncode)
