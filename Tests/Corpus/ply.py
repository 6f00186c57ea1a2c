import itertools
import struct

from cases import FACES, NO_COORDINATES, NO_COUNTS, NO_INDICES, NUMBERS, POINTS, bad, bad_words, good, layouts

ROWS = "".join(" ".join(point) + "\n" for point in POINTS)
TRIANGLES = "".join("3 " + " ".join(map(str, face)) + "\n" for face in FACES)


def header(encoding="ascii", points=4, faces=4, real="float", index="uchar int"):
    """Nine lines; the eighth is the list's."""
    axes = "".join(f"property {real} {axis}\n" for axis in "xyz")
    return (f"ply\nformat {encoding} 1.0\nelement vertex {points}\n{axes}"
            f"element face {faces}\nproperty list {index} vertex_indices\nend_header\n")


TEXT = header() + ROWS + TRIANGLES
LETTERS = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
           "float": "f", "double": "d"}
ORDERS = {"little": "<", "big": ">"}


def binary(order="little", real="float", count="uchar", index="int", counts=(4, 4)):
    mark = ORDERS[order]
    content = header(f"binary_{order}_endian", *counts, real, f"{count} {index}").encode()
    content += b"".join(struct.pack(mark + "3" + LETTERS[real], *point) for point in NUMBERS)
    face = mark + LETTERS[count] + "3" + LETTERS[index]
    return content + b"".join(struct.pack(face, 3, *corners) for corners in FACES)


def ascii_cases():
    yield from layouts("ply-ascii", TEXT)
    five = header(points=5, faces=2) + ROWS
    yield from bad_words("ply-ascii-coordinate", five + "0 @ 0\n" + TRIANGLES, NO_COORDINATES)
    yield from bad_words("ply-ascii-index", five + "1 1 1\n3 0 1 2\n3 0 @ 2\n",
                         {**NO_INDICES, "-1": "out of range"})
    yield from bad_words("ply-ascii-corners", five + "1 1 1\n3 0 1 2\n@ 0 1 2\n", NO_COUNTS)
    words = {word: part for word, part in NO_COUNTS.items() if "promises" not in part}
    yield from bad_words("ply-ascii-points", header(points="@") + ROWS + TRIANGLES, words)
    yield from bad_words("ply-ascii-faces", header(faces="@") + ROWS + TRIANGLES, words)
    for count in (2**32, 10**12, 2**63 - 1):
        yield bad(f"ply-ascii-{count}-points", header(points=count) + ROWS + TRIANGLES, "line 9", f"promises {count}")
        yield bad(f"ply-ascii-{count}-faces", header(faces=count) + ROWS + TRIANGLES, "line 13", f"promises {count}")
    for real, index in itertools.product(("float32", "double", "float64"), ("int uint", "uint8 ushort")):
        yield good(f"ply-ascii-{real}-{index.replace(' ', '-')}", header(real=real, index=index) + ROWS + TRIANGLES)
    yield good("ply-ascii-blank-lines", TEXT.replace("\n3 ", "\n\n3 "))
    yield good("ply-ascii-comments", TEXT.replace("format", "comment a\nobj_info b\nformat").replace(
        "element face", "comment c\nelement face"))
    yield good("ply-ascii-vertex-index", TEXT.replace("vertex_indices", "vertex_index"))
    yield good("ply-ascii-faces-first", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
               "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n" + ROWS,
               faces=1)
    yield good("ply-ascii-extras", "ply\nformat ascii 1.0\nelement nothing 1000000000000\nelement vertex 4\n"
               "property uchar red\nproperty float z\nproperty float y\nproperty list uchar float a\nproperty float x\n"
               "element edge 1\nproperty int a\nproperty list int double b\nelement face 1\n"
               "property list uchar float texcoord\nproperty list uchar int vertex_indices\nend_header\n"
               + "".join(f"9 {z} {y} 2 0.5 0.5 {x}\n" for x, y, z in POINTS) + "7 1 0.5\n1 0.5 3 0 1 2\n", faces=1)


