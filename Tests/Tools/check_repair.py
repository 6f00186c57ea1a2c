"""Runs cutwater repair on surfaces broken by hand. Usage: check_repair.py PROGRAM [group]"""
import re
import unittest

from command import BOX_FACES, BOX_POINTS, OPEN_BOX_FACES, CommandTest
from readers import bounds, read_off


class RepairTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.surface("open.off", BOX_POINTS, OPEN_BOX_FACES)

    def repaired(self, file, *options, output="out.off"):
        """What it says, after it was compared with what is in the file it wrote."""
        facts = self.json("repair", file, "-o", output, *options)
        read = self.json("info", output)
        for key in "polygons", "points", "area", "volume":
            self.assertEqual(facts["after"][key], read["surface"][key])
        self.assertEqual(facts["check"], read["check"])
        self.assertEqual(facts["defects"], read["defects"])
        self.assertEqual(facts["signs"], read["signedDistance"]["signs"])
        return facts

    def expect_sound(self, facts, area, volume):
        self.assertTrue(facts["check"]["sound"], facts["check"])
        self.assertAlmostEqual(facts["after"]["area"], area, delta=1e-6)
        self.assertAlmostEqual(facts["after"]["volume"], volume, delta=1e-6)

    def corrections(self, facts):
        """How often each kind was put right."""
        self.assertEqual(facts["steps"][0]["name"], "clean")
        return {c["key"]: c["count"] for c in facts["steps"][0]["corrections"]}


class Cleaning(RepairTest):
    def test_every_kind_of_damage(self):
        points = BOX_POINTS + [(0.5, 0, 0), (9, 9, 9)]
        faces = [(0, 3, 2, 1, 8), (0, 8, 1), (0, 1, 5, 4), *BOX_FACES[2:5], BOX_FACES[5][::-1], BOX_FACES[3],
                 (0, 0, 1)]
        self.surface("bad.off", points, faces)
        facts = self.repaired("bad.off")
        self.expect_sound(facts, 6, 1)
        done = self.corrections(facts)
        self.assertEqual((done["duplicateFaces"], done["unusedPoints"], done["turnedFaces"], done["turnedShells"]),
                         (1, 1, 1, 0))
        self.assertGreaterEqual(done["degenerateFaces"], 2)
        self.assertEqual(facts["before"]["volume"], None)

    def test_an_inside_out_box(self):
        self.surface("turned.off", BOX_POINTS, [f[::-1] for f in BOX_FACES])
        self.expect_sound(self.repaired("turned.off"), 6, 1)
        facts = self.repaired("turned.off", "--no-orient")
        self.assertEqual(facts["after"]["volume"], -1)
        self.assertNotIn("turnedShells", self.corrections(facts))

    def test_cracks_are_welded_on_request(self):
        points, faces = [], []
        for face in BOX_FACES:
            faces.append(tuple(range(len(points), len(points) + 4)))
            points += [tuple(c + 1e-5 * (len(faces) % 3) for c in BOX_POINTS[i]) for i in face]
        self.surface("cracked.off", points, faces)
        self.assertFalse(self.repaired("cracked.off")["check"]["closed"])
        facts = self.repaired("cracked.off", "--weld", "1e-4")
        # At two corners three faces are apart, at six only two: 2 * 3 + 6 * 2 points become 8.
        self.assertEqual(self.corrections(facts)["closePoints"], 10)
        self.assertTrue(facts["check"]["sound"])
        largest = max(c["largest"] for c in facts["steps"][0]["corrections"])
        self.assertAlmostEqual(largest, 2e-5 * 3 ** 0.5, delta=1e-10)

    def test_junctions(self):
        points = BOX_POINTS + [(0.5, 0, 0)]
        self.surface("junction.off", points, [(0, 3, 2, 1), (0, 8, 5, 4), (8, 1, 5)] + BOX_FACES[2:])
        self.assertFalse(self.repaired("junction.off")["check"]["closed"])
        facts = self.repaired("junction.off", "--junctions", "1e-6")
        self.assertEqual(self.corrections(facts)["junctions"], 1)
        self.expect_sound(facts, 6, 1)

    def test_opposite_faces(self):
        points = BOX_POINTS + [(2, 0, 0), (3, 0, 0), (2, 1, 0)]
        self.surface("panel.off", points, BOX_FACES + [(8, 9, 10), (8, 10, 9)])
        self.assertEqual(self.repaired("panel.off")["after"]["area"], 7)
        facts = self.repaired("panel.off", "--cancel-opposite")
        self.assertEqual(self.corrections(facts)["oppositeFaces"], 2)
        self.expect_sound(facts, 6, 1)

    def test_shells_within_shells(self):
        inner = [tuple(0.25 + c / 2 for c in p) for p in BOX_POINTS]
        for turned in False, True:
            faces = BOX_FACES + [tuple(i + 8 for i in (f[::-1] if turned else f)) for f in BOX_FACES]
            self.surface("nested.off", BOX_POINTS + inner, faces)
            for policy, volume in [("as-they-are", 7 / 8 if turned else 9 / 8), ("cavities", 7 / 8),
                                   ("solids", 9 / 8)]:
                with self.subTest(turned=turned, policy=policy):
                    self.assertEqual(self.repaired("nested.off", "--nested", policy)["after"]["volume"], volume)


