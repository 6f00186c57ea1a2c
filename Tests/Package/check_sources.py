"""Checks of the sources as text. Usage: check_sources.py ROOT CHECK [program]

  format        clang-format (the program given) would change nothing
  length        no file is longer than one can take in
  paths         no path of one machine in any file
  manners       the library does not print, exit or depend on the locale
  mirror        a test file per unit, and every unit and test file in its folder's list
  expectations  every test case expects something
  scripts       scripts are executable and pass shellcheck (the program given)
  readme        C++, C and Fortran in the README and in Docs are marked regions of what is compiled
  links         relative links in pages lead to files and headings that are there, and every page in
                Docs is in the site's contents
"""
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = sys.argv[3] if len(sys.argv) > 3 else ""
SKIPPED = 77  # ctest's SKIP_RETURN_CODE
FOLDERS = ["Source", "Tests", "Tools", "Examples", "Bindings", "Benchmarks", "Scripts", "Docs", ".ci"]
PARTS = ["P4est", "Render", "Repair", "Scene"]  # libraries beside the main one, a folder each
LIBRARIES = [ROOT / "Source/Cutwater", *(ROOT / f"Source/{part}/Cutwater" for part in PARTS)]
SOURCES = {".hpp", ".cpp", ".inl", ".h", ".c"}


def all_files():
    for folder in FOLDERS:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.is_file() and "__pycache__" not in file.parts:
                yield file
    yield from sorted(f for f in ROOT.iterdir() if f.is_file() and f.name not in (".git", "compile_commands.json"))


def sources():
    return [file for file in all_files() if file.suffix in SOURCES]


def name(file):
    return file.relative_to(ROOT).as_posix()


def check_format():
    if not pathlib.Path(PROGRAM).is_file():
        return None
    done = subprocess.run([PROGRAM, "--dry-run", "-Werror", *sources()], capture_output=True, text=True)
    wrong = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", done.stderr, re.MULTILINE)))
    if done.returncode and not wrong:
        return [done.stderr]
    return [f"{name(pathlib.Path(file))}: run clang-format -i" for file in wrong]


def check_length():
    found = []
    for file in sources():
        lines = len(file.read_text().splitlines())
        if lines > 400:
            found.append(f"{name(file)}: {lines} lines; at most 400, better below 300")
        elif lines > 300:
            print(f"{name(file)}: {lines} lines, more than 300: is it one thing?")
    return found


def check_paths():
    places = re.compile(r"(?<![\w.$}*])/(home|root|Users|work|farm|tmp)/[\w.]")
    found = []
    for file in all_files():
        data = file.read_bytes()
        if b"\0" in data:
            continue
        for number, line in enumerate(data.decode(errors="replace").splitlines(), 1):
            if places.search(line):
                found.append(f"{name(file)}:{number}: {line.strip()[:80]}")
    return found


def listed(folder):
    """The words in a folder's list of units."""
    lists = folder / "CMakeLists.txt"
    text = re.sub(r"#.*", "", lists.read_text()) if lists.exists() else ""
    return set(re.split(r"[\s()]+", text))


def check_manners():
    """The library does not print, does not end the program, and does not ask the locale."""
    ours = re.compile(r"\b(printf|puts|putchar|perror|exit|_Exit|quick_exit|abort|terminate)\s*\(|"
                      r"\bstd::(cout|cerr|clog)\b|\bstderr\b")
    locale = re.compile(r"\b(sn?printf|v?s?scanf|fscanf|ato[fil]|strto\w+|sto[dfil]\w*)\s*\(|"
                        r"\bstd::[io]?stringstream\b")
    found = []
    for file in sources():
        if not {*LIBRARIES} & {*file.parents}:
            continue
        for number, line in enumerate(file.read_text().splitlines(), 1):
            code = re.sub(r"//.*", "", line)
            if ours.search(code):
                found.append(f"{name(file)}:{number}: throw Error, or return a report: {line.strip()}")
            if locale.search(code):
                found.append(f"{name(file)}:{number}: use to_chars, from_chars: {line.strip()}")
    return found


def tested_elsewhere():
    """Unit -> the test that covers it, from the list beside this file."""
    text = (ROOT / "Tests/Package/tested-elsewhere.txt").read_text()
    rows = [line.split(maxsplit=2) for line in text.splitlines() if line and line[0] != "#"]
    return {unit: test for unit, test, _ in rows}


def check_mirror():
    elsewhere = tested_elsewhere()
    found = [f"tested-elsewhere.txt: {unit}: there is no Tests/{test}"
             for unit, test in elsewhere.items() if not (ROOT / "Tests" / test).exists()]
    units = set()
    for library in LIBRARIES:
        for file in sorted(library.rglob("*.*pp")):
            unit = file.relative_to(library).with_suffix("").as_posix()
            layer, _, inner = unit.partition("/")
            if not inner:
                continue  # a header of all headers
            units.add(unit)
            lists = library.parent if layer in PARTS else library / layer
            if file.suffix == ".cpp" and inner not in listed(lists):
                found.append(f"{name(file)} is not listed in {name(lists)}/CMakeLists.txt")
    for unit in sorted(units):
        layer, _, inner = unit.partition("/")
        stem = inner.rpartition("/")[2]
        tested = any((ROOT / f"Tests/{layer}/{test}Test.cpp").exists() for test in (inner, stem))
        if not tested and unit not in elsewhere:
            found.append(f"{unit} has no Tests/{layer}/{stem}Test.cpp")
        if tested and unit in elsewhere:
            found.append(f"tested-elsewhere.txt: {unit} has a test now: strike it out")
    found += [f"tested-elsewhere.txt: {unit} is gone: strike it out"
              for unit in elsewhere if unit not in units]
    for file in sorted((ROOT / "Tests").rglob("*Test.cpp")):
        if file.stem.removesuffix("Test") not in listed(file.parent):
            found.append(f"{name(file)} is not in its folder's cutwater_tests: it never runs")
    return found


