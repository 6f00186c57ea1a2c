"""Points with data: tables, .npy, legacy VTK with cells of any kind, and VTK's XML.

Of the answers, "faces" is the number of cells and "patches" that of arrays.
"""
import base64
import dataclasses
import struct
import zlib

import cases as made
from cases import NUMBERS, POINTS, bad_words

ROWS = "".join(",".join(point) + "\n" for point in POINTS)
TABLE = "x,y,z,p\n" + "".join(",".join((*point, "7")) + "\n" for point in POINTS)


def good(name, content, points=4, faces=0, patches=0):
    return dataclasses.replace(made.good(name, content, points, faces, patches), reader="points")


def bad(name, content, at, part, answer="File"):
    return dataclasses.replace(made.bad(name, content, at, part, answer), reader="points")


def for_points(found):
    return [dataclasses.replace(case, reader="points") for case in found]


# --- Tables -------------------------------------------------------------------------------------

def tables():
    finite = {"nan": "need finite numbers", "inf": "need finite numbers", "1e400": "out of range", "-1e999": "out of range",
              "1e-400": "out of range", "": "is empty", "0x1p3": '"0x1p3"', "abc": '"abc"', "1.2.3": '"1.2.3"', "1d5": '"1d5"',
              "1;5": '"1;5"', "1 5": '"1 5"', "1_000": '"1_000"', "\u0661": '"'}
    yield from for_points(bad_words("points-csv-coordinate", "x,y,z\n0,0,0\n0,@,0\n", finite))
    values = {word: part for word, part in finite.items() if word not in ("nan", "inf")}
    yield from for_points(bad_words("points-csv-value", TABLE + "0,0,0,@\n", values))
    yield good("points-csv", ROWS)
    yield good("points-csv-names", TABLE, patches=1)
    yield good("points-csv-nan", TABLE + "0,0,0,nan\n", points=5, patches=1)
    yield good("points-csv-crlf", TABLE.replace("\n", "\r\n"), patches=1)
    yield good("points-csv-mark", "\ufeff# a run\n\n" + TABLE, patches=1)
    for name, content, at, part in [
            ("no-z", "x,y\n0,0\n", "line 1", "there is no z"), ("short", TABLE + "0,0,0\n", "line 6", "need 4 fields, found 3"),
            ("long", TABLE + "0,0,0,0,0\n", "line 6", "need 4 fields, found 5"), ("twice", "x,y,z,p,p\n0,0,0,0,0\n", "line 1", '"p"'),
            ("nameless", "x,y,z,\n0,0,0,0\n", "line 1", "no name"), ("nothing", "x,y,z\n", "line 1", "without a point"),
            ("blanks", " \n\n", "line 2", "without a point"), ("nul", "0,0,0\n0,\0,0\n", "line 2", "NUL"),
            ("wide", "x,y,z" + ",a" * 2000 + "\n", "line 1", "columns"), ("line", "x,y,z" + "a" * 70000, "line 1", "64 kB"),
            ("empty", "", "", "empty")]:
        yield bad(f"points-csv-{name}", content, at, part)


# --- NumPy --------------------------------------------------------------------------------------

def npy(kind="<f8", order="False", shape="(4, 3)", version=1, letter="d"):
    header = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}".ljust(117) + "\n"
    length = struct.pack("<H" if version == 1 else "<I", len(header))
    numbers = struct.pack(f"<12{letter}", *(x for point in NUMBERS for x in point))
    return b"\x93NUMPY" + bytes([version, 0]) + length + header.encode() + numbers


def arrays():
    for version in (1, 2, 3):
        yield good(f"points-npy-{version}", npy(version=version))
    yield good("points-npy-float", npy("<f4", letter="f"))
    for name, content, part in [
            ("big-endian", npy(">f8"), "little-endian"), ("integers", npy("<i8"), '"<i8"'), ("objects", npy("|O"), '"|O"'),
            ("fortran", npy(order="True"), "Fortran"), ("flat", npy(shape="(12,)"), "(12,)"), ("wide", npy(shape="(3, 4)"), "(3, 4)"),
            ("cube", npy(shape="(2, 2, 3)"), "(2, 2, 3)"), ("negative", npy(shape="(-4, 3)"), "expected a number"),
            ("more", npy(shape="(5, 3)"), "promises 5"), ("fewer", npy(shape="(3, 3)"), "promises 3"),
            ("huge", npy(shape="(6148914691236517206, 3)"), "promises 6148914691236517206"),
            ("overflow", npy(shape="(99999999999999999999, 3)"), "expected a number"),
            ("half-size", npy("<f4"), "promises 4"), ("tail", npy() + b"\0", "97 bytes"), ("cut", npy()[:-1], "95 bytes"),
            ("version-0", npy(version=0), "version 0.0"), ("version-9", npy(version=9), "version 9.0"),
            ("no-key", npy().replace(b"'shape'", b"'shaqe'"), '"shaqe"'), ("nan", npy()[:-8] + struct.pack("<d", float("nan")), "not finite"),
            ("magic-only", b"\x93NUMPY", "too early"), ("header-cut", npy()[:40], "within its header")]:
        yield bad(f"points-npy-{name}", content, "", part)


