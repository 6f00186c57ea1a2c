"""Builds the documentation: build.py ROOT FOLDER site|comments

  site      the whole of it; it is in FOLDER/html afterwards
  comments  only lists what is public and has no comment, which takes seconds

Exit status 0 if there was no warning and nothing to list; 77, which ctest takes for skipped, if a program
it needs is missing.
"""
import pathlib
import shutil
import subprocess
import sys
import time

from doxygen import run_doxygen
from headers import write_shown
from pages import write_pages
from selfcontained import reaches_outside, take_along
from undocumented import undocumented

SKIPPED = 77


def interpreter():
    """A Python that has what the site needs: this one, or the system's, for which Debian packages it."""
    needed = "import breathe, furo, myst_parser, sphinx"
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", needed], capture_output=True).returncode == 0:
            return python
    return None


def check_comments(root, folder):
    """Returns the installed headers, and whether something is wrong with their comments."""
    headers = write_shown(root, folder / "headers")
    warnings = run_doxygen(root, folder)
    bare = undocumented(folder / "doxygen/xml", folder / "headers")
    print(f"{len(headers)} headers; of what they declare, without a comment: {len(bare)}", *warnings, *bare, sep="\n")
    return headers, bool(warnings or bare)


def run_sphinx(python, root, folder):
    """Returns whether Sphinx warned. What it read then is forgotten: it warns only of pages that it reads."""
    status = subprocess.run([python, "-m", "sphinx", "-b", "html", "-q", "-W", "--keep-going", "-j", "2",
                           "-c", root / "Docs/site", "-D", f"breathe_projects.cutwater={folder}/doxygen/xml",
                           "-d", folder / "doctrees", folder / "source", folder / "html"]).returncode
    if status:
        shutil.rmtree(folder / "doctrees", ignore_errors=True)
    return bool(status)


def main():
    root, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    whole = sys.argv[3] == "site"
    python = interpreter() if whole else sys.executable
    if python is None or shutil.which("doxygen") is None:
        print("skipped: needs Doxygen, and Sphinx with furo, Breathe and the MyST parser")
        sys.exit(SKIPPED)
    start = time.monotonic()
    headers, failed = check_comments(root, folder)
    if whole:
        write_pages(root, folder / "source", folder / "doxygen/xml", headers)
        failed |= run_sphinx(python, root, folder)
        take_along(folder / "html")
        outside = reaches_outside(folder / "html")
        print(*outside, sep="\n", end="\n" if outside else "")
        failed |= bool(outside)
        print(f"{folder}/html/index.html after {time.monotonic() - start:.0f} s")
    sys.exit(failed)


main()