class Openings(RepairTest):
    def test_caps(self):
        facts = self.repaired("open.off", "--cap", "z=1")
        self.expect_sound(facts, 6, 1)
        self.assertEqual(facts["before"]["polygons"], 5)
        cap = facts["steps"][1]
        self.assertEqual((cap["name"], cap["openingsClosed"], cap["rimEdges"], cap["areaAdded"]), ("cap z=1", 1, 4, 1))
        self.assertEqual((cap["before"]["area"], cap["after"]["area"]), (5, 6))
        facts = self.repaired("open.off", "--cap", "0.2,0.3,1,0,0,-7")
        self.expect_sound(facts, 6, 1)
        self.assertEqual(self.repaired("open.off", "--cap", "z=0.99")["steps"][1]["openingsClosed"], 0)
        self.expect_sound(self.repaired("open.off", "--cap", "z=0.99", "--tolerance", "0.02"), 6, 1)

    def test_caps_have_patches(self):
        self.succeeds("convert", "open.off", "open.obj")
        self.repaired("open.obj", "--cap", "z=1:outlet: upper", output="out.obj")
        self.assertIn("g outlet: upper\n", (self.folder / "out.obj").read_text())
        self.repaired("open.obj", "--cap", "z=1", output="out.obj")
        self.assertIn("g cap\n", (self.folder / "out.obj").read_text())

    def test_mirror_images(self):
        facts = self.repaired("open.off", "--mirror", "z=1")
        self.expect_sound(facts, 10, 2)
        self.assertEqual(bounds(read_off(self.folder / "out.off")[0]), (0, 0, 0, 1, 1, 2))
        self.assertEqual(facts["steps"][1]["rimEdges"], 4)
        facts = self.repaired("open.off", "--mirror", "z=1.01", "--tolerance", "0.02")
        self.expect_sound(facts, 2 + 8 * 1.01, 2.02)
        self.assertAlmostEqual(facts["steps"][1]["farthestMove"], 0.01, delta=1e-12)

    def test_steps_follow_the_order_given(self):
        self.surface("duct.off", BOX_POINTS, BOX_FACES[1:5])
        facts = self.repaired("duct.off", "--cap", "z=0", "--mirror", "z=1")
        self.assertEqual([s["name"] for s in facts["steps"]], ["clean", "cap z=0", "mirror z=1"])
        self.expect_sound(facts, 10, 2)
        # The other way round there is no point at z = 1 left on a rim, but a second half to cap.
        facts = self.repaired("duct.off", "--mirror", "z=1", "--cap", "z=0")
        self.assertEqual([s["name"] for s in facts["steps"]], ["clean", "mirror z=1", "cap z=0"])
        self.assertEqual(facts["check"]["summary"].split(";")[1], " 4 open edges")
        facts = self.repaired("duct.off", "--mirror", "z=1", "--cap", "z=0", "--cap", "z=2")
        self.expect_sound(facts, 10, 2)

    def terrain(self):
        n = 4
        points = [(x, y, 0.25 * (x * y % 3)) for y in range(n) for x in range(n)]
        faces = [f for i in range(n * (n - 1)) if i % n < n - 1
                 for f in ((i, i + 1, i + n + 1), (i, i + n + 1, i + n))]
        return self.surface("terrain.off", points, faces), points, faces

    def test_a_terrain_becomes_a_solid(self):
        name, points, faces = self.terrain()
        below = sum((1 + sum(points[i][2] for i in f) / 3) / 2 for f in faces)  # down to z = -1
        facts = self.repaired(name, "--extend", "z=-1")
        self.assertTrue(facts["check"]["sound"])
        self.assertAlmostEqual(facts["after"]["volume"], below, delta=1e-12)
        facts = self.repaired(name, "--extend", "z=2")
        self.assertAlmostEqual(facts["after"]["volume"], 3 * 9 - below, delta=1e-12)
        self.assertIn("beyond the surface", self.fails(1, "repair", name, "-o", "a.off", "--extend", "z=0.1"))

    def test_a_terrain_reaches_a_box(self):
        name, _, _ = self.terrain()
        facts = self.repaired(name, "--extend-to-box", "-2,-2,-1,5,5,3:-z")
        self.assertTrue(facts["check"]["sound"])
        self.assertEqual(bounds(read_off(self.folder / "out.off")[0])[:5], (-2, -2, -1, 5, 5))
        upper = self.repaired(name, "--extend-to-box", "-2,-2,-1,5,5,3:+z")
        self.assertAlmostEqual(facts["after"]["volume"] + upper["after"]["volume"], 7 * 7 * 4, delta=1e-9)


