"""Fails if a file compiled for one instruction set defines a symbol that others would share.

    check_symbols.py NM OBJECT;OBJECT...

The linker keeps one copy of a weak symbol, such as an inline function of the standard library. Were
it one compiled for AVX-512, the library would crash on processors without.
"""
import pathlib
import re
import subprocess
import sys

OWN = re.compile(r"cutwater::(portable|baseline|avx2|avx512)::")


def complaints(nm, objects):
    for file in objects:
        listing = subprocess.run([nm, "-C", "--defined-only", file], capture_output=True, text=True,
                                 check=True).stdout
        names = [line.split(maxsplit=2)[1:] for line in listing.splitlines()]
        if not any(kind == "T" and OWN.search(name) for kind, name in names):
            yield f"{file}: defines nothing for its instruction set"
        for kind, name in names:
            if kind in "WVuTDBR" and not OWN.search(name) and not name.startswith("DW.ref."):
                yield f"{pathlib.Path(file).name}: shares {name}"


found = list(complaints(sys.argv[1], sys.argv[2].split(";")))
print("\n".join(found) or "symbols ok")
sys.exit(bool(found))
