"""A short Markdown report of some runs: one table, and the figures by relative link."""

import os
from pathlib import Path

from ..drawing import words
from ..errors import OutputError
from . import captions


def write_report(runs, report, figures):
    """Writes the report.

    runs: RunFiles, a column each;  report: Path;  figures: Path of a folder, those of our figures
    that are in it are embedded. Raises OutputError.
    """
    text = report_text(runs, Path(os.path.relpath(figures, report.parent)),
                       _present(runs, figures))
    try:
        report.parent.mkdir(parents=True, exist_ok=True)
        report.write_text(text, encoding="utf-8")
    except OSError as error:
        raise OutputError(f"{report}: cannot be written ({error.strerror});"
                          " choose another file with -o") from error


def report_text(runs, link, present):
    """The report as Markdown.

    runs: RunFiles;  link: Path from the report to the figures;  present: {name: caption}
    """
    columns = [dict(_facts(run)) for run in runs]
    lines = ["# Detection of inelastic collapse", "",
             "Units: diameter = mass = 1, time in the unit of the case. All numbers come from the"
             " output files.", "",
             "| | " + " | ".join(f"`{run.path.name}`" for run in runs) + " |",
             "|---" * (len(runs) + 1) + "|"]
    for quantity in columns[0]:
        lines.append(f"| {quantity} | " + " | ".join(_cell(column[quantity])
                                                     for column in columns) + " |")
    for name, caption in present.items():
        lines += ["", f"![{name}]({(link / name).as_posix()}.png)", "",
                  f"*{name.replace('figure-', 'Figure ')}.* {caption}"]
    return "\n".join(lines) + "\n"


def _facts(run):
    """(quantity, text) of each row of the table, the same rows for every run."""
    yield from _case_facts(run)
    yield from _collapse_facts(run)
    yield from _flow_facts(run)
    made_by = run.attributes
    yield "program version", str(made_by.get("program_version", "?"))
    yield "git hash", f"`{made_by.get('git_hash', '?')}`"


def _case_facts(run):
    start, drive = run.case.get("start", {}), run.case.get("drive", {})
    yield "restitution e", words.short(run.setting("system", "restitution"))
    yield "restitution of the walls", words.short(run.setting("walls", "restitution"))
    yield "spheres N", words.grouped(run.spheres)
    yield "solids volume fraction", words.short(run.setting("system", "solids_volume_fraction"))
    yield "start", (f"{start.get('arrangement', '?')}, granular temperature"
                    f" {words.short(start.get('granular_temperature'))}, seed"
                    f" {start.get('seed', '?')}")
    yield "drive", f"{drive.get('kind', '?')}, shear rate {words.short(drive.get('shear_rate'))}"
    yield "overlap rule, precision", (f"{run.setting('collision', 'overlap')},"
                                      f" {run.setting('collision', 'precision')}")


def _collapse_facts(run):
    hits, arrest = run.separation, run.arrest
    yield "**verdict**", f"**{run.verdict}**"
    yield "separation threshold (diameters)", words.short(run.threshold)
    yield "hits", words.grouped(hits["hits"])
    yield "first hit", _moment(run, hits["first_collision"], hits["first_time"])
    yield "last hit", _moment(run, hits["last_collision"], _time_of(run, hits["last_collision"]))
    yield "arrest", _moment(run, arrest["collision"], arrest["time"])
    yield "arrest window (collisions)", words.grouped(arrest["window"])
    yield "pairs of the arrest", words.pairs(run)
    yield "collisions absorbed", words.short(run.summary.get("absorbed"), digits=9)


def _flow_facts(run):
    summary, averages = run.summary, run.summary.get("averages") or {}
    yield "collisions", words.grouped(summary.get("collisions", 0))
    yield "time", words.short(summary.get("time"), digits=6)
    for text, name in (("collision rate omega (per sphere per time)", "collision_rate"),
                       ("granular temperature T", "granular_temperature")):
        yield text, _with_error(averages, name)
    yield "averages from and to time", (f"{words.short(averages.get('from_time'))} to"
                                        f" {words.short(averages.get('to_time'))}"
                                        if averages.get("to_time") is not None
                                        else words.short(None))
    yield "steady state", averages.get("steady_reason") or words.short(None)
    yield "ledger error (relative)", words.short(summary.get("ledger_error"), digits=2)


def _with_error(averages, name):
    """`1.139 +- 0.002`, or the average alone where its error is not known."""
    error = (averages.get("standard_error") or {}).get(name)
    text = words.short(averages.get(name))
    return f"{text} +- {words.short(error, 2)}" if error else text


def _moment(run, collision, time):
    """`12 345 (6.17 per sphere), time 0.69`; a dash where it never came."""
    if collision is None:
        return words.short(None)
    each = words.short(words.per_sphere(run, collision), 3)
    at = "" if time is None else f", time {words.short(time, digits=6)}"
    return f"{words.grouped(collision)} ({each} per sphere){at}"


def _time_of(run, collision):
    """Time of a logged collision; None where it is not in the log."""
    if collision is None or not run.has_log:
        return None
    (time,) = run.collisions.read("time", first=collision, last=collision)
    return float(time[0]) if time.size else None


def _cell(text):
    return text.replace("|", "\\|")


def _present(runs, folder):
    """{name: caption} of those of our figures that are in the folder."""
    named = captions()
    for run in runs:
        named |= captions(prefix=f"{run.name}-")
    return {name: caption for name, caption in named.items() if (folder / f"{name}.png").is_file()}
