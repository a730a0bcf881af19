#!/usr/bin/env bash
# Installs what the checks need beside Rust. Nothing else in the project installs anything.
#
#     dev/install.sh [GROUP...]     one or more of: rust programs shells oracle browser python simulations slurm book wasm web windows; all without arguments
#
# Quick, and silent but for the table at its end, where everything is there. What it cannot install (no root, no
# Debian, no such package) it names, and goes on: tests that need it say that they were skipped.
set -euo pipefail
cd "$(dirname "$0")/.."

# Environments of Python: which groups use it, where it is, and the list of its packages with their versions.
ENVIRONMENTS="
rust            target/tools-venv   dev/requirements.txt
oracle,browser  target/oracle-venv  tests/oracle/requirements.txt
python,simulations  target/python-venv  tests/python/requirements.txt
book            target/book-venv    docs/requirements.txt
"
GROUPS_KNOWN="rust programs shells oracle browser python simulations slurm book wasm web windows"

# Packages from npm: which groups use them, and the folder with their list and its lock file.
PACKAGES="
browser  tests/browser
web      web
web      tests/web
python   tests/pyright
"

# One tool a line:
#   group
#   tool     as the table calls it
#   wanted   the least version that is known to do; =VERSION for exactly that one
#   from     apt:PACKAGE of Debian; rust, comes with Rust; none, cannot be had
#   tells    what prints its version
#
# rust:     what dev/requirements.txt lists looks at licences and sources of dependencies.
# programs: octave runs the package for MATLAB, jython the scripts for OpenSim's GUI, groff sets the manual, strace sees what
#           reaches the disk, setpriv and unshare take permissions and make small disks (util-linux), readelf looks into the
#           archive's program, pdfinfo reads figures, valgrind counts instructions.
# shells:   each reads the completions made for it.
# oracle:   Python for the comparison with the real OpenSim. Its packages are in the table further below.
# browser:  opens reports; pdftotext reads what they print. The tests run in the oracle's Python. npm brings axe-core, by
#           tests/browser/package-lock.json.
# web:      makes the page, and opens it in two browsers: what wasm needs, and zstd, which compresses what the page holds.
# python:   what tests the Python package, which is installed beside it by pip; npm brings pyright, the second type checker.
# simulations: what tests of many models in OpenSim run in, which is the environment of the Python package.
# slurm:    and munge, by which its programs know each other: for those of these tests that start a cluster of their own.
# book:     makes the pages of docs/ a book, with the reference of the Python package.
# wasm:     a compiler with the sources of its library, for targets that rustup cannot fetch here, and a linker.
# windows:  the same compiler, a linker for Windows, and Wine, which runs what it links.
TOOLS="
rust      cargo          1.92     rust                cargo --version
rust      rustfmt        1.8      rust                cargo fmt --version
rust      clippy         0.1      rust                cargo clippy --version
rust      python3        3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
programs  octave         7        apt:octave          octave --version
programs  jython         2.7      apt:jython          dpkg-query -W jython
programs  groff          1.22     apt:groff-base      groff --version
programs  strace         6        apt:strace          strace --version
programs  setpriv        2.38     apt:util-linux      setpriv --version
programs  unshare        2.38     apt:util-linux      unshare --version
programs  pdfinfo        22       apt:poppler-utils   pdfinfo -v
programs  readelf        2.40     apt:binutils        readelf --version
programs  valgrind       3.19     apt:valgrind        valgrind --version
shells    bash           5        apt:bash            bash --version
shells    zsh            5.8      apt:zsh             zsh --version
shells    fish           3.3      apt:fish            fish --version
shells    elvish         0.18     apt:elvish          elvish -version
shells    pwsh           7        none                pwsh --version
oracle    python3        3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
browser   python3        3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
browser   chromium       120      apt:chromium        eval chromium --version || chromium-browser --version || google-chrome --version
browser   chromedriver   120      apt:chromium-driver chromedriver --version
browser   npm            9        apt:npm             npm --version
browser   pdftotext      22       apt:poppler-utils   pdftotext -v
python    python3        3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
python    node           18       apt:nodejs          node --version
python    npm            9        apt:npm             npm --version
simulations python3      3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
slurm     slurm-wlm      22.05    apt:slurm-wlm       dpkg-query -W slurm-wlm
slurm     munge          0.5      apt:munge           munge --version
book      python3        3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
wasm      rustc-web      1.92     apt:rustc-web       /usr/bin/rustc --version
wasm      rust-web-src   1.92     apt:rust-web-src    dpkg-query -W rust-web-src
wasm      wasm-ld-19     19       apt:lld-19          wasm-ld-19 --version
web       rustc-web      1.92     apt:rustc-web       /usr/bin/rustc --version
web       rust-web-src   1.92     apt:rust-web-src    dpkg-query -W rust-web-src
web       wasm-ld-19     19       apt:lld-19          wasm-ld-19 --version
web       node           18       apt:nodejs          node --version
web       npm            9        apt:npm             npm --version
web       zstd           1.4      apt:zstd            zstd --version
web       python3        3.11     apt:python3-venv    python3 -c 'import ensurepip, platform; print(platform.python_version())'
web       chromium       120      apt:chromium        eval chromium --version || chromium-browser --version || google-chrome --version
web       firefox        115      apt:firefox-esr     eval firefox-esr --version || firefox --version
windows   rustc-web      1.92     apt:rustc-web       /usr/bin/rustc --version
windows   rust-web-src   1.92     apt:rust-web-src    dpkg-query -W rust-web-src
windows   mingw-gcc      12       apt:gcc-mingw-w64-x86-64 dpkg-query -W gcc-mingw-w64-x86-64
windows   wine           8        apt:wine            wine --version
"