# --- Legacy VTK ---------------------------------------------------------------------------------

START = "# vtk DataFile Version 3.0\na title\nASCII\nDATASET UNSTRUCTURED_GRID\n"
COORDINATES = "POINTS 4 double\n" + "".join(" ".join(point) + "\n" for point in POINTS)  # lines 5 to 9
GRID = START + COORDINATES + "CELLS 2 8\n4 0 1 2 3\n2 0 1\nCELL_TYPES 2\n10 3\n"         # lines 10 to 14
DATA = GRID + ("POINT_DATA 4\nSCALARS p float 1\nLOOKUP_TABLE default\n1 2 3 4\n"          # lines 15 to 18
               "CELL_DATA 2\nVECTORS U double\n1 2 3 4 5 6\n")


def binary_grid(kinds=(10, 3)):
    content = START.replace("ASCII", "BINARY").encode() + b"POINTS 4 double\n"
    content += struct.pack(">12d", *(x for point in NUMBERS for x in point)) + b"\nCELLS 2 8\n"
    content += struct.pack(">8i", 4, 0, 1, 2, 3, 2, 0, 1) + b"\nCELL_TYPES 2\n" + struct.pack(">2i", *kinds)
    return content + b"\nPOINT_DATA 4\nFIELD FieldData 1\np 1 4 float\n" + struct.pack(">4f", 1, 2, 3, 4) + b"\n"