class Mending(RepairTest):
    """What Cutwater::Repair does, where the program is built with it."""

    def setUp(self):
        super().setUp()
        if "--wrap" not in self.succeeds("repair", "--help"):
            self.skipTest("built without Cutwater::Repair")

    def tilted(self):
        """The open box with its rim in no plane across an axis."""
        points = [(x, y, z + (0.2 * x + 0.1 * y if z == 1 else 0)) for x, y, z in BOX_POINTS]
        return self.surface("tilted.off", points, OPEN_BOX_FACES)

    def test_holes(self):
        facts = self.repaired(self.tilted(), "--holes", "all")
        self.assertTrue(facts["check"]["sound"])
        self.assertAlmostEqual(facts["after"]["volume"], 1.15)
        step = facts["steps"][1]
        self.assertEqual((step["name"], step["holesFilled"], step["facesAdded"]), ("holes all", 1, 2))
        self.assertEqual(step["crossings"], 0)

    def test_holes_up_to_a_width(self):
        facts = self.repaired(self.tilted(), "--holes", "0.5")
        self.assertEqual((facts["steps"][1]["holesFilled"], facts["steps"][1]["tooWide"]), (0, 1))
        self.assertFalse(facts["check"]["closed"])

    def test_wrap(self):
        facts = self.repaired("open.off", "--wrap", "2,0.01")
        self.assertTrue(facts["check"]["sound"])
        self.assertGreater(facts["after"]["volume"], 1)
        self.assertLess(facts["after"]["volume"], 1.1)
        self.assertEqual(facts["steps"][1]["offset"], 0.01)
        page = self.succeeds("repair", "open.off", "-o", "out.stl", "--wrap", "2")
        self.assertRegex(page, r"wrap 2, in [^\n]+\n +faces +5 -> \d+")

    def test_intersections(self):
        facts = self.repaired("open.off", "--cap", "z=1", "--intersections")
        self.assertEqual(facts["steps"][2]["pairsBefore"], 0)
        self.assertTrue(facts["check"]["sound"])

    def test_refusals(self):
        for wrong in "0", "-1", "1,0", "1,2,3", "x":
            self.fails(2, "repair", "open.off", "-o", "out.off", "--wrap", wrong)
        self.assertIn("need all, or a length above 0",
                      self.fails(2, "repair", "open.off", "-o", "out.off", "--holes", "some"))
        self.fails(2, "repair", "open.off", "-o", "out.off", "--holes", "0")
        self.assertIn("--wrap 0.",
                      self.fails(1, "repair", "open.off", "-o", "out.off", "--wrap", "1e-5"))
        self.assertIn("not done within 0.001 seconds; --budget gives it more",
                      self.fails(1, "repair", "open.off", "-o", "out.off", "--wrap", "0.01",
                                 "--budget", "0.001"))
        self.assertFalse((self.folder / "out.off").exists())

    def test_info_suggests_to_fill_a_hole(self):
        self.succeeds("make", "sphere", "--parts", "12", "-o", "ball.off")
        points, faces = read_off(self.folder / "ball.off")
        volume = self.json("info", "ball.off")["surface"]["volume"]
        hole = next(i for i, face in enumerate(faces) if len({points[c][2] for c in face}) == 3)
        self.surface("leak.off", points, faces[:hole] + faces[hole + 1:])
        command = self.json("info", "leak.off")["next"][0]["command"].split()
        self.assertIn("--holes", command)
        facts = self.repaired(*command[2:3], *command[5:])
        self.assertTrue(facts["check"]["sound"])
        self.assertAlmostEqual(facts["after"]["volume"], volume, places=6)

    def test_info_suggests_a_wrap_where_nothing_else_helps(self):
        # Two faces that meet at a point only look along all axes: no plane, no hole, no terrain.
        points = [(0, 0, 0), (1, 0.1, 0.2), (0.2, 1, 0.3), (-1, 0.2, -0.1), (-0.1, -0.3, -1)]
        self.surface("scraps.off", points, [(0, 1, 2), (0, 3, 4)])
        command = self.json("info", "scraps.off")["next"][-4]["command"].split()
        self.assertIn("--wrap", command)
        self.assertTrue(self.repaired(command[2], *command[5:])["check"]["sound"])


