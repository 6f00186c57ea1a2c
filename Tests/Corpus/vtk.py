import struct

from cases import FACES, NO_COORDINATES, NO_COUNTS, NO_INDICES, NUMBERS, POINTS, bad, bad_words, good, layouts

ROWS = "".join(" ".join(point) + "\n" for point in POINTS)
TRIANGLES = "".join("3 " + " ".join(map(str, face)) + "\n" for face in FACES)
CORNERS = [i for face in FACES for i in face]


def start(version="3.0", encoding="ASCII"):
    return f"# vtk DataFile Version {version}\nany title, solid or ply\n{encoding}\nDATASET POLYDATA\n"


POINT_ROWS = f"POINTS 4 float\n{ROWS}"                                 # lines 5 to 9
OLD = f"{start()}{POINT_ROWS}POLYGONS 4 16\n{TRIANGLES}"               # the cells on lines 11 to 14
NEW = (f"{start('5.1')}{POINT_ROWS}POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\n"
       f"CONNECTIVITY vtktypeint64\n{' '.join(map(str, CORNERS))}\n")  # offsets on 12, corners on 14
FIVE = f"{start()}POINTS 5 float\n{ROWS}1 1 1\n"


def binary(version="3.0", real="float"):
    content = start(version, "BINARY").encode() + f"POINTS 4 {real}\n".encode()
    letter = {"float": "f", "double": "d"}[real]
    content += struct.pack(f">12{letter}", *(x for point in NUMBERS for x in point)) + b"\n"
    if version < "5":
        return content + b"POLYGONS 4 16\n" + b"".join(struct.pack(">4i", 3, *face) for face in FACES) + b"\n"
    content += b"POLYGONS 5 12\nOFFSETS vtktypeint64\n" + struct.pack(">5q", 0, 3, 6, 9, 12)
    return content + b"\nCONNECTIVITY vtktypeint64\n" + struct.pack(">12q", *CORNERS) + b"\n"


def words():
    yield from bad_words("vtk-coordinate", f"{start()}POINTS 5 float\n{ROWS}0 @ 0\nPOLYGONS 4 16\n{TRIANGLES}", NO_COORDINATES)
    indices = {**NO_INDICES, "-1": "out of range"}
    yield from bad_words("vtk-index", FIVE + "POLYGONS 1 4\n3 0 @ 2\n", indices)
    connectivity = FIVE + "POLYGONS 2 3\nOFFSETS int\n0 3\nCONNECTIVITY int\n0 @ 2\n"
    yield from bad_words("vtk-connectivity", connectivity.replace("Version 3.0", "Version 5.1"), indices)
    yield from bad_words("vtk-points", OLD.replace("POINTS 4", "POINTS @"), NO_COUNTS)
    yield from bad_words("vtk-cells", OLD.replace("POLYGONS 4", "POLYGONS @"), NO_COUNTS)
    yield from bad_words("vtk-cell-numbers", OLD.replace("4 16", "4 @"), NO_COUNTS)
    corners = {word: "of the numbers are left" if "promises" in part or word == "-1" else part
               for word, part in NO_COUNTS.items()}
    yield from bad_words("vtk-corners", FIVE + "POLYGONS 1 4\n@ 0 1 2\n", corners)
    offsets = {word: "ascend" if "promises" in part or word == "-1" else part for word, part in NO_COUNTS.items()}
    yield from bad_words("vtk-offset", NEW.replace("0 3 6 9", "0 3 @ 9"), offsets)
    yield from bad_words("vtk-tuples", OLD.replace("POINTS", "FIELD a 1\nb 1 @ int\n1\nPOINTS"), NO_COUNTS)
    yield from bad_words("vtk-arrays", OLD.replace("POINTS", "FIELD a @\nb 1 1 int\n1\nPOINTS"), NO_COUNTS)


