"""Fails if a file of the library or of its components includes what its layer must not know, or if what
is installed is not what users need. Usage: check_layers.py ROOT
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
SOURCE = ROOT / "Source"
sys.path.append(str(ROOT / "Docs/site"))
from headers import installed  # noqa: E402  the CMake lists, as the reference reads them

# In order: a layer may include itself and the layers named on its line, which all stand above it.
MAY_INCLUDE = {
    "Core": "",
    "Text": "Core",
    "Simd": "Core",
    "Bvh": "Core",
    "Sdf": "Core",
    "Shapes": "Core Bvh Sdf",
    "Operations": "Core Bvh Sdf Shapes",
    "Triangles": "Core Simd Bvh Sdf",
    "Surface": "Core Text Bvh Triangles",
    "Mesh": "Core Text Bvh Sdf Triangles Surface",
    "Lattice": "Core Simd Bvh Sdf Shapes Operations",
    "Tpms": "Core Simd Sdf Shapes Operations",
    "Grid": "Core Sdf Surface",
    "CutCells": "Core Text Bvh Sdf Shapes Operations Triangles Surface Mesh Grid",
    "Polyhedra": "Core Triangles Surface Grid CutCells",
    "Io": "Core Text Surface Lattice Grid CutCells Polyhedra",
    "Adapters": "Core Sdf Grid CutCells",
    "Render": "Core Bvh Sdf Operations Grid CutCells",
    "Scene": "Core Text Sdf Shapes Operations Surface Mesh Lattice Tpms Io",
    "Repair": "Core Text Bvh Surface Mesh",
    "P4est": "Core Surface Mesh Grid CutCells Io",
}
PARTS = {"Render", "Scene", "Repair", "P4est"}  # components, each in a folder of its own
GPL = {"Repair", "P4est"}
# Nothing in these is for users, nor in a folder Detail/ or Formats/: such a header is installed only if
# an installed one includes it.
INTERNAL_LAYERS = {"Text", "Simd", "Triangles"}
INTERNAL_FOLDERS = {"Detail", "Formats"}
MOST_INSTALLED = 155

# GPL code is for those; streams depend on the locale.
FORBIDDEN = re.compile(r"CGAL/|p4est|p8est|gmp|mpfr|iostream|sstream")
# Other people's headers cost users compile time and tie them to versions: only in .cpp files.
PRIVATE = re.compile(r"Eigen/|omp\.h|zlib\.h|expat\.h|png\.h|xxhash\.h|experimental/|immintrin\.h|toml\+\+/|CLI/|p8est|CGAL/")
OPTIONAL_HEADERS = {"Core/Eigen.hpp"}  # for users of that library only
# Host codes are known to one header each, which nothing else of ours includes.
HOST = re.compile(r"AMReX|BaseIF|IrregNode|deal\.II/|Cutwater/Adapters/(Amrex|AmrexEB|Chombo|ChomboCutCells|DealII)\.hpp")
HOST_HEADERS = {"Adapters/Amrex.hpp", "Adapters/AmrexEB.hpp", "Adapters/Chombo.hpp", "Adapters/ChomboCutCells.hpp",
                "Adapters/DealII.hpp"}
# What users read and run.
USERS = [*sorted((ROOT / "Docs").glob("*.md")), ROOT / "README.md",
         *(f for folder in ("Examples", "Tools", "Bindings") for f in sorted((ROOT / folder).rglob("*"))
           if f.suffix in {".hpp", ".cpp", ".md"})]


def includes(file):
    """(bracket, path) of each."""
    return re.findall(r'^\s*#\s*include ([<"])([^>"]+)', file.read_text(), re.M)


def is_internal(path):
    """Of a path within Cutwater/, such as Mesh/Detail/MeshLayout.hpp."""
    layer, *folders = path.split("/")[:-1] or [""]
    return layer in INTERNAL_LAYERS or bool(INTERNAL_FOLDERS & {*folders})


def complaints_about_includes():
    layers = list(MAY_INCLUDE)
    for layer, allowed in MAY_INCLUDE.items():
        for other in allowed.split():
            if layers.index(other) >= layers.index(layer):
                yield f"this list: {layer} stands above {other}"
    roots = [SOURCE / "Cutwater", *(SOURCE / part / "Cutwater" for part in sorted(PARTS))]
    for file, root in ((file, root) for root in roots for file in sorted([*root.rglob("*.?pp"), *root.rglob("*.inl")])):
        name = file.relative_to(root)
        layer = name.parts[0]
        if len(name.parts) == 1:  # a header that includes all others
            continue
        if layer not in MAY_INCLUDE:
            yield f"{name}: {layer} is no layer; see Docs/architecture.md"
            continue
        for bracket, path in includes(file):
            inside = re.match(r"Cutwater/(\w+)/", path)
            if bracket == '"':
                yield f'{name}: include <Cutwater/...> and not "{path}"'
            elif inside and inside[1] not in {layer, *MAY_INCLUDE[layer].split()}:
                yield f"{name}: {layer} must not include {inside[1]}"
            elif FORBIDDEN.match(path) and layer not in GPL:
                yield f"{name}: the library does not use <{path}>"
            elif HOST.match(path) and str(name) not in HOST_HEADERS:
                yield f"{name}: only an adapter's header for a host includes <{path}>"
            elif name.suffix == ".hpp" and PRIVATE.match(path) and \
                    str(name) not in OPTIONAL_HEADERS and not is_internal(str(name)):
                yield f"{name}: include <{path}> in a .cpp only"


def headers():
    """Path within Cutwater/ -> file, of every header of the library and its components."""
    roots = [SOURCE / "Cutwater", *(SOURCE / part / "Cutwater" for part in sorted(PARTS))]
    return {file.relative_to(root).as_posix(): file for root in roots for file in sorted(root.rglob("*.hpp"))
            if file.parent != root}


def declared(text):
    """The types and functions that a header declares outside of namespaces of details."""
    text = re.sub(r"namespace (cutwater::)?detail \{.*?\n\} *// namespace (cutwater::)?detail", "", text, flags=re.S)
    types = re.findall(r"^(?:class|struct|enum class|concept|using) (\w+)", text, re.M)
    functions = re.findall(r"^(?:\[\[nodiscard\]\] )?(?:inline |constexpr )*[\w:<>, ]+[ &*](\w+)\(", text, re.M)
    return {*types, *functions}


def complaints_about_types():
    """Two types of one name in one namespace: the linker takes what templates make of them for the same."""
    places = {}
    for name, file in headers().items():
        namespaces = []
        for line in file.read_text().splitlines():
            if opened := re.match(r"namespace ([\w:]+) \{", line):
                namespaces.append(opened[1])
            elif line.startswith("}  // namespace") and namespaces:
                namespaces.pop()
            elif defined := re.match(r"(?:struct|class|enum class) (\w+)(?: final)?(?: :[^;]*)? ?\{", line):
                places.setdefault("::".join([*namespaces, defined[1]]), set()).add(name)
    for name, files in places.items():
        if len(files) > 1:
            yield f"{name} is in {' and in '.join(sorted(files))}"


def complaints_about_installed():
    every, ours = headers(), {path.removeprefix("Cutwater/") for path in installed(ROOT)}
    included = {path.removeprefix("Cutwater/") for name in ours for _, path in includes(every[name])}
    if len(ours) > MOST_INSTALLED:
        yield f"{len(ours)} headers are installed: {MOST_INSTALLED} will do"
    text = "\n".join(file.read_text() for file in USERS)
    words = {*re.findall(r"\w+", text)}
    for name in sorted(every):
        if name in ours and is_internal(name) and name not in included:
            yield f"{name} is installed, and no installed header includes it: list it as PRIVATE"
        elif name in included - ours:
            yield f"{name} is included by an installed header: list it as PUBLIC"
        elif not is_internal(name) and name not in ours:
            yield f"{name} is for users by its folder: list it as PUBLIC, or move it to Detail/"
        elif not is_internal(name) and not declared(every[name].read_text()) & words:
            yield f"{name}: no example, page or command uses what it declares"
    for umbrella in [SOURCE / "Cutwater/Cutwater.hpp", *(SOURCE / p / f"Cutwater/{p}.hpp" for p in sorted(PARTS))]:
        layers = {umbrella.stem} if umbrella.stem in PARTS else {*MAY_INCLUDE} - PARTS
        wanted = {name for name in ours if name.split("/")[0] in layers and not is_internal(name)}
        has = {path.removeprefix("Cutwater/") for _, path in includes(umbrella)}
        for name in sorted(wanted - OPTIONAL_HEADERS - HOST_HEADERS ^ has):
            yield f"{umbrella.name}: {'do not ' if name in has else ''}include <Cutwater/{name}>"


found = [*complaints_about_includes(), *complaints_about_types(), *complaints_about_installed()]
print("\n".join(found) or f"layers ok; {len(installed(ROOT))} headers installed")
sys.exit(bool(found))
