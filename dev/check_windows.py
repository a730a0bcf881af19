#!/usr/bin/env python3
"""Builds the program for Windows and runs it under Wine; checks that all of it compiles for macOS.

    dev/check_windows.py [--no-macos]

Needs what `dev/install.sh windows` installs: Debian's compiler with the sources of its library (rustc-web, rust-web-src), a
linker (mingw) and Wine. What runs under Wine is compared with what the program for this system writes. dev/README.md says
what Wine cannot show. Prints a line for each check, and ends with 1 where one failed.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
OTHER = TARGET / "other-systems"
COMPILER = "/usr/bin/rustc"
WINDOWS, MACOS = "x86_64-pc-windows-gnu", "aarch64-apple-darwin"
HUMAN = ROOT / "fixtures/table1/human_62kg_smooth_sphere.osim"
INCLUDES = ROOT / "fixtures/format/file_forceset.osim"

# Windows 10 has this function, Wine 8 does not: the standard library takes its random numbers from it.
RANDOM = r"""
#include <windows.h>
BOOLEAN NTAPI SystemFunction036(PVOID, ULONG);
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE bytes, SIZE_T count) {
    return SystemFunction036(bytes, (ULONG)count);
}
"""


def cargo(verb, target, *options):
    """Runs cargo with another compiler than the project's own, which has no libraries for other systems here; it builds them along."""
    call = ["cargo", verb, "--locked", "-Zbuild-std=std,panic_abort", "--target", target, "--target-dir", str(OTHER)]
    call += ["--config", "profile.dev.debug=false", *options]
    print("+", " ".join(call), flush=True)
    environment = dict(os.environ, RUSTC=COMPILER, RUSTC_BOOTSTRAP="1", CARGO_INCREMENTAL="0")
    subprocess.run(call, cwd=ROOT, env=environment, check=True)


def build_dll(folder):
    source = folder / "random.c"
    source.write_text(RANDOM)
    library = folder / "bcryptprimitives.dll"
    call = ["x86_64-w64-mingw32-gcc", "-shared", "-o", library, source, "-ladvapi32"]
    subprocess.run(call, check=True)


def wine_environment(prefix):
    return dict(os.environ, LC_ALL="C.UTF-8", NO_COLOR="1", WINEPREFIX=str(prefix), WINEDEBUG="-all",
                WINEDLLOVERRIDES="mscoree,mshtml=")


def boot(folder):
    """Wine's own files, made before the first check: a program that makes them along sometimes ends with 1 and no word."""
    for number in range(3):
        prefix = pathlib.Path(folder) / f"prefix{number}"
        environment = wine_environment(prefix)
        try:
            for call in (["wineboot", "--init"], ["wineserver", "--wait"]):
                subprocess.run(call, env=environment, check=True, timeout=180)
            return prefix
        except subprocess.SubprocessError as error:
            print(f"try {number + 1} of 3: {error}", flush=True)
            subprocess.run(["wineserver", "--kill"], env=environment, check=False)
    sys.exit("error: Wine cannot be started")


class Bench:
    """A folder with models, and the two programs."""

    def __init__(self, folder, prefix, program, native):
        self.folder, self.program, self.native = folder, program, native
        self.environment = wine_environment(prefix)

    def run(self, *words, program=None, stdin=subprocess.DEVNULL, seconds=60):
        call = [program] if program else ["wine", str(self.program)]
        ran = subprocess.run(call + [str(word) for word in words], cwd=self.folder, env=self.environment, stdin=stdin,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=seconds)
        text = (ran.stdout + ran.stderr).decode(errors="replace").replace("\r\n", "\n")
        # Debian's script says at every start that there is no Wine for 32 bits.
        lines = text.splitlines()
        if lines and lines[0].startswith("it looks like wine32 is missing"):
            lines = lines[4:]
        return ran.returncode, "\n".join(lines)

    def run_ok(self, *words, **options):
        status, text = self.run(*words, **options)
        assert status == 0, f"{words}: exit status {status}\n{text}"
        return text

    def refused(self, *words, status=1, says=(), **options):
        got, text = self.run(*words, **options)
        assert got == status, f"{words}: exit status {got}\n{text}"
        for word in says:
            assert word in text, f"{words}: '{word}' is not in\n{text}"

    def model(self, name, source=HUMAN):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, path)
        return path

    def names(self, name="."):
        return sorted(path.name for path in (self.folder / name).iterdir())

    def like_here(self, output, *words):
        """Checks that Wine's program writes the same file as this system's program."""
        if self.native is None:
            return
        here = self.folder / "here.osim"
        assert self.run(*words, "-o", here, "--force", program=self.native)[0] == 0
        assert here.read_bytes() == (self.folder / output).read_bytes(), f"{output} is not what this system writes"
        here.unlink()

    def windows(self, path):
        return "Z:" + str(path).replace("/", "\\")


