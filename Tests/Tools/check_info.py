"""Runs cutwater info on good and bad surfaces. Usage: check_info.py PROGRAM [group]"""
import itertools
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import unittest

from command import BOX_FACES, BOX_POINTS, OPEN_BOX_FACES, PROGRAM, CommandTest, off
from readers import read_off


class InfoTest(CommandTest):
    def value(self, text, name):
        return re.search(rf"^  {name}  +(.*)$", text, re.MULTILINE)[1]

    def facts(self, *arguments):
        return self.json("info", *arguments)

    def defects(self, *arguments):
        """By key; their order is looked at here."""
        found = self.facts(*arguments)["defects"]
        order = [["error", "warning", "note"].index(defect["severity"]) for defect in found]
        self.assertEqual(order, sorted(order))
        for defect in found:
            self.assertLessEqual(len(defect["places"]), min(8, defect["count"]))
        return {defect["key"]: defect for defect in found}

    def expect_defect(self, found, key, severity, count):
        self.assertIn(key, found)
        self.assertEqual((found[key]["severity"], found[key]["count"]), (severity, count))

    def repairs(self, *arguments):
        """The commands that info suggests, as words after the program's name."""
        commands = [shlex.split(n["command"]) for n in self.facts(*arguments)["next"]]
        return [words[1:] for words in commands if words[1] == "repair"]

    def expect_cure(self, words, area, volume):
        """Runs what was suggested: it says what comes of it, and that must be so."""
        self.succeeds(*words)
        facts = self.facts(words[words.index("-o") + 1])
        self.assertTrue(facts["check"]["sound"], facts["check"])
        self.assertAlmostEqual(facts["surface"]["area"], area, delta=1e-5 * area)
        self.assertAlmostEqual(facts["surface"]["volume"], volume, delta=1e-5 * volume)
        self.assertFalse([n for n in facts["next"] if " repair " in n["command"]])


