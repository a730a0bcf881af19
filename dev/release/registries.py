"""Writes the project's address where registries look for it, and recipes for conda, Homebrew and winget.

    python3 dev/release/registries.py address URL [--root FOLDER]    once, before the first release
    python3 dev/release/registries.py recipes FOLDER                 from the files of a release in FOLDER, into FOLDER/registries

Recipes take name, version, description, authors, licence and address from Cargo.toml and pyproject.toml, and checksums from FOLDER:
SHA256SUMS, or files NAME.sha256. Needs Python 3.11.
"""

import argparse
import json
import re
import sys
import tomllib
from pathlib import Path

from building import ROOT

# Targets of Homebrew's archives: system and processor as a formula calls them.
HOMEBREW = {
    "aarch64-apple-darwin": ("macos", "arm"), "x86_64-apple-darwin": ("macos", "intel"),
    "aarch64-unknown-linux-gnu": ("linux", "arm"), "x86_64-unknown-linux-gnu": ("linux", "intel"),
}


def set_address(root, address):
    """Writes the address; a second call replaces it."""
    def replace(path, pattern, text):
        before = path.read_text(encoding="utf-8")
        after, count = re.subn(pattern, text, before, flags=re.M)
        if count == 0:
            sys.exit(f"{path}: found no place for the address")
        path.write_text(after, encoding="utf-8", newline="\n")

    replace(root / "Cargo.toml", r'^(license = ".*"\n)(repository = ".*"\n)?', rf'\1repository = "{address}"\n')
    for path in sorted(root.glob("crates/*/Cargo.toml")):
        replace(path, r"^(repository\.workspace = true\n)?authors\.workspace = true\n", "repository.workspace = true\nauthors.workspace = true\n")
    urls = f'[project.urls]\nRepository = "{address}"\nIssues = "{address}/issues"\n\n'
    replace(root / "pyproject.toml", r"(\[project\.urls\]\n(?:.+\n)+\n)?^\[tool\.maturin\]\n", rf"{urls}[tool.maturin]\n")
    replace(root / "CITATION.cff", r"^(repository-code: .*\n)?license:\n", f"repository-code: {address}\nlicense:\n")
    for name in ("README.md", "docs/install.md", "docs/page.md", "docs/tutorial.md", "python/README.md"):
        replace(root / name, r"\*Releases\*|\[Releases\]\([^)]*\)", f"[Releases]({address}/releases)")
    owner, name = address.split("/")[-2:]
    replace(root / "README.md", r"https://[\w-]+\.github\.io/[^/]+/", f"https://{owner}.github.io/{name}/")
    replace(root / "README.md", r"(winget|brew) install [\w-]+", rf"\1 install {owner}")


def checksums(folder):
    """The SHA-256 of each file of the release."""
    lists = [path for path in folder.iterdir() if path.name == "SHA256SUMS" or path.suffix == ".sha256"]
    lines = [line.split() for path in lists for line in path.read_text(encoding="utf-8").splitlines()]
    return {name: digest for digest, name in lines}


