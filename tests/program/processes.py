"""How far a process has come that runs beside a test: waited for, never guessed from the time."""

import os
import select
import time
from pathlib import Path

MOST_SECONDS = 600  # commands take ten at most on an idle machine: what takes so long, hangs


def wait_for(condition):
    """Returns once the condition holds."""
    end = time.monotonic() + MOST_SECONDS
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.005)
    raise AssertionError(f"{MOST_SECONDS} seconds were not enough")


def processor_seconds(pid):
    """What a process has spent of processors, of all its threads."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return int(fields[11]) / os.sysconf("SC_CLK_TCK")  # utime, field 14 of proc(5)


def has_worked(pid, seconds=0.1):
    """Whether a process has spent so much time of a processor: then its runs are going on."""
    return processor_seconds(pid) >= seconds


def let_work(process, seconds=0.1):
    """Returns once a process has spent so much more time of a processor, or has ended."""
    end = processor_seconds(process.pid) + seconds
    wait_for(lambda: process.poll() is not None or has_worked(process.pid, end))


def shown_until(descriptor, is_enough):
    """What a process shows on the pseudo-terminal of a test, up to where that is enough."""
    shown = ""

    def is_there():
        nonlocal shown
        while select.select([descriptor], [], [], 0)[0]:
            shown += os.read(descriptor, 65536).decode()
        return is_enough(shown)

    wait_for(is_there)
    return shown
