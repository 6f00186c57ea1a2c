"""Runs `cutwater mesh` as people and scripts do. Usage: check_mesh.py PROGRAM [group]"""
import json
import re
import unittest

from command import BOX_FACES, BOX_POINTS, CommandTest, off


def lists(path):
    """The entries between the parentheses of a file of OpenFOAM, as text."""
    text = path.read_text()
    body = re.sub(r"/\*.*?\*/|//[^\n]*|FoamFile\s*\{.*?\}", "", text, flags=re.S)
    count, entries = re.search(r"(\d+)\s*\(\s*(.*)\)", body, flags=re.S).groups()
    return int(count), entries


class PolyMesh:
    """A mesh as OpenFOAM would read it from text."""

    def __init__(self, folder):
        folder = folder / "constant/polyMesh"
        points = self.rows(folder / "points")
        self.points = [tuple(map(float, p.split())) for p in points]
        self.faces = [list(map(int, f.split())) for f in self.rows(folder / "faces")]
        self.owner, self.neighbour = (list(map(int, lists(folder / name)[1].split())) for name in ("owner", "neighbour"))
        entries = lists(folder / "boundary")[1]
        self.patches = {name: (kind, int(faces), int(first)) for name, kind, faces, first in re.findall(
            r"(\w+)\s*\{\s*type\s+(\w+);.*?nFaces\s+(\d+);.*?startFace\s+(\d+);", entries, flags=re.S)}
        self.cells = max(self.owner) + 1

    @staticmethod
    def rows(path):
        count, entries = lists(path)
        found = re.findall(r"\(([^()]*)\)", entries)
        assert count == len(found), (path, count, len(found))
        return found

    def area(self, face):
        """The vector, from the owner outwards."""
        corners = [self.points[n] for n in self.faces[face]]
        total = [0.0, 0.0, 0.0]
        for (a, b) in zip(corners, corners[1:] + corners[:1]):
            for k in range(3):
                total[k] += 0.5 * (a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2])
        return total

    def center(self, face):
        """That of the triangles between its edges and the mean of its corners."""
        corners = [self.points[n] for n in self.faces[face]]
        mean = [sum(c[k] for c in corners) / len(corners) for k in range(3)]
        total, weighted = 0.0, [0.0, 0.0, 0.0]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            u, v = ([p[k] - mean[k] for k in range(3)] for p in (a, b))
            size = sum((u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2]) ** 2 for k in range(3)) ** 0.5
            total += size
            weighted = [w + size * (m + p + q) / 3 for w, m, p, q in zip(weighted, mean, a, b)]
        return [w / total for w in weighted]

    def sides(self):
        """Of each cell: (face, sign)."""
        sides = [[] for _ in range(self.cells)]
        for face, cell in enumerate(self.owner):
            sides[cell].append((face, 1))
        for face, cell in enumerate(self.neighbour):
            sides[cell].append((face, -1))
        return sides


