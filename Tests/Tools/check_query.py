"""Runs `cutwater query` as people and scripts do. Usage: check_query.py PROGRAM [group]"""
import csv
import gzip
import math
import struct
import unittest

from command import CommandTest
from readers import VtkXml

POINTS = [(0, 0, 0), (3, 0, 0), (0, -2, 0.5), (0.25, 0, 0.75), (2, 2, 2)]


def box_distance(p, half):
    """Signed distance from a box about the origin."""
    q = [abs(c) - h for c, h in zip(p, half)]
    return math.hypot(*(max(c, 0) for c in q)) + min(max(q), 0)


def table(points, more=""):
    return "x,y,z\n" + "".join(",".join(map(repr, p)) + more + "\n" for p in points)


def legacy(points, cells, kinds, binary=False):
    """An unstructured grid in legacy VTK."""
    numbers = [n for cell in cells for n in (len(cell), *cell)]
    head = f"# vtk DataFile Version 3.0\na mesh\n{'BINARY' if binary else 'ASCII'}\nDATASET UNSTRUCTURED_GRID\n"
    parts = [(f"POINTS {len(points)} double", "d", [c for p in points for c in p]),
             (f"CELLS {len(cells)} {len(numbers)}", "i", numbers), (f"CELL_TYPES {len(cells)}", "i", kinds),
             (f"CELL_DATA {len(cells)}\nFIELD FieldData 1\nmaterial 1 {len(cells)} int", "i", range(len(cells)))]
    content = head.encode()
    for words, letter, values in parts:
        body = struct.pack(f">{len(values)}{letter}", *values) if binary else " ".join(map(repr, values)).encode()
        content += words.encode() + b"\n" + body + b"\n"
    return content