class Info(InfoTest):
    def test_reports_a_closed_surface(self):
        text = self.succeeds("info", self.box(size="2,3,4"))
        self.assertEqual(self.value(text, "polygons"), "6, as 12 triangles")
        self.assertEqual(self.value(text, "bounding box"), "(-1, -1.5, -2) to (1, 1.5, 2)")
        self.assertEqual(self.value(text, "extent"), "2 x 3 x 4")
        self.assertEqual(float(self.value(text, "area")), 52)
        self.assertEqual(float(self.value(text, "volume")), 24)
        self.assertEqual(self.value(text, "components"), "1")
        self.assertEqual(self.value(text, "topology"), "Euler characteristic 2, genus 0")
        self.assertEqual(self.value(text, "watertight"), "yes")
        self.assertRegex(self.value(text, "memory"), r"\d+ bytes per triangle")
        self.assertEqual(self.value(text, "self-intersections"), "none")
        for name in ["read", "weld", "mesh and check", "build"]:
            self.assertRegex(self.value(text, name), r"^[\d.]+ (us|ms|s)$")
        self.assertIn("cutwater sample", text)

    def test_groups_digits_and_counts_merged_points(self):
        self.succeeds("make", "sphere", "--parts", 160, "-o", "s.stl")
        text = self.succeeds("info", "s.stl")
        self.assertEqual(self.value(text, "polygons"), "20 480, all triangles")
        self.assertEqual(self.value(text, "points"),
                         "10 242 (61 440 in the file, 51 198 merged with equal ones)")

    def test_topology_is_told_of_every_surface(self):
        self.succeeds("make", "torus", "--parts", "12", "-o", "torus.off")
        self.assertEqual(self.value(self.succeeds("info", "torus.off"), "topology"), "Euler characteristic 0, genus 1")
        self.surface("duct.off", BOX_POINTS, BOX_FACES[1:5])
        text = self.succeeds("info", "duct.off")
        self.assertEqual(self.value(text, "topology"),
                         "Euler characteristic 0, no genus: not a closed, oriented manifold")


    def test_says_nothing_if_told_so(self):
        self.box()
        self.assertEqual(self.succeeds("info", "box.off", "--quiet"), "")
        self.assertTrue(self.facts("box.off", "--quiet")["check"]["sound"])
        self.fails(1, "info", "missing.off", "--quiet")

    def test_lists_patches(self):
        (self.folder / "two.obj").write_text(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        text = self.succeeds("info", "two.obj")
        self.assertRegex(text, r"Patches: 2\n +0  base +1 polygon\n +1  sides +3 polygons\n")

    def test_reports_an_open_surface_in_full(self):
        self.surface("open.off", BOX_POINTS, OPEN_BOX_FACES)
        text = self.succeeds("info", "open.off")
        self.assertEqual(self.value(text, "watertight"), "no")
        self.assertEqual(float(self.value(text, "area")), 5)
        self.assertEqual(self.value(text, "volume"), "not computed: the surface is not closed")
        self.assertIn("4 open edges", self.value(text, "in short"))
        self.assertEqual(len(re.findall(r"^ .*\bopen edges$", text, re.MULTILINE)), 1)  # among the defects
        self.assertRegex(self.value(text, "signs"), r"^winding number: 4 unbalanced edges; 1024 probes, \d+ ambiguous")
        self.assertIn("the sign jumps", self.value(text, "distances"))

    def test_counts_self_intersections(self):
        points, faces = read_off(self.folder / self.box())
        both = points + [tuple(c + 1 for c in p) for p in points]  # a corner of each within the other
        self.surface("two.off", both, faces + [[i + len(points) for i in f] for f in faces])
        text = self.succeeds("info", "two.off")
        self.assertEqual(self.value(text, "watertight"), "yes")
        self.assertEqual(self.value(text, "self-intersections"), "yes, see below")
        self.assertRegex(text, r"\n  warning +6  pairs of faces that intersect\n")
        found = self.defects("two.off")["selfIntersections"]
        self.assertEqual((found["count"], found["complete"]), (6, True))
        for place in found["places"]:  # each face of one box with one of the other
            first, second = place["faces"]
            self.assertTrue(first < 6 <= second, place)
            self.assertTrue(all(0 <= c <= 1 for c in place["point"]), place)
        self.assertRegex(self.value(text, "signs"), r"^winding number: closed, \d+ self-intersections; ")
        self.assertIn("nearest face", self.value(text, "distances"))
        timings = text[text.index("Timings"):]
        self.assertRegex(self.value(timings, "self-intersections"), r"^[\d.]+ (us|ms|s)$")


class Defects(InfoTest):
    def test_an_open_box(self):
        self.surface("open.off", BOX_POINTS, OPEN_BOX_FACES)
        found = self.defects("open.off")
        self.assertEqual(set(found), {"openEdges"})
        self.expect_defect(found, "openEdges", "error", 4)
        places = {(tuple(p["point"]), *p["faces"]) for p in found["openEdges"]["places"]}
        self.assertEqual(places, {((0.5, 0, 1), 1), ((1, 0.5, 1), 2), ((0.5, 1, 1), 3), ((0, 0.5, 1), 4)})
        opening, = self.facts("open.off")["openings"]
        self.assertEqual((opening["edges"], opening["axis"], opening["at"]), (4, "z", 1))
        self.assertEqual(opening["box"], {"lower": [0, 0, 1], "upper": [1, 1, 1]})

    def test_a_box_with_a_hole_that_is_small(self):
        self.succeeds("make", "sphere", "--parts", 160, "-o", "s.off")
        points, faces = read_off(self.folder / "s.off")
        self.surface("hole.off", points, faces[1:])
        found = self.defects("hole.off")
        self.expect_defect(found, "openEdges", "warning", 3)

    def test_an_inside_out_box(self):
        self.surface("turned.off", BOX_POINTS, [f[::-1] for f in BOX_FACES])
        found = self.defects("turned.off")
        self.assertEqual(set(found), {"insideOutShells"})
        self.expect_defect(found, "insideOutShells", "warning", 1)
        self.assertEqual(self.value(self.succeeds("info", "turned.off"), "volume"),
                         "-1 of the faces as they are; 1 of the solid, with all facing outward")
        words, = self.repairs("turned.off")
        self.expect_cure(words, 6, 1)

    def test_a_volume_of_shells_of_which_one_is_turned(self):
        points = BOX_POINTS + [tuple(2 + 2 * c for c in p) for p in BOX_POINTS]
        self.surface("two.off", points, BOX_FACES + [tuple(8 + i for i in f[::-1]) for f in BOX_FACES])
        surface = self.facts("two.off")["surface"]
        self.assertEqual((surface["volume"], surface["solidVolume"]), (-7, 9))
        self.assertRegex(self.value(self.succeeds("info", "two.off"), "volume"), "^-7 of the faces.*; 9 of the solid")

    def test_a_face_that_is_turned(self):
        self.surface("turned.off", BOX_POINTS, BOX_FACES[:5] + [BOX_FACES[5][::-1]])
        found = self.defects("turned.off")
        self.assertEqual(set(found), {"turnedFaces"})
        self.expect_defect(found, "turnedFaces", "warning", 1)
        self.assertEqual(found["turnedFaces"]["places"], [{"point": [0.5, 0.5, 1], "faces": [5]}])
        words, = self.repairs("turned.off")
        self.expect_cure(words, 6, 1)

    def test_harmless_things(self):
        points = BOX_POINTS + [(0.5, 0, 0), (9, 9, 9)]
        # A needle on an edge of its own, a face twice, a face with a corner twice, a point for nothing.
        faces = BOX_FACES[:1] + [(0, 8, 1), (0, 1, 5, 4)] + BOX_FACES[2:] + [BOX_FACES[3], (0, 0, 1)]
        faces[0] = (0, 3, 2, 1, 8)
        self.surface("bad.off", points, faces)
        found = self.defects("bad.off")
        for key, places in [("zeroAreaFaces", [1, 8]), ("duplicateFaces", [7]), ("repeatedCorners", [8])]:
            self.expect_defect(found, key, "note", len(places))
            self.assertEqual([p["faces"] for p in found[key]["places"]], [[i] for i in places])
        self.expect_defect(found, "unusedPoints", "note", 1)
        self.assertEqual(found["unusedPoints"]["places"], [{"point": [9, 9, 9], "faces": []}])
        words, = self.repairs("bad.off")
        self.expect_cure(words, 6, 1)

    def test_panels_of_no_thickness(self):
        points = BOX_POINTS + [(2, 0, 0), (3, 0, 0), (2, 1, 0)]
        self.surface("panel.off", points, BOX_FACES + [(8, 9, 10), (8, 10, 9)])
        found = self.defects("panel.off")
        self.expect_defect(found, "oppositeFaces", "warning", 1)
        self.expect_defect(found, "selfIntersections", "note", 1)
        self.expect_defect(found, "components", "note", 2)

    def test_a_moebius_strip(self):
        points, faces, parts = [], [], 12
        for i in range(parts):
            turn = 2 * math.pi * i / parts
            for side in -0.3, 0.3:
                radius = 1 + side * math.cos(turn / 2)
                points.append((radius * math.cos(turn), radius * math.sin(turn), side * math.sin(turn / 2)))
        for i in range(parts):
            a, b = 2 * i, 2 * i + 1
            c, d = (a + 2, b + 2) if i + 1 < parts else (1, 0)
            faces += [(a, c, b), (b, c, d)]
        self.surface("strip.off", points, faces)
        self.expect_defect(self.defects("strip.off"), "unorientableShells", "error", 1)

    def test_no_face_at_all(self):
        self.surface("none.off", BOX_POINTS, [(0, 0, 1), (1, 2, 2)])
        found = self.defects("none.off")
        self.expect_defect(found, "noFaces", "error", 2)
        self.assertEqual(self.facts("none.off")["signedDistance"], None)
        self.assertEqual(self.facts("none.off")["next"], [])
        self.assertIn("none.off: cleaning leaves no face", self.fails(1, "repair", "none.off", "-o", "out.off"))

    def test_a_sheet_in_a_plane(self):
        self.surface("inlet.off", BOX_POINTS, [BOX_FACES[5]])
        found = self.defects("inlet.off")
        self.expect_defect(found, "flat", "error", 1)
        self.assertIn("z = 1", found["flat"]["meaning"])
        words, = self.repairs("inlet.off")  # of its unused points only
        self.assertEqual(words, ["repair", "inlet.off", "-o", "inlet-repaired.off"])

    def test_polygons_that_are_not_planar(self):
        points = BOX_POINTS[:6] + [(1, 1, 1.5), (0, 1, 1)]
        self.surface("warped.off", points, BOX_FACES)
        found = self.defects("warped.off")
        self.expect_defect(found, "nonPlanarPolygons", "note", 1)
        self.assertEqual(found["nonPlanarPolygons"]["places"][0]["faces"], [5])

    def test_shells_within_shells(self):
        inner = [tuple(0.25 + c / 2 for c in p) for p in BOX_POINTS]
        self.surface("nested.off", BOX_POINTS + inner,
                     BOX_FACES + [tuple(i + 8 for i in f) for f in BOX_FACES])
        found = self.defects("nested.off")
        self.assertEqual(found["unsoundSurface"]["severity"], "warning")
        self.expect_defect(found, "components", "note", 2)
        cavity = [tuple(reversed([i + 8 for i in f])) for f in BOX_FACES]
        self.surface("cavity.off", BOX_POINTS + inner, BOX_FACES + cavity)
        self.assertEqual(set(self.defects("cavity.off")), {"components"})


class Suggestions(InfoTest):
    """What info suggests is run, and must come to what it is to come to."""

    def cracked_box(self, distance):
        """Every face with points of its own, in turns so far off."""
        points, faces = [], []
        for face in BOX_FACES:
            faces.append(tuple(range(len(points), len(points) + 4)))
            points += [tuple(c + distance * ((len(points) + i + k) % 3 - 1) for k, c in enumerate(BOX_POINTS[p]))
                       for i, p in enumerate(face)]
        return points, faces

    def test_points_a_rounding_apart_are_welded(self):
        self.surface("cracked.off", *self.cracked_box(3e-7))
        self.expect_defect(self.defects("cracked.off"), "openEdges", "warning", 24)
        words, = self.repairs("cracked.off")
        self.assertIn("--weld", words)
        self.assertGreater(float(words[words.index("--weld") + 1]), 3e-7)
        self.expect_cure(words, 6, 1)

    def test_gaps_as_wide_as_details_are_not_welded(self):
        self.surface("apart.off", *self.cracked_box(0.01))
        self.assertFalse([words for words in self.repairs("apart.off") if "--weld" in words])

    def test_points_on_the_edges_of_others(self):
        points = BOX_POINTS + [(0.5, 0, 0)]
        faces = [(0, 3, 2, 1), (0, 8, 5, 4), (8, 1, 5)] + BOX_FACES[2:]
        self.surface("junction.off", points, faces)
        words, = self.repairs("junction.off")
        self.assertIn("--junctions", words)
        self.expect_cure(words, 6, 1)

    def test_half_models_are_capped_or_mirrored(self):
        self.surface("half.off", BOX_POINTS, OPEN_BOX_FACES)
        capped, mirrored = self.repairs("half.off")
        self.assertEqual(capped[-2:], ["--cap", "z=1"])
        self.expect_cure(capped, 6, 1)
        self.assertEqual(mirrored[-2:], ["--mirror", "z=1"])
        self.expect_cure(mirrored, 10, 2)

    def test_rims_that_are_nearly_plane_get_a_tolerance(self):
        points = [(x, y, z + 2e-6 * (x - y) if z == 1 else z) for x, y, z in BOX_POINTS]
        self.surface("half.off", points, OPEN_BOX_FACES)
        words = self.repairs("half.off")[0]
        self.assertEqual(words[-4:-1], ["--cap", "z=1", "--tolerance"])
        self.expect_cure(words, 6, 1)

    def test_ducts_get_all_their_ends(self):
        self.surface("duct.off", BOX_POINTS, BOX_FACES[1:5])
        words, = self.repairs("duct.off")
        self.assertEqual({words[-3], words[-1]}, {"z=0", "z=1"})
        self.expect_cure(words, 6, 1)

    def test_terrains_are_extended(self):
        n = 5
        points = [(x, y, 0.25 * (x * y % 3)) for y in range(n) for x in range(n)]
        faces = [(i, i + 1, i + n + 1, i + n) for i in range(n * (n - 1)) if i % n < n - 1]
        self.surface("terrain.off", points, faces)
        words, = self.repairs("terrain.off")
        self.assertEqual(words[-2], "--extend")
        axis, level = words[-1].split("=")
        self.assertEqual(axis, "z")
        self.assertLess(float(level), 0)
        self.succeeds(*words)
        self.assertTrue(self.facts("terrain-repaired.off")["check"]["sound"])
        repaired, _ = read_off(self.folder / "terrain-repaired.off")
        self.assertEqual(min(p[2] for p in repaired), float(level))

    def test_sheets_in_planes_get_no_second_side(self):
        # Two blades, in planes across axes: a cap would be the blade again.
        points = [(0, 0, 1), (0, 1, 1), (0, 1, 2), (0, 0, 2), (0, 0, 4), (1, 0, 4), (1, 0, 5), (0, 0, 5)]
        self.surface("blades.off", points, [(0, 1, 2, 3), (4, 5, 6, 7)])
        repairs = self.repairs("blades.off")
        self.assertEqual([words for words in repairs if "--wrap" not in words], [])

    def test_small_openings_make_no_half_model(self):
        self.surface("vase.off", [(x, y, z) if z == 0 else (0.3 + 0.4 * x, 0.3 + 0.4 * y, z)
                                  for x, y, z in BOX_POINTS], OPEN_BOX_FACES)
        words, = self.repairs("vase.off")
        self.assertIn("--cap", words)

    def test_debris_is_cancelled_where_it_is_in_the_way(self):
        # A can without its lid, with a fin of no thickness: an edge of the wall has four faces.
        self.succeeds("make", "cylinder", "--parts", "150", "-o", "can.off")
        points, faces = read_off(self.folder / "can.off")
        wall = next(f for f in faces if len(f) == 4)
        tip = tuple(sum(1.001 * points[c][k] for c in wall[:2]) / 2 for k in range(2)) + (0.05,)
        fin = [wall[0], wall[1], len(points)]
        surface = self.facts("can.off")["surface"]
        for name, kept in [("can.off", faces), ("open.off", [f for f in faces if f is not faces[-1]])]:
            self.surface(name, points + [tip], kept + [fin, fin[::-1]])
            words = self.repairs(name)[0]
            self.assertEqual("--cap" in words, name == "open.off")
            self.assertIn("--cancel-opposite", words)
            self.expect_cure(words, surface["area"], surface["volume"])

    def test_welds_that_leave_openings_in_planes_only(self):
        # Two tubes of four walls each; a wall of one of them stands a rounding apart: welded,
        # 4 of 20 open edges close, and the others are four plane openings.
        points = BOX_POINTS + [(3 + x, y, z) for x, y, z in BOX_POINTS]
        walls = BOX_FACES[1:5] + [tuple(8 + i for i in f) for f in BOX_FACES[1:5]]
        loose = [tuple(c + 3e-7 for c in points[i]) for i in walls[0]]
        self.surface("tubes.off", points + loose, [tuple(range(16, 20))] + walls[1:])
        words = self.repairs("tubes.off")[0]
        self.assertIn("--weld", words)
        self.assertEqual(words.count("--cap"), 2)
        self.expect_cure(words, 12, 2)

    def test_sound_surfaces_need_nothing(self):
        self.surface("box.off", BOX_POINTS, BOX_FACES)
        self.assertEqual(self.repairs("box.off"), [])
        self.assertIn("Defects: none", self.succeeds("info", "box.off"))

    def test_commands_can_be_pasted(self):
        self.surface("a box's.off", BOX_POINTS, OPEN_BOX_FACES)
        words = self.repairs("a box's.off", "--scale", "0.5", "--translate", "-1,0,0", "--rotate", "90,x")[0]
        self.assertEqual(words[1], "a box's.off")
        self.expect_cure(words, 6 / 4, 1 / 8)
        points, _ = read_off(self.folder / "a box's-repaired.off")
        self.assertEqual(min(p[0] for p in points), -1)


    def test_names_like_options(self):
        self.surface("-box.off", BOX_POINTS, OPEN_BOX_FACES)
        text = self.succeeds("info", "--", "-box.off")
        command = shlex.split(re.search("cutwater (repair .*)", text)[1])
        self.assertEqual(command[1], "./-box.off")
        self.succeeds(*command)
        self.assertIn("Defects: none", self.succeeds("info", "./-box-repaired.off"))
        self.assertIn("cutwater sample ./-box.off", self.succeeds("repair", "./-box-repaired.off", "-o", "-box.off"))

    def test_a_pipe_is_not_read_again(self):
        (self.folder / "open.off").write_text(off(BOX_POINTS, OPEN_BOX_FACES))
        with open(self.folder / "open.off", encoding="ascii") as file:
            done = subprocess.run([PROGRAM, "info", "/dev/stdin"], stdin=file, capture_output=True, text=True,
                                  check=True)
        self.assertIn("cutwater repair FILE -o FILE-repaired.off --cap z=1\n", done.stdout)
        self.assertIn("cutwater sample FILE -o", done.stdout)

    def test_lengths_have_few_digits(self):
        # Scaled, a thirtieth of the diagonal is nearly 0.3, and 3 * 0.1 is 0.30000000000000004.
        points = [(0, 0, 0), (5, 0.5, 1), (1, 5, 1.5), (-5, 1, -0.5), (-0.5, -1.5, -5)]
        self.surface("scraps.off", points, [(0, 1, 2), (0, 3, 4)])
        for words in self.repairs("scraps.off", "--scale", "0.66"):
            for option in "--wrap", "--holes", "--weld":
                if option in words:
                    self.assertLess(len(words[words.index(option) + 1]), 6, words)


class Json(InfoTest):
    def expect_the_same(self, file):
        """The figures of the page, one by one."""
        text, facts = self.succeeds("info", file, "--float"), self.facts(file, "--float")
        surface, check = facts["surface"], facts["check"]
        plain = re.sub(r"(?<=\d) (?=\d)", "", text)  # digits are not grouped
        self.assertEqual(int(re.match(r"\d+", self.value(plain, "polygons"))[0]), surface["polygons"])
        told = re.fullmatch(r"(\d+) \((\d+) in the file, (\d+) merged with equal ones\)",
                            self.value(plain, "points"))
        self.assertEqual([int(n) for n in told.groups()],
                         [surface[key] for key in ("points", "pointsInFile", "pointsMerged")])
        box = [float(n) for n in re.findall(r"[-\d.e]+", self.value(text, "bounding box"))]
        for page, exact in zip(box, surface["boundingBox"]["lower"] + surface["boundingBox"]["upper"]):
            self.assertAlmostEqual(page, exact, delta=1e-5 * abs(exact))
        self.assertAlmostEqual(float(self.value(text, "area")), surface["area"], delta=1e-5 * surface["area"])
        self.assertEqual(self.value(text, "volume").startswith("not computed"), surface["volume"] is None)
        self.assertEqual(self.value(text, "watertight"), "yes" if check["watertight"] else "no")
        self.assertEqual(self.value(text, "in short"), check["summary"])
        self.assertEqual(self.value(text, "verdict"), check["verdict"])
        self.assertEqual(self.value(text, "distances"), facts["signedDistance"]["distances"])
        self.assertIn(facts["signedDistance"]["signs"]["summary"], text)
        shown = re.findall(r"^  (error|warning|note) +(\d+)  (.*)$", plain, re.MULTILINE)
        self.assertEqual(shown, [(d["severity"], str(d["count"]), d["name"]) for d in facts["defects"]])
        one_line = re.sub(r"\s+", " ", text)
        for defect, advice in itertools.zip_longest(facts["defects"], facts["next"]):
            self.assertIn(re.sub(r"\s+", " ", defect["meaning"]) if defect else "", one_line)
            self.assertIn(advice["command"] + "\n" if advice else "", text)
        self.assertEqual(f"Openings: {len(facts['openings'])}," in text, bool(facts["openings"]))
        for memory in "memory", "memoryInFloat":
            use = facts["signedDistance"][memory]
            self.assertGreater(facts["peakResidentBytes"], use["bytes"])
            self.assertIn(f"{use['bytesPerTriangle']} bytes per triangle", text)

    def test_says_what_the_page_says(self):
        self.succeeds("make", "sphere", "--parts", 160, "-o", "s.stl")
        self.surface("open.off", BOX_POINTS, OPEN_BOX_FACES)
        self.surface("torn.off", [(3.1 * x, y, 0.7 * z) for x, y, z in BOX_POINTS],
                     BOX_FACES[1:] + [(0, 1, 6), (0, 0, 3)])
        for file in "s.stl", "open.off", "torn.off":
            with self.subTest(file=file):
                self.expect_the_same(file)

    def test_numbers_have_all_their_digits(self):
        third = 1 / 3
        self.surface("box.off", [(third * x, y, z) for x, y, z in BOX_POINTS], BOX_FACES)
        self.assertEqual(self.facts("box.off")["surface"]["boundingBox"]["upper"], [third, 1, 1])

    def test_names_that_are_no_text(self):
        (self.folder / "odd.obj").write_bytes(
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng \xff\"\\a\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        patch, = self.facts("odd.obj")["patches"]
        self.assertEqual(patch, {"name": '\ufffd"\\a', "polygons": 4})

    def test_prepared_files(self):
        self.surface("box.off", BOX_POINTS, BOX_FACES)
        self.succeeds("prepare", "box.off", "-o", "box.cutwater")
        file = self.facts("box.cutwater")["file"]
        self.assertEqual(file["format"], "prepared, double precision")
        self.assertRegex(file["preparedFromXxh64"], r"\A[0-9a-f]{16}\Z")

    def test_errors_go_to_stderr(self):
        self.assertIn("missing.stl", self.fails(1, "info", "missing.stl", "--json"))


class Memory(CommandTest):
    def expect_little(self, file):
        text = self.succeeds("info", file, "--float")
        for name, most in [("memory", 150), ("memory in float", 110)]:
            line = re.search(rf"^  {name}  +(.*)$", text, re.MULTILINE)[1]
            told = re.fullmatch(r"\S+ [kMG]B, (\d+) bytes per triangle", line)
            self.assertTrue(told, line)
            self.assertGreater(int(told[1]), 60, line)  # corners, neighbours and packets alone
            self.assertLessEqual(int(told[1]), most, line)
        self.assertRegex(text, r"\nMemory of this program\n  peak, resident  +\S+ [kMG]B for all of the above together\n$")
        self.expect_true_peak(file)

    def expect_true_peak(self, file):
        """The program cannot know less of its memory than the system does: within a few pages at its end."""
        process = subprocess.Popen([PROGRAM, "info", file, "--float", "--json"], cwd=self.folder,
                                   stdout=subprocess.PIPE)
        told = json.load(process.stdout)["peakResidentBytes"]
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        process.stdout.close()
        self.assertEqual(process.returncode, 0)
        self.assertLessEqual(told, 1024 * usage.ru_maxrss)
        self.assertGreater(told, 0.8 * 1024 * usage.ru_maxrss)

    def test_of_quads(self):
        self.succeeds("make", "torus", "--parts", 200, "-o", "torus.off")
        self.expect_little("torus.off")

    def test_of_a_real_hull(self):
        hull = os.environ.get("CUTWATER_HULL", "")
        if not pathlib.Path(hull).is_file():
            self.skipTest("openfoam-examples is not installed")
        self.expect_little(hull)


if __name__ == "__main__":
    unittest.main()