def starts(bench):
    print(bench.run_ok("--version", seconds=180))


def blanks_and_umlauts(bench):
    bench.model("Mäuse & Co/my model ß.osim")
    bench.run_ok(r"Mäuse & Co\my model ß.osim", "--target-mass", "500", "-o", r"Öl\größer als groß.osim")
    bench.like_here("Öl/größer als groß.osim", "Mäuse & Co/my model ß.osim", "--target-mass", "500")
    bench.run_ok("inspect", "Mäuse & Co/my model ß.osim")
    bench.refused("inspect", "Mäuse", "&", "Co/my", "model", "ß.osim", says=["quotes"])


def servers_and_long_names(bench):
    bench.refused("inspect", r"\\server\share\model.osim", says=["error: "], seconds=120)
    path = bench.model("model.osim")
    bench.run_ok("inspect", "\\\\?\\" + bench.windows(path))
    bench.run_ok(bench.windows(path), "--target-mass", "500", "-o", bench.windows(bench.folder / "absolute.osim"))
    bench.like_here("absolute.osim", "model.osim", "--target-mass", "500")
    deep = pathlib.Path(*["a folder with quite a long name " + "x" * 30 for _ in range(5)])
    long = bench.model(deep / "model.osim")
    assert len(str(long)) > 300
    for name in [deep / "model.osim", "\\\\?\\" + bench.windows(long)]:
        bench.run_ok("inspect", str(name).replace("/", "\\"))
    bench.run_ok(str(deep / "model.osim").replace("/", "\\"), "--target-mass", "500", "--in-place")
    assert bench.names(deep) == ["model.osim", "model.osim.bak"], bench.names(deep)


def in_place(bench):
    before = bench.model("model.osim").read_bytes()
    bench.run_ok("model.osim", "--target-mass", "500", "--in-place")
    assert (bench.folder / "model.osim.bak").read_bytes() == before
    bench.like_here("model.osim", "model.osim.bak", "--target-mass", "500")
    changed = (bench.folder / "model.osim").read_bytes()
    bench.run_ok("model.osim", "--target-mass", "400", "--in-place")
    assert (bench.folder / "model.osim.bak2").read_bytes() == changed
    assert bench.names() == ["model.osim", "model.osim.bak", "model.osim.bak2"], bench.names()
    (bench.folder / "model.osim").chmod(0o444)
    bench.refused("model.osim", "--target-mass", "300", "--in-place", says=["write-protected"])
    bench.refused("model.osim", "--target-mass", "300", "-o", "model.osim.bak", says=["exists already"])