def legacy():
    yield good("points-vtk", GRID, faces=2)
    yield good("points-vtk-data", DATA, faces=2, patches=2)
    yield good("points-vtk-binary", binary_grid(), faces=2, patches=1)
    yield good("points-vtk-crlf", DATA.replace("\n", "\r\n"), faces=2, patches=2)
    counts = {"-1": "-1", "abc": '"abc"', "1.5": '"1.5"', "4294967296": "promises 4294967296", "9223372036854775808": "out of range"}
    for name, old, new in [("points", "POINTS 4", "POINTS @"), ("cells", "CELLS 2", "CELLS @"), ("numbers", "2 8", "2 @"),
                           ("kinds", "TYPES 2", "TYPES @")]:
        yield from for_points(bad_words(f"points-vtk-{name}", DATA.replace(old, new), counts))
    rows = {"3": "data for 3 of 4", "-1": "data for -1 of 4", "4.0": '"4.0"', "4294967300": "data for 4294967300 of 4"}
    yield from for_points(bad_words("points-vtk-rows", DATA.replace("POINT_DATA 4", "POINT_DATA @"), rows))
    widths = {"0": "array of 0", "-1": "array of -1", "9999999999": "array of 9999999999", "1000000": "promises", "x": '"x"'}
    yield from for_points(bad_words("points-vtk-width", DATA.replace("p float 1", "p float @"), widths)[:3])
    corners = {"4": "out of range", "-1": "out of range", "4294967296": "out of range", "x": '"x"'}
    yield from for_points(bad_words("points-vtk-corner", DATA.replace("4 0 1 2 3", "4 0 1 2 @"), corners))
    for name, old, new, part in [
            ("kind-256", "10 3", "10 256", "no kind of cells 256"), ("kind-negative", "10 3", "10 -3", "no kind of cells -3"),
            ("polyhedron", "10 3", "42 3", "polyhedra"), ("twice", "VECTORS U", "VECTORS U double\n1 2 3 4 5 6\nVECTORS U", "second array"),
            ("dataset", "UNSTRUCTURED_GRID", "STRUCTURED_GRID", "STRUCTURED_GRID"), ("no-points", COORDINATES, "", "data for 4 of 0"),
            ("type", "U double", "U bit", '"bit"'), ("table", "LOOKUP_TABLE default\n", "", "LOOKUP_TABLE"), ("nan", "1.5 0 0", "nan 0 0", "finite"),
            ("no-kinds", "CELL_TYPES 2\n10 3\n", "", "0 kinds"), ("few", "1 2 3 4 5 6", "1 2 3 4 5", "too early")]:
        yield bad(f"points-vtk-{name}", DATA.replace(old, new), "", part)
    yield bad("points-vtk-binary-kind", binary_grid((10, 999)), "", "no kind of cells 999")
    whole = binary_grid()
    for i in range(1, 8):
        yield bad(f"points-vtk-binary-cut-{i}", whole[:len(whole) * i // 8 - 20], "", "")


# --- XML ----------------------------------------------------------------------------------------

class Xml:
    """A file of one tetrahedron and one line, with an array of each kind."""

    def __init__(self, form="ascii", encoding="raw", packed=False, order="<", size="I"):
        self.form, self.encoding, self.packed, self.order, self.size = form, encoding, packed, order, size
        self.appended = b""

    def sizes(self, *numbers):
        return struct.pack(f"{self.order}{len(numbers)}{self.size}", *numbers)

    def data(self, letter, numbers):
        """Sizes, and what they are of."""
        raw = struct.pack(f"{self.order}{len(numbers)}{letter}", *numbers)
        if not self.packed:
            return self.sizes(len(raw)), raw
        blocks = [zlib.compress(raw[i:i + 32]) for i in range(0, len(raw), 32)]
        return self.sizes(len(blocks), 32, len(raw) % 32, *map(len, blocks)), b"".join(blocks)

    def array(self, kind, letter, attributes, numbers):
        start = f'<DataArray type="{kind}" {attributes} format="{self.form}"'.encode()
        if self.form == "ascii":
            return start + b">\n" + " ".join(map(repr, numbers)).encode() + b"\n</DataArray>\n"
        sizes, data = self.data(letter, numbers)
        text = base64.b64encode(sizes) + base64.b64encode(data) if self.packed else base64.b64encode(sizes + data)
        if self.form == "binary":
            return start + b">\n" + text + b"\n</DataArray>\n"
        start += b' offset="%d"/>\n' % len(self.appended)
        self.appended += sizes + data if self.encoding == "raw" else text
        return start

    def file(self):
        attributes = f'type="UnstructuredGrid" version="1.0" byte_order="{"Little" if self.order == "<" else "Big"}Endian"'
        if self.size == "Q":
            attributes += ' header_type="UInt64"'
        if self.packed:
            attributes += ' compressor="vtkZLibDataCompressor"'
        text = f'<?xml version="1.0"?>\n<VTKFile {attributes}>\n<UnstructuredGrid>\n<Piece NumberOfPoints="4" NumberOfCells="2">\n'.encode()
        text += b"<Points>\n" + self.array("Float64", "d", 'NumberOfComponents="3"', [x for p in NUMBERS for x in p]) + b"</Points>\n<Cells>\n"
        text += self.array("Int64", "q", 'Name="connectivity"', [0, 1, 2, 3, 0, 1])
        text += self.array("Int64", "q", 'Name="offsets"', [4, 6])
        text += self.array("UInt8", "B", 'Name="types"', [10, 3]) + b"</Cells>\n<PointData>\n"
        text += self.array("Float32", "f", 'Name="p"', [1.0, 2.0, 3.0, 4.0]) + b"</PointData>\n<CellData>\n"
        text += self.array("Int16", "h", 'Name="q" NumberOfComponents="2"', [1, 2, 3, 4]) + b"</CellData>\n</Piece>\n</UnstructuredGrid>\n"
        if self.form == "appended":
            text += f'<AppendedData encoding="{self.encoding}">\n _'.encode() + self.appended + b"\n</AppendedData>\n"
        return text + b"</VTKFile>\n"


def samples():
    yield "ascii", Xml()
    for order, name in (("<", "little"), (">", "big")):
        for size, bits in (("I", 32), ("Q", 64)):
            for packed in (False, True):
                for form, encoding in (("binary", "raw"), ("appended", "raw"), ("appended", "base64")):
                    kind = "zlib" if packed else "plain"
                    yield f"{form}-{encoding}-{kind}-{name}-{bits}", Xml(form, encoding, packed, order, size)


def xml():
    text = Xml().file()
    for name, sample in samples():
        whole = sample.file()
        yield good(f"xml-{name}", whole, faces=2, patches=2)
        for i in range(1, 8):
            yield bad(f"xml-{name}-cut-{i}", whole[:len(whole) * i // 8], "", "")
        yield bad(f"xml-{name}-end", whole[:-4], "", "")
        yield bad(f"xml-{name}-points", whole.replace(b'NumberOfPoints="4"', b'NumberOfPoints="900000000"'), "", "")
        yield bad(f"xml-{name}-cells", whole.replace(b'NumberOfCells="2"', b'NumberOfCells="900000000000"'), "", "")
    for name, old, new, at, part in [
            ("image", b'type="UnstructuredGrid"', b'type="ImageData"', "line 2", "ImageData"), ("root", b"VTKFile", b"VtkFile", "line 2", "VtkFile"),
            ("pieces", b"<Piece", b"<Piece/><Piece", "line 3", "need one element Piece, found 2"), ("no-points", b"Points>", b"Pts>", "line 4", "need one element Points"),
            ("components", b'NumberOfComponents="3"', b'NumberOfComponents="2"', "line 6", "3 components"),
            ("components-huge", b'NumberOfComponents="2"', b'NumberOfComponents="90000000000000"', "line 27", "more numbers"),
            ("type", b'"Float64"', b'"Float80"', "line 6", "Float80"), ("no-type", b'type="Float64"', b"", "line 6", "without a type"),
            ("format", b'"ascii"', b'"text"', "line 6", '"text"'), ("nan", b"0.25", b"nan", "line 6", "not finite"), ("inf", b"0.25", b"inf", "line 6", "not finite"),
            ("word", b"0.25", b"zero", "line 7", '"zero"'), ("comma", b"0.25", b"0,25", "line 7", '"0,25"'), ("overflow", b"0.25", b"1e400", "line 7", "out of range"),
            ("more", b"0.25", b"0.25 1", "line 7", "more than 12"), ("fewer", b"0.25", b"", "line 8", "needs 12"), ("entity", b"0.25", b"&#49;", "line 7", '"&#49;"'),
            ("comment", b"0.25", b"0.25<!-- -->", "line 7", '"'), ("corner", b"0 1 2 3 0 1", b"0 1 2 4 0 1", "line 11", "out of range"),
            ("corner-negative", b"0 1 2 3 0 1", b"0 1 2 -3 0 1", "line 11", "out of range"), ("corner-float", b"0 1 2 3 0 1", b"0 1 2 3.0 0 1", "line 12", '"3.0"'),
            ("offsets", b"4 6", b"6 4", "line 14", "ascend"), ("offset-negative", b"4 6", b"-4 6", "line 14", "out of range"),
            ("offset-huge", b"4 6", b"4 9000000000000000000", "line 14", "ascend"), ("offset-far", b"4 6", b"4 60000", "line 11", "promises"),
            ("types", b"10 3", b"10 300", "line 18", "out of range"), ("polyhedron", b"10 3", b"42 3", "line 10", "faceoffsets"),
            ("named-twice", b'Name="q"', b'Name="q"/><DataArray Name="q"', "", ""), ("nameless", b'Name="p"', b"", "line 22", "without a name"),
            ("byte-order", b"LittleEndian", b"MiddleEndian", "line 2", "MiddleEndian"), ("header", b"byte_order=", b'header_type="UInt16" byte_order=', "line 2", "UInt16"),
            ("lz4", b"byte_order=", b'compressor="vtkLZ4DataCompressor" byte_order=', "line 2", "vtkLZ4DataCompressor"),
            ("doctype", b"<VTKFile", b"<!DOCTYPE a [<!ENTITY b 'c'>]><VTKFile", "line 2", "document type"),
            ("elements", b"<Points>", b"<a/>" * 20000 + b"<Points>", "line 5", "elements"), ("deep", b"<Points>", b"<a>" * 100 + b"<Points>", "line 5", "deep"),
            ("tags", b"</Points>", b"</Point>", "", "mismatched"), ("utf-8", b'Name="p"', b'Name="\xff"', "line 22", "well-formed")]:
        yield bad(f"xml-{name}", text.replace(old, new) if name in ("root", "no-points") else text.replace(old, new, 1), at, part)
    yield bad("xml-only", b"<", "line 1", "")
    whole = Xml("appended").file()
    for name, old, new, part in [
            ("offset", b'offset="0"', b'offset="9999"', "9999"), ("offset-negative", b'offset="0"', b'offset="-1"', "-1"), ("no-offset", b' offset="0"', b"", "without an offset"),
            ("encoding", b'encoding="raw"', b'encoding="hex"', "raw or base64"), ("mark", b" _", b" ", "underscore"), ("no-order", b' byte_order="LittleEndian"', b"", "byte_order"),
            ("no-data", b"AppendedData", b"Appended", ""), ("order", b"LittleEndian", b"BigEndian", "bytes"), ("wide", b"byte_order=", b'header_type="UInt64" byte_order=', "bytes"),
            ("zlib", b"byte_order=", b'compressor="vtkZLibDataCompressor" byte_order=', "")]:
        yield bad(f"xml-appended-{name}", whole.replace(old, new), "", part)
    # Sizes of blocks that do not fit, one after the other.
    packed = Xml("appended", packed=True).file()
    begin = packed.index(b" _") + 2
    for word in range(6):
        for value in (0, 1, 33, 2**31, 2**32 - 1):
            changed = packed[:begin + 4 * word] + struct.pack("<I", value) + packed[begin + 4 * word + 4:]
            if changed != packed and (word, value) != (2, 0):  # the last block is as large as the others
                yield bad(f"xml-zlib-block-{word}-{value}", changed, "", "")


def cases():
    return [*tables(), *arrays(), *legacy(), *xml()]
