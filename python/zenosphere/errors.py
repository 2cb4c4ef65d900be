"""The two kinds of failure a user can do something about.

Both texts follow `where: problem (why); what you can do`, as in the C++ program; the compiled part
raises the same two.
"""


class InputError(ValueError):
    """The user's input is wrong. Exit code 2."""


class OutputError(OSError):
    """The world is in the way: a disk, a file. Exit code 4."""