def recipes(project, sums):
    """Every recipe that the files of the release suffice for: path and text."""
    name, version, home = project["name"], project["version"], project["repository"]
    files = {}

    def download(file):
        return f"{home}/releases/download/v{version}/{file}"

    sdist = f"{name.replace('-', '_')}-{version}.tar.gz"
    if sdist in sums:
        files["conda/recipe.yaml"] = f"""\
package:
  name: {name}
  version: {version}
source:
  url: {download(sdist)}
  sha256: {sums[sdist]}
build:
  number: 0
  script: ${{{{ PYTHON }}}} -m pip install . --no-deps --no-build-isolation -vv
requirements:
  build: ["${{{{ compiler('rust') }}}}", "${{{{ stdlib('c') }}}}", "${{{{ compiler('c') }}}}"]
  host: [python, pip, {', '.join(project['build'])}]
  run: [python, {', '.join(project['dependencies'])}]
tests:
  - python: {{imports: [{name.replace('-', '_')}]}}
  - script: [{name} --version]
about:
  homepage: {home}
  summary: {project['description']}
  license: {project['license']}
  license_file: [{', '.join(project['license-files'])}]
"""
    places = [(*place, f"{name}-{version}-{target}.tar.gz") for target, place in HOMEBREW.items()]
    blocks = "".join(f"""
  on_{system} do
    on_{processor} do
      url "{download(file)}"
      sha256 "{sums[file]}"
    end
  end
""" for system, processor, file in places if file in sums)
    if blocks:
        class_name = "".join(word.capitalize() for word in name.split("-"))
        # "(A OR B) AND C" as Homebrew writes it.
        choices = [part.strip("()").split(" OR ") for part in project["license"].split(" AND ")]
        licences = ", ".join(f'"{one[0]}"' if len(one) == 1 else f"{{ any_of: {json.dumps(one)} }}" for one in choices)
        files[f"homebrew/{name}.rb"] = f"""\
class {class_name} < Formula
  desc "{project['description']}"
  homepage "{home}"
  version "{version}"
  license all_of: [{licences}]
{blocks}
  def install
    bin.install "{name}"
    man1.install Dir["man/*.1"]
    bash_completion.install "completions/{name}.bash" => "{name}"
    zsh_completion.install "completions/_{name}"
    fish_completion.install "completions/{name}.fish"
  end

  test do
    assert_match version.to_s, shell_output("#{{bin}}/{name} --version")
  end
end
"""
    archives = {"x64": f"{name}-{version}-x86_64-pc-windows-msvc", "arm64": f"{name}-{version}-aarch64-pc-windows-msvc"}
    archives = {processor: archive for processor, archive in archives.items() if f"{archive}.zip" in sums}
    if archives:
        package = f"{home.rstrip('/').split('/')[-2]}.{name}"
        head = f"PackageIdentifier: {package}\nPackageVersion: {version}\n"
        tail = "ManifestVersion: 1.6.0\n"
        files[f"winget/{package}.yaml"] = f"{head}DefaultLocale: en-US\nManifestType: version\n{tail}"
        files[f"winget/{package}.locale.en-US.yaml"] = f"""\
{head}PackageLocale: en-US
Publisher: {project['authors'][0]['name']}
PackageName: {name}
PackageUrl: {home}
License: {project['license']}
ShortDescription: {project['description']}
ManifestType: defaultLocale
{tail}"""
        installers = "".join(f"""\
  - Architecture: {processor}
    NestedInstallerFiles:
      - RelativeFilePath: {archive}\\{name}.exe
        PortableCommandAlias: {name}
    InstallerUrl: {download(archive + '.zip')}
    InstallerSha256: {sums[archive + '.zip'].upper()}
""" for processor, archive in archives.items())
        files[f"winget/{package}.installer.yaml"] = f"""\
{head}InstallerType: zip
NestedInstallerType: portable
Installers:
{installers}ManifestType: installer
{tail}"""
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    address = verbs.add_parser("address", help="write the address of the repository")
    address.add_argument("url")
    address.add_argument("--root", type=Path, default=ROOT, help="another copy of the project")
    made = verbs.add_parser("recipes", help="write the recipes")
    made.add_argument("folder", type=Path)
    made.add_argument("--repository", help="the address, where Cargo.toml has none yet")
    arguments = parser.parse_args()
    if arguments.verb == "address":
        return set_address(arguments.root, arguments.url.rstrip("/"))
    workspace = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]
    python = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    repository = arguments.repository or workspace.get("repository")
    if not repository:
        sys.exit("Cargo.toml has no address yet: python3 dev/release/registries.py address URL")
    project = python["project"] | {"version": workspace["version"], "repository": repository, "build": python["build-system"]["requires"]}
    files = recipes(project, checksums(arguments.folder))
    if not files:
        sys.exit(f"{arguments.folder}: no archive with a checksum")
    for name, text in files.items():
        path = arguments.folder / "registries" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
        print(path)


if __name__ == "__main__":
    main()
