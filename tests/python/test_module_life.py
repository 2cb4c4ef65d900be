"""Stopping, saving, resuming, failing and threads of a run that Python drives."""

import os
import resource
import signal
import subprocess
import sys
import threading
import time

import pytest
from identity import differences
from module import ENDLESS, SHEARED, failure, joined, needed, program, ran_by_program
from processes import MOST_SECONDS

import zenosphere
from zenosphere.errors import in_python_words

pytestmark = needed


def case(**overrides):
    return zenosphere.Case(SHEARED, overrides=overrides)


def interrupt_while_it_goes_on(run):
    """Advances a run; once it has collisions SIGINT reaches this process, as by Ctrl-C."""

    def interrupt():
        while not run.collisions:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        run.advance()
    thread.join()


def test_interrupted_advance_loses_no_collision():
    run = zenosphere.Run(case(**ENDLESS))
    interrupt_while_it_goes_on(run)  # else it would go on for a week
    done = run.collisions
    assert done > 0
    rows = run.advance(10)
    assert rows["k"].tolist() == list(range(1, done + 10))


def test_block_that_is_left_by_an_exception_leaves_a_complete_file(tmp_path):
    output = tmp_path / "out.h5"
    with pytest.raises(ZeroDivisionError), zenosphere.Run(case(), output=output) as run:
        run.skip(500)
        run.skip(1 // 0)
    told = program("info", output)
    assert "interrupted" in told and "  collisions              500" in told


def test_run_that_was_stopped_is_resumed_with_the_same_bits(tmp_path):
    whole, parts = tmp_path / "whole.h5", tmp_path / "parts.h5"
    chosen = case(**{"output.snapshot_interval": 0.1})
    ran_by_program(chosen, whole)
    with zenosphere.Run(zenosphere.Case.parse(chosen.resolved), output=parts) as run:
        run.skip(until=0.234)
    for stop in (333, 1999):
        with zenosphere.Run.resume(parts) as run:
            run.advance(stop - run.collisions)
    program("resume", parts, "--quiet")
    assert differences(parts, whole) == []


def test_finished_run_is_made_longer(tmp_path):
    output = tmp_path / "out.h5"
    with zenosphere.Run(case(), output=output) as run:
        first = run.advance()
    run = zenosphere.Run.resume(output, overrides={"run.collisions": 2100})
    more = joined(run.chunks(30))
    assert (first["k"][-1], more["k"][0], more["k"][-1]) == (2000, 2001, 2100)
    assert run.finish()["collisions"] == 2100


def test_resume_refuses_with_the_text_of_the_program_in_words_of_python(tmp_path):
    output = tmp_path / "out.h5"
    zenosphere.Run(case(), output=output).finish()
    zenosphere.Run.resume(output).finish()
    with zenosphere.Run.resume(output) as run:
        run.skip()
    for file in (output, tmp_path / "none.h5"):
        code, printed = failure("resume", file)
        with pytest.raises(zenosphere.InputError) as caught:
            zenosphere.Run.resume(file)
        assert code == 2 and str(caught.value) == in_python_words(printed)
        assert "--set" not in str(caught.value)
    with pytest.raises(zenosphere.OutputError, match="pass overwrite=True$"):
        zenosphere.Run(case(), output=output)


def test_saved_run_survives_the_death_of_its_process(tmp_path):
    output = tmp_path / "out.h5"
    script = ("import os, sys, zenosphere\n"
              "run = zenosphere.Run(sys.argv[1], output=sys.argv[2])\n"
              "run.skip(700); run.save(); run.skip(200); os._exit(9)\n")
    file = tmp_path / "case.toml"
    file.write_text(case().resolved)
    done = subprocess.run([sys.executable, "-c", script, file, output], timeout=MOST_SECONDS)
    assert done.returncode == 9
    run = zenosphere.Run.resume(output)
    assert run.collisions == 700
    assert run.advance()["k"][0] == 701
    run.finish()
    ran_by_program(case(), tmp_path / "whole.h5")
    assert differences(output, tmp_path / "whole.h5") == []


def test_block_that_fails_tells_its_own_error(tmp_path):
    output = tmp_path / "folder" / "out.h5"
    output.parent.mkdir()
    with pytest.raises(zenosphere.OutputError) as caught:
        with zenosphere.Run(case(**ENDLESS), output=output) as run:
            output.unlink()
            run.skip()  # finds out within a second or two that its file is gone
    assert caught.value.__context__ is None


def test_files_are_resumed_while_other_runs_write_theirs(tmp_path):
    """What resumes reads in a copy of the process, where no lock of another thread may stay."""
    zenosphere.Run(case(), output=tmp_path / "old.h5").finish()
    busy = [zenosphere.Run(case(**ENDLESS), output=tmp_path / f"{name}.h5") for name in "ab"]
    threads = [threading.Thread(target=run.skip) for run in busy]
    for thread in threads:
        thread.start()
    for _ in range(5):
        zenosphere.Run.resume(tmp_path / "old.h5").finish()
    for run, thread in zip(busy, threads):
        run.stop()
        thread.join()


def test_run_without_output_cannot_be_saved():
    with pytest.raises(zenosphere.InputError, match="save: the run has no output"):
        zenosphere.Run(case()).save()


def test_existing_output_is_refused_with_the_text_of_the_program(tmp_path):
    output, file = tmp_path / "out.h5", tmp_path / "case.toml"
    file.write_text(case().text)
    zenosphere.Run(case(), output=output).finish()
    code, printed = failure("run", file, "-o", output)
    with pytest.raises(zenosphere.OutputError) as caught:
        zenosphere.Run(case(), output=output)
    assert code == 4
    assert str(caught.value).split(";")[0] == printed.split(";")[0]
    zenosphere.Run(case(), output=output, overwrite=True).finish()


def test_failed_output_is_told_again_and_again(tmp_path):
    """Files of this process may not grow past 200 kB for a while, as on a full disk."""
    run = zenosphere.Run(case(**ENDLESS), output=tmp_path / "out.h5")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, hard))
    try:
        with pytest.raises(zenosphere.OutputError) as caught:
            run.skip(200_000)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    for use in (run.advance, run.save, run.finish):
        with pytest.raises(zenosphere.OutputError) as again:
            use()
        assert str(again.value) == str(caught.value)
    assert run.collisions > 0 and run.state().positions.shape == (108, 3)


def test_other_threads_go_on_and_may_stop_a_run_but_not_use_it():
    run = zenosphere.Run(case(**ENDLESS))
    told = []

    def meddle():
        while not run.collisions:  # told while the run below goes on
            time.sleep(0.01)
        try:
            run.advance(1)
        except RuntimeError as error:
            told.append(str(error))
        run.stop()

    thread = threading.Thread(target=meddle)
    thread.start()
    run.skip()
    thread.join()
    assert told and "in use by another thread" in told[0]
    assert run.is_over and run.finish()["ended_by"] == "signal"


def test_two_runs_in_two_threads_are_two_runs(tmp_path):
    chosen = case(**{"run.collisions": 20_000})
    runs = [zenosphere.Run(chosen, output=tmp_path / f"{name}.h5") for name in "ab"]
    threads = [threading.Thread(target=run.skip) for run in runs]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for run in runs:
        run.finish()
    assert differences(tmp_path / "a.h5", tmp_path / "b.h5") == []


@pytest.mark.parametrize("name", ["", "a\0b"])
def test_output_without_a_name_is_refused(name):
    with pytest.raises(zenosphere.InputError, match="is no name of a file"):
        zenosphere.Run(case(), output=name)
