"""Fails if a file of the library, or of Source/Repair or Source/P4est, includes what its layer must not know."""
import pathlib
import re
import sys

# In order: a layer may include itself and the layers named on its line, which all stand above it.
MAY_INCLUDE = {
    "Core": "",
    "Simd": "Core",
    "Bvh": "Core Simd",
    "Sdf": "Core",
    "Shapes": "Core Bvh Sdf",
    "Operations": "Core Bvh Sdf Shapes",
    "Mesh": "Core Simd Bvh Sdf",
    "Lattice": "Core Simd Bvh Sdf Shapes Operations",
    "Tpms": "Core Simd Sdf Shapes Operations",
    "Grid": "Core Sdf Mesh",
    "Render": "Core Sdf Grid",
    "Io": "Core Sdf Shapes Operations Mesh Lattice Tpms Grid Render",
    "Adapters": "Core Sdf Grid",
    "Repair": "Core Bvh Mesh",
    "P4est": "Core Sdf Mesh Grid Io",
}
GPL = {"Repair", "P4est"}  # targets and folders of their own

# GPL code is for those; streams depend on the locale.
FORBIDDEN = re.compile(r"CGAL/|p4est|p8est|gmp|mpfr|iostream|sstream")
# Other people's headers cost users compile time and tie them to versions: only in .cpp files.
PRIVATE = re.compile(r"Eigen/|omp\.h|zlib\.h|png\.h|experimental/|immintrin\.h|toml\+\+/|CLI/|p8est|CGAL/")
OPTIONAL_HEADERS = {"Core/Eigen.hpp"}  # for users of that library only
# Host codes are known to one header each, which nothing else of ours includes.
HOST = re.compile(r"AMReX|BaseIF|deal\.II/|Cutwater/Adapters/(Amrex|Chombo|DealII)\.hpp")
HOST_HEADERS = {"Adapters/Amrex.hpp", "Adapters/Chombo.hpp", "Adapters/DealII.hpp"}
# With one of these, a header is of use to users ...
PUBLIC = re.compile(r"^namespace cutwater(::tessellation)? \{", re.M)
NOT_INSTALLED = "// Private: not installed."  # ... unless it says this
# Not installed.
PRIVATE_HEADERS = {"P4est/ForestBuilder.hpp", "Repair/CgalCall.hpp", "Repair/SurfaceMesh.hpp"}


def umbrella_complaints(name, text, root):
    if HOST.search(text):
        yield f"{name}: adapters' headers for hosts are for these hosts' code only"
    for header in sorted(root.glob("*/**/*.hpp")):
        path = header.relative_to(root).as_posix()
        content = header.read_text()
        if (PUBLIC.search(content) and NOT_INSTALLED not in content
                and path not in HOST_HEADERS | OPTIONAL_HEADERS and f"<Cutwater/{path}>" not in text):
            yield f"{name}: include <Cutwater/{path}>, which is public"


def complaints(source):
    layers = list(MAY_INCLUDE)
    for layer, allowed in MAY_INCLUDE.items():
        for other in allowed.split():
            if layers.index(other) >= layers.index(layer):
                yield f"this list: {layer} stands above {other}"
    for root, file in ((root, file) for root in (source / "Cutwater", *(source / part / "Cutwater" for part in sorted(GPL)))
                       for file in sorted([*root.rglob("*.?pp"), *root.rglob("*.inl")])):
        name = file.relative_to(root)
        layer = name.parts[0]
        if len(name.parts) == 1:  # the header that includes all others
            yield from umbrella_complaints(name, file.read_text(), root)
            continue
        if layer not in MAY_INCLUDE:
            yield f"{name}: {layer} is no layer; see DESIGN"
            continue
        for bracket, path in re.findall(r'^\s*#\s*include ([<"])([^>"]+)', file.read_text(), re.M):
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
                    str(name) not in OPTIONAL_HEADERS | PRIVATE_HEADERS:
                yield f"{name}: include <{path}> in a .cpp only"


found = list(complaints(pathlib.Path(sys.argv[1]) / "Source"))
print("\n".join(found) or "layers ok")
sys.exit(bool(found))