def header_cases():
    for name, old, new, at, part in [
            ("no-x", "float x", "float a", "line 9", "x, y and z"),
            ("x-is-a-list", "float x", "list uchar float x", "line 9", "x, y and z"),
            ("no-vertices", "element vertex", "element vertices", "line 15", "out of range"),
            ("no-list", "vertex_indices", "indices", "line 13", "vertex_indices"),
            ("no-face", "element face", "element faces", "", "no faces"),
            ("unknown-type", "float x", "real x", "line 4", '"real"'),
            ("no-name", "float x", "float", "line 4", "name is missing"),
            ("two-names", "float x", "float x y", "line 4", "end of the line"),
            ("float-indices", "uchar int", "uchar float", "line 13", "vertex_indices"),
            ("float-counts", "uchar int", "float int", "line 8", "integer count"),
            ("unknown-encoding", "ascii", "utf8", "line 2", '"utf8"'),
            ("unknown-version", "1.0", "1.1", "line 2", '"1.1"'),
            ("no-format", "format ascii 1.0\n", "", "line 8", "no format"),
            ("no-end", "end_header\n", "", "line 9", '"0"'),
            ("upper-case", "element vertex", "ELEMENT VERTEX", "line 3", '"ELEMENT"'),
            ("second-element", "element face", "element vertex", "line 7", "a second element"),
            ("property-first", "element vertex 4\n", "", "line 3", "before any element"),
            ("no-count", "element vertex 4", "element vertex", "line 3", "missing"),
            ("nul", "float x", "float\0x", "line 4", "NUL"),
            ("long-line", "float x", "float" + " " * 65536 + "x", "line 4", "64 kB"),
            ("word-behind-ply", "ply\n", "ply 1\n", "line 1", "end of the line"),
            ("one-point-more", "vertex 4", "vertex 5", "line 14", "end of the line"),
            ("one-point-less", "vertex 4", "vertex 3", "line 13", ""),
            ("one-face-more", "face 4", "face 5", "line 13", ""),
            ("one-face-less", "face 4", "face 3", "line 17", "more lines"),
            ("no-faces", f"face 4\n", "face 0\n", "line 14", "more lines")]:
        yield bad(f"ply-header-{name}", TEXT.replace(old, new), at, part)
    yield bad("ply-header-cut", header()[:60], "", "")
    yield bad("ply-header-only", header(), "line 9", "promises")
    start = "ply\nformat ascii 1.0\n"
    yield bad("ply-header-elements", start + "".join(f"element a{i} 1\n" for i in range(300)), "line 259", "too many")
    yield bad("ply-header-properties", start + "element a 1\n" + "property int a\n" * 5000, "line 4100", "too many")
    for name, old, new, at, part in [
            ("two-corners", "3 0 2 1", "2 0 2", "line 14", "2 corners"), ("no-corners", "3 0 2 1", "0 " + " " * 9, "line 14", "0 corners"),
            ("missing-corner", "3 0 2 1", "3 0 2", "line 14", "missing"),
            ("corner-too-many", "3 0 2 1", "3 0 2 1 3", "line 14", "end of the line"),
            ("two-coordinates", "0 1 0\n", "0 1\n", "line 12", "missing"),
            ("four-coordinates", "0 1 0\n", "0 1 0 0\n", "line 12", "end of the line")]:
        yield bad(f"ply-ascii-{name}", TEXT.replace(old, new), at, part)


def binary_cases():
    for order, count, index in itertools.product(ORDERS, ("uchar", "int"), ("int", "uint", "ushort", "char")):
        yield good(f"ply-{order}-{count}-{index}", binary(order, count=count, index=index))
    for order, mark in ORDERS.items():
        yield good(f"ply-{order}-double", binary(order, "double"))
        whole = binary(order, count="int")
        data = len(header(f"binary_{order}_endian", index="int int"))
        faces = f"byte {data + 48}"

        def patched(at, kind, number):
            content = bytearray(whole)
            struct.pack_into(mark + kind, content, data + at, number)
            return bytes(content)

        yield good(f"ply-{order}-padding", whole + bytes(10))
        yield bad(f"ply-{order}-bytes-behind", whole + b"x", f"byte {len(whole)}", "behind the last")
        yield bad(f"ply-{order}-cut", whole[:-1], f"byte {data + 96}", "too early")
        yield bad(f"ply-{order}-cut-in-points", whole[:data + 20], f"byte {data}", "promises 4")
        yield bad(f"ply-{order}-cut-in-header", whole[:data - 5], "", "")
        for name, number in [("nan", float("nan")), ("inf", float("inf")), ("minus-inf", float("-inf"))]:
            yield bad(f"ply-{order}-{name}", patched(16, "f", number), f"byte {data + 12}", "not finite")
        for number, part in [(-1, "-1"), (-2**31, "-2147483648"), (2**31 - 1, "promises 2147483647"),
                             (2, "2 corners"), (0, "0 corners")]:
            yield bad(f"ply-{order}-list-of-{number}", patched(48, "i", number), faces, part)
        for number in (4, -1, 2**31 - 1, -2**31):
            yield bad(f"ply-{order}-index-{number}", patched(52, "i", number), faces, f"index {number}")
        for points, faces_ in [(2**32, 4), (2**63 - 1, 4), (4, 2**32), (4, 2**63 - 1)]:
            yield bad(f"ply-{order}-counts-{points}-{faces_}", binary(order, counts=(points, faces_)), "", "promises")
        yield bad(f"ply-{order}-one-point-less", binary(order, counts=(3, 4)), "", "")
        yield bad(f"ply-{order}-one-face-less", binary(order, counts=(4, 3)), "", "behind the last")


def cases():
    return [*ascii_cases(), *header_cases(), *binary_cases()]