wanted_groups=${*:-$GROUPS_KNOWN}
for group in $wanted_groups; do
    case " $GROUPS_KNOWN " in
    *" $group "*) ;;
    *) printf 'no group %s; there are: %s\n' "$group" "$GROUPS_KNOWN" >&2; exit 2 ;;
    esac
done

log=$(mktemp)
trap 'rm -f "$log"' EXIT

# The tools of the wanted groups, each once.
chosen() {
    local group tool rest known=" "
    while read -r group tool rest; do
        case " $wanted_groups " in *" $group "*) ;; *) continue ;; esac
        case "$known" in *" $tool "*) continue ;; esac
        known="$known$tool "
        printf '%s %s %s\n' "$group" "$tool" "$rest"
    done <<<"$(grep -v '^$' <<<"$TOOLS")"
}

# The first version number that a command prints; nothing where there is no such command.
version_of() {
    { eval "$*" 2>&1 </dev/null || true; } | grep -v -i 'not found\|no such' | grep -o -m 1 -E '[0-9]+(\.[0-9]+)+' | head -n 1 || true
}

# Whether version $2 is what $1 wants.
is_enough() {
    [ -n "$2" ] || return 1
    case "$1" in
    =*) [ "$1" = "=$2" ] ;;
    *) [ "$(printf '%s\n%s\n' "$1" "$2" | sort -V | head -n 1)" = "$1" ] ;;
    esac
}

may_be_root() { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }

problems=""
problem() { problems="$problems  $1: $2"$'\n'; }

# Runs what is slow; what it prints is shown only where it fails.
quietly() {
    local call="$*"
    printf '+ %s\n' "${call#as_root }"
    "$@" >"$log" 2>&1 </dev/null && return 0
    tail -n 20 "$log"
    return 1
}

# Debian packages, all in one call.
install_packages() {
    local package packages=""
    if ! command -v apt-get >/dev/null; then
        for package in "$@"; do problem "$package" "no apt-get here: install it by other means"; done
        return
    fi
    if ! may_be_root; then
        problem "$*" "not root: run apt-get install --no-install-recommends $*"
        return
    fi
    # An old list is better than none.
    quietly as_root apt-get update -qq || true
    for package in "$@"; do
        case $(apt-cache policy "$package" 2>/dev/null) in
        *"Candidate: "[0-9]*) packages="$packages $package" ;;
        *) problem "$package" "this system has no such package" ;;
        esac
    done
    # shellcheck disable=SC2086
    [ -z "$packages" ] || quietly as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends $packages || problem "$packages" "apt-get could not install them"
}