def folders_and_leftovers(bench):
    for name in ["lib/even/a.osim", "lib/odd/b.osim", "lib/c.OSIM"]:
        bench.model(name)
    call = ["lib", "--target-mass", "500", "-d", "out", "--summary", r"notes\done.csv", "--jobs", "2"]
    assert "3 written" in bench.run_ok(*call)
    for name in ["even/a.osim", "odd/b.osim", "c.OSIM"]:
        bench.like_here(f"out/{name}", f"lib/{name}", "--target-mass", "500")
    assert "3 done before" in bench.run_ok(*call, "--resume")
    assert bench.names("notes") == ["done.csv"]
    # The program's own name of this computer, from a run that is killed while it writes.
    host = os.uname().nodename.split(".")[0]
    plain = "".join(c if c.isalnum() or c in "._" else "_" for c in host)[:64]
    leftover = bench.folder / f"out/even/.osim-contact-scale-{plain}-999999-abcdef.tmp"
    other = bench.folder / "out/even/.osim-contact-scale-another.computer-999999-abcdef.tmp"
    leftover.write_text("half a model")
    other.write_text("half a model")
    bench.run_ok(*call, "--force")
    assert other.exists() and not leftover.exists(), "what a process that is gone left behind goes, nothing else"
    bench.refused("lib", "--target-mass", "500", "-d", "OUT", "-o", "x.osim", status=2)


def sweeps(bench):
    bench.model("model.osim")
    bench.run_ok("sweep", "model.osim", "--grid", "stiffness=x0.5,x1,x2", "-d", "variants")
    names = bench.names("variants")
    assert sum(name.endswith(".osim") for name in names) == 3, names
    assert not any(name.endswith(".tmp") for name in names), names
    bench.refused("sweep", "model.osim", "--grid", "stiffness=x0.5,x1,x2", "-d", "variants", status=2, says=["exist already"])
    # Two shares, and the call that makes the whole of them: their tables are gone, and all is as if one call had made it.
    call = ["sweep", "model.osim", "--grid", "stiffness=x0.5,x1,x2", "-d", "shares"]
    for share in ("1/2", "2/2"):
        bench.run_ok(*call, "--shard", share)
    bench.run_ok(*call, "--resume")
    contents = [{path.name: path.read_bytes() for path in (bench.folder / name).iterdir()} for name in ("variants", "shares")]
    assert contents[0] == contents[1], bench.names("shares")


def goes_on(bench):
    """A sweep and a summary that a killed run left in the middle; and what another run is writing."""
    bench.model("model.osim")
    call = ["sweep", "model.osim", "--grid", "stiffness=x0.5,x1,x2", "-d", "variants"]
    bench.run_ok(*call)
    [table] = [name for name in bench.names("variants") if name.endswith(".csv")]
    table = bench.folder / "variants" / table
    lines = table.read_text().splitlines(keepends=True)
    # As if it had been killed after the first variant: the others, and the table, are not there.
    for name in [name for name in bench.names("variants") if name.endswith(".osim")][1:]:
        (bench.folder / "variants" / name).unlink()
    written = {path.name: path.read_bytes() for path in table.parent.iterdir()}
    table.unlink()
    columns = lines[0].rstrip("\n").split(",")
    [first] = [line.split(",") for line in lines[1:] if line.split(",")[columns.index("file")] in written]
    row = ",".join(first[columns.index(column)] for column in ("file", "sha256"))
    table.with_name(table.name + ".partial").write_text(f"file,sha256\n{row}\ncut o")
    bench.run_ok(*call, "--resume")
    assert table.read_text().splitlines(keepends=True) == lines
    assert not (table.with_name(table.name + ".partial")).exists()
    summary = ["model.osim", "--target-mass", "500", "-d", "out", "--summary", "done.csv"]
    bench.run_ok(*summary)
    text = (bench.folder / "done.csv").read_text()
    (bench.folder / "done.csv").rename(bench.folder / "done.csv.partial")
    with open(bench.folder / "done.csv.partial", "a") as partial:
        partial.write("cut o")
    bench.run_ok(*summary, "--resume")
    assert (bench.folder / "done.csv").read_text() == text
    assert not (bench.folder / "done.csv.partial").exists()


