"""The documentation as a site, by Sphinx: `scripts/site` builds it."""

import re
import sys
from importlib.machinery import ModuleSpec
from importlib.util import module_from_spec
from pathlib import Path

from sphinx.pycode import ModuleAnalyzer

CHECKOUT = Path(__file__).resolve().parent.parent

# The compiled part of the module need not have been built: what it has is documented by its front.
compiled = module_from_spec(ModuleSpec("zenosphere._core", loader=None))
compiled.__getattr__ = lambda name: object
sys.modules["zenosphere._core"] = compiled
sys.path.insert(0, str(CHECKOUT / "python"))

project = "Zenosphere"
release = re.search(r"^version: (.+)$", (CHECKOUT / "CITATION.cff").read_text(), re.M)[1]

extensions = ["myst_parser", "sphinx.ext.autodoc"]
myst_heading_anchors = 4  # for links such as theory.md#criteria
smartquotes = False  # values such as "fcc" stand as they are typed
default_role = "py:obj"  # in docstrings, `Case` is code, and a link to what is documented

autodoc_member_order = "bysource"
autodoc_typehints_format = "short"

html_theme = "furo"
html_title = f"Zenosphere {release}"
html_copy_source = False
html_show_copyright = False
html_static_path = ["site.css"]
html_css_files = ["site.css"]


def with_fields(lines):
    """Lines of a docstring in which those of the form `name: meaning` are fields of their own.

    An argument's meaning may go on in the next line; it ends with an empty line, or at "Raises".
    """
    text, in_field = [], False
    for line in lines:
        argument = re.match(r"([a-z_]+): ", line)
        if argument:
            text += [] if in_field else [""]
            line = f":param {argument[1]}: {line[argument.end():]}"
        elif line.startswith("Raises "):
            text.append("")
        in_field = bool(argument) or (in_field and line != "" and not line.startswith("Raises "))
        text.append("    " + line if in_field and not argument else line)
    return text


def with_links(line):
    """A line in which pages are links, docs/summary.md as well as errors."""
    line = re.sub(r"\bdocs/([\w-]+)\.md\b", r":doc:`\1`", line)
    return re.sub(r"(?<!`)\b(InputError|OutputError)\b", r"`\1`", line)


def process_docstring(_app, what, name, _documented, _options, lines):
    if what in ("class", "exception", "function", "method"):
        lines[:] = with_fields(lines)
    if name == "zenosphere.COLLISION_DTYPE":  # which is imported there
        analyzer = ModuleAnalyzer.for_module("zenosphere.run")
        lines[:] = analyzer.find_attr_docs()["", "COLLISION_DTYPE"]
    lines[:] = map(with_links, lines)


def setup(app):
    app.connect("autodoc-process-docstring", process_docstring)
