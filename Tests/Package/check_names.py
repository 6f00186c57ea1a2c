"""Every name that a page mentions exists. Usage: check_names.py ROOT

Code in pages is compiled (see check_sources.py readme); this is about names within the text, in backticks:
functions, types and constants must be in public headers, options in the command or a script, and keys of
JSON in what writes it. Pages for those who change the library may name what is internal. Names of other
libraries are listed in foreign-names.txt.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
INTERNAL = {"Detail", "Formats", "Text", "Simd", "Triangles"}  # folders of headers that are not for users
INSIDE = {"architecture.md", "bibliography.md", "CONTRIBUTING.md"}  # pages for those who change the library
WORD = re.compile(r"[A-Za-z_]\w*")
OPTION = re.compile(r"(?<![\w-])--[a-z][\w-]*")


def words_of(files):
    return {word for file in files for word in WORD.findall(file.read_text(errors="replace"))}


def files_in(folder, *suffixes):
    return [file for file in sorted((ROOT / folder).rglob("*"))
            if file.is_file() and file.suffix in suffixes and "corpus" not in file.parts]


def foreign():
    lines = (ROOT / "Tests/Package/foreign-names.txt").read_text().splitlines()
    return {line.split()[0] for line in lines if line and not line.startswith("#")}


def names_in(code):
    """What looks like a name of the interface in a piece of code: `clean()`, `CleanOptions::opposite`,
    `{.weldWithin = 1e-5}`, `MeshSDF<T>`, `kNone`, `cw_union`."""
    yield from re.findall(r"\b([A-Za-z_]\w*)(?=\()", code)
    yield from re.findall(r"\b([A-Z]\w*)::", code)
    yield from re.findall(r"::(\w+)", code)
    yield from re.findall(r"[{,] *\.(\w+)", code)
    alone = re.fullmatch(r"(\w+)(<[\w, ]*>)?", code)
    if alone and re.search(r"[a-z][A-Z]|^[A-Z]{2,}[a-z]|^[A-Z]\w*SDF$|^cw_", alone[1]):
        yield alone[1]


def pairs_in(code):
    """A class, or an enum, and its member: `OppositeFaces::Cancel`."""
    return re.findall(r"\b([A-Z]\w*)::(\w+)", code)


def enumerators_in(files):
    """Enum -> its values."""
    enums = {}
    for file in files:
        text = re.sub(r"//.*", "", file.read_text())
        for name, body in re.findall(r"\benum class (\w+)[^{;]*\{([^}]*)\}", text):
            enums[name] = set(WORD.findall(body))
    return enums


def main():
    public = [file for file in files_in("Source", ".hpp") if not INTERNAL & set(file.parts)]
    together = [words_of([file]) for file in public]
    enums = enumerators_in(public)
    interface = set().union(*together) | words_of([ROOT / "Bindings/C/cutwater.h",
                                                   *files_in("Examples/Fortran", ".f90")])
    written = [*files_in("Source", ".cpp"), *files_in("Tools", ".cpp")]
    keys = {key for file in written for key in re.findall(r'"([a-z]\w*)"', file.read_text())}
    inside = words_of([*(file for folder in ("Source", "Tools", "Tests", "Bindings", "Benchmarks", "Docs/site")
                         for file in files_in(folder, ".hpp", ".cpp", ".inl", ".py", ".txt", ".in")),
                       ROOT / "CMakeLists.txt"])
    scripts = [file for file in (ROOT / "Scripts").iterdir() if file.is_file()]
    options = {option for file in [*files_in("Tools", ".cpp"), *scripts]
               for option in OPTION.findall(file.read_text())}
    others = foreign()

    found, mentioned = [], set()
    for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "Docs").glob("*.md"))]:
        known = interface | keys | others | (inside if page.name in INSIDE else set())
        text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
        text = re.sub(r"^    .*$", "", text, flags=re.MULTILINE)
        for code in re.findall(r"(?<!`)`([^`\n]+)`", text):
            mentioned |= set(WORD.findall(code)) | set(OPTION.findall(code))
            unknown = [name for name in names_in(code) if name not in known]
            unknown += [option for option in OPTION.findall(code) if option not in options | others]
            if not unknown and page.name not in INSIDE:
                unknown = [f"{owner}::{member}" for owner, member in pairs_in(code) if owner not in others and
                           (member not in enums[owner] if owner in enums else
                            not any({owner, member} <= words for words in together))]
            found += [f"{page.relative_to(ROOT)}: `{code}`: there is no {name}" for name in unknown]
    found += [f"foreign-names.txt: no page mentions {name}: strike it out" for name in sorted(others - mentioned)]
    print("\n".join(dict.fromkeys(found)) or f"{len(mentioned)} words in backticks: ok")
    sys.exit(bool(found))


main()