def read():
    for version in ("1.0", "2.0", "3.0", "4.0", "4.2"):
        yield good(f"vtk-ascii-{version}", OLD.replace("3.0", version))
        yield good(f"vtk-binary-{version}", binary(version))
    yield from layouts("vtk-ascii", OLD)
    yield from layouts("vtk-ascii-offsets", NEW)
    yield good("vtk-binary-double", binary(real="double"))
    yield good("vtk-binary-5.1", binary("5.1"))
    yield good("vtk-binary-5.1-double", binary("5.1", "double"))
    yield good("vtk-lower-case", OLD.lower())
    yield good("vtk-vertices-and-lines", OLD.replace("POLYGONS", "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nPOLYGONS"))
    yield good("vtk-strips", f"{start()}{POINT_ROWS}TRIANGLE_STRIPS 1 6\n5 0 1 2 3 0\n", faces=3)
    yield good("vtk-strips-and-polygons", OLD + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n", faces=6)
    yield good("vtk-quads", f"{start()}{POINT_ROWS}POLYGONS 2 9\n3 0 1 2\n4 0 1 2 3\n", faces=2)
    yield good("vtk-data", OLD + "CELL_DATA 4\nSCALARS a float\nLOOKUP_TABLE default\nanything at all\n")
    yield good("vtk-metadata", OLD.replace("POLYGONS", "METADATA\nINFORMATION 0\n\nPOLYGONS"))
    yield good("vtk-fields", OLD.replace("POINTS", "FIELD a 2\nb 2 1 double\n0.5 nan\nc 0 1000000000000 int\nPOINTS"))
    yield good("vtk-cells-on-one-line", OLD.replace("\n3 ", " 3 ").replace("16 3", "16\n3"))
    yield good("vtk-long-line", OLD.replace("0 1 0\n", "0 1 0" + " " * 65536 + "\n"))  # meshio writes arrays so
    yield good("vtk-points-first-unused", FIVE + f"POLYGONS 4 16\n{TRIANGLES}", points=5)


def refused():
    for name, old, new, at, part in [
            ("version", "3.0", "5.2", "line 1", "5.1"), ("version-0", "3.0", "0.9", "line 1", "5.1"),
            ("version-nan", "3.0", "nan", "line 1", "5.1"), ("version-word", "3.0", "three", "line 1", '"three"'),
            ("magic", "# vtk DataFile Version", "# vtk DataFile version:", "line 1", "expected # vtk"),
            ("encoding", "ASCII", "TEXT", "line 3", "ASCII or BINARY"),
            ("grid", "POLYDATA", "UNSTRUCTURED_GRID", "line 4", "POLYDATA"),
            ("keyword", "POLYGONS", "POLYGON", "line 10", '"POLYGON"'), ("type", "float", "real", "line 5", '"real"'),
            ("no-type", " float", "", "line 5", "number type"),
            ("second-points", "POLYGONS", f"{POINT_ROWS}POLYGONS", "line 10", "a second"),
            ("one-point-more", "POINTS 4", "POINTS 5", "line 10", '"POLYGONS"'),
            ("one-point-less", "POINTS 4", "POINTS 3", "line 9", '"0"'),
            ("one-cell-more", "4 16", "5 16", "line 10", "promises 5"),
            ("one-cell-less", "4 16", "3 16", "line 13", "leave 4 of the 16 numbers"),
            ("too-few-numbers", "4 16", "4 15", "line 10", "4 cells with only 15 numbers, and they take 16"),
            ("too-many-numbers", "4 16", "4 17", "line 14", "leave 1 of the 17 numbers"),
            ("two-corners", "3 0 2 1\n3 0 1 3", "2 0 2 4 1 0 1 3", "line 11", "2 corners"),
            ("two-coordinates", "0 1 0\n", "0 1\n", "line 10", '"POLYGONS"'),
            ("nul", "0 1 0\n", "0 1 0\0\n", "line 8", "NUL"),
            ("no-polygons", f"POLYGONS 4 16\n{TRIANGLES}", "", "line 9", "no faces")]:
        yield bad(f"vtk-{name}", OLD.replace(old, new), at, part)
    for name, old, new, at, part in [
            ("first", "0 3 6", "1 3 6", "line 12", "begin with 0"), ("descend", "0 3 6", "0 6 3", "line 12", "ascend"),
            ("last", "9 12", "9 11", "line 13", "last offset is 11, not the number of cell points, 12"), ("equal", "0 3 6", "0 0 6", "line 13", "0 corners"),
            ("narrow", "OFFSETS vtktypeint64", "OFFSETS char", "line 11", "array of indices"),
            ("real", "OFFSETS vtktypeint64", "OFFSETS double", "line 11", "array of indices"),
            ("missing", "OFFSETS vtktypeint64\n0 3 6 9 12\n", "", "line 11", '"OFFSETS"'),
            ("connectivity", "CONNECTIVITY", "CELLS", "line 13", '"CONNECTIVITY"'),
            ("one-more", "POLYGONS 5 12", "POLYGONS 6 12", "line 13", '"CONNECTIVITY"')]:
        yield bad(f"vtk-offsets-{name}", NEW.replace(old, new), at, part)
    strips = f"{start()}{POINT_ROWS}TRIANGLE_STRIPS 1 "
    yield bad("vtk-strip-of-two", strips + "4\n2 0 1 2\n", "line 11", "2 points")
    yield bad("vtk-strip-index", strips + "4\n3 0 1 4\n", "line 11", "index 4")
    for version, data in [("3.0", b"POLYGONS 4 16\n"), ("5.1", b"CONNECTIVITY vtktypeint64\n")]:
        whole = binary(version)
        at = whole.index(data) + len(data)
        points = whole.index(b" float\n") + 7
        yield bad(f"vtk-binary-{version}-cut", whole[:-2], "", "too early")
        yield bad(f"vtk-binary-{version}-cut-in-points", whole[:points + 20], "", "promises 4")
        yield bad(f"vtk-binary-{version}-nan", whole[:points + 12] + b"\x7f\xc0\0\0" + whole[points + 16:],
                  f"byte {points + 12}", "not finite")
        last = len(whole) - 1 - (4 if version == "3.0" else 8)
        for name, number in [("4", 4), ("minus-1", -1)]:
            raw = number.to_bytes(len(whole) - 1 - last, "big", signed=True)
            yield bad(f"vtk-binary-{version}-index-{name}", whole[:last] + raw + b"\n", "", f"index {number}")
        if version == "3.0":
            yield bad("vtk-binary-corners-minus-1", whole[:at] + b"\xff" * 4 + whole[at + 4:], f"byte {at}", "a cell of -1 points")


def cases():
    return [*read(), *words(), *refused()]
