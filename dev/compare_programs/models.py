"""Calls for every model: each verb with the options that matter most, and, in turn, with all the others.

`{m}` stands for the model's name, `{scales}` for factors of its feet. The language of the lines: `calls.py`.
"""

import re
from collections.abc import Iterator
from pathlib import Path

from calls import Case
from store import Store

ALWAYS = r"""
{m}
inspect {m}
inspect {m} --format json --stance-limbs 2
inspect {m} --report page.html --impact-speed 0.3
check {m}
check {m} --format json --deny warn
check {m} --report page.html --stance-limbs 2
{m} --target-mass 1190
{m} --target-mass 500 --contacts-mass 62 --dry-run --diff
rescale {m} --target-mass 0.0209 --format json -o out.osim
{m} --target-mass 500 --contacts-mass 75 -d out --format lines --summary done.csv && {m} --target-mass 500 --contacts-mass 75 -d out --format lines --summary done.csv --resume
{m} --target-mass 80 --contacts-mass 75 --radius keep --dissipation-by mass -o -
{m} --target-mass 80 --radius 0.05 --level --friction --dry-run --format json
{m} --target-mass 500 --contacts-mass 75 --in-place && {m} --target-mass 70 --in-place && inspect {m}
{m} --target-mass 500 --contacts-mass 62 --report page.html --quiet
- --target-mass 500 --contacts-mass 62 < {m}
transfer {m} --from falisse2022 --dry-run
transfer {m} --from falisse2022 --spheres 4 --mass 70 -o out.osim
transfer {m} --from human.osim --stance-limbs 2 --format json --dry-run
transfer {m} --from human.osim --radius isometric --spheres 3 --reference-spheres 6 --report page.html
:copy {m} same.osim && transfer {m} --from same.osim --follow-bodies {scales} --spheres 2 --reference-spheres 2 --mass 70 --level --format json
design {m} --indentation 0.16 --dry-run
design {m} --indentation 0.16 --restitution 0.9 --constant-indentation 0.05 --state-width 0.3 --speed-width 0.3 --spheres 2 --mass 70 -o out.osim --diff
design {m} --radius x1.25 --format json
set {m} stiffness=x2 dissipation=1.5 --diff
set {m} radius=0.05 static_friction=0.9 --in-place && set {m} stiffness=x2 --in-place && set {m} stiffness=x2 --in-place && check {m}
drop-test {m}
drop-test {m} --spheres 2 --mass 70 --gravity 9.81 --samples 21 --format json
plot force {m} -o figure.svg
sweep {m} --grid stiffness=x0.5,2e6 --grid dissipation=0.5,x2
sweep {m} --ladder 3 --indentation 0.16 --restitution 0.9 --spheres 2 --mass 70 -d out.sweep --format json
:put m.csv 'model,target-mass,set,from,verb,indentation,spheres,output\n{m},500,,,,,,a.osim\n{m},,stiffness=x2,,,,,b.osim\n{m},,,falisse2022,,,4,c.osim\n{m},,,,design,0.16,4,d.osim\n' && batch m.csv --summary s.ndjson
"""

