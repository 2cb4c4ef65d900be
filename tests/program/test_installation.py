"""What `cmake --install` puts in place works from there, moved, without the checkout."""

import gzip
import os
import shutil
import subprocess
from pathlib import Path

import pytest

BUILD = Path(os.environ["ZENOSPHERE"]).parent
BARE = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LANG": "C.UTF-8"}


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    """A folder with an installation that was moved after it was made."""
    folder = tmp_path_factory.mktemp("installed")
    first = folder / "first"
    subprocess.run(["cmake", "--install", BUILD, "--prefix", first], check=True,
                   capture_output=True)
    return first.rename(folder / "moved")


def installed(prefix, *words, **options):
    """Runs the installed program in an environment that names nothing of the checkout."""
    return subprocess.run([prefix / "bin" / "zenosphere", *words], env=BARE, check=True,
                          capture_output=True, text=True, **options).stdout


def test_installed_program_makes_runs_and_draws_a_case(prefix, tmp_path):
    installed(prefix, "new", "rods", cwd=tmp_path)
    installed(prefix, "run", "rods.toml", "-o", "run.h5", cwd=tmp_path)
    installed(prefix, "figures", "--run", "run.h5", "-o", "figures", cwd=tmp_path)
    assert list((tmp_path / "figures").glob("*.png"))


def test_python_imports_what_was_installed(prefix):
    if os.environ.get("ZENOSPHERE_MODULE") != "1":
        pytest.skip("built without the Python module")
    package, = prefix.glob("lib/python3*/dist-packages")
    code = "import zenosphere; print(zenosphere.__file__, zenosphere.Run.__name__)"
    done = subprocess.run(["/usr/bin/python3", "-c", code], env=BARE | {"PYTHONPATH": str(package)},
                          check=True, capture_output=True, text=True)
    assert done.stdout.split() == [str(package / "zenosphere" / "__init__.py"), "Run"]


def test_every_command_has_a_manual_page(prefix):
    pages = prefix / "share" / "man" / "man1"
    commands = installed(prefix, "manual", "--list").splitlines()
    assert {"run", "sweep show", "figures"} <= set(commands)
    for command in commands:
        name = f"zenosphere-{command.replace(' ', '-')}"
        text = gzip.decompress((pages / f"{name}.1.gz").read_bytes()).decode()
        assert text.startswith(f".TH {name.replace('-', chr(92) + '-')} 1")
        assert ".SH EXIT STATUS" in text


def test_manual_pages_are_clean_to_groff(prefix):
    if not shutil.which("groff"):
        pytest.skip("no groff")
    for page in (prefix / "share" / "man" / "man1").iterdir():
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], capture_output=True,
                              input=gzip.decompress(page.read_bytes()))
        assert done.stderr == b"", page.name


def completed(prefix, *words):
    """What bash offers for the last of these words."""
    script = prefix / "share" / "bash-completion" / "completions" / "zenosphere"
    line = " ".join(f"'{word}'" for word in ("zenosphere", *words))
    code = (f"source '{script}'; COMP_WORDS=({line}); COMP_CWORD={len(words)}; _zenosphere;"
            ' printf "%s\\n" "${COMPREPLY[@]}"')
    return subprocess.run(["bash", "-c", code], check=True, capture_output=True, text=True,
                          cwd=prefix).stdout.split()


@pytest.mark.parametrize("words, offered", [
    (["adj"], "adjudicate"), (["run", "--over"], "--overwrite"), (["sweep", "cs"], "csv"),
    (["sweep", "show", "--r"], "--run"), (["export", "run.h5", "--format", "ext"], "extxyz"),
    (["adjudicate", "run.h5", "--up-to", "qu"], "quad"), (["new", "shea"], "sheared"),
    (["examples", "haff"], "haff-1983-cooling"),
])
def test_bash_completes_commands_options_and_choices(prefix, words, offered):
    assert completed(prefix, *words) == [offered]


@pytest.mark.parametrize("shell, file", [
    ("zsh", "zsh/vendor-completions/_zenosphere"),
    ("fish", "fish/vendor_completions.d/zenosphere.fish"),
])
def test_completion_is_a_script_that_the_shell_can_read(prefix, shell, file):
    if not shutil.which(shell):
        pytest.skip(f"no {shell}")
    subprocess.run([shell, "-n", prefix / "share" / file], check=True)
