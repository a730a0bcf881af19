"""What registries look at: metadata of the wheel, and recipes, made of a release that is not there."""

import subprocess
import sys
from pathlib import Path

import pytest

RELEASE = Path(__file__).parents[2] / "dev/release"
FILES = [
    "osim_contact_scale-{}.tar.gz",
    "osim-contact-scale-{}-x86_64-pc-windows-msvc.zip",
    "osim-contact-scale-{}-aarch64-pc-windows-msvc.zip",
    "osim-contact-scale-{}-aarch64-apple-darwin.tar.gz",
]


@pytest.mark.skipif(not RELEASE.exists() or sys.version_info < (3, 11), reason="needs the sources, and Python 3.11")
def test_every_recipe_has_the_files_of_the_release(tmp_path):
    from importlib.metadata import version

    names = [name.format(version("osim-contact-scale")) for name in FILES]
    sums = {name: f"{number:064x}" for number, name in enumerate(names, 10)}
    (tmp_path / "SHA256SUMS").write_text("".join(f"{digest}  {name}\n" for name, digest in sums.items()))
    call = [
        sys.executable,
        RELEASE / "registries.py",
        "recipes",
        tmp_path,
        "--repository",
        "https://example.org/OWNER/x",
    ]
    subprocess.run(call, check=True, capture_output=True)
    texts = [path.read_text() for path in (tmp_path / "registries").rglob("*.*")]
    assert len(texts) == 5
    said = "\n".join(texts)
    for name, digest in sums.items():
        assert f"https://example.org/OWNER/x/releases/download/v{version('osim-contact-scale')}/{name}" in said
        assert digest in said.lower()
    assert 'any_of: ["MIT", "Apache-2.0"]' in said and "{{" not in said.replace("${{", "")


def test_the_metadata_are_what_pypi_takes():
    """PyPI reads metadata with the same library."""
    from importlib.metadata import distribution

    from packaging.metadata import Metadata

    text = distribution("osim-contact-scale").read_text("METADATA")
    assert text is not None
    read = Metadata.from_email(text, validate=True)
    assert str(read.license_expression) == "(MIT OR Apache-2.0) AND OFL-1.1" and len(read.license_files) == 3
    assert str(read.requires_python) == ">=3.10"
