"""Fails unless the C library defines exactly the functions its header declares, and a shared one
shows nothing else. Usage: check_exports.py NM HEADER LIBRARY
"""
import pathlib
import re
import subprocess
import sys


def defined(nm, library):
    """Names with C linkage in a static library; all that are visible in a shared one."""
    shared = not library.endswith(".a")
    listing = subprocess.run([nm, "-D" if shared else "-g", "--defined-only", library],
                             capture_output=True, text=True, check=True).stdout
    names = {line.split()[2] for line in listing.splitlines() if len(line.split()) == 3}
    return names if shared else {name for name in names if not re.match(r"_Z|DW\.ref\.", name)}


def declared(header):
    code = re.sub(r"//.*", "", pathlib.Path(header).read_text())
    return set(re.findall(r"\b(cw_\w+)\(", code))


there, wanted = defined(sys.argv[1], sys.argv[3]), declared(sys.argv[2])
found = [f"declared and not defined: {name}" for name in sorted(wanted - there)]
found += [f"defined and not declared: {name}" for name in sorted(there - wanted)]
print("\n".join(found) or f"{len(wanted)} functions")
sys.exit(bool(found) or not wanted)
