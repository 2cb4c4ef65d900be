"""The two kinds of failure a user can do something about.

Both texts follow `where: problem (why); what you can do`, as in the C++ program.
"""


class InputError(Exception):
    """The user's input is wrong. Exit code 2."""


class OutputError(Exception):
    """The world is in the way: a disk, a file. Exit code 4."""