missing_packages=""
while read -r group tool wanted from tells; do
    is_enough "$wanted" "$(version_of "$tells")" && continue
    case "$from" in
    apt:*) case " $missing_packages " in *" ${from#apt:} "*) ;; *) missing_packages="$missing_packages ${from#apt:}" ;; esac ;;
    rust) problem "$tool" "comes with Rust, see rustup" ;;
    esac
done <<<"$(chosen)"
# shellcheck disable=SC2086
[ -z "$missing_packages" ] || install_packages $missing_packages

# Python packages: exactly those of the list $2, in the environment $1.
python_packages() {
    "$1/bin/python" - "$2" "$3" <<'END'
import sys
from importlib import metadata

right = True
for line in open(sys.argv[1]):
    # After the version there may be sums of files.
    name, _, wanted = line.split("#")[0].partition(" ")[0].strip().partition("==")
    if not name:
        continue
    try:
        found = metadata.version(name)
    except metadata.PackageNotFoundError:
        found = ""
    right &= found == wanted
    if sys.argv[2] == "table":
        print(name, f"={wanted}", found)
sys.exit(0 if right or sys.argv[2] == "table" else 1)
END
}
# The environments that the wanted groups use.
environments() {
    local groups venv list group
    while read -r groups venv list; do
        for group in ${groups//,/ }; do
            case " $wanted_groups " in *" $group "*) printf '%s %s\n' "$venv" "$list"; break ;; esac
        done
    done <<<"$(grep -v '^$' <<<"$ENVIRONMENTS")"
}
while read -r venv list; do
    [ -n "$venv" ] || continue
    if [ ! -x "$venv/bin/python" ]; then
        quietly python3 -m venv "$venv" || problem "$venv" "python3 -m venv failed"
    fi
    if [ -x "$venv/bin/python" ] && ! python_packages "$venv" "$list" check </dev/null; then
        quietly "$venv/bin/python" -m pip install --disable-pip-version-check --no-compile -r "$list" || problem "$list" "pip could not install it"
    fi
done <<<"$(environments)"

# The packages from npm in the folder $1: name, version that is wanted, version that is there.
npm_packages() {
    python3 - "$1" <<'END'
import json
import sys
from pathlib import Path

folder = Path(sys.argv[1])
wanted = json.loads((folder / "package.json").read_text())
for name, version in {**wanted.get("dependencies", {}), **wanted.get("devDependencies", {})}.items():
    there = folder / "node_modules" / name / "package.json"
    print(name, version, json.loads(there.read_text())["version"] if there.is_file() else "")
END
}
# The folders that the wanted groups use.
npm_folders() {
    local group folder
    while read -r group folder; do
        case " $wanted_groups " in *" $group "*) [ -f "$folder/package.json" ] && printf '%s\n' "$folder" ;; esac
    done <<<"$(grep -v '^$' <<<"$PACKAGES")"
    return 0
}
for folder in $(npm_folders); do
    if [ -n "$(npm_packages "$folder" | awk '$2 != $3')" ] && command -v npm >/dev/null; then
        quietly npm ci --prefix "$folder" --no-audit --no-fund --ignore-scripts || problem "$folder/package-lock.json" "npm could not install it"
    fi
done

row() {
    local state=""
    is_enough "$3" "$4" || { state="missing$5"; [ -z "$4" ] || state="another version"; }
    local line
    line=$(printf '%-11s %-14s %-9s %-12s %s' "$1" "$2" "$3" "${4:--}" "$state")
    printf '%s\n' "${line%"${line##*[! ]}"}"
}
printf '%-11s %-14s %-9s %s\n' group tool wanted found
while read -r group tool wanted from tells; do
    case $from in none) why=": neither Debian nor npm nor crates.io has it" ;; *) why="" ;; esac
    row "$group" "$tool" "$wanted" "$(version_of "$tells")" "$why"
done <<<"$(chosen)"
while read -r venv list; do
    [ -n "$venv" ] && [ -x "$venv/bin/python" ] || continue
    while read -r name wanted found; do row python "$name" "$wanted" "$found" ""; done <<<"$(python_packages "$venv" "$list" table)"
done <<<"$(environments)"
for folder in $(npm_folders); do
    while read -r name wanted found; do row npm "$name" "=$wanted" "$found" ""; done <<<"$(npm_packages "$folder")"
done
if [ -n "$problems" ]; then
    printf 'not installed:\n%s' "$problems" >&2
fi
