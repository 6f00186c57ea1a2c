#!/usr/bin/env python3
"""Writes the corpus of bad, and of odd but good, files, each with the answer that is due.

Usage: make_corpus.py FOLDER [GEOMETRY...]

FOLDER/files holds the files, FOLDER/answers.txt a line for each, of fields between tabs:

    name  reader  answer  place  part of the message  points  faces  patches

where the answer is "read", or the kind of the Error. FOLDER/locale gets a locale "comma" with a
decimal comma where there is a localedef. GEOMETRY: intact geometry files, to be damaged.
"""
import collections
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True

import geometry
import obj
import off
import other
import ply
import points
import stl
import vtk

LOCALE = """comment_char %
escape_char /
LC_NUMERIC
decimal_point "<U002C>"
thousands_sep "<U002E>"
grouping 3;3
END LC_NUMERIC
"""
CHARACTERS = "<code_set_name> ASCII\n<comment_char> %\n<escape_char> /\nCHARMAP\n" + "".join(
    f"<U{code:04X}> /x{code:02x} NAME\n" for code in range(128)) + "END CHARMAP\n"


def write_locale(folder):
    """By our own definition: the system's, such as de_DE, may not be installed."""
    program = shutil.which("localedef")
    if program is None:
        return
    folder.mkdir(exist_ok=True)
    (folder / "definition").write_text(LOCALE)
    (folder / "characters").write_text(CHARACTERS)
    # -c: the other categories are left out, which it warns of.
    subprocess.run([program, "-c", "-i", folder / "definition", "-f", folder / "characters", folder / "comma"],
                   capture_output=True)


def line(case):
    fields = (case.name, case.reader, case.answer, case.at, case.part, case.points, case.faces, case.patches)
    text = "\t".join(map(str, fields))
    assert text.count("\t") == len(fields) - 1 and "\n" not in text, text
    return text + "\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    found = [case for source in (stl, obj, off, ply, vtk, other, points) for case in source.cases()]
    found += geometry.cases([pathlib.Path(word) for word in sys.argv[2:]])
    repeated = [name for name, times in collections.Counter(case.name for case in found).items() if times > 1]
    assert not repeated, repeated
    shutil.rmtree(folder / "files", ignore_errors=True)
    (folder / "files").mkdir(parents=True)
    for case in found:
        (folder / "files" / case.name).write_bytes(case.content)
    (folder / "answers.txt").write_text("".join(map(line, found)))
    write_locale(folder / "locale")
    kinds = collections.Counter((case.name.partition("-")[0], case.answer == "read") for case in found)
    for kind in sorted({kind for kind, _ in kinds}):
        print(f"{kind:10} {kinds[kind, False]:4} refused {kinds[kind, True]:4} read")
    print(f"{len(found)} files")


main()
