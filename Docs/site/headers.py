"""The headers that are installed, by layer, and what the reference shows of them."""
import re

# In the order of the reference: the layer's heading, and what is in it.
LAYERS = {
    "Core": "vectors, boxes, intervals, motions, levels and grid patches, errors",
    "Sdf": "the signed distance function, its guarantee, and the value that holds any of them",
    "Shapes": "analytic shapes",
    "Operations": "operators on solids",
    "Bvh": "the tree: nearest primitives, overlaps, crossings",
    "Surface": "surfaces: files, cleaning, checks, the half-edge mesh",
    "Mesh": "signed distances of meshes",
    "Lattice": "beams, unit cells, lattices, packed beds",
    "Tpms": "triply periodic surfaces: patterns, maps, walls and channels, two fluids",
    "Grid": "filling grid patches, volumes, isosurfaces, refinement tags, octree meshes",
    "CutCells": "cut cells of meshes: volumes, apertures and walls of every piece of fluid",
    "Polyhedra": "the fluid as a mesh of polyhedra",
    "Io": "VTK files, tables of beams and balls, meshes for OpenFOAM",
    "Adapters": "AMReX, Chombo, deal.II; their headers are needed to use these",
    "Render": "pictures of solids and of planes through them: `Cutwater::Render`",
    "Scene": "solids from text: `Cutwater::Scene`",
    "Repair": "holes, self-intersections and wraps by CGAL: `Cutwater::Repair`, GPL",
    "P4est": "octree meshes over MPI: `Cutwater::P4est`, GPL",
    "C": "the interface for C and whatever can call it: `Cutwater::C`",
}


def lists(text, command):
    """The words of every call of a CMake command."""
    text = re.sub(r"#.*", "", text)
    return [call.split() for call in re.findall(rf"\b{command}\(([^)]*)\)", text)]


def public(words):
    """The units that a call of cutwater_sources or cutwater_part names as public."""
    end = words.index("PRIVATE") if "PRIVATE" in words else len(words)
    return words[words.index("PUBLIC") + 1:end] if "PUBLIC" in words else []


def installed(root):
    """Path as users include it -> file, as the CMake lists have them."""
    found = {}
    for cmake in sorted((root / "Source/Cutwater").rglob("CMakeLists.txt")):
        for words in lists(cmake.read_text(), "cutwater_sources"):
            files = [cmake.parent / f"{unit}.hpp" for unit in public(words)]
            found |= {f.relative_to(root / "Source").as_posix(): f for f in files if f.exists()}
    for cmake in sorted((root / "Source").glob("*/CMakeLists.txt")):
        for name, *words in lists(cmake.read_text(), "cutwater_part"):
            files = [cmake.parent / f"Cutwater/{name}/{unit}.hpp" for unit in public(words)]
            found |= {f.relative_to(cmake.parent).as_posix(): f for f in files if f.exists()}
    return found


def documented(root):
    """Of these, what users call; and the header for C."""
    found = {path: file for path, file in installed(root).items() if "Detail" not in path.split("/")}
    return found | {"cutwater.h": root / "Bindings/C/cutwater.h"}


def layer(path):
    return path.split("/")[1] if "/" in path else "C"


def group(path):
    """The name of the Doxygen group that holds what a header declares."""
    return re.sub(r"\W", "_", path)


def without_local_macros(text):
    """Macros that a header undefines are its own business, and so is what they make."""
    for macro in re.findall(r"^#undef (\w+)", text, re.MULTILINE):
        for pattern in (rf"^#define {macro}\b(.*\\\n)*.*", rf"^{macro}\(.*", rf"^#undef {macro}$"):
            text = re.sub(pattern, lambda match: "\n" * match[0].count("\n"), text, flags=re.MULTILINE)
    return text


def introduction(path, text):
    """The comment about a header as a whole, without its slashes: C's first one, or that above the
    namespace."""
    behind = r"\n(?!///)" if layer(path) == "C" else r"namespace cutwater\S* \{"
    found = re.search(rf"^((?:///.*\n)+){behind}", text, re.MULTILINE)
    return re.sub(r"^/// ?", "", found[1], flags=re.MULTILINE) if found else ""


def without_introduction(path, text):
    lines = "".join(f"///{' ' if line else ''}{line}\n" for line in introduction(path, text).splitlines())
    return text.replace(lines, "\n" * lines.count("\n"), 1) if lines else text


def shown(path, text):
    """The header as Doxygen reads it, with its lines where they were: what it declares is one group;
    namespaces of details and explicit instantiations are left out."""
    # The comment that opens the group goes on in the next line, which is empty.
    opened = f"  /** @addtogroup {group(path)}"
    opens = r"#include" if layer(path) == "C" else r"namespace cutwater(::tessellation)? \{"
    lines, hidden, instantiation = [], False, False
    for line in without_introduction(path, without_local_macros(text)).splitlines():
        # Doxygen takes every word of a list for an exception's name.
        line = re.sub(r"@throws (Error(\(\w+\))?),", r"@throws \1", line)
        hidden |= bool(re.match(r"namespace (cutwater::)?detail \{", line))
        instantiation |= line.startswith("extern template")
        lines.append("" if hidden or instantiation else line)
        if len(lines) > 1 and lines[-2].endswith(opened):
            lines[-1] = f"@{{ */ {line}"
        if re.match(opens, line):
            lines[-1] += opened
            opens = "(?!)"
        if re.match(r"\} *// namespace cutwater(::tessellation)?$", line):
            lines[-1] = "/** @} */ " + line
        instantiation &= not line.endswith(";")
        hidden &= not re.match(r"\} *// namespace (cutwater::)?detail$", line)
    return "\n".join([*lines, "/** @} */"] if layer(path) == "C" else lines) + "\n"


def write_if_changed(file, text):
    """Unchanged files keep their times, so that what is built from them is not built again."""
    if not file.exists() or file.read_text() != text:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def write_shown(root, folder):
    """Writes all headers as Doxygen reads them into a folder; returns documented()."""
    headers = documented(root)
    for path, file in headers.items():
        write_if_changed(folder / path, shown(path, file.read_text()))
    for file in folder.rglob("*.h*"):
        if file.relative_to(folder).as_posix() not in headers:
            file.unlink()
    return headers

