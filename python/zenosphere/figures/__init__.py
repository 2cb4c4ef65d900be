"""The figures: the paper's seven from its two runs, and a general set for any one run."""

from dataclasses import dataclass
from typing import Callable

from ..anatomy import panels as anatomy_panels
from ..drawing.pictures import Pictures, made_folder
from . import panels, windows

USUAL = Pictures(formats=("png", "pdf"))


@dataclass(frozen=True)
class FigurePlan:
    """One figure: what is drawn over which collisions, and what it shows."""

    name: str  # file name without suffix
    draw: Callable  # of panels: (axes, run, window)
    window: Callable  # of windows: run -> (first, last); of an anatomy: run -> which one
    caption: str
    rows: int = 1  # of panels


FALSE_POSITIVE = (
    FigurePlan("figure-1", panels.separation, windows.early,
               "Separation of the next pair where the criterion is met for the first time."),
    FigurePlan("figure-2", panels.separation, windows.long,
               "The same over the whole temporary stage, into the steady state."),
    FigurePlan("figure-3a", panels.time, windows.whole,
               "Dimensionless time against collisions, whole run."),
    FigurePlan("figure-3b", panels.time, windows.temporary_stage,
               "Dimensionless time against collisions, the temporary stage."),
)

TRUE_COLLAPSE = (
    FigurePlan("figure-4", panels.separation, windows.to_arrest,
               "Separation of the next pair, up to the arrest."),
    FigurePlan("figure-5", panels.time, windows.to_arrest,
               "Dimensionless time against collisions, up to the arrest."),
    FigurePlan("figure-6", panels.separation, windows.into_arrest,
               "Separation of the next pair in the passage into the arrest."),
)

ANY_RUN = (
    FigurePlan("separation", panels.separation, windows.whole,
               "Separation of the next pair, whole log."),
    FigurePlan("time", panels.time, windows.whole, "Time against collisions, whole log."),
    FigurePlan("pairs", panels.pairs_raster, windows.pairs_change,
               "Which pairs collide around the arrest, the last hit, or the end."),
)

WHAT_COLLAPSES = {
    which: (
        FigurePlan(f"{which}-decay", anatomy_panels.decay, lambda _, name=which: name,
                   f"Gaps, speeds and flights of the cluster that collapses, up to the {moment}.",
                   rows=3),
        FigurePlan(f"{which}-cluster", anatomy_panels.cluster, lambda _, name=which: name,
                   f"The cluster at the {moment}, with the contacts that repeat."),
        FigurePlan(f"{which}-pairs", anatomy_panels.raster, lambda _, name=which: name,
                   f"Which of its pairs collide, up to the {moment}."),
    ) for which, moment in (("hit", "first hit"), ("arrest", "arrest"))
}


def draw_paper_figures(run, plans, folder, pictures=USUAL):
    """Draws the paper's figures of one run; needs its complete collision log.

    run: RunFile;  plans: FALSE_POSITIVE or TRUE_COLLAPSE;  folder: Path, made where missing
    pictures: Pictures
    Returns the paths written. Raises InputError, OutputError.
    """
    run.complete_collisions()
    return _drawn(run, plans, folder, pictures, prefix="")


def draw_general_figures(run, folder, pictures=USUAL):
    """Draws ANY_RUN of one run and WHAT_COLLAPSES, files named after it; a part of a log will do.

    Returns the paths written. Raises InputError, OutputError.
    """
    plans = ANY_RUN
    for which, anatomy in WHAT_COLLAPSES.items():
        plans += anatomy if run.dissection(which) else ()
    return _drawn(run, plans, folder, pictures, prefix=f"{run.name}-")


def captions(prefix=""):
    """File name without suffix -> caption, of every figure in the paper's order.

    prefix: of the general figures; without one, the paper's.
    """
    general = ANY_RUN + sum(WHAT_COLLAPSES.values(), ())
    plans = general if prefix else FALSE_POSITIVE + TRUE_COLLAPSE
    return {prefix + plan.name: plan.caption for plan in plans}


def _drawn(run, plans, folder, pictures, prefix):
    made_folder(folder)
    written = []
    for plan in plans:
        written += panels.save(plan.draw, run, plan.window(run), folder / (prefix + plan.name),
                               pictures, plan.rows)
    return written
