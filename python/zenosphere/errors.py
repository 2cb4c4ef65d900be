"""The two kinds of failure a user can do something about.

Both texts follow `where: problem (why); what you can do`, as in the C++ program; the compiled part
raises the same two.
"""

import re


class InputError(ValueError):
    """The user's input is wrong. Exit code 2."""


class OutputError(OSError):
    """The output cannot be written: a disk, a file. Exit code 4."""


_KEY = r"([\w.-]+)"
_WORDS = (
    # What an error begins with: the value comes again behind it, or is what the error is about.
    (re.compile(rf"^--set {_KEY}=.*?: ", re.MULTILINE), r'overrides["\1"]: '),
    (re.compile(rf"^--set {_KEY}: ", re.MULTILINE), r'overrides["\1"]: '),
    (re.compile(r"^--set: ", re.MULTILINE), "overrides: "),
    # What can be done.
    (re.compile(rf"--set {_KEY}=true\b"), r'overrides={"\1": True}'),
    (re.compile(rf"--set {_KEY}=false\b"), r'overrides={"\1": False}'),
    (re.compile(rf"--set {_KEY}=([^\s;,]+)"), r'overrides={"\1": \2}'),
    (re.compile(r"--overwrite\b"), "overwrite=True"),
    (re.compile(r"--set\b"), "overrides"),
)


def in_python_words(text: str) -> str:
    """A message of the program with keyword arguments in the place of its options.

    `--set run.time=3` is `overrides={"run.time": 3}` in Python, and `--overwrite` is
    `overwrite=True`.
    """
    for pattern, words in _WORDS:
        text = pattern.sub(words, text)
    return text