class Page(RepairTest):
    def test_tells_the_steps_and_the_result(self):
        text = self.succeeds("repair", "open.off", "-o", "out.off", "--cap", "z=1")
        for line in [r"equal points merged +0", r"faces turned +0", r"openings closed +1; at \(\d, \d, 1\)",
                     r"faces added +2, of area 1, area 5 -> 6, volume \S+ -> 1", r"area +5 -> 6",
                     r"volume +not closed -> 1", r"before +not closed, .*; 4 open edges; .*",
                     r"after +closed, oriented, manifold; .*", r"wrote +out.off: 7 polygons, 8 points, 1 patch",
                     r"watertight +yes", r"signs +nearest feature: closed, 0 self-intersections; .*", r"cutwater sample out.off .*"]:
            self.assertRegex(text, re.compile(rf"^  {line}$", re.MULTILINE))
        self.assertIn("Defects: none", text)
        self.assertEqual(self.succeeds("repair", "open.off", "-o", "out.off", "-q"), "")

    def test_tells_what_is_left(self):
        text = self.succeeds("repair", "open.off", "-o", "out.off")
        self.assertRegex(text, r"\n  error +4  open edges\n")
        self.assertIn("  cutwater info out.off\n      all about it, and a repair that would help further, if there is one\n", text)
        self.assertRegex(text, r"watertight +no\n")


class Files(RepairTest):
    def test_the_result_is_that_of_the_file_with_its_digits(self):
        # In single precision 1 + 1e-9 is 1: two points become one there, and the crack closes.
        points = [(x, y, z + 1e-9 if (x, y, z) == (1, 1, 1) else z) for x, y, z in BOX_POINTS] + [(1, 1, 1)]
        faces = BOX_FACES[:5] + [(4, 5, 8, 7)]
        self.surface("crack.off", points, faces)
        self.assertFalse(self.repaired("crack.off", output="out.ply")["check"]["closed"])
        self.assertFalse(self.repaired("crack.off", "--ascii", output="out.stl")["check"]["closed"])
        facts = self.repaired("crack.off", output="out.stl")
        self.expect_sound(facts, 6, 1)
        self.assertEqual(facts["after"]["polygons"], 12)

    def test_says_which_patches_are_lost(self):
        ends = ("--cap", "z=1:outlet")
        self.assertEqual(self.repaired("open.off", *ends, output="out.obj")["losses"], [])
        loss, = self.repaired("open.off", *ends, output="out.stl")["losses"]
        self.assertIn("names of 2 patches", loss)
        self.assertIn(f": 12 polygons, 8 points, 1 patch\n  {loss}\n",
                      self.succeeds("repair", "open.off", *ends, "-o", "out.stl"))

    def test_only_watertight_surfaces_if_told_to(self):
        why = self.fails(1, "repair", "open.off", "-o", "out.off", "--require-watertight")
        self.assertIn("open.off", why)
        self.assertIn("4 open edges", why)
        self.assertFalse((self.folder / "out.off").exists())
        self.succeeds("repair", "open.off", "-o", "out.off", "--require-watertight", "--cap", "z=1")
        self.assertTrue((self.folder / "out.off").exists())

    def test_refusals(self):
        for option, value in [("--weld", "0"), ("--weld", "x"), ("--junctions", "-1"), ("--nested", "some"),
                              ("--cap", "z"), ("--cap", "w=1"), ("--cap", "z=x"), ("--cap", "z=1:"),
                              ("--cap", "0,0,0,0,0,0"), ("--cap", "0,0,0,1"), ("--mirror", "1"), ("--mirror", "z=inf"),
                              ("--extend", "0,0,0,0,0,1"), ("--extend", "z=1,2"), ("--tolerance", "0"),
                              ("--extend-to-box", "0,0,0,1,1,1"), ("--extend-to-box", "0,0,0,1,1,1:z"),
                              ("--extend-to-box", "0,0,0,1,1,1:-w"), ("--extend-to-box", "0,0,0,1,1:-z")]:
            with self.subTest(option=option, value=value):
                self.assertIn(option, self.fails(2, "repair", "open.off", "-o", "out.off", option, value))
        self.fails(2, "repair", "open.off")
        for option, value, why in [("--mirror", "z=0.5", "there are points on both sides"),
                                   ("--extend", "z=0.5", "the level must lie beyond the surface"),
                                   ("--extend-to-box", "0,0,0,1,1,3:+z", "the rim reaches the sides of the box: use --extend")]:
            self.assertIn(f"{option} {value}: {why}", self.fails(1, "repair", "open.off", "-o", "out.off", option, value))
        self.assertIn("missing.off", self.fails(1, "repair", "missing.off", "-o", "out.off"))
        self.assertIn("out.xyz", self.fails(2, "repair", "open.off", "-o", "out.xyz"))
        self.assertEqual([f.name for f in self.folder.iterdir()], ["open.off"])

    def test_motions_come_first(self):
        facts = self.repaired("open.off", "--cap", "x=-2", "--scale", "2", "--rotate", "-90,y")
        self.expect_sound(facts, 24, 8)


if __name__ == "__main__":
    unittest.main()