EXPECTS = r"\b(EXPECT_|ASSERT_|ADD_FAILURE|FAIL\(|(expect|check)[A-Z])"


def expecting(file):
    """What counts as an expectation in a test file: gtest's, those named expect... or check..., and
    functions of the file and its folder's headers that contain one."""
    texts = [f.read_text() for f in (file, *sorted(file.parent.glob("*.hpp")))]
    blocks = [block for text in texts for block in re.split(r"^};?$", text, flags=re.MULTILINE)]
    helpers = set()
    while True:
        wanted = re.compile("|".join([EXPECTS, *(rf"\b{helper}[(<]" for helper in sorted(helpers))]))
        more = set()
        for block in blocks:
            heads = re.findall(r"^[A-Za-z_][^\n(]*?\b(\w+)\(", block, re.MULTILINE)
            if heads and not re.match(r"(TYPED_)?TEST", heads[-1]) and wanted.search(block):
                more.add(heads[-1])
        if more <= helpers:
            return wanted
        helpers |= more


def check_expectations():
    found = []
    start = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\(([^)]*)\)", re.MULTILINE)
    for file in sorted((ROOT / "Tests").rglob("*Test.cpp")):
        text, wanted = file.read_text(), expecting(file)
        cases = list(start.finditer(text))
        if not cases:
            found.append(f"{name(file)}: no test case")
        for case, end in zip(cases, [c.start() for c in cases[1:]] + [len(text)]):
            if not wanted.search(text[case.end():end]):
                found.append(f"{name(file)}: {case[1]} expects nothing")
    return found


def check_scripts():
    found = []
    scripts = [file for file in all_files() if file.read_bytes()[:2] == b"#!"]
    for file in scripts:
        if not file.stat().st_mode & 0o100:
            found.append(f"{name(file)}: not executable")
    shell = [file for file in scripts if b"sh" in file.read_bytes().split(b"\n", 1)[0]]
    for file in shell:
        if not re.search(r"^set -euo pipefail$", file.read_text(), re.MULTILINE):
            found.append(f"{name(file)}: needs set -euo pipefail")
    if shell and pathlib.Path(PROGRAM).is_file():
        done = subprocess.run([PROGRAM, "-x", *shell], capture_output=True, text=True, cwd=ROOT)
        if done.returncode:
            found.append(done.stdout)
    else:
        print("no shellcheck here: only the executable bits and the shell's options were checked")
    return found


def check_readme():
    block = re.compile(r"```(?:cpp|c|fortran)\n(.*?)```", re.DOTALL)
    region = re.compile(r"// \[README\n(.*?)\n *// README\]|/\* \[README \*/\n(.*?)\n */\* README\] \*/|"
                        r"// \[DOCS\n(.*?)\n *// DOCS\]|/\* \[DOCS \*/\n(.*?)\n */\* DOCS\] \*/|"
                        r"! \[DOCS\n(.*?)\n *! DOCS\]", re.DOTALL)
    compiled = set()
    for file in [file for folder in ("Examples", "Tests") for file in (ROOT / folder).rglob("*")
                 if file.suffix in SOURCES | {".f90"}]:
        for texts in region.findall(file.read_text()):
            compiled.add(textwrap.dedent(next(filter(None, texts))).strip())
    pages = [ROOT / "README.md", *sorted((ROOT / "Docs").glob("*.md"))]
    blocks = [(page, text) for page in pages for text in block.findall(page.read_text())]
    if not compiled or not any(page.name == "README.md" for page, _ in blocks):
        return ["no code in the README, or no region marked // [README ... // README] in Examples"]
    return [f"{name(page)}: not from what is compiled:\n{text}"
            for page, text in blocks if text.strip() not in compiled]


def headings(page):
    """The anchors of a page's headings, as repository hosts and the site make them."""
    found = re.findall(r"^#+ (.+)$", re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in found}


def check_links():
    found = []
    link = re.compile(r"\]\((?!\w+:)([^)#\s]*)(?:#([^)\s]*))?\)")
    for page in [file for file in all_files() if file.suffix == ".md"]:
        for target, anchor in link.findall(re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)):
            file = page.parent / target if target else page
            if not file.exists():
                found.append(f"{name(page)}: no file {target}")
            elif anchor and anchor not in headings(file):
                found.append(f"{name(page)}: no heading {target}#{anchor}")
    # An entry is a path, or a title and <a path>.
    contents = re.findall(r"[^\s<>]+", (ROOT / "Docs/site/contents.md").read_text())
    return found + [f"{name(page)}: not in Docs/site/contents.md"
                    for page in sorted((ROOT / "Docs").glob("*.md")) if f"Docs/{page.stem}" not in contents]


def main():
    check = sys.argv[2]
    found = globals()[f"check_{check}"]()
    if found is None:
        print("skipped: the program it needs is not here")
        sys.exit(SKIPPED)
    print("\n".join(found) or f"{check}: ok")
    sys.exit(bool(found))


main()
