"""Arguments of the commands: what is wrong with them is said in one line, as the program does."""

import argparse
import difflib

MISSING = "the following arguments are required: "


class CommandParser(argparse.ArgumentParser):
    """An ArgumentParser for a command, and for the words behind it.

    Prints `COMMAND: problem; see COMMAND --help` and exits with 2, where argparse prints a usage
    block too and, for an unknown word, the name of the program without that of the command.
    """

    def parse_known_args(self, args=None, namespace=None):
        known, rest = super().parse_known_args(args, namespace)
        if rest:
            self._refuse(*self._unknown(rest[0]))
        return known, rest

    def error(self, message):
        if message.startswith(MISSING):
            message = " and ".join(message.removeprefix(MISSING).split(", ")) + " missing"
        self._refuse(message.removeprefix("argument "), "; see")

    def _unknown(self, word):
        if not word.startswith("-"):
            return f"{word} is one word too many", "; see"
        option = word.split("=")[0]
        near = difflib.get_close_matches(option, self._option_string_actions, n=1)
        return f"unknown option {option}", f"; did you mean {near[0]}? See" if near else "; see"

    def _refuse(self, problem, see):
        self.exit(2, f"{self.prog}: {problem}{see} {self.prog} --help\n")
