"""Reads what the command writes, by the formats' descriptions: OFF, VTK images and grids, PNG."""
import re
import struct
import zlib


def read_off(path):
    """Points and polygons."""
    words = path.read_text().split()
    assert words[0] == "OFF"
    points, polygons = int(words[1]), int(words[2])
    at = 4
    coordinates = [float(w) for w in words[at:at + 3 * points]]
    at += 3 * points
    faces = []
    for _ in range(polygons):
        corners = int(words[at])
        faces.append([int(w) for w in words[at + 1:at + 1 + corners]])
        at += 1 + corners
    return [tuple(coordinates[3 * i:3 * i + 3]) for i in range(points)], faces


def bounds(points):
    """Lower and upper corner, rounded, as one tuple."""
    corners = [pick(p[axis] for p in points) for pick in (min, max) for axis in range(3)]
    return tuple(round(c, 9) + 0.0 for c in corners)


class VtkXml:
    """A VTK file of XML and raw bytes: attributes by name, arrays by name, vectors as tuples."""

    LETTERS = {"Float64": "d", "Float32": "f", "UInt32": "I", "UInt64": "Q", "Int32": "i", "Int64": "q", "UInt8": "B"}

    def __init__(self, path):
        content = path.read_bytes()
        mark = b'<AppendedData encoding="raw">\n_'
        start = content.index(mark)
        self.header, data = content[:start].decode(), content[start + len(mark):]
        self.arrays = {}
        for kind, name, components, offset in re.findall(
                r'<DataArray type="(\w+)" Name="([^"]*)" NumberOfComponents="(\d)" format="appended" '
                r'offset="(\d+)"', self.header):
            offset, components, letter = int(offset), int(components), self.LETTERS[kind]
            size, = struct.unpack_from("<Q", data, offset)
            values = struct.unpack_from(f"<{size // struct.calcsize(letter)}{letter}", data, offset + 8)
            self.arrays[name] = values if components == 1 else list(zip(*[iter(values)] * components))

    def patch_names(self):
        """Field data: texts, each ended by a zero."""
        codes = re.search(r'<Array type="String" Name="patch names"[^>]*>([^<]*)<', self.header)
        texts = bytes(int(w) for w in codes[1].split()).decode().split("\0") if codes else [""]
        assert texts.pop() == ""
        return texts

    def numbers(self, name, kind):
        return [kind(w) for w in re.search(f' {name}="([^"]*)"', self.header)[1].split()]


class Vtu(VtkXml):
    """A VTK unstructured grid of voxels: boxes of the cells, (lower, upper), arrays by name."""

    def __init__(self, path):
        super().__init__(path)
        points, corners = self.arrays.pop("Points"), self.arrays.pop("connectivity")
        assert self.numbers("NumberOfPoints", int) == [len(points)] == [len(set(points))]
        assert self.arrays.pop("offsets") == tuple(range(8, len(corners) + 8, 8))
        assert set(self.arrays.pop("types")) == {11}
        self.boxes = []
        for cell in zip(*[iter(corners)] * 8):
            low, high = points[cell[0]], points[cell[7]]
            for corner, node in enumerate(cell):
                assert points[node] == tuple((high if corner >> a & 1 else low)[a] for a in range(3))
            self.boxes.append((low, high))
        assert self.numbers("NumberOfCells", int) == [len(self.boxes)]


class Vti(VtkXml):
    """A VTK image: extent of points, origin, spacing, arrays by name; positions of values."""

    def __init__(self, path):
        super().__init__(path)
        self.extent = self.numbers("WholeExtent", int)
        self.origin = self.numbers("Origin", float)
        self.spacing = self.numbers("Spacing", float)
        self.cells = "<CellData " in self.header

    def positions(self):
        """Centres of the cells, or the nodes, in the order of the values."""
        shift = 0.5 if self.cells else 0
        ranges = [range(self.extent[2 * a], self.extent[2 * a + 1] + (0 if self.cells else 1)) for a in range(3)]
        at = lambda axis, i: self.origin[axis] + (i + shift) * self.spacing[axis]
        return [(at(0, i), at(1, j), at(2, k)) for k in ranges[2] for j in ranges[1] for i in ranges[0]]


class Png:
    """An 8-bit RGB picture: width, height, pixel(x, y)."""

    def __init__(self, path):
        content = path.read_bytes()
        assert content[:8] == b"\x89PNG\r\n\x1a\n"
        at, packed = 8, b""
        while at < len(content):
            length, kind = struct.unpack_from(">I4s", content, at)
            body = content[at + 8:at + 8 + length]
            assert zlib.crc32(kind + body) == struct.unpack_from(">I", content, at + 8 + length)[0]
            if kind == b"IHDR":
                self.width, self.height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
                assert (depth, color, interlaced) == (8, 2, 0)
            packed += body if kind == b"IDAT" else b""
            at += length + 12
        self._unfilter(zlib.decompress(packed))

    def _unfilter(self, raw):
        stride = 3 * self.width
        before = bytearray(stride)
        self.rows = []
        for y in range(self.height):
            kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
            for x in range(stride if kind else 0):
                left = row[x - 3] if x >= 3 else 0
                corner = before[x - 3] if x >= 3 else 0
                row[x] = (row[x] + self._predicted(kind, left, before[x], corner)) & 255
            self.rows.append(row)
            before = row

    @staticmethod
    def _predicted(kind, left, up, corner):
        if kind == 4:
            nearest = left + up - corner
            return min((left, up, corner), key=lambda v: abs(nearest - v))
        return {1: left, 2: up, 3: (left + up) // 2}[kind]

    def pixel(self, x, y):
        return tuple(self.rows[y][3 * x:3 * x + 3])