class Mesh(CommandTest):
    def setUp(self):
        super().setUp()
        self.box()  # of side 2 about the origin
        self.around = ("box.off", "--box", "-2.18,-2.2,-2.3,2.22,2.2,2.1", "--roots", "11", "--level", "0")

    def made(self, *arguments):
        said = self.succeeds("mesh", "case", *arguments, "--json", "totals.json")
        return said, json.loads((self.folder / "totals.json").read_text()), PolyMesh(self.folder / "case")

    def check(self, mesh):
        """What OpenFOAM asks of every mesh: order, closed cells, faces used."""
        inner = len(mesh.neighbour)
        pairs = list(zip(mesh.owner, mesh.neighbour))
        self.assertEqual(pairs, sorted(pairs))
        self.assertTrue(all(a < b for a, b in pairs))
        first = inner
        for _, faces, start in mesh.patches.values():
            self.assertEqual(start, first)
            owners = mesh.owner[start:start + faces]
            self.assertEqual(owners, sorted(owners))
            first += faces
        self.assertEqual(first, len(mesh.faces))
        self.assertEqual({n for f in mesh.faces for n in f}, set(range(len(mesh.points))))
        areas = [mesh.area(face) for face in range(len(mesh.faces))]
        for sides in mesh.sides():
            edges = {}
            for face, sign in sides:
                corners = mesh.faces[face]
                self.assertEqual(len(corners), len(set(corners)))
                for a, b in zip(corners, corners[1:] + corners[:1]):
                    edges[min(a, b), max(a, b)] = edges.get((min(a, b), max(a, b)), 0) + (sign if a < b else -sign)
            self.assertEqual(set(edges.values()), {0})
            for k in range(3):
                self.assertAlmostEqual(sum(sign * areas[face][k] for face, sign in sides), 0, places=13)

    def area_of(self, mesh, patch):
        """The sums of the area vectors of its faces, and of their lengths."""
        _, faces, start = mesh.patches[patch]
        areas = [mesh.area(face) for face in range(start, start + faces)]
        return [sum(a[k] for a in areas) for k in range(3)], sum(sum(x * x for x in a) ** 0.5 for a in areas)

    def volume(self, mesh):
        """As OpenFOAM computes it, of closed cells."""
        total = 0
        for sides in mesh.sides():
            for face, sign in sides:
                total += sign * sum(a * c for a, c in zip(mesh.area(face), mesh.center(face))) / 3
        return total

    def test_around_a_box(self):
        said, totals, mesh = self.made(*self.around)
        self.check(mesh)
        self.assertIn(f"made {totals['cells']:,} cells with".replace(",", " "), said)
        self.assertIn("wrote constant/polyMesh in case", said)
        self.assertNotIn("checkMesh", said)
        self.assertEqual({name: kind for name, (kind, *_) in mesh.patches.items()},
                         {"box": "wall", **{name: "patch" for name in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")}})
        self.assertEqual([(p["name"], p["faces"]) for p in totals["patches"]],
                         [(name, faces) for name, (_, faces, _) in mesh.patches.items()])
        self.assertEqual((totals["cells"], totals["faces"], totals["points"]),
                         (mesh.cells, len(mesh.faces), len(mesh.points)))
        vector, length = self.area_of(mesh, "box")
        self.assertTrue(23 < length < 24, length)  # a face goes across the edges of the box
        self.assertTrue(all(abs(x) < 1e-13 for x in vector), vector)
        for axis, size in enumerate((4.4, 4.4, 4.4)):
            vector, length = self.area_of(mesh, "xyz"[axis] + "Max")
            self.assertAlmostEqual(vector[axis], size * size, places=11)
            self.assertAlmostEqual(length, size * size, places=11)
        self.assertAlmostEqual(totals["fluidVolume"], 4.4**3 - 8, places=11)
        self.assertAlmostEqual(totals["meshVolume"], self.volume(mesh), places=11)
        self.assertEqual([totals[key] for key in ("openCells", "repeatedCorners", "disorderedFaces", "invertedCells",
                                                  "invertedFaces", "skewFaces", "lostRegions")], [0] * 7)
        self.assertGreater(totals["joinedPieces"], 0)

    def test_small_pieces_stay_where_none_is_to_be_joined(self):
        _, joined, _ = self.made(*self.around)
        _, apart, mesh = self.made(*self.around, "--smallest", "0")
        self.check(mesh)
        self.assertEqual(apart["joinedPieces"], 0)
        self.assertEqual(apart["cells"], joined["cells"] + joined["joinedPieces"])

    def test_wall_triangles_keep_volumes(self):
        self.succeeds("make", "sphere", "-o", "ball.off")
        around = ("ball.off", "--roots", "6", "--level", "1")
        _, flat, plain = self.made(*around)
        self.check(plain)
        self.assertGreater(abs(flat["meshVolume"] - flat["fluidVolume"]), 1e-6)
        _, exact, mesh = self.made(*around, "--wall-triangles", "--smallest", "0")
        self.check(mesh)
        self.assertAlmostEqual(exact["meshVolume"] / exact["fluidVolume"], 1, places=12)
        self.assertAlmostEqual(self.volume(mesh) / exact["fluidVolume"], 1, places=12)
        self.assertGreater(mesh.patches["ball"][1], plain.patches["ball"][1])

    def test_closed_regions(self):
        inner = [(0.4 * x + 0.3, 0.4 * y + 0.3, 0.4 * z + 0.3) for x, y, z in BOX_POINTS]
        walls = [tuple(face) for face in BOX_FACES] + [tuple(8 + n for n in reversed(face)) for face in BOX_FACES]
        (self.folder / "hollow.off").write_text(off(BOX_POINTS + inner, walls))
        place = ("hollow.off", "--box", "-1.05,-1.05,-1.05,2.05,2.05,2.05", "--roots", "31", "--level", "0")
        said, totals, mesh = self.made(*place)
        self.check(mesh)
        self.assertIn("left out: 1 closed region of 0.064", said)
        self.assertAlmostEqual(totals["lostVolume"], 0.4**3, places=12)
        zones = self.folder / "case/constant/polyMesh/cellZones"
        self.assertFalse(zones.exists())
        said, totals, mesh = self.made(*place, "--cavities")
        self.check(mesh)
        self.assertIn("in 2 regions", said)
        self.assertAlmostEqual(totals["regions"][1], 0.4**3, places=12)
        self.assertIn("region1", zones.read_text())
        _, totals, _ = self.made(*place, "--within", "0.5,0.5,0.5")
        self.assertAlmostEqual(totals["fluidVolume"], 0.4**3, places=12)
        self.assertFalse(zones.exists())

    def test_open_patches_and_levels(self):
        ends = {(3, 0, 4, 7): "inlet", (1, 2, 6, 5): "outlet"}
        lines = [f"v {x} {y} {z}" for x, y, z in BOX_POINTS]
        for face in BOX_FACES:
            lines += [f"g {ends.get(face, 'wall')}", "f " + " ".join(str(n + 1) for n in face)]
        (self.folder / "duct.obj").write_text("\n".join(lines) + "\n")
        duct = ("duct.obj", "--inside", "--open", "inlet", "--open", "outlet", "--box", "0,-0.25,-0.25,1,1.25,1.25",
                "--roots", "6", "--level", "0", "--band", "0.1:1")
        _, totals, mesh = self.made(*duct)
        self.check(mesh)
        self.assertEqual({name: kind for name, (kind, *_) in mesh.patches.items()},
                         {"wall": "wall", "inlet": "patch", "outlet": "patch"})
        self.assertAlmostEqual(totals["fluidVolume"], 1, places=13)
        self.assertAlmostEqual(self.area_of(mesh, "inlet")[0][0], -1, places=13)
        _, exact, mesh = self.made(*duct, "--wall-triangles")
        self.assertAlmostEqual(self.area_of(mesh, "wall")[1], 4, places=12)
        self.assertAlmostEqual(exact["meshVolume"], 1, places=13)

    def test_solids_of_scenes(self):
        (self.folder / "ball.toml").write_text('[ball]\nshape = "sphere"\nradius = 1\n')
        _, totals, mesh = self.made("ball.toml", "--roots", "6", "--level", "1", "--box", "-2,-2,-2,2,2,2")
        self.check(mesh)
        self.assertAlmostEqual(totals["fluidVolume"], 64 - 4.18879020478639, places=4)

    def test_the_same_bytes(self):
        """Whatever the number of threads; an earlier mesh is replaced; nothing is said with -q."""
        found = []
        for threads in (1, 3):
            self.assertEqual(self.succeeds("mesh", "new/", *self.around, "--threads", threads, "-q", "--binary"), "")
            folder = self.folder / "new/constant/polyMesh"
            found.append({f.name: f.read_bytes() for f in folder.iterdir()})
        self.assertEqual(*found)
        self.assertEqual(set(found[0]), {"points", "faces", "owner", "neighbour", "boundary"})

    def test_refusals(self):
        self.assertIn("there is no folder", self.fails(1, "mesh", "none/case", *self.around))
        self.assertIn("--period is for grids", self.fails(1, "mesh", "case", *self.around, "--period", "4,0,0"))
        self.assertIn("--max-cells allows 100", self.fails(1, "mesh", "case", *self.around, "--max-cells", "100"))
        self.assertIn("fluid", self.fails(1, "mesh", "case", *self.around, "--within", "0,0,0"))
        self.fails(1, "mesh", "box.off", *self.around)
        self.fails(2, "mesh", "case", *self.around, "--smallest", "2")
        self.fails(2, "mesh", "case", "box.off")
        self.assertFalse((self.folder / "case").exists())


if __name__ == "__main__":
    unittest.main()