def one_summary_for_two_runs(bench):
    """A second run finds the first one working, because its model comes slowly through a pipe."""
    bench.model("model.osim")
    call = ["-", "--target-mass", "500", "-o", "one.osim", "--summary", "done.csv"]
    first = subprocess.Popen(["wine", str(bench.program), *call], cwd=bench.folder, env=bench.environment,
                             stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        end = time.monotonic() + 60
        while not (bench.folder / "done.csv.partial").exists() and time.monotonic() < end:
            time.sleep(0.05)
        bench.refused("model.osim", "--target-mass", "500", "-o", "two.osim", "--summary", "done.csv", "--force",
                      status=3, says=["is being written by another run"])
        text = first.communicate((bench.folder / "model.osim").read_bytes(), timeout=60)[0]
        assert first.returncode == 0, text
    finally:
        if first.poll() is None:
            first.kill()
    assert bench.names() == ["done.csv", "model.osim", "one.osim"], bench.names()


def tables(bench):
    bench.model("model.osim")
    (bench.folder / "rows.csv").write_text("model,target-mass,output\nmodel.osim,500,new.osim\n")
    bench.run_ok("batch", "rows.csv", "-d", ".")
    bench.like_here("new.osim", "model.osim", "--target-mass", "500")


def devices(bench):
    text = INCLUDES.read_text()
    for name in ["NUL", "CON", "aux.xml", r"\\.\COM1", r"\\.\pipe\nobody"]:
        (bench.folder / "model.osim").write_text(text.replace("standalone_ForceSet.xml", name))
        bench.refused("inspect", "model.osim", says=["this is a device"])
    bench.model("lib/comb.osim")
    bench.run_ok("inspect", r"lib\comb.osim")
    (bench.folder / "folder.osim.d").mkdir()
    bench.refused("transfer", "model.osim", "--from", "folder.osim.d", says=["error: "])


def unit_tests(bench):
    """Runs the unit tests of file access, some of which are only for Windows."""
    tests = max(bench.program.parent.glob("deps/osim_library-*.exe"), key=lambda path: path.stat().st_mtime)
    shutil.copy(bench.program.parent / "bcryptprimitives.dll", tests.parent)
    bench.run_ok("wine", tests, "--test-threads=1", program="env", seconds=300)


CHECKS = [starts, blanks_and_umlauts, servers_and_long_names, in_place, folders_and_leftovers, sweeps, goes_on,
          one_summary_for_two_runs, tables, devices, unit_tests]


def run_under_wine(program):
    native = next((TARGET / kind / "osim-contact-scale" for kind in ("debug", "release")
                   if (TARGET / kind / "osim-contact-scale").exists()), None)
    if native is None:
        print("skipped: comparison with this system's program: it is not built")
    failed = []
    with tempfile.TemporaryDirectory(prefix="wine-") as place:
        prefix = boot(place)
        for check in CHECKS:
            with tempfile.TemporaryDirectory(prefix="windows-") as folder:
                bench = Bench(pathlib.Path(folder), prefix, program, native)
                try:
                    check(bench)
                    print(f"{check.__name__}: ok", flush=True)
                except (AssertionError, subprocess.TimeoutExpired) as error:
                    failed.append(check.__name__)
                    print(f"{check.__name__}: FAILED: {error}", flush=True)
        subprocess.run(["wineserver", "-k"], env=wine_environment(prefix), check=False)
    print(f"{len(CHECKS) - len(failed)} passed, {len(failed)} failed")
    return not failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--no-macos", action="store_true")
    options = parser.parse_args()
    missing = [tool for tool in (COMPILER, "x86_64-w64-mingw32-gcc", "wine") if shutil.which(tool) is None]
    if missing:
        sys.exit(f"error: {', '.join(missing)}: dev/install.sh windows")
    subprocess.run([COMPILER, "--version"], check=True)
    if not options.no_macos:
        cargo("check", MACOS, "--workspace")
    cargo("build", WINDOWS, "--package", "osim-contact-scale")
    cargo("test", WINDOWS, "--package", "osim-library", "--lib", "--no-run")
    program = OTHER / WINDOWS / "debug/osim-contact-scale.exe"
    build_dll(program.parent)
    sys.exit(0 if run_under_wine(program) else 1)


if __name__ == "__main__":
    main()
