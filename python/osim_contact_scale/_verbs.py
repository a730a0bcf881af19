"""The verbs as functions. Written by dev/generate_python.py from the schemas of requests: do not edit."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from typing import Literal, overload

from . import _run
from ._answers import DesignSheet, DropTest, Explanation, Fit, Motion, Presets, Reproduction
from ._figure import Figure
from ._option_names import Property, Question
from ._result import Result
from ._survey import Check, Inspection
from ._sweep import Sweep
from .types import Polars, PolarsTable, Progress, Source, Sources, StrPath, Table, TableLike

__all__ = [
    "add",
    "check",
    "convert",
    "design",
    "drop_test",
    "explain",
    "fit",
    "inspect",
    "motion",
    "note",
    "plot",
    "presets",
    "remove",
    "reproduce",
    "rescale",
    "rescale_many",
    "sweep",
    "transfer",
]

def add(
    source: Source,
    /,
    *,
    from_: Source | None = None,
    contacts: StrPath | None = None,
    default_pose: bool = False,
    feet: str | Sequence[str] | None = None,
    count: int | None = None,
    pad: float | None = None,
    geometry_dir: StrPath | None = None,
    mirror: Literal["z"] | None = None,
    class_: Literal["smooth", "hunt-crossley"] | None = None,
    friction: bool = False,
    radius: float | str | None = None,
    body_scale: str | Sequence[str] | Mapping[str, float | Sequence[float]] | None = None,
    body_map: str | Sequence[str] | None = None,
    level: bool = False,
    replace: bool = False,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    indentation: float | None = None,
    young: float | None = None,
    poisson: float | None = None,
    restitution: float | None = None,
    impact_speed: float | None = None,
    constant_indentation: float | None = None,
    state_width: float | None = None,
    speed_width: float | None = None,
    threshold: float | None = None,
    static_friction: float | None = None,
    dynamic_friction: float | None = None,
    viscous_friction: float | None = None,
    transition_velocity: float | None = None,
    load: float | None = None,
    body_weights: float | None = None,
    gravity: float | None = None,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    reference_mass: float | None = None,
    reference_spheres: int | None = None,
    reference_gravity: float | None = None,
    reference_select: str | Sequence[str] | None = None,
    reference_sphere: str | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
) -> Result:
    """Gives a model that has no foot contacts those of another model or of a preset, of a table, or spheres under its bones.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    from_ : path, bytes or opensim.Model, optional
        Where the contacts come from: a model, or a preset with places: falisse2022, dhondt2024, moco-2d-gait.
    contacts : path, optional
        Where the spheres are: a table with name, body, x, y, z [m, in the body's frame] and perhaps radius, or
        MuSkeMo's export.
    default_pose : bool, optional
        Take places that the table has in ground only as those of the default pose.
    feet : str or list of str, optional
        Lay spheres under the meshes of these bodies, which touch the ground.
    count : int, optional
        Spheres under each foot.
    pad : float, optional
        How far below the lowest bone point the sole is, m: bones have no skin.
    geometry_dir : path, optional
        A folder with the bones' meshes, beside that of the model and its Geometry.
    mirror : {"z"}, optional
        If the reference has one side only: make the other side, too, mirrored in this axis.
    class_ : {"smooth", "hunt-crossley"}, optional
        Class of the new forces [default: the reference's]
    friction : bool, optional
        Scale transition_velocity and viscous_friction of the reference too (an extension of the paper)
    radius : float or str, optional
        Radii: isometric (R ~ M^1/3), follow (with the factors of the bodies), or a radius in metres.
    body_scale : str or list of str or dict, optional
        Factors of a body against the reference's (or one, BODY=f); one or several in a list.
    body_map : str or list of str, optional
        A body of the reference, and the one that takes its spheres here; one or several in a list.
    level : bool, optional
        Move spheres down until all spheres of a foot are as low as its lowest one, at the default pose.
    replace : bool, optional
        Take the model's own foot contacts out first.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    indentation : float, optional
        Relative indentation x/R under the load, 0 to 1 (11)
    young : float, optional
        Young's modulus, N/m2 (A.1, A.5)
    poisson : float, optional
        Poisson's ratio.
    restitution : float, optional
        Coefficient of restitution, 0 to 1 (13)
    impact_speed : float, optional
        Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    constant_indentation : float, optional
        Constant indentation over radius, for constant_contact_force (C.2)
    state_width : float, optional
        Width of the contact transition over radius, for hertz_smoothing (C.8)
    speed_width : float, optional
        Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)
    threshold : float, optional
        Threshold t that the widths refer to: from t to 1 - t.
    static_friction : float, optional
        Static friction of the new forces [default: the reference's, else OpenSim's]
    dynamic_friction : float, optional
        Their dynamic friction [default: the reference's, else OpenSim's]
    viscous_friction : float, optional
        Their viscous friction, s/m [default: the reference's, else OpenSim's]
    transition_velocity : float, optional
        Their transition velocity, m/s [default: the reference's, else OpenSim's]
    load : float, optional
        Total load on all spheres, N.
    body_weights : float, optional
        The load in body weights [default: 1 where a mass is known]
    gravity : float, optional
        Gravity, m/s2 [default: the model's, else 9.80665]
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    reference_mass : float, optional
        Mass its contacts are made for, kg [default: its note, else its bodies]
    reference_spheres : int, optional
        Its spheres that share the body weight [default: as found per limb]
    reference_gravity : float, optional
        Its gravity, m/s2 [default: its note's, else its own]: if given, contacts are scaled from it to
        `target_gravity`.
    reference_select : str or list of str, optional
        Only its forces with such a name; one or several in a list.
    reference_sphere : str, optional
        Take contact and isometric radius of this sphere for all.
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> len(ocs.add("fixtures/feet/human_40000.osim", from_="fixtures/table1/human_62kg_smooth_sphere.osim", radius="isometric").objects)
    25
    """
    keywords = {"from": from_, "contacts": contacts, "default_pose": default_pose or None, "feet": feet, "count": count, "pad": pad, "geometry_dir": geometry_dir, "mirror": mirror, "class": class_, "friction": friction or None, "radius": radius, "body_scale": body_scale, "body_map": body_map, "level": level or None, "replace": replace or None, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "indentation": indentation, "young": young, "poisson": poisson, "restitution": restitution, "impact_speed": impact_speed, "constant_indentation": constant_indentation, "state_width": state_width, "speed_width": speed_width, "threshold": threshold, "static_friction": static_friction, "dynamic_friction": dynamic_friction, "viscous_friction": viscous_friction, "transition_velocity": transition_velocity, "load": load, "body_weights": body_weights, "gravity": gravity, "spheres": spheres, "stance_limbs": stance_limbs, "reference_mass": reference_mass, "reference_spheres": reference_spheres, "reference_gravity": reference_gravity, "reference_select": reference_select, "reference_sphere": reference_sphere, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "no_note": no_note or None, "yes": yes}
    return _run.plan("add", source, keywords)


@overload
def rescale_many(table: PolarsTable, /, *, keep: bool | str | Sequence[Hashable] = False, output_dir: StrPath | None = None, in_place: bool = False, no_backup: bool = False, force: bool = False, no_note: bool = False, allow_outside: bool = False, dry_run: bool = False, report: StrPath | None = None, jobs: int | None = None, summary: StrPath | None = None, resume: bool = False, shard: str | None = None, yes: Question | Sequence[Question] | None = None, progress: Progress = False) -> PolarsTable: ...
@overload
def rescale_many(table: StrPath | TableLike, /, *, keep: bool | str | Sequence[Hashable] = False, output_dir: StrPath | None = None, in_place: bool = False, no_backup: bool = False, force: bool = False, no_note: bool = False, allow_outside: bool = False, dry_run: bool = False, report: StrPath | None = None, jobs: int | None = None, summary: StrPath | None = None, resume: bool = False, shard: str | None = None, yes: Question | Sequence[Question] | None = None, progress: Progress = False) -> Table: ...
def rescale_many(
    table: StrPath | TableLike | Polars,
    /,
    *,
    keep: bool | str | Sequence[Hashable] = False,
    output_dir: StrPath | None = None,
    in_place: bool = False,
    no_backup: bool = False,
    force: bool = False,
    no_note: bool = False,
    allow_outside: bool = False,
    dry_run: bool = False,
    report: StrPath | None = None,
    jobs: int | None = None,
    summary: StrPath | None = None,
    resume: bool = False,
    shard: str | None = None,
    yes: Question | Sequence[Question] | None = None,
    progress: Progress = False,
) -> Table | Polars:
    """One row per model; columns are named like the long options of rescale, transfer, design and set.

    Parameters
    ----------
    table : path or table
        A DataFrame of pandas, polars or another library, a dictionary of columns, a list of dictionaries, or the
        path of a table (.csv). One row per model, with columns named like the keywords of the verbs. A missing
        value is an empty cell.
    keep : bool, str or list of str, optional
        Columns of the table that are yours: `keep=["age", "site"]`, or True for all that are not options. They
        come first in the result, as they are in the table. A column whose name begins with # is yours without
        this. Any other that is not an option is an error.
    output_dir : path, optional
        Write into this folder.
    in_place : bool, optional
        Change the model itself and keep the old one as NAME.osim.bak.
    no_backup : bool, optional
        With `in_place`: keep no backup.
    force : bool, optional
        Replace existing files.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    allow_outside : bool, optional
        Let rows name files to write outside the folder of the results, or of the table.
    dry_run : bool, optional
        Write nothing, only show what would change.
    report : path, optional
        Write a page for browsers too (.html): tables, plots, findings.
    jobs : int, optional
        Models to work on at once [default: one per processor]
    summary : path, optional
        Keep a line per model in this file (.csv or .ndjson)
    resume : bool, optional
        Skip models that `summary` says are done, if nothing has changed since.
    shard : str, optional
        Only share I of N of the models, for job arrays.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    progress : bool or callable, optional
        Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model.

    Returns
    -------
    pandas.DataFrame, polars.DataFrame or list of dict
        A row for each model: the user's own columns, what was done, old and new values, errors. A DataFrame with
        the index of the table; one of polars where the table is; without pandas a list of dictionaries.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> table = [{"model": "fixtures/table1/human_62kg_smooth_sphere.osim", "target_mass": 70, "age": 31}]
    >>> ocs.rescale_many(table, keep=["age"], dry_run=True)[["age", "status", "target_mass_kg"]].values.tolist()
    [[31, 'dry-run', 70.0]]
    """
    keywords = {"output_dir": output_dir, "in_place": in_place or None, "no_backup": no_backup or None, "force": force or None, "no_note": no_note or None, "allow_outside": allow_outside or None, "dry_run": dry_run or None, "report": report, "jobs": jobs, "summary": summary, "resume": resume or None, "shard": shard, "yes": yes}
    return _run.batch(table, keep, keywords, progress)  # type: ignore[no-any-return]


def check(
    sources: Sources,
    /,
    *,
    from_: Source | None = None,
    body_scale_file: StrPath | None = None,
    moco_setup: StrPath | None = None,
    from_moco_setup: StrPath | None = None,
    motion: StrPath | None = None,
    plates: StrPath | None = None,
    loads: StrPath | None = None,
    angles: Literal["degrees", "radians"] | None = None,
    fix: bool = False,
    output: StrPath | None = None,
    output_dir: StrPath | None = None,
    in_place: bool = False,
    report: StrPath | None = None,
    force: bool = False,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    impact_speed: float | None = None,
    gravity: float | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    geometry: Source | None = None,
    model: Source | None = None,
    yes: Question | Sequence[Question] | None = None,
    jobs: int | None = None,
    progress: Progress = False,
) -> Check:
    """Compares models with the limits of the paper and the traps of the format.

    Parameters
    ----------
    sources : path or list
        One or several: paths of models or folders, bytes, results, live models.
    from_ : path, bytes or opensim.Model, optional
        The generic model this one was scaled from: whether its spheres followed, and what else follows size.
    body_scale_file : path, optional
        With `from_`: the ScaleSet that the Scale Tool applied.
    moco_setup : path, optional
        With `from_`: list what else follows size in this Moco setup (.omoco), too.
    from_moco_setup : path, optional
        With `moco_setup`: the Moco setup of the generic model, to compare with.
    motion : path, optional
        Say whether the contacts fit this motion (.mot, .sto), too.
    plates : path, optional
        With `motion`: the ground reactions that force plates measured (.mot, .sto)
    loads : path, optional
        With `motion`: OpenSim's ExternalLoads (.xml)
    angles : {"degrees", "radians"}, optional
        With `motion`: the unit of its angles, where its header does not say it.
    fix : bool, optional
        Do what the printed commands do, and check the result: with `output`, `output_dir` or `in_place`.
    output : path, optional
        Write to this file, or - [default: NAME.scaled.osim beside it]
    output_dir : path, optional
        Write into this folder.
    in_place : bool, optional
        Change the model itself and keep the old one as NAME.osim.bak.
    report : path, optional
        Write a page for browsers too (.html): tables, plots, findings.
    force : bool, optional
        Replace existing files.
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    impact_speed : float, optional
        Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    gravity : float, optional
        Gravity, m/s2 [default: the model's own]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    jobs : int, optional
        Models to work on at once [default: one per processor]
    progress : bool or callable, optional
        Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model.

    Returns
    -------
    Check
        What is wrong with them, each with its remedy.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.check("fixtures/scale_tool/scaled_smooth.osim", from_="fixtures/scale_tool/generic_smooth.osim").findings[0].code
    'spheres-left-behind'
    """
    keywords = {"from": from_, "body_scale_file": body_scale_file, "moco_setup": moco_setup, "from_moco_setup": from_moco_setup, "motion": motion, "plates": plates, "loads": loads, "angles": angles, "fix": fix or None, "output": output, "output_dir": output_dir, "in_place": in_place or None, "report": report, "force": force or None, "spheres": spheres, "stance_limbs": stance_limbs, "impact_speed": impact_speed, "gravity": gravity, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "geometry": geometry, "model": model, "yes": yes}
    return _run.survey("check", sources, keywords, jobs, progress)  # type: ignore[no-any-return]


def convert(
    source: Source,
    /,
    *,
    to: Literal["smooth", "hunt-crossley"] | None = None,
    sockets: bool = False,
    constant_contact_force: float | None = None,
    hertz_smoothing: float | None = None,
    hunt_crossley_smoothing: float | None = None,
    strict: bool = False,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
) -> Result:
    """Makes forces of one class from those of the other, one for each sphere, or connects sockets. Stiffness, dissipation, friction and transition velocity stay as they are.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    to : {"smooth", "hunt-crossley"}, optional
        The class that forces get.
    sockets : bool, optional
        Write the paths of sockets that lead nowhere, where only one component has the name in them.
    constant_contact_force : float, optional
        OpenSim's constant_contact_force of forces that had none [default: Falisse et al. (2022) at each radius
        (C.2)]
    hertz_smoothing : float, optional
        hertz_smoothing of forces that had none, 1/m [default: Falisse et al. (2022) at each radius (C.5)]
    hunt_crossley_smoothing : float, optional
        hunt_crossley_smoothing of forces that had none, s/m [default: Falisse et al. (2022) at each radius
        (C.10)]
    strict : bool, optional
        Refuse where sphere and half-space have parameters of their own that differ.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.convert("fixtures/table1/human_62kg_smooth_sphere.osim", to="hunt-crossley")
    <Result of convert: fixtures/table1/human_62kg_smooth_sphere.osim: 24 objects to change>
    """
    keywords = {"to": to, "sockets": sockets or None, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "strict": strict or None, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes}
    return _run.plan("convert", source, keywords)


@overload
def design(source: None = None, /, *, radius: float | str | None = None, indentation: float | None = None, contact_stiffness: float | None = None, young: float | None = None, poisson: float | None = None, stiffness: float | None = None, restitution: float | None = None, impact_speed: float | None = None, constant_indentation: float | None = None, state_width: float | None = None, speed_width: float | None = None, threshold: float | None = None, dimensionless_stiffness: float | None = None, stress: float | None = None, other_young: float | None = None, other_poisson: float | None = None, state_smoothing: float | None = None, speed_smoothing: float | None = None, load: float | None = None, body_weights: float | None = None, gravity: float | None = None, contacts_mass: float | None = None, mass: float | None = None, exclude_body: str | Sequence[str] | None = None, spheres: int | None = None, stance_limbs: int | None = None, select: str | Sequence[str] | None = None, exclude: str | Sequence[str] | None = None, skip_disabled: bool = False, no_note: bool = False, yes: Question | Sequence[Question] | None = None, geometry: Source | None = None, model: Source | None = None) -> DesignSheet: ...
@overload
def design(source: Source, /, *, radius: float | str | None = None, indentation: float | None = None, contact_stiffness: float | None = None, young: float | None = None, poisson: float | None = None, stiffness: float | None = None, restitution: float | None = None, impact_speed: float | None = None, constant_indentation: float | None = None, state_width: float | None = None, speed_width: float | None = None, threshold: float | None = None, dimensionless_stiffness: float | None = None, stress: float | None = None, other_young: float | None = None, other_poisson: float | None = None, state_smoothing: float | None = None, speed_smoothing: float | None = None, load: float | None = None, body_weights: float | None = None, gravity: float | None = None, contacts_mass: float | None = None, mass: float | None = None, exclude_body: str | Sequence[str] | None = None, spheres: int | None = None, stance_limbs: int | None = None, select: str | Sequence[str] | None = None, exclude: str | Sequence[str] | None = None, skip_disabled: bool = False, no_note: bool = False, yes: Question | Sequence[Question] | None = None, geometry: Source | None = None, model: Source | None = None) -> Result: ...
def design(
    source: Source | None = None,
    /,
    *,
    radius: float | str | None = None,
    indentation: float | None = None,
    contact_stiffness: float | None = None,
    young: float | None = None,
    poisson: float | None = None,
    stiffness: float | None = None,
    restitution: float | None = None,
    impact_speed: float | None = None,
    constant_indentation: float | None = None,
    state_width: float | None = None,
    speed_width: float | None = None,
    threshold: float | None = None,
    dimensionless_stiffness: float | None = None,
    stress: float | None = None,
    other_young: float | None = None,
    other_poisson: float | None = None,
    state_smoothing: float | None = None,
    speed_smoothing: float | None = None,
    load: float | None = None,
    body_weights: float | None = None,
    gravity: float | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Result | DesignSheet:
    """Finds parameters from what is wanted: indentation, stiffness, restitution.

    Parameters
    ----------
    source : path, bytes or opensim.Model, optional
        The model as for `rescale`; without one this is a calculator.
    radius : float or str, optional
        Sphere radius in metres (with models also keep or a factor like x1.5)
    indentation : float, optional
        Relative indentation x/R under the load, 0 to 1 (11)
    contact_stiffness : float, optional
        Stiffness of one sphere at that load, N/m (11 with B.2)
    young : float, optional
        Young's modulus, N/m2 (A.1, A.5)
    poisson : float, optional
        Poisson's ratio.
    stiffness : float, optional
        OpenSim's stiffness (plane strain modulus of one surface), N/m2.
    restitution : float, optional
        Coefficient of restitution, 0 to 1 (13)
    impact_speed : float, optional
        Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    constant_indentation : float, optional
        Constant indentation over radius, for constant_contact_force (C.2)
    state_width : float, optional
        Width of the contact transition over radius, for hertz_smoothing (C.8)
    speed_width : float, optional
        Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)
    threshold : float, optional
        Threshold t that the widths refer to: from t to 1 - t.
    dimensionless_stiffness : float, optional
        Dimensionless stiffness k R n/F under the load, 1.5 or more: x/R is 3/(2 K) (B.3)
    stress : float, optional
        Mean stress on the contact patch under the load, N/m2: x/R is F/(n pi R^2 stress) (15)
    other_young : float, optional
        With `young`: Young's modulus of the other surface, N/m2 [default: rigid]
    other_poisson : float, optional
        Poisson's ratio of the other surface.
    state_smoothing : float, optional
        Hertz smoothing times radius, without unit, for hertz_smoothing (C.5)
    speed_smoothing : float, optional
        Hunt-Crossley smoothing times the root of the radius, s/m^(1/2), for hunt_crossley_smoothing (C.10)
    load : float, optional
        Total load on all spheres, N.
    body_weights : float, optional
        The load in body weights [default: 1 where a mass is known]
    gravity : float, optional
        Gravity, m/s2 [default: the model's, else 9.80665]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Result | DesignSheet
        The plan, or the quantities where no model is given.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> round(ocs.design(mass=62, spheres=6, radius=0.032, indentation=0.16, gravity=9.81).stiffness)
    3281223
    >>> ocs.design("fixtures/table1/human_62kg_smooth_sphere.osim", indentation=0.16)
    <Result of design: fixtures/table1/human_62kg_smooth_sphere.osim: 12 numbers to change>
    """
    keywords = {"radius": radius, "indentation": indentation, "contact_stiffness": contact_stiffness, "young": young, "poisson": poisson, "stiffness": stiffness, "restitution": restitution, "impact_speed": impact_speed, "constant_indentation": constant_indentation, "state_width": state_width, "speed_width": speed_width, "threshold": threshold, "dimensionless_stiffness": dimensionless_stiffness, "stress": stress, "other_young": other_young, "other_poisson": other_poisson, "state_smoothing": state_smoothing, "speed_smoothing": speed_smoothing, "load": load, "body_weights": body_weights, "gravity": gravity, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "spheres": spheres, "stance_limbs": stance_limbs, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes, "geometry": geometry, "model": model}
    return _run.design(source, keywords)  # type: ignore[no-any-return]


def drop_test(
    subject: Source | None = None,
    /,
    *,
    height: float | str | None = None,
    duration: float | None = None,
    samples: int | None = None,
    compare: StrPath | None = None,
    compare_spheres: int | None = None,
    foot_mass: float | None = None,
    presets: StrPath | None = None,
    radius: float | None = None,
    stiffness: float | None = None,
    dissipation: float | None = None,
    constant_contact_force: float | None = None,
    hertz_smoothing: float | None = None,
    hunt_crossley_smoothing: float | None = None,
    gravity: float | None = None,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    geometry: Source | None = None,
    model: Source | None = None,
    yes: Question | Sequence[Question] | None = None,
) -> DropTest:
    """Lets a model fall on its contacts and shows what they do.

    Parameters
    ----------
    subject : path, bytes or opensim.Model, optional
        A model as for `rescale`, or the name of a preset.
    height : float or str, optional
        Height of the spheres' lowest points at the start: metres, or a factor of the radius like x0.25.
    duration : float, optional
        How long to follow the body, s.
    samples : int, optional
        Points of the series.
    compare : path, optional
        Say how far this drop and that of OTHER (a model or preset) lie apart in dimensionless form.
    compare_spheres : int, optional
        With `compare`: the spheres that share OTHER's weight [default: as found on one limb]
    foot_mass : float, optional
        Let a foot of this mass fall in the place of the body, kg: it is the foot that strikes the ground.
    presets : path, optional
        A file with presets of your own (TOML)
    radius : float, optional
        Sphere radius, m.
    stiffness : float, optional
        OpenSim's stiffness (plane strain modulus of one surface), N/m2.
    dissipation : float, optional
        OpenSim's dissipation, s/m.
    constant_contact_force : float, optional
        With the next two: SmoothSphereHalfSpaceForce's law, m2.
    hertz_smoothing : float, optional
        1/m.
    hunt_crossley_smoothing : float, optional
        s/m.
    gravity : float, optional
        Gravity, m/s2 [default: the model's, else 9.80665]
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.

    Returns
    -------
    DropTest
        What happens, and the motion as `series`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> round(ocs.drop_test("falisse2022").peak_force_bw, 3)
    2.492
    """
    keywords = {"height": height, "duration": duration, "samples": samples, "compare": compare, "compare_spheres": compare_spheres, "foot_mass": foot_mass, "presets": presets, "radius": radius, "stiffness": stiffness, "dissipation": dissipation, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "gravity": gravity, "spheres": spheres, "stance_limbs": stance_limbs, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "geometry": geometry, "model": model, "yes": yes}
    return _run.drop_test(subject, keywords)


def explain(
    *topics: str,
) -> list[Explanation]:
    """Explains equations, quantities, and the codes of findings and errors.

    Parameters
    ----------
    topics : str
        Equations, quantities, codes of findings and errors; none lists all.

    Returns
    -------
    list[Explanation]
        Each with its text.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.explain("13")[0].title
    'Coefficient of restitution, approximate'
    """
    return _run.explain(topics, {})


@overload
def fit(measured: StrPath | TableLike, /, *, motion: None = None, plates: StrPath | TableLike | Sequence[StrPath | TableLike] | None = None, loads: StrPath | Sequence[StrPath] | None = None, fit: Literal["stiffness", "dissipation", "height"] | Sequence[Literal["stiffness", "dissipation", "height"]] | None = None, unbounded: bool = False, height_in: Literal["floor", "spheres"] | None = None, belt: float | None = None, belt_column: str | None = None, start: float | None = None, end: float | None = None, angles: Literal["degrees", "radians"] | None = None, low_pass: float | None = None, plates_delay: float | None = None, radius: float | None = None, spheres: int | None = None, onset: Literal["fit"] | None = None, branch: Literal["both", "loading", "unloading"] | None = None, indentation_column: str | None = None, force_column: str | None = None, speed_column: str | None = None, time_column: str | None = None, indentation_unit: Literal["m", "mm", "um"] | None = None, force_unit: Literal["N", "kN", "mN"] | None = None, speed_unit: Literal["m/s", "mm/s"] | None = None, time_unit: Literal["s", "ms"] | None = None, contacts_mass: float | None = None, mass: float | None = None, exclude_body: str | Sequence[str] | None = None, select: str | Sequence[str] | None = None, exclude: str | Sequence[str] | None = None, skip_disabled: bool = False, no_note: bool = False, yes: Question | Sequence[Question] | None = None, geometry: Source | None = None, model: Source | None = None) -> Fit: ...
@overload
def fit(measured: Source, /, *, motion: StrPath | TableLike | Sequence[StrPath | TableLike], plates: StrPath | TableLike | Sequence[StrPath | TableLike] | None = None, loads: StrPath | Sequence[StrPath] | None = None, fit: Literal["stiffness", "dissipation", "height"] | Sequence[Literal["stiffness", "dissipation", "height"]] | None = None, unbounded: bool = False, height_in: Literal["floor", "spheres"] | None = None, belt: float | None = None, belt_column: str | None = None, start: float | None = None, end: float | None = None, angles: Literal["degrees", "radians"] | None = None, low_pass: float | None = None, plates_delay: float | None = None, radius: float | None = None, spheres: int | None = None, onset: Literal["fit"] | None = None, branch: Literal["both", "loading", "unloading"] | None = None, indentation_column: str | None = None, force_column: str | None = None, speed_column: str | None = None, time_column: str | None = None, indentation_unit: Literal["m", "mm", "um"] | None = None, force_unit: Literal["N", "kN", "mN"] | None = None, speed_unit: Literal["m/s", "mm/s"] | None = None, time_unit: Literal["s", "ms"] | None = None, contacts_mass: float | None = None, mass: float | None = None, exclude_body: str | Sequence[str] | None = None, select: str | Sequence[str] | None = None, exclude: str | Sequence[str] | None = None, skip_disabled: bool = False, no_note: bool = False, yes: Question | Sequence[Question] | None = None, geometry: Source | None = None, model: Source | None = None) -> Result: ...
def fit(
    measured: StrPath | TableLike | Source,
    /,
    *,
    motion: StrPath | TableLike | Sequence[StrPath | TableLike] | None = None,
    plates: StrPath | TableLike | Sequence[StrPath | TableLike] | None = None,
    loads: StrPath | Sequence[StrPath] | None = None,
    fit: Literal["stiffness", "dissipation", "height"] | Sequence[Literal["stiffness", "dissipation", "height"]] | None = None,
    unbounded: bool = False,
    height_in: Literal["floor", "spheres"] | None = None,
    belt: float | None = None,
    belt_column: str | None = None,
    start: float | None = None,
    end: float | None = None,
    angles: Literal["degrees", "radians"] | None = None,
    low_pass: float | None = None,
    plates_delay: float | None = None,
    radius: float | None = None,
    spheres: int | None = None,
    onset: Literal["fit"] | None = None,
    branch: Literal["both", "loading", "unloading"] | None = None,
    indentation_column: str | None = None,
    force_column: str | None = None,
    speed_column: str | None = None,
    time_column: str | None = None,
    indentation_unit: Literal["m", "mm", "um"] | None = None,
    force_unit: Literal["N", "kN", "mN"] | None = None,
    speed_unit: Literal["m/s", "mm/s"] | None = None,
    time_unit: Literal["s", "ms"] | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Fit | Result:
    """Finds contact parameters from a measured indentation and force, or those of a model from recordings of its gait.

    Parameters
    ----------
    measured : path or table or path, bytes or opensim.Model
        Measured indentation and force: a path (.csv), or a table with columns. With `motion`, the model as for
        `rescale`.
    motion : path or table or list of path or table, optional
        Fit the model to this motion (.mot, .sto), so that its forces are the measured ones; one or several in a
        list, for several trials.
    plates : path or table or list of path or table, optional
        Ground reactions that force plates measured (.mot, .sto); one for each motion.
    loads : path or list of path, optional
        OpenSim's ExternalLoads (.xml); one for each motion, or one for all.
    fit : {"stiffness", "dissipation", "height"} or list of {"stiffness", "dissipation", "height"}, optional
        What to fit; one or several in a list [default: stiffness, dissipation and height]
    unbounded : bool, optional
        Let spheres go deeper than their radius.
    height_in : {"floor", "spheres"}, optional
        What a fitted height moves.
    belt : float, optional
        Speed of a treadmill's belt towards -x, m/s; slip is relative to it.
    belt_column : str, optional
        Speed of a treadmill's belt from this column of each motion.
    start : float, optional
        Leave out what the motion has before this time, s.
    end : float, optional
        Leave out what the motion has after this time, s.
    angles : {"degrees", "radians"}, optional
        The unit of the motions' angles, where their headers do not say it.
    low_pass : float, optional
        Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6 is usual for
        walking)
    plates_delay : float, optional
        Delay of the plates, s: their data are moved earlier by this time.
    radius : float, optional
        Sphere radius, m.
    spheres : int, optional
        Spheres that share the measured force.
    onset : {"fit"}, optional
        Where contact begins, in metres, or fit to find it.
    branch : {"both", "loading", "unloading"}, optional
        Which part of the measurement.
    indentation_column : str, optional
        Column of the indentation.
    force_column : str, optional
        Column of the force.
    speed_column : str, optional
        Column of the speed of indentation; without it and without a time, dissipation is not fitted.
    time_column : str, optional
        Column of the time, from which the speed is taken.
    indentation_unit : {"m", "mm", "um"}, optional
        Unit of the indentation.
    force_unit : {"N", "kN", "mN"}, optional
        Unit of the force.
    speed_unit : {"m/s", "mm/s"}, optional
        Unit of the speed.
    time_unit : {"s", "ms"}, optional
        Unit of the time.
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Fit | Result
        A `Fit`: the parameters with their uncertainty. With `motion`, a `Result`: the plan for the model.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.fit("fixtures/measured/heel_pad.csv", radius=0.03, indentation_unit="mm").frame()["name"][1]
    'stiffness'
    """
    keywords = {"motion": motion, "plates": plates, "loads": loads, "fit": fit, "unbounded": unbounded or None, "height_in": height_in, "belt": belt, "belt_column": belt_column, "start": start, "end": end, "angles": angles, "low_pass": low_pass, "plates_delay": plates_delay, "radius": radius, "spheres": spheres, "onset": onset, "branch": branch, "indentation_column": indentation_column, "force_column": force_column, "speed_column": speed_column, "time_column": time_column, "indentation_unit": indentation_unit, "force_unit": force_unit, "speed_unit": speed_unit, "time_unit": time_unit, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes, "geometry": geometry, "model": model}
    return _run.fit(measured, keywords)


def inspect(
    sources: Sources,
    /,
    *,
    from_: Source | None = None,
    body_scale_file: StrPath | None = None,
    target_mass: float | None = None,
    report: StrPath | None = None,
    force: bool = False,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    impact_speed: float | None = None,
    gravity: float | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    geometry: Source | None = None,
    model: Source | None = None,
    yes: Question | Sequence[Question] | None = None,
    jobs: int | None = None,
    progress: Progress = False,
) -> Inspection:
    """Shows what contacts models have.

    Parameters
    ----------
    sources : path or list
        One or several: paths of models or folders, bytes, results, live models.
    from_ : path, bytes or opensim.Model, optional
        The generic model this one was scaled from: show each body's factors.
    body_scale_file : path, optional
        With `from_`: the ScaleSet that the Scale Tool applied.
    target_mass : float, optional
        List what else changes with body size, for a body of this mass, kg: muscles, springs, actuators.
    report : path, optional
        Write a page for browsers too (.html): tables, plots, findings.
    force : bool, optional
        Replace an existing report.
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    impact_speed : float, optional
        Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    gravity : float, optional
        Gravity, m/s2 [default: the model's own]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    jobs : int, optional
        Models to work on at once [default: one per processor]
    progress : bool or callable, optional
        Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model.

    Returns
    -------
    Inspection
        The models, their spheres and forces as tables.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.inspect("fixtures/table1/human_62kg_smooth_sphere.osim")[0]["mass_kg"]
    62.0
    """
    keywords = {"from": from_, "body_scale_file": body_scale_file, "target_mass": target_mass, "report": report, "force": force or None, "spheres": spheres, "stance_limbs": stance_limbs, "impact_speed": impact_speed, "gravity": gravity, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "geometry": geometry, "model": model, "yes": yes}
    return _run.survey("inspect", sources, keywords, jobs, progress)  # type: ignore[no-any-return]


def motion(
    source: Source,
    recording: StrPath | TableLike,
    /,
    *,
    plates: StrPath | TableLike | None = None,
    loads: StrPath | None = None,
    angles: Literal["degrees", "radians"] | None = None,
    low_pass: float | None = None,
    plates_delay: float | None = None,
    belt: float | None = None,
    belt_column: str | None = None,
    start: float | None = None,
    end: float | None = None,
    correct: StrPath | None = None,
    vertical: bool = False,
    floor: float | None = None,
    moco: StrPath | None = None,
    nmsm: StrPath | None = None,
    error: str | None = None,
    output: StrPath | None = None,
    force: bool = False,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Motion:
    """Shows what contacts do along a recorded motion, beside what force plates measured.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    recording : path or table
        Coordinates over time: a path (.mot, .sto), or a table with a column `time` and one for each coordinate,
        in rad and m.
    plates : path or table, optional
        Ground reactions that force plates measured (.mot or .sto)
    loads : path, optional
        OpenSim's ExternalLoads (.xml): which columns of the plates act on which body.
    angles : {"degrees", "radians"}, optional
        The unit of the motion's angles, where its header does not say it.
    low_pass : float, optional
        Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6 is usual for
        walking)
    plates_delay : float, optional
        Delay of the plates, s: their data are moved earlier by this time.
    belt : float, optional
        Speed of a treadmill's belt towards -x, m/s; slip is relative to it.
    belt_column : str, optional
        Speed of a treadmill's belt from this column of the motion.
    start : float, optional
        Leave out what the motion has before this time, s.
    end : float, optional
        Leave out what the motion has after this time, s.
    correct : path, optional
        Write the motion to this file (.sto, .mot) after the least correction that makes the contacts give the
        forces of the plates.
    vertical : bool, optional
        With `correct`: only forces along the normal of the floor and their centres count.
    floor : float, optional
        With `correct`: the floor is this much higher than in the model, m [default: it is found]
    moco : path, optional
        With `correct`: write what Moco needs to track the corrected motion and the plates into this folder.
    nmsm : path, optional
        With `correct`: write what NMSM's ground contact personalisation reads into this folder, not corrected.
    error : str, optional
        With `correct`: usual errors of the motion's places and angles, as in 6mm,2deg [default: these]. The
        limits of the verdict grow with the first.
    output : path, optional
        Write the model's ground reactions to this file (.sto), with its ExternalLoads beside it (.xml)
    force : bool, optional
        Replace existing files.
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Motion
        Each foot and sphere beside the plates, and all frames as `rows`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> walk = ocs.motion("fixtures/motion/walker.osim", "fixtures/motion/walk.mot")
    >>> len(walk.rows)
    964
    """
    keywords = {"plates": plates, "loads": loads, "angles": angles, "low_pass": low_pass, "plates_delay": plates_delay, "belt": belt, "belt_column": belt_column, "start": start, "end": end, "correct": correct, "vertical": vertical or None, "floor": floor, "moco": moco, "nmsm": nmsm, "error": error, "output": output, "force": force or None, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "geometry": geometry, "model": model}
    return _run.motion(source, recording, keywords)


def note(
    source: Source,
    /,
    *,
    contacts_mass: float | None = None,
    contacts_gravity: float | None = None,
    stance_limbs: int | None = None,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Result:
    """Writes into models which mass their contacts were made for, or how many limbs share the weight; no number changes.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    contacts_mass : float, optional
        Mass the contacts in the file were made for, kg.
    contacts_gravity : float, optional
        Gravity the contacts in the file were made for, m/s2 [default: the model's]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says]
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.note("fixtures/table1/human_62kg_smooth_sphere.osim", contacts_mass=60).target_mass_kg
    60.0
    """
    keywords = {"contacts_mass": contacts_mass, "contacts_gravity": contacts_gravity, "stance_limbs": stance_limbs, "no_note": no_note or None, "yes": yes, "geometry": geometry, "model": model}
    return _run.plan("note", source, keywords)


def plot(
    kind: Literal["force", "state", "loop", "drop", "sweep", "feet", "motion", "fig1", "fig4", "fig-c5"],
    *models: Source,
    target_mass: float | None = None,
    axes: Literal["dimensionless", "real"] | None = None,
    geometry_dir: StrPath | None = None,
    motion: StrPath | None = None,
    plates: StrPath | None = None,
    loads: StrPath | None = None,
    angles: Literal["degrees", "radians"] | None = None,
    presets: StrPath | None = None,
    gravity: float | None = None,
    height: float | str | None = None,
    duration: float | None = None,
    quantity: Literal["indentation", "restitution", "peak-force"] | None = None,
    stiffness: str | None = None,
    dissipation: str | None = None,
    table: StrPath | TableLike | None = None,
    value_column: str | None = None,
    x_column: str | None = None,
    y_column: str | None = None,
    value_range: str | None = None,
    title: str | None = None,
    label: str | Sequence[str] | None = None,
    width: float | None = None,
    font_size: float | None = None,
    x_range: str | None = None,
    y_range: str | None = None,
    dpi: int | None = None,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    geometry: Source | None = None,
    model: Source | None = None,
    yes: Question | Sequence[Question] | None = None,
) -> Figure:
    """Draws what contacts do.

    Parameters
    ----------
    kind : {"force", "state", "loop", "drop", "sweep", "feet", "motion", "fig1", "fig4", "fig-c5"}
        What to draw.
    models : path, bytes or opensim.Model
        Models or presets, overlaid in one figure.
    target_mass : float, optional
        Draw each contact also as it is after scaling to this mass, kg.
    axes : {"dimensionless", "real"}, optional
        Units of indentation and force [default: x/R and N; x/R and shares of the weight for several]
    geometry_dir : path, optional
        Of feet: a folder with the bones' meshes, beside the model's own and its Geometry.
    motion : path, optional
        Of motion: coordinates over time (.mot, .sto)
    plates : path, optional
        Of motion: the ground reactions that force plates measured (.mot, .sto)
    loads : path, optional
        Of motion: OpenSim's ExternalLoads (.xml)
    angles : {"degrees", "radians"}, optional
        Of motion: the unit of its angles, where its header does not say it.
    presets : path, optional
        A file with presets of your own (TOML)
    gravity : float, optional
        Gravity, m/s2 [default: the model's]
    height : float or str, optional
        Height of the spheres' lowest points at the start: metres, or a factor of the radius like x0.25.
    duration : float, optional
        How long to follow the body, s [default: 20 sqrt(R/g), of the slowest]
    quantity : {"indentation", "restitution", "peak-force"}, optional
        What the colours show.
    stiffness : str, optional
        Values of stiffness: FROM..TO/COUNT in N/m2, or factors like x0.1..x10/25.
    dissipation : str, optional
        Values of dissipation: FROM..TO/COUNT in s/m, or factors.
    table : path or table, optional
        Draw a column of this table (CSV) instead, such as a sweep's with your results in it.
    value_column : str, optional
        The table's column that is drawn.
    x_column : str, optional
        The table's column along the horizontal axis [default: the first grid_ column]
    y_column : str, optional
        The table's column along the vertical axis [default: the second grid_ column]
    value_range : str, optional
        From which value to which colours change: FROM..TO.
    title : str, optional
        Title of the figure; "" for none.
    label : str or list of str, optional
        Name of a curve, in the order of the legend; once for each.
    width : float, optional
        Width on paper, mm [default: 90, one column of a journal; 190 for several panels side by side]
    font_size : float, optional
        Size of the letters on paper, points; everything else grows with them.
    x_range : str, optional
        Limits of the horizontal axis, in its unit: FROM..TO.
    y_range : str, optional
        Limits of the vertical axis, in its unit: FROM..TO.
    dpi : int, optional
        Pixels to the inch of a PNG.
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.

    Returns
    -------
    Figure
        The figure, which a notebook shows.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.plot("drop", "falisse2022")
    <Figure: Drop test: falisse2022: show it in a notebook, or write it with save()>
    """
    keywords = {"target_mass": target_mass, "axes": axes, "geometry_dir": geometry_dir, "motion": motion, "plates": plates, "loads": loads, "angles": angles, "presets": presets, "gravity": gravity, "height": height, "duration": duration, "quantity": quantity, "stiffness": stiffness, "dissipation": dissipation, "table": table, "value_column": value_column, "x_column": x_column, "y_column": y_column, "value_range": value_range, "title": title, "label": label, "width": width, "font_size": font_size, "x_range": x_range, "y_range": y_range, "dpi": dpi, "spheres": spheres, "stance_limbs": stance_limbs, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "geometry": geometry, "model": model, "yes": yes}
    return _run.plot(kind, models, keywords)


def presets(
    name: str | None = None,
    /,
    *,
    presets: StrPath | None = None,
) -> Presets:
    """Lists presets, or shows one.

    Parameters
    ----------
    name : str, optional
        One preset; all without it.
    presets : path, optional
        A file with presets of your own (TOML)

    Returns
    -------
    Presets
        Published contacts, and one's own: a list.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.presets("falisse2022")[0].mass_kg
    62.0
    """
    keywords = {"presets": presets}
    return _run.presets(name, keywords)


def remove(
    source: Source,
    /,
    *,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
) -> Result:
    """Takes the foot contacts out of models: forces, the spheres that nothing else uses, and what was made for them.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.remove("fixtures/table1/human_62kg_smooth_sphere.osim")
    <Result of remove: fixtures/table1/human_62kg_smooth_sphere.osim: 24 objects to change>
    """
    keywords = {"select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes}
    return _run.plan("remove", source, keywords)


def reproduce() -> Reproduction:
    """Compares Table 1 of the paper with what its equations give, and draws its figures 4 and C.5.

    Returns
    -------
    Reproduction
        Table 1 of the paper, as printed and computed.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.reproduce()
    <Reproduction: numbers=42, within_last_digit=41>
    """
    return _run.reproduce()


def rescale(
    source: Source,
    /,
    *,
    target_mass: float,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    radius: float | str | None = None,
    level: bool = False,
    level_axis: Literal["x", "y", "z", "-x", "-y", "-z"] | None = None,
    only: Property | Sequence[Property] | None = None,
    keep: Property | Sequence[Property] | None = None,
    dissipation_by: Literal["radius", "mass"] | None = None,
    friction: bool = False,
    contacts_gravity: float | None = None,
    target_gravity: float | None = None,
    body_scale_file: StrPath | None = None,
    follow_bodies: bool = False,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Result:
    """Rescales a model's own contacts to another mass.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    target_mass : float
        Mass the contacts should be made for, kg.
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    radius : float or str, optional
        Radii: isometric (R ~ M^1/3), keep, a radius in metres, or a factor like x1.5 [default: isometric with
        `target_mass`, keep otherwise]
    level : bool, optional
        Keep the soles: where a radius changes, move the centre so that the lowest point of the sphere stays.
    level_axis : {"x", "y", "z", "-x", "-y", "-z"}, optional
        The axis of the spheres' frames that points up with the foot flat [default: nearest to -gravity]
    only : str or list of str, optional
        Only these properties (OpenSim's names, and radius)
    keep : str or list of str, optional
        Everything but these properties.
    dissipation_by : {"radius", "mass"}, optional
        What dissipation follows (14): R^-1/2 or M^-1/6.
    friction : bool, optional
        Scale transition_velocity and viscous_friction too (an extension of the paper)
    contacts_gravity : float, optional
        Gravity the contacts are made for now, m/s2 [default: the note's, else the model's]
    target_gravity : float, optional
        Scale to this gravity too, m/s2 (an extension of the paper) [default with `reference_gravity`: the
        model's]
    body_scale_file : path, optional
        ScaleSet that the Scale Tool applied: spheres follow their bodies.
    follow_bodies : bool, optional
        Spheres follow bodies scaled since the model's note was written.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.rescale("fixtures/table1/human_62kg_smooth_sphere.osim", target_mass=1190)
    <Result of rescale: fixtures/table1/human_62kg_smooth_sphere.osim: 72 numbers to change>
    """
    keywords = {"target_mass": target_mass, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "radius": radius, "level": level or None, "level_axis": level_axis, "only": only, "keep": keep, "dissipation_by": dissipation_by, "friction": friction or None, "contacts_gravity": contacts_gravity, "target_gravity": target_gravity, "body_scale_file": body_scale_file, "follow_bodies": follow_bodies or None, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes, "geometry": geometry, "model": model}
    return _run.plan("rescale", source, keywords)


def set(
    source: Source,
    /,
    *,
    stiffness: float | str | None = None,
    dissipation: float | str | None = None,
    static_friction: float | str | None = None,
    dynamic_friction: float | str | None = None,
    viscous_friction: float | str | None = None,
    transition_velocity: float | str | None = None,
    constant_contact_force: float | str | None = None,
    hertz_smoothing: float | str | None = None,
    hunt_crossley_smoothing: float | str | None = None,
    radius: float | str | None = None,
    level: bool = False,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Result:
    """Sets properties to a value, or multiplies them by a factor.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    stiffness, dissipation, static_friction, dynamic_friction, viscous_friction, transition_velocity, constant_contact_force, hertz_smoothing, hunt_crossley_smoothing, radius : float or str, optional
        The value of this property, or a factor such as "x2".
    level : bool, optional
        Move spheres down until all spheres of a foot are as low as its lowest one, at the default pose.
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.set("fixtures/table1/human_62kg_smooth_sphere.osim", stiffness="x2", dissipation=1)
    <Result of set: fixtures/table1/human_62kg_smooth_sphere.osim: 24 numbers to change>
    """
    keywords = {"set": _run.assignments({"stiffness": stiffness, "dissipation": dissipation, "static_friction": static_friction, "dynamic_friction": dynamic_friction, "viscous_friction": viscous_friction, "transition_velocity": transition_velocity, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "radius": radius}), "level": level or None, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes, "geometry": geometry, "model": model}
    return _run.plan("set", source, keywords)


@overload
def sweep(source: StrPath, /, *, grid: str | Sequence[str] | Mapping[str, float | str | Sequence[object]], ladder: None = None, soft: None = None, point: int | None = None, shard: str | None = None, output_dir: StrPath | None = None, force: bool = False, resume: bool = False, no_note: bool = False, dry_run: bool = False, jobs: int | None = None, radius: float | str | None = None, indentation: float | None = None, contact_stiffness: float | None = None, young: float | None = None, poisson: float | None = None, stiffness: float | None = None, restitution: float | None = None, impact_speed: float | None = None, constant_indentation: float | None = None, state_width: float | None = None, speed_width: float | None = None, threshold: float | None = None, load: float | None = None, body_weights: float | None = None, gravity: float | None = None, contacts_mass: float | None = None, mass: float | None = None, exclude_body: str | Sequence[str] | None = None, spheres: int | None = None, stance_limbs: int | None = None, select: str | Sequence[str] | None = None, exclude: str | Sequence[str] | None = None, skip_disabled: bool = False, yes: Question | Sequence[Question] | None = None, progress: Progress = False) -> Sweep: ...
@overload
def sweep(source: StrPath, /, *, grid: None = None, ladder: int, soft: float | None = None, point: int | None = None, shard: str | None = None, output_dir: StrPath | None = None, force: bool = False, resume: bool = False, no_note: bool = False, dry_run: bool = False, jobs: int | None = None, radius: float | str | None = None, indentation: float, contact_stiffness: float | None = None, young: float | None = None, poisson: float | None = None, stiffness: float | None = None, restitution: float | None = None, impact_speed: float | None = None, constant_indentation: float | None = None, state_width: float | None = None, speed_width: float | None = None, threshold: float | None = None, load: float | None = None, body_weights: float | None = None, gravity: float | None = None, contacts_mass: float | None = None, mass: float | None = None, exclude_body: str | Sequence[str] | None = None, spheres: int | None = None, stance_limbs: int | None = None, select: str | Sequence[str] | None = None, exclude: str | Sequence[str] | None = None, skip_disabled: bool = False, yes: Question | Sequence[Question] | None = None, progress: Progress = False) -> Sweep: ...
def sweep(
    source: StrPath,
    /,
    *,
    grid: str | Sequence[str] | Mapping[str, float | str | Sequence[object]] | None = None,
    ladder: int | None = None,
    soft: float | None = None,
    point: int | None = None,
    shard: str | None = None,
    output_dir: StrPath | None = None,
    force: bool = False,
    resume: bool = False,
    no_note: bool = False,
    dry_run: bool = False,
    jobs: int | None = None,
    radius: float | str | None = None,
    indentation: float | None = None,
    contact_stiffness: float | None = None,
    young: float | None = None,
    poisson: float | None = None,
    stiffness: float | None = None,
    restitution: float | None = None,
    impact_speed: float | None = None,
    constant_indentation: float | None = None,
    state_width: float | None = None,
    speed_width: float | None = None,
    threshold: float | None = None,
    load: float | None = None,
    body_weights: float | None = None,
    gravity: float | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    yes: Question | Sequence[Question] | None = None,
    progress: Progress = False,
) -> Sweep:
    """One file per point of a grid, or per step of a ladder, and a table that says what is in which.

    Parameters
    ----------
    source : path
        Path of a model.
    grid : str or list of str or dict, optional
        Values of a property (stiffness=1e5,1e6), factors (stiffness=x0.1,x1,x10), a logarithmic range
        (stiffness=x0.1..x10/9), or values of indentation, restitution or target_mass; one or several in a list.
    ladder : int, optional
        N steps from a soft contact to `indentation` and `restitution`, to search for a gait step by step.
    soft : float, optional
        With `ladder`: dimensionless stiffness of the first step.
    point : int, optional
        Only point N of the grid, or step N of the ladder, counted from 1, for job arrays.
    shard : str, optional
        Only share I of N of the points, for job arrays.
    output_dir : path, optional
        Write the models into this folder [default: NAME.sweep beside the model]
    force : bool, optional
        Replace existing files.
    resume : bool, optional
        Continue a sweep that was stopped or changed: make the models that are missing or out of date, and leave
        edited ones.
    no_note : bool, optional
        Leave no note (in the credits) in the models.
    dry_run : bool, optional
        Write nothing, only show what would be made.
    jobs : int, optional
        Models to make at once [default: one per processor]
    radius : float or str, optional
        Sphere radius in metres (with models also keep or a factor like x1.5)
    indentation : float, optional
        Relative indentation x/R under the load, 0 to 1 (11)
    contact_stiffness : float, optional
        Stiffness of one sphere at that load, N/m (11 with B.2)
    young : float, optional
        Young's modulus, N/m2 (A.1, A.5)
    poisson : float, optional
        Poisson's ratio.
    stiffness : float, optional
        OpenSim's stiffness (plane strain modulus of one surface), N/m2.
    restitution : float, optional
        Coefficient of restitution, 0 to 1 (13)
    impact_speed : float, optional
        Impact speed, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    constant_indentation : float, optional
        Constant indentation over radius, for constant_contact_force (C.2)
    state_width : float, optional
        Width of the contact transition over radius, for hertz_smoothing (C.8)
    speed_width : float, optional
        Width of the transition in speed, m/s, for hunt_crossley_smoothing (C.10)
    threshold : float, optional
        Threshold t that the widths refer to: from t to 1 - t.
    load : float, optional
        Total load on all spheres, N.
    body_weights : float, optional
        The load in body weights [default: 1 where a mass is known]
    gravity : float, optional
        Gravity, m/s2 [default: the model's, else 9.80665]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    progress : bool or callable, optional
        Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model.

    Returns
    -------
    Sweep
        The variants, and the table of what is in which file.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> len(ocs.sweep("fixtures/table1/human_62kg_smooth_sphere.osim", grid={"stiffness": "x0.1..x10/3"}, dry_run=True))
    3
    """
    keywords = {"grid": grid, "ladder": ladder, "soft": soft, "point": point, "shard": shard, "output_dir": output_dir, "force": force or None, "resume": resume or None, "no_note": no_note or None, "dry_run": dry_run or None, "jobs": jobs, "radius": radius, "indentation": indentation, "contact_stiffness": contact_stiffness, "young": young, "poisson": poisson, "stiffness": stiffness, "restitution": restitution, "impact_speed": impact_speed, "constant_indentation": constant_indentation, "state_width": state_width, "speed_width": speed_width, "threshold": threshold, "load": load, "body_weights": body_weights, "gravity": gravity, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "spheres": spheres, "stance_limbs": stance_limbs, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "yes": yes}
    return _run.sweep(source, keywords, progress)


def transfer(
    source: Source,
    /,
    *,
    from_: Source,
    presets: StrPath | None = None,
    spheres: int | None = None,
    stance_limbs: int | None = None,
    reference_mass: float | None = None,
    reference_spheres: int | None = None,
    reference_gravity: float | None = None,
    reference_select: str | Sequence[str] | None = None,
    reference_sphere: str | None = None,
    follow_bodies: bool = False,
    body_scale_file: StrPath | None = None,
    body_scale: str | Sequence[str] | Mapping[str, float | Sequence[float]] | None = None,
    radius_axis: Literal["x", "y", "z", "geomean", "min", "max"] | None = None,
    moved_spheres: Literal["keep", "replace"] | None = None,
    strict: bool = False,
    rule: Literal["paper", "predsim"] | None = None,
    height_ratio: float | None = None,
    contacts_mass: float | None = None,
    mass: float | None = None,
    exclude_body: str | Sequence[str] | None = None,
    radius: float | str | None = None,
    level: bool = False,
    level_axis: Literal["x", "y", "z", "-x", "-y", "-z"] | None = None,
    only: Property | Sequence[Property] | None = None,
    keep: Property | Sequence[Property] | None = None,
    dissipation_by: Literal["radius", "mass"] | None = None,
    friction: bool = False,
    contacts_gravity: float | None = None,
    target_gravity: float | None = None,
    select: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    skip_disabled: bool = False,
    no_note: bool = False,
    yes: Question | Sequence[Question] | None = None,
    geometry: Source | None = None,
    model: Source | None = None,
) -> Result:
    """Gives a model the contacts of another model or of a preset, at its own size.

    Parameters
    ----------
    source : path, bytes or opensim.Model
        Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.
    from_ : path, bytes or opensim.Model
        Where the contacts come from: a model, or a preset such as falisse2022.
    presets : path, optional
        A file with presets of your own (TOML)
    spheres : int, optional
        Spheres that share the body weight, all stance limbs together [default: as found per limb]
    stance_limbs : int, optional
        Limbs that share the body weight [default: as the note in the model says, else 1]
    reference_mass : float, optional
        Mass its contacts are made for, kg [default: its note, else its bodies]
    reference_spheres : int, optional
        Its spheres that share the body weight [default: as found per limb]
    reference_gravity : float, optional
        Its gravity, m/s2 [default: its note's, else its own]: if given, contacts are scaled from it to
        `target_gravity`.
    reference_select : str or list of str, optional
        Only its forces with such a name; one or several in a list.
    reference_sphere : str, optional
        Take contact and isometric radius of this sphere for all.
    follow_bodies : bool, optional
        Spheres take place and size from their bodies, which OpenSim has scaled.
    body_scale_file : path, optional
        The ScaleSet that the Scale Tool applied (its output_scale_file)
    body_scale : str or list of str or dict, optional
        Factors of a body (or one, BODY=f); one or several in a list.
    radius_axis : {"x", "y", "z", "geomean", "min", "max"}, optional
        How the radius of a sphere follows from the three factors of its body [default: geomean, where radii
        follow]
    moved_spheres : {"keep", "replace"}, optional
        Spheres that were moved or resized already: keep them, or place them again.
    strict : bool, optional
        Refuse where spheres of one force follow bodies with different factors.
    rule : {"paper", "predsim"}, optional
        The paper's scaling, or PredSim's (stiffness by mass/height^2, dissipation by 1/height)
    height_ratio : float, optional
        Height of this model over that of the reference [default: mean of the body factors]
    contacts_mass : float, optional
        Mass the contacts are made for now, kg [default: the note, else `mass`]
    mass : float, optional
        Mass of this model, kg [default: the sum of its bodies]
    exclude_body : str or list of str, optional
        Leave these bodies out of the sum (props, platforms); one or several in a list.
    radius : float or str, optional
        Radii: keep, isometric (as the reference's, in proportion to M^(1/3)), follow (with the factors of bodies,
        by `radius_axis`), a radius in metres, or a factor like x1.5 [default: keep; isometric with
        `follow_bodies`]
    level : bool, optional
        Keep the soles: where a radius changes, move the centre so that the lowest point of the sphere stays (with
        `follow_bodies`: on the scaled sole)
    level_axis : {"x", "y", "z", "-x", "-y", "-z"}, optional
        The axis of the spheres' frames that points up with the foot flat [default: nearest to -gravity]
    only : str or list of str, optional
        Only these properties (OpenSim's names, and radius)
    keep : str or list of str, optional
        Everything but these properties.
    dissipation_by : {"radius", "mass"}, optional
        What dissipation follows (14): R^-1/2 or M^-1/6.
    friction : bool, optional
        Scale transition_velocity and viscous_friction too (an extension of the paper)
    contacts_gravity : float, optional
        Gravity the contacts are made for now, m/s2 [default: the note's, else the model's]
    target_gravity : float, optional
        Scale to this gravity too, m/s2 (an extension of the paper) [default with `reference_gravity`: the
        model's]
    select : str or list of str, optional
        Only forces with such a name; one or several in a list.
    exclude : str or list of str, optional
        No forces with such a name; one or several in a list.
    skip_disabled : bool, optional
        Leave out forces that are switched off.
    no_note : bool, optional
        Leave no note (in the credits) in the model.
    yes : str or list of str, optional
        Confirm what looks like a mistake: the code of the error that asks; one or several in a list.
    geometry : path, bytes or opensim.Model, optional
        The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet.
    model : path, bytes or opensim.Model, optional
        The model a standalone ForceSet belongs to, for its masses and joints.

    Returns
    -------
    Result
        The plan. Nothing is written before `Result.write`.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.

    Examples
    --------
    >>> ocs.transfer("fixtures/scale_tool/scaled_smooth.osim", from_="fixtures/scale_tool/generic_smooth.osim", follow_bodies=True, level=True)
    <Result of transfer: fixtures/scale_tool/scaled_smooth.osim: 42 numbers to change>
    """
    keywords = {"from": from_, "presets": presets, "spheres": spheres, "stance_limbs": stance_limbs, "reference_mass": reference_mass, "reference_spheres": reference_spheres, "reference_gravity": reference_gravity, "reference_select": reference_select, "reference_sphere": reference_sphere, "follow_bodies": follow_bodies or None, "body_scale_file": body_scale_file, "body_scale": body_scale, "radius_axis": radius_axis, "moved_spheres": moved_spheres, "strict": strict or None, "rule": rule, "height_ratio": height_ratio, "contacts_mass": contacts_mass, "mass": mass, "exclude_body": exclude_body, "radius": radius, "level": level or None, "level_axis": level_axis, "only": only, "keep": keep, "dissipation_by": dissipation_by, "friction": friction or None, "contacts_gravity": contacts_gravity, "target_gravity": target_gravity, "select": select, "exclude": exclude, "skip_disabled": skip_disabled or None, "no_note": no_note or None, "yes": yes, "geometry": geometry, "model": model}
    return _run.plan("transfer", source, keywords)