class Query(CommandTest):
    def setUp(self):
        super().setUp()
        self.box()

    def write(self, name, content):
        (self.folder / name).write_bytes(content.encode() if isinstance(content, str) else content)
        return name

    def rows(self, name):
        with (self.folder / name).open(newline="") as file:
            return list(csv.DictReader(file))

    def test_tables_get_columns_and_keep_their_own(self):
        self.write("p.csv", "name of a run,z,x,y\n" + "".join(f"{i},{z},{x},{y}\n" for i, (x, y, z) in enumerate(POINTS)))
        said = self.succeeds("query", "box.off", "p.csv", "-o", "q.csv")
        self.assertIn("asked at 5 points", said)
        self.assertIn("inside: 2;", said)
        rows = self.rows("q.csv")
        self.assertEqual(list(rows[0]), ["x", "y", "z", "name of a run", "distance", "closest_x", "closest_y", "closest_z",
                                         "normal_x", "normal_y", "normal_z", "patch"])
        for i, (row, point) in enumerate(zip(rows, POINTS, strict=True)):
            self.assertEqual(tuple(float(row[key]) for key in "xyz"), point)
            self.assertEqual(row["name of a run"], str(i))
            distance = float(row["distance"])
            self.assertAlmostEqual(distance, box_distance(point, (1, 1, 1)), delta=1e-14)
            closest = [float(row[f"closest_{axis}"]) for axis in "xyz"]
            normal = [float(row[f"normal_{axis}"]) for axis in "xyz"]
            self.assertAlmostEqual(math.dist(closest, point), abs(distance), delta=1e-14)
            self.assertAlmostEqual(max(map(abs, closest)), 1, delta=1e-14)
            self.assertAlmostEqual(math.hypot(*normal), 1, delta=1e-14)
            away = sum((p - c) * n for p, c, n in zip(point, closest, normal))
            self.assertEqual(away < 0, distance < 0)
            self.assertEqual(row["patch"], "0")

    def test_distances_alone_are_the_same(self):
        self.write("p.csv", table(POINTS))
        self.succeeds("query", "box.off", "p.csv", "-o", "all.csv", "-q")
        self.assertEqual(self.succeeds("query", "box.off", "p.csv", "-o", "some.csv", "--write", "distance", "-q"), "")
        self.assertEqual([row["distance"] for row in self.rows("some.csv")], [row["distance"] for row in self.rows("all.csv")])
        self.assertEqual(list(self.rows("some.csv")[0]), ["x", "y", "z", "distance"])

    def test_cells_of_a_mesh(self):
        cells, kinds = [(0, 1, 2, 3), (1, 4)], [10, 3]
        for binary in (False, True):
            self.write("m.vtk", legacy(POINTS, cells, kinds, binary))
            said = self.succeeds("query", "box.off", "m.vtk", "--cells", "--write", "distance", "-o", "m.vtu")
            self.assertIn("2 centres of cells", said)
            mesh = VtkXml(self.folder / "m.vtu")
            self.assertEqual(mesh.arrays["Points"], POINTS)
            self.assertEqual(mesh.arrays["connectivity"], (0, 1, 2, 3, 1, 4))
            self.assertEqual(mesh.arrays["offsets"], (4, 6))
            self.assertEqual(mesh.arrays["types"], (10, 3))
            self.assertEqual(mesh.arrays["material"], (0, 1))
            centers = [tuple(sum(POINTS[i][axis] for i in cell) / len(cell) for axis in range(3)) for cell in cells]
            for value, center in zip(mesh.arrays["distance"], centers, strict=True):
                self.assertAlmostEqual(value, box_distance(center, (1, 1, 1)), delta=1e-14)
        # What it wrote, it reads; the output may have another format.
        self.succeeds("query", "box.off", "m.vtu", "-o", "again.vtk")
        self.succeeds("query", "box.off", "again.vtk", "--prefix", "new_", "-o", "again.vtu")
        again = VtkXml(self.folder / "again.vtu")
        self.assertEqual(again.arrays["connectivity"], (0, 1, 2, 3, 1, 4))
        self.assertEqual(again.arrays["new_distance"], tuple(box_distance(p, (1, 1, 1)) for p in POINTS))

    def test_numpy(self):
        header = "{'descr': '<f8', 'fortran_order': False, 'shape': (5, 3), }".ljust(117) + "\n"
        body = struct.pack("<15d", *(c for p in POINTS for c in p))
        self.write("p.npy", b"\x93NUMPY\1\0" + struct.pack("<H", len(header)) + header.encode() + body)
        self.succeeds("query", "box.off", "p.npy", "--write", "distance,patch", "-o", "q.npy")
        content = (self.folder / "q.npy").read_bytes()
        length, = struct.unpack_from("<H", content, 8)
        self.assertIn(b"('points', '<f8', (3,)), ('distance', '<f8'), ('patch', '<i4')", content[10:10 + length])
        rows = list(struct.iter_unpack("<4di", content[10 + length:]))
        self.assertEqual([row[:3] for row in rows], POINTS)
        self.assertEqual([(row[3], row[4]) for row in rows], [(box_distance(p, (1, 1, 1)), 0) for p in POINTS])

    def test_scenes_motions_and_compressed_files(self):
        self.write("ball.toml", '[ball]\nshape = "sphere"\ncenter = [0, 0, 0]\nradius = 1\n')
        self.write("p.csv.gz", gzip.compress(table(POINTS).encode()))
        self.succeeds("query", "ball.toml", "p.csv.gz", "--translate", "1,0,0", "-o", "q.csv")
        for row, point in zip(self.rows("q.csv"), POINTS, strict=True):
            self.assertAlmostEqual(float(row["distance"]), math.dist(point, (1, 0, 0)) - 1, delta=1e-14)

    def test_surfaces_may_be_vtp(self):
        """A box, written by query itself as the points of a surface."""
        corners = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        text = "# vtk DataFile Version 3.0\nbox\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n"
        text += "".join("%d %d %d\n" % p for p in corners) + "POLYGONS 6 30\n" + "".join("4 %d %d %d %d\n" % f for f in faces)
        self.write("box.vtk", text)
        self.succeeds("query", "box.off", "box.vtk", "-o", "surface.vtp")
        self.assertIn("binary VTP", self.succeeds("info", "surface.vtp"))
        self.write("p.csv", table(POINTS))
        self.succeeds("query", "surface.vtp", "p.csv", "-o", "by-vtp.csv")
        self.succeeds("query", "box.off", "p.csv", "-o", "by-off.csv")
        for one, other in zip(self.rows("by-vtp.csv"), self.rows("by-off.csv"), strict=True):
            self.assertEqual(float(one["distance"]), float(other["distance"]))

    def test_patches_keep_their_names(self):
        self.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        self.write("m.vtk", legacy(POINTS, [(0, 1, 2, 3)], [10]))
        said = self.succeeds("query", "two.obj", "m.vtk", "-o", "q.vtu")
        self.assertNotIn("note", said)
        self.assertEqual(VtkXml(self.folder / "q.vtu").patch_names(), ["base", "sides"])
        self.succeeds("query", "two.obj", "m.vtk", "-o", "q.vtu", "--write", "distance")
        self.assertEqual(VtkXml(self.folder / "q.vtu").patch_names(), [])
        self.write("p.csv", table(POINTS))
        self.succeeds("query", "two.obj", "p.csv", "-o", "q.vtp")
        self.assertEqual(VtkXml(self.folder / "q.vtp").patch_names(), ["base", "sides"])
        self.succeeds("query", "box.off", "p.csv", "-o", "q.vtp")
        self.assertEqual(VtkXml(self.folder / "q.vtp").patch_names(), [])
        note = "note: this format does not keep the names of 2 patches; .vtu and .vtp do\n"
        self.assertTrue(self.succeeds("query", "two.obj", "p.csv", "-o", "q.csv").endswith(note))
        self.assertNotIn("note", self.succeeds("query", "box.off", "p.csv", "-o", "q.csv"))

    def test_the_same_bytes_whatever_the_threads(self):
        self.write("p.csv", table([(0.01 * i, 0.02 * i - 1, 0.3) for i in range(3000)]))
        for threads in (1, 3):
            self.succeeds("query", "box.off", "p.csv", "--threads", threads, "-o", f"{threads}.npy")
        self.assertEqual((self.folder / "1.npy").read_bytes(), (self.folder / "3.npy").read_bytes())

    def test_refusals(self):
        self.write("p.csv", table(POINTS))
        self.write("distance.csv", "x,y,z,distance\n0,0,0,1\n")
        self.write("m.vtk", legacy(POINTS, [(0, 1)], [3]))
        query = ["query", "box.off"]
        self.assertIn("POINTS", self.fails(2, *query, "-o", "q.csv"))
        self.assertIn("--output", self.fails(2, *query, "p.csv"))
        self.assertIn("'q.txt'", self.fails(2, *query, "p.csv", "-o", "q.txt"))
        self.assertIn("colour", self.fails(2, *query, "p.csv", "-o", "q.csv", "--write", "colour"))
        self.assertIn("p.csv: --cells, but the file has no cells", self.fails(1, *query, "p.csv", "--cells", "-o", "q.vtu"))
        self.assertIn('an array named "distance" already', self.fails(1, *query, "distance.csv", "-o", "q.csv"))
        self.assertIn("q.csv: tables hold points only", self.fails(1, *query, "m.vtk", "-o", "q.csv"))
        self.assertIn("none.csv", self.fails(1, *query, "none.csv", "-o", "q.csv"))
        self.assertIn("m.vtk: line 5", self.fails(1, *query, self.write("m.vtk", legacy(POINTS, [], [])[:90]), "-o", "q.vtk"))
        self.assertEqual([f.name for f in self.folder.iterdir() if f.name.startswith("q.")], [])


if __name__ == "__main__":
    unittest.main()