SOMETIMES = r"""
inspect {m} --format csv --spheres 2 --mass 80
check {m} --format csv --spheres 2 --mass 80
plot drop {m} --spheres 2 --mass 70 --gravity 9.81 -o -
transfer human.osim --from {m} --reference-spheres 2 --dry-run
{m} --format json
{m} --report page.html --spheres 2
inspect {m} --from generic.osim
inspect {m} --from generic.osim --body-scale-file applied.xml --format json
:copy {m} same.osim && inspect {m} --from same.osim --report page.html
inspect {m} --select *_r* --format json
inspect {m} --exclude *_l* --skip-disabled
inspect {m} --contacts-mass 70 --exclude-body *_r --format json
inspect - --format json < {m}
inspect {m} --mass 80 --stance-limbs 2 --report page.html --quiet
inspect {m} nowhere.osim human.osim --format csv
check {m} --contacts-mass 70
check {m} --select *_r* --spheres 1 --format json
check {m} --exclude *_l* --impact-speed 1 --format csv
check {m} human.osim nowhere.osim
check - --spheres 2 < {m}
check {m} --mass 0.02 --exclude-body toes* --deny warn
check {m} human.osim --report page.html --format json
{m} --target-mass 62
{m} --target-mass 500 --only stiffness,dissipation --contacts-mass 70
{m} --target-mass 500 --only radius --contacts-mass 70 --format json
{m} --target-mass 500 --keep radius --no-note --contacts-mass 70 --in-place --no-backup
{m} --target-mass 500 --keep dissipation,hunt_crossley_smoothing --contacts-mass 70 --dry-run --format lines
{m} --target-mass 500 --select *_r* --contacts-mass 70 -o out.osim && out.osim --target-mass 80
{m} --target-mass 500 --exclude *_l* --contacts-mass 70 --format json --diff
{m} --target-mass 500 --skip-disabled --contacts-mass 70 --diff
{m} --target-mass 500 --mass 70 --exclude-body toes* --dry-run
{m} --target-mass 500 --contacts-mass 62 --target-gravity 1.62
{m} --target-mass 500 --contacts-mass 62 --target-gravity 1.62 --contacts-gravity 9.8 --dry-run --format json
{m} --target-mass 62 --contacts-mass 62 --target-gravity 3.71 -o mars.osim && mars.osim --target-mass 62 --target-gravity 9.81 --diff && inspect mars.osim
{m} --target-mass 500 --contacts-mass 62 --radius x1.5 --level
{m} --target-mass 500 --contacts-mass 62 --radius isometric --level --level-axis z --format json
{m} --target-mass 500 --contacts-mass 62 --level --level-axis -y --diff --dry-run
{m} --target-mass 500 --contacts-mass 62 --friction --in-place
{m} --target-mass 500 --contacts-mass 62 --only transition_velocity,viscous_friction
{m} --target-mass 62.05 --contacts-mass 62 -o copy.osim
{m} --target-mass 500 --contacts-mass 62 --quiet
{m} --target-mass 500 --contacts-mass 62 --no-note && {m} --target-mass 500 --contacts-mass 62 && {m} --target-mass 70 --contacts-mass 62 --force
{m} human.osim --target-mass 500 --contacts-mass 62 -d out --summary done.ndjson && {m} human.osim --target-mass 500 --contacts-mass 62 -d out --summary done.ndjson --resume --format json
{m} human.osim nowhere.osim --target-mass 500 --contacts-mass 62 -d out --report page.html --summary done.csv
:mkdir lib2 && :copy {m} lib2/a.osim && lib2 --target-mass 500 --contacts-mass 70 -d out --format table
:mkdir lib2 && :copy {m} lib2/a.osim && :copy {m} lib2/b.osim && lib2 --target-mass 500 --contacts-mass 70 --shard 1/2 -d out --summary s.csv
- --target-mass 500 --contacts-mass 62 -o out.osim --format json < {m}
:put F_out.so compiled && {m} --target-mass 500 --contacts-mass 62 -o out.osim
transfer {m} --from human.osim
transfer {m} --from human.osim --reference-sphere s1_r --spheres 2 --in-place
transfer {m} --from unlike.osim --dry-run
transfer {m} --from unlike.osim --reference-sphere heel_r --spheres 2 --diff
transfer {m} --from generic_hunt.osim --spheres 2 --mass 70
transfer {m} --from lab_heel --presets both.toml --spheres 2 --mass 70 --format json
transfer {m} --from lab_toe --presets both.toml --level --radius isometric --dry-run
transfer {m} --from falisse2022 --rule predsim --height-ratio 0.9 --spheres 2 --mass 70
transfer {m} --from generic.osim --follow-bodies --dry-run
transfer {m} --from generic.osim --follow-bodies --moved-spheres replace --rule predsim --radius-axis y
:copy {m} same.osim && transfer {m} --from same.osim --follow-bodies {scales} --moved-spheres keep --mass 50 --spheres 2 --reference-spheres 2 -o out.osim
:copy {m} same.osim && transfer {m} --from same.osim --spheres 2 --reference-spheres 3 --mass 50 --diff
:copy {m} same.osim && transfer {m} --from same.osim --follow-bodies {scales} --rule predsim --radius-axis z --mass 50 --spheres 2 --reference-spheres 2 --strict
:copy {m} same.osim && transfer {m} --from same.osim --follow-bodies {scales} --dry-run
transfer {m} --from falisse2022 --radius 0.02 --spheres 6 --reference-mass 75 --report page.html
transfer {m} --from human.osim --reference-mass 75 --reference-gravity 1.62 --reference-spheres 3 --spheres 2 --target-gravity 1.62
transfer {m} --from human.osim --reference-select *_r --select *_r* --spheres 2 --quiet
transfer {m} --from emu.osim --friction --dissipation-by mass --spheres 2 --only dissipation,transition_velocity
transfer emu.osim --from {m} --reference-spheres 2 --reference-mass 70 --radius isometric -o out.osim
transfer - --from falisse2022 --spheres 2 --mass 70 < {m}
design {m} --restitution 0.9
design {m} --restitution 0.8 --impact-speed 0.5 --format json
design {m} --young 1e5 --poisson 0.49 --in-place
design {m} --indentation 0.1 --radius 0.04 --spheres 2 --load 700 --dry-run
design {m} --indentation 0.1 --contact-stiffness 20000 --spheres 2 --mass 70 --body-weights 2.5
design {m} --constant-indentation 0.1 --state-width 0.2 --threshold 0.01 --diff --dry-run
design {m} --speed-width 0.2 --select *_r* -o out.osim --report page.html
design {m} --indentation 0.16 --stance-limbs 2 --gravity 1.62 -d out --summary done.csv --quiet
design - --indentation 0.16 --spheres 3 --mass 50 < {m}
set {m} dissipation=0 hertz_smoothing=250 --dry-run --format json
set {m} stiffness=x3 --select *_r* --report page.html
set {m} constant_contact_force=x4 hunt_crossley_smoothing=40 transition_velocity=0.1 viscous_friction=0.4 -o out.osim
set {m} radius=x1.25 dynamic_friction=0.7 --skip-disabled --no-note --diff --in-place --no-backup
set {m} stiffness=2e6 -d out --summary done.csv && set {m} stiffness=2e6 -d out --summary done.csv --resume
set {m} stiffness=0
set - stiffness=x2 --quiet < {m}
drop-test {m} --compare falisse2022
drop-test {m} --compare human.osim --compare-spheres 6 --spheres 2 --mass 70 --gravity 9.81
drop-test {m} --height 0.05 --duration 0.5 --samples 11 --format csv --spheres 2
drop-test {m} --height x1 --stance-limbs 2 --select *_r* --format json --samples 5
drop-test {m} --mass 70 --spheres 3 --gravity 1.62 --duration 5
drop-test human.osim --compare {m} --compare-spheres 2
plot force {m} --target-mass 1190 --spheres 2 --mass 70 --gravity 9.81 -o figure.svg --axes real
plot force {m} human.osim --spheres 2 -o - --title 'Two & <more>'
plot state {m} -o figure.svg
plot state {m} --spheres 2 --mass 70 --axes dimensionless -o -
plot loop {m} --spheres 2 --mass 70 --gravity 9.81 --height x0.5 -o figure.svg
plot drop {m} --duration 0.5 --height 0.02 --target-mass 5 -o figure.svg
plot sweep {m} --spheres 2 --mass 70 --gravity 9.81 --stiffness x0.1..x10/7 --dissipation 0.1..4/5 -o figure.svg
plot sweep {m} --quantity restitution --stiffness 1e5..1e7/5 --dissipation x0.1..x4/5 -o -
sweep {m} --grid indentation=0.05,0.16 --grid restitution=0.8 --spheres 2 --mass 70 -d out --no-note
sweep {m} --grid target-mass=5,500 --contacts-mass 70 --dry-run --format json
sweep {m} --grid radius=x0.5..x2/3 --select *_r* --jobs 1 --quiet
sweep {m} --ladder 3 --indentation 0.16 --soft 2 --dry-run
:put m.csv 'model,set,in-place\n{m},stiffness=x2,yes\n' && batch m.csv --format json --report page.html
:put m.csv 'model;target-mass;contacts-mass;radius\n{m};0,5;62;x1,5\n' && batch m.csv -d out --diff && batch m.csv -d out --force --quiet
"""

