"""What a store has of a sweep, while that goes on and as a table."""

import csv
import io
import signal
import subprocess

from processes import MOST_SECONDS, wait_for
from sweeps import ENDLESS, rows, runs_done


def test_runs_that_are_done_are_in_the_store_while_others_go_on(sweep):
    """At 0.2 they arrest at once; those at 0.99 have no end."""
    (sweep.folder / "s.toml").write_text(ENDLESS.replace("[0.95, 0.99]", "[0.2, 0.99]"))
    process = subprocess.Popen(
        sweep.command("sweep", "s.toml", "--threads", "8", "--quiet"), cwd=sweep.folder)
    try:
        wait_for(lambda: runs_done(sweep.folder / "s.sqlite") == 4 or process.poll() is not None)
        assert process.poll() is None
    finally:
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=MOST_SECONDS)


def test_csv_has_a_line_for_each_run(sweep):
    sweep("sweep", "s.toml")
    table = list(csv.DictReader(io.StringIO(sweep("sweep", "csv", "s.sqlite").stdout)))
    found = rows(sweep.folder / "s.sqlite")
    assert [int(line["run"]) for line in table] == [row["run"] for row in found]
    assert [float(line["time"]) for line in table] == [row["time"] for row in found]
    assert [line["arrest_pairs"] for line in table] == [row["arrest_pairs"] for row in found]
    sweep("sweep", "csv", "s.sqlite", "-o", "s.csv")
    assert list(csv.DictReader((sweep.folder / "s.csv").open())) == table


def test_csv_goes_to_standard_output_by_the_name_of_it(sweep):
    sweep("sweep", "s.toml", "--quiet")
    printed = sweep("sweep", "csv", "s.sqlite").stdout
    for name in ("-", "/dev/stdout"):
        assert sweep("sweep", "csv", "s.sqlite", "-o", name).stdout == printed