# Of `SOMETIMES`, each model has one line in so many; of `ALWAYS`, a broken model has one in so many.
EVERY, EVERY_OF_BROKEN = 16, 3
SPHERE = re.compile(rb"<ContactSphere\b.*?</ContactSphere>", re.DOTALL)
BODY = re.compile(rb"/bodyset/([\w.-]+)|<body_name>\s*([\w.-]+)")


def lines(text: str) -> list[str]:
    """The calls of a table; lines that begin with `#` are remarks."""
    found = (line.strip() for line in text.splitlines())
    return [line for line in found if line and not line.startswith("#")]


def cases(store: Store) -> Iterator[Case]:
    """The cases of every model."""
    always, sometimes = lines(ALWAYS), lines(SOMETIMES)
    for number, model in enumerate(store.models):
        path = store.files[model]
        broken = isinstance(path, Path) and path.parent.name == "bad"
        for line in always[number % EVERY_OF_BROKEN :: EVERY_OF_BROKEN] if broken else always:
            yield store.case("models", filled(store, line, model))
        for line in sometimes[number % EVERY :: EVERY]:
            yield store.case("models in turn", filled(store, line, model))


def filled(store: Store, line: str, model: str) -> str:
    """The call for one model."""
    line = line.replace("{m}", model)
    return line.replace("{scales}", scales(store, model)) if "{scales}" in line else line


def scales(store: Store, model: str) -> str:
    """How each body that carries a contact sphere was scaled, as options."""
    found = {first or second for text in SPHERE.findall(store.read(model)) for first, second in BODY.findall(text)}
    return " ".join(f"--body-scale {body.decode()}=1.1,1,0.9" for body in sorted(found) if body != b"ground")
