"""Runs the command as people and scripts do. Usage: check_command.py PROGRAM [group]"""
import contextlib
import math
import os
import pty
import re
import resource
import signal
import subprocess
import time
import unittest

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    vtkXMLUnstructuredGridReader = None  # what it would show is shown by our own reader, too

from command import BOX_POINTS, OPEN_BOX, OPEN_BOX_FACES, PROGRAM, CommandTest
from readers import Png, Vti, Vtu, bounds, read_off

SUBCOMMANDS = ["info", "repair", "sample", "query", "amr", "slice", "render", "isosurface", "convert", "prepare",
               "make", "scene"]


def box_distance(p, half):
    """Signed distance from a box about the origin."""
    q = [abs(c) - h for c, h in zip(p, half)]
    return math.hypot(*(max(c, 0) for c in q)) + min(max(q), 0)


def number(value):
    """As the command writes it."""
    return f"{value:g}"


class Usage(CommandTest):
    def test_help_shows_examples(self):
        text = self.succeeds("--help")
        for name in SUBCOMMANDS:
            self.assertIn(name, text)
            help_text = self.succeeds(name, "--help")
            self.assertRegex(help_text, rf"Examples:\n +cutwater {name} ")
        self.assertIn("Exit status", text)

    def test_version(self):
        self.assertRegex(self.succeeds("--version"), r"\Acutwater \d+\.\d+\.\d+\n\Z")

    def test_wrong_usage_is_status_2(self):
        self.fails(2)
        self.fails(2, "info")
        self.fails(2, "info", "a.stl", "b.stl")
        self.fails(2, "info", "a.stl", "--no-such-option")
        self.fails(2, "sample", "a.stl")
        self.assertIn("--output", self.fails(2, "slice", "a.stl"))

    def test_pictures_are_png(self):
        for option, *command in [("--output", "slice", "a.stl", "-o"), ("--output", "render", "a.stl", "-o"),
                                 ("--picture", "amr", "a.stl", "-o", "a.vtu", "--level", "1", "--picture")]:
            self.assertIn(f"{option}: 'a.jpg': need a name that ends in .png", self.fails(2, *command, "a.jpg"))
            self.assertIn("a.stl", self.fails(1, *command, "a.PNG"))  # is looked for

    def test_wrong_values_name_the_option(self):
        for option, value in [("--cells", "0"), ("--cells", "3x4"), ("--cells", "1e3"), ("--cells", "-5"),
                              ("--spacing", "0"), ("--spacing", "1,2"), ("--spacing", "nan"), ("--band", "0"),
                              ("--box", "0,0,0,1,1"), ("--box", "0,0,0,1,1,0"), ("--margin", "-1"),
                              ("--write", "colour"), ("--threads", "-1"), ("--scale", "0"), ("--scale", "1,5"),
                              ("--translate", "1,2"), ("--translate", "1;2;3"), ("--rotate", "90"),
                              ("--rotate", "90,w"), ("--rotate", "x,90"), ("--rotate", "90,0,0,0"),
                              ("--total", "inf")]:
            with self.subTest(option=option, value=value):
                self.assertIn(option, self.fails(2, "sample", "a.stl", "-o", "a.vti", option, value))
        for option, value in [("--axis", "w"), ("--at", "here"), ("--size", "100x100"), ("--size", "800"),
                              ("--window", "0,0,0,1")]:
            with self.subTest(option=option, value=value):
                self.assertIn(option, self.fails(2, "slice", "a.stl", "-o", "a.png", option, value))
        for option, value in [("--view", "up"), ("--view", "30,91"), ("--view", "1,2,3"), ("--size", "300x300"),
                              ("--cut", "z"), ("--cut", "w=1"), ("--cut", "z=1:left"), ("--cut", "z="),
                              ("--color", "mauve"), ("--show", "0,0,0,1,1,0"), ("--perspective", "180")]:
            with self.subTest(option=option, value=value):
                self.assertIn(option, self.fails(2, "render", "a.stl", "-o", "a.png", option, value))
        self.fails(2, "sample", "a.stl", "-o", "a.vti", "--cells", "9", "--spacing", "1")
        for option, value in [("--level", "-1"), ("--level", "x"), ("--band", "1"), ("--band", "1:"),
                              ("--band", ":1"), ("--band", "1:-1"), ("--band=-1:2", ""), ("--band", "1:2:3"),
                              ("--patch", "hull"), ("--patch", ":3"), ("--patch", "hull:x"), ("--curvature", "20"),
                              ("--curvature", "0:3"), ("--edges", "180:3"), ("--edges", "x:3"), ("--gaps", "3"),
                              ("--gaps", "0:3"), ("--walls=-1:3", ""), ("--walls", "3:100"),
                              ("--roots", "0"), ("--roots", "2x2x2"), ("--balance", "vertex"), ("--write", "colour")]:
            with self.subTest(option=option, value=value):
                level = [] if option == "--level" else ["--level", "1"]
                given = [option, value] if value else [option]
                self.assertIn(option.split("=")[0], self.fails(2, "amr", "a.stl", "-o", "a.vtu", *level, *given))
        self.assertIn("--level", self.fails(2, "amr", "a.stl", "-o", "a.vtu"))

    def test_wrong_values_are_told_what_is_needed(self):
        for need, command in [
                ("one of auto, nearest, winding", "sample a.stl -o a.vti --signs foo"),
                ("one of none, face, edge, corner", "amr a.stl --level 1 -o a.vtu --balance foo"),
                ("one of as-they-are, cavities, solids", "repair a.stl -o b.stl --nested foo"),
                ("one whole number above 0", "amr a.stl --level 1 -o a.vtu --roots 0"),
                ("one whole number above 0", "amr a.stl --level 1 -o a.vtu --roots 2x3x4"),
                ("a distance and a level: 0.5:4", "amr a.stl --level 1 -o a.vtu --band 0.1:3:4"),
                ("a number above 0", "info a.stl --scale abc"),
                ("a number above 0", "make torus -o a.stl --major nan"),

                ("degrees and an axis, x, y or z", "info a.stl --rotate 90,w"),
                ("a plane: AXIS=VALUE as in z=0, or a point", "repair a.stl -o b.stl --cap z"),
                ("degrees above 0 and below 180", "isosurface a.stl -o b.stl --edges 200"),
                ("WIDTHxHEIGHT from 320x240, up to 32768 along a side and 2^26 pixels in all", "render a.stl -o a.png --size 32768x32768")]:
            words = command.split()
            with self.subTest(command=command):
                self.assertIn(f"{words[-2]}: '{words[-1]}': need {need}", self.fails(2, *words))

    def test_outputs_have_the_names_of_their_kind(self):
        self.box()
        for command, name, need in [
                ("sample", "a.vtk", ".vti"), ("sample", "a", ".vti"), ("sample", "-", ".vti"),
                ("amr --level 1", "a.png", ".vtu"), ("amr --level 1 -o a.vtu --picture", "a.vtu", ".png"),
                ("isosurface", "a.step", ".stl, .obj, .ply, .off, .vtk"),
                ("prepare", "a.stl", "FILE.cutwater"), ("prepare", "-", "FILE.cutwater")]:
            words = command.split() if "-o" in command else [*command.split(), "-o"]
            with self.subTest(command=command):
                self.assertRegex(self.fails(2, *words, name, "box.off"), f"'{name}': need a name .*{re.escape(need)}\n")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["box.off"])
        self.succeeds("sample", "box.off", "-o", "a.VTI", "--cells", "4")
        self.succeeds("prepare", "box.off", "-o", "a.geometry")
        self.assertIn("ImageData", self.succeeds("sample", "box.off", "-q", "-o", "/dev/stdout", "--cells", "1",
                                                 "--write", "patch"))

    def test_folders_are_looked_for_before_the_work(self):
        for command in [("sample", "-o", "no/a.vti"), ("isosurface", "-o", "no/a.stl"),
                        ("prepare", "-o", "no/a.cutwater"), ("amr", "--level", "1", "-o", "no/a.vtu"),
                        ("amr", "--level", "1", "-o", "a.vtu", "--picture", "no/a.png")]:
            self.assertIn(f"{command[-1]}: there is no folder no\n", self.fails(1, *command, "missing.stl"))

    def test_names_a_command_that_there_is_not(self):
        self.assertIn('there is no command "inf"; is it "info"?', self.fails(2, "inf", "a.stl"))
        self.assertIn('there is no command "frobnicate"\n', self.fails(2, "frobnicate"))
        self.assertIn('there is no command "inf"; is it "info"?', self.fails(2, "inf", "--help"))
        self.assertIn('there is no command "frobnicate"\n', self.fails(2, "frobnicate", "-h"))
        self.assertIn('there is no command "wrap"; is it "repair"?', self.fails(2, "wrap", "a.stl"))
        self.assertIn('there is no command "help"; is it "--help"?', self.fails(2, "help"))
        self.assertIn('there is no command "help"; is it "--help"?', self.fails(2, "help", "info"))
        self.assertIn('there is no command "foo"\n', self.fails(2, "foo", "info", "a.stl"))

    def test_a_message_is_one_line_whatever_a_name_holds(self):
        self.assertIn("no\\nfile\\033[1m.stl: cannot open", self.fails(1, "info", "no\nfile\033[1m.stl"))

    def test_names_an_option_that_there_is_not(self):
        for command, near in [
                ("amr a.stl --levle 3 -o a.vtu", '"--levle"; is it "--level"?'),
                ("sample a.stl --cell=3 -o a.vti", '"--cell"; is it "--cells"?'),
                ("info a.stl --jason", '"--jason"; is it "--json"?'),
                ("info a.stl --out b", '"--out"\n'),
                ("query a.stl p.csv --out q.csv", '"--out"; is it "--output"?'),
                ("make torus --diameter 3 -o a.stl", '"--diameter"\n')]:
            words = command.split()
            self.assertIn(f"cutwater: error: {words[0]} has no option {near}", self.fails(2, *words))
        self.assertIn('error: cutwater has no option "--verison"; is it "--version"?', self.fails(2, "--verison"))
        self.assertIn('error: cutwater has no option "--quite"\n', self.fails(2, "--quite", "info", "a.stl"))
        self.assertIn("not expected: b.stl", self.fails(2, "info", "a.stl", "b.stl"))

    def test_keys_of_scenes_by_a_word(self):
        self.assertIn("### Every solid", self.succeeds("scene", "--keys"))
        text = self.succeeds("scene", "--keys", "torus")
        self.assertIn('#### `shape = "torus"`', text)
        self.assertNotIn('shape = "sphere"', text)
        self.assertIn("--keys: nothing in a scene is called 'teapot'", self.fails(2, "scene", "--keys", "teapot"))
        self.assertIn("Usage: cutwater scene", self.succeeds("scene"))

    def test_standard_input_has_a_name(self):
        self.assertIn("/dev/stdin", self.fails(2, "info", "-"))


class Make(CommandTest):
    def test_all_shapes_are_closed(self):
        for shape in ["sphere", "ellipsoid", "cuboid", "torus", "cylinder", "cone", "capsule"]:
            for extension in ["stl", "ply", "obj", "off"]:
                name = f"{shape}.{extension}"
                self.succeeds("make", shape, "-o", name, *([] if shape == "cuboid" else ["--parts", 12]))
                self.assertRegex(self.succeeds("info", name), r"watertight +yes", name)

    def test_sizes(self):
        self.succeeds("make", "torus", "--major", 3, "--minor", 0.5, "--parts", 64, "-o", "t.off")
        points, _ = read_off(self.folder / "t.off")
        self.assertEqual(bounds(points), (-3.5, -3.5, -0.5, 3.5, 3.5, 0.5))
        self.succeeds("make", "cylinder", "--radius", 2, "--height", 7, "-o", "c.off")
        points, _ = read_off(self.folder / "c.off")
        self.assertEqual(bounds(points), (-2, -2, 0, 2, 2, 7))
        self.succeeds("make", "ellipsoid", "--size", "2,4,8", "-o", "e.off")
        points, _ = read_off(self.folder / "e.off")
        for point in points:
            self.assertAlmostEqual(point[0] ** 2 + (point[1] / 2) ** 2 + (point[2] / 4) ** 2, 1)

    def test_refusals(self):
        self.assertIn("SHAPE: 'box': need one of capsule, cone, cuboid, ", self.fails(2, "make", "box", "-o", "a.stl"))
        for word, shape in [("box", "cuboid"), ("cube", "cuboid"), ("rectangle", "cuboid"), ("ball", "sphere"),
                            ("ring", "torus"), ("rod", "cylinder"), ("pill", "capsule"), ("egg", "ellipsoid"),
                            ("toruz", "torus"), ("cyl", "cylinder")]:
            self.assertTrue(self.fails(2, "make", word, "-o", "a.stl").endswith(f'sphere, torus; is it "{shape}"?\n'), word)
        self.assertTrue(self.fails(2, "make", "teapot", "-o", "a.stl").endswith("sphere, torus\n"))
        for shape, option, value in [("torus", "--minor", "2"), ("ellipsoid", "--size", "1,0,1")]:
            self.assertIn(option, self.fails(2, "make", shape, option, value, "-o", "a.stl"))
        for shape, option in [("sphere", "--minor"), ("sphere", "--height"), ("ellipsoid", "--radius"),
                              ("cuboid", "--parts"), ("cuboid", "--radius"), ("torus", "--height"),
                              ("torus", "--radius"), ("cone", "--minor")]:
            why = self.fails(2, "make", shape, option, "3", "-o", "a.stl")
            self.assertRegex(why, rf"{option}: an? {shape} has no such option")
        self.fails(2, "make", "cuboid", "-o", "a.xyz")
        for shape, triangles in [("sphere", "21 474 836 480"), ("torus", "10 000 000 000"),
                                 ("capsule", "10 000 000 000")]:
            why = self.fails(2, "make", shape, "--parts", "100000", "-o", "a.stl")
            self.assertRegex(why, f"--parts: .* {triangles} triangles")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_says_what_it_made(self):
        self.assertEqual(self.succeeds("make", "ellipsoid", "--parts", "5", "-o", "a.ply"),
                         "wrote a.ply: an ellipsoid of 20 polygons\n")
        self.assertEqual(self.succeeds("make", "cylinder", "--parts", "100000", "-o", "a.ply"),
                         "wrote a.ply: a cylinder of 100 002 polygons\n")


class Motions(CommandTest):
    def moved(self, *motions):
        self.box("long.off", "2,1,1")
        self.succeeds("convert", "long.off", "moved.off", *motions)
        return bounds(read_off(self.folder / "moved.off")[0])

    def test_act_in_the_order_given(self):
        self.assertEqual(self.moved("--translate", "1,0,0", "--rotate", "90,z"), (-0.5, 0, -0.5, 0.5, 2, 0.5))
        self.assertEqual(self.moved("--rotate", "90,z", "--translate", "1,0,0"), (0.5, -1, -0.5, 1.5, 1, 0.5))

    def test_may_be_repeated(self):
        self.assertEqual(self.moved("--translate", "1,0,0", "--rotate", "90,z", "--translate=0,0,3",
                                    "--rotate", "90,x"), (-0.5, -3.5, 0, 0.5, -2.5, 2))

    def test_scale_comes_first_wherever_it_stands(self):
        for motions in [("--scale", "0.5", "--translate", "1,2,3"), ("--translate", "1,2,3", "--scale", "0.5")]:
            self.assertEqual(self.moved(*motions), (0.5, 1.75, 2.75, 1.5, 2.25, 3.25))

    def test_take_negative_numbers_and_any_axis(self):
        self.assertEqual(self.moved("--translate", "-1,-2,-3"), (-2, -2.5, -3.5, 0, -1.5, -2.5))
        self.assertEqual(self.moved("--rotate", "-90,z"), self.moved("--rotate", "90,0,0,-2"))
        self.assertEqual(self.moved("--rotate", "120,1,1,1"), (-0.5, -1, -0.5, 0.5, 1, 0.5))


class Sample(CommandTest):
    def sampled(self, *options, surface="box.off"):
        self.succeeds("sample", surface, "-o", "out.vti", "--quiet", *options)
        return Vti(self.folder / "out.vti")

    def setUp(self):
        super().setUp()
        self.box()

    def test_cells_and_nodes_hold_the_distance(self):
        for options, extent in [((), [0, 8, 0, 8, 0, 8]), (("--nodes",), [0, 8, 0, 8, 0, 8])]:
            image = self.sampled("--box", "-2,-2,-2,2,2,2", "--cells", "8", *options)
            self.assertEqual(image.cells, not options)
            self.assertEqual((image.extent, image.origin, image.spacing), (extent, [-2] * 3, [0.5] * 3))
            values, positions = image.arrays["distance"], image.positions()
            self.assertEqual(len(values), len(positions))
            for value, p in zip(values, positions):
                self.assertAlmostEqual(value, box_distance(p, (1, 1, 1)), delta=1e-14)

    def test_grid_sizes(self):
        image = self.sampled("--box", "0,0,0,4,2,1", "--cells", "10x8x2")
        self.assertEqual((image.extent, image.spacing), ([0, 10, 0, 8, 0, 2], [0.4, 0.25, 0.5]))
        image = self.sampled("--box", "0,0,0,4,2,1", "--cells", "6")
        self.assertEqual(image.extent, [0, 6, 0, 3, 0, 2])  # 1 / (4 / 6) = 1.5 cells, grown to 2
        self.assertAlmostEqual(image.origin[2], 0.5 - 4 / 6)
        image = self.sampled("--spacing", "0.5", "--margin", "1")
        self.assertEqual((image.extent, image.origin), ([0, 8, 0, 8, 0, 8], [-2, -2, -2]))
        image = self.sampled("--spacing", "0.5,1,2", "--margin", "1")
        self.assertEqual((image.extent, image.spacing), ([0, 8, 0, 4, 0, 2], [0.5, 1, 2]))
        image = self.sampled("--total", "5000")
        self.assertAlmostEqual(len(image.arrays["distance"]), 5000, delta=1000)
        image = self.sampled("--cells", "20")
        self.assertAlmostEqual(image.origin[0], -1 - 0.2 * math.sqrt(3))  # a tenth of 2 sqrt(3)

    def test_band(self):
        image = self.sampled("--spacing", "0.25", "--margin", "1", "--band", "2")
        told = [box_distance(p, (1, 1, 1)) for p in image.positions()]
        for value, exact in zip(image.arrays["distance"], told):
            if abs(exact) <= 0.5:
                self.assertAlmostEqual(value, exact, delta=1e-14)
            else:
                self.assertEqual(value, math.copysign(0.5, exact))

    def test_patches_end_with_the_band(self):
        image = self.sampled("--spacing", "0.5", "--margin", "2", "--band", "1", "--write", "distance,patch")
        for distance, patch in zip(image.arrays["distance"], image.arrays["patch"]):
            self.assertEqual(patch, 0 if abs(distance) < 0.5 else -1)

    def test_classes_of_cells(self):
        image = self.sampled("--spacing", "0.3", "--margin", "1", "--write", "distance,class")
        kinds = list(image.arrays["class"])
        self.assertEqual(set(kinds), {0, 1, 2})
        for distance, kind in zip(image.arrays["distance"], kinds):
            self.assertIn(kind, {0, 2} if distance < 0 else {1, 2})

    def test_values_beyond_memory_are_counted_first(self):
        self.assertRegex(self.fails(1, "sample", "box.off", "-o", "a.vti", "--cells", "9000", "--write", "distance,patch"),
                         r"would take 729 000 000 000 cells, 8.75 TB of memory; three quarters of the memory here are [0-9.]+ [GT]B")

    def test_patches(self):
        (self.folder / "two.obj").write_text(
            "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\ng base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        image = self.sampled("--box", "0.5,0.5,-1,1.5,1.5,0", "--cells", "4", "--write", "patch,distance",
                             surface="two.obj")
        self.assertEqual(list(image.arrays), ["patch", "distance"])
        self.assertEqual(set(image.arrays["patch"]), {0})  # below the base
        self.assertEqual(image.patch_names(), ["base", "sides"])
        self.assertEqual(self.sampled("--cells", "4", surface="two.obj").patch_names(), [])
        image = self.sampled("--box", "-1,1,1,0,2,2", "--cells", "4", "--write", "patch", surface="two.obj")
        self.assertEqual(list(image.arrays), ["patch"])
        self.assertEqual(set(image.arrays["patch"]), {1})

    def test_the_same_bytes_for_any_number_of_threads(self):
        contents = set()
        for threads in [1, 2, 3]:
            self.sampled("--cells", "20", "--threads", threads)
            contents.add((self.folder / "out.vti").read_bytes())
        self.assertEqual(len(contents), 1)

    def test_says_what_it_did(self):
        text = self.succeeds("sample", "box.off", "-o", "out.vti", "--box", "-2,-2,-2,2,2,2", "--cells", "40")
        self.assertIn("40 x 40 x 40 = 64 000 cells of 0.1 x 0.1 x 0.1", text)
        self.assertIn("inside: 8 000 cells", text)
        self.assertEqual(self.succeeds("sample", "box.off", "-o", "out.vti", "--quiet"), "")


class Amr(CommandTest):
    AROUND = ("--box", "-2,-2,-2,2,2,2", "--roots", "4")

    def meshed(self, *options):
        self.succeeds("amr", *options, "box.off", "-o", "out.vtu", "--quiet")
        return Vtu(self.folder / "out.vtu")

    def setUp(self):
        super().setUp()
        self.box(size="2.1,2.1,2.1")  # its sides are between those of the cells

    def test_cells_fill_the_box_and_know_where_they_are(self):
        mesh = self.meshed(*self.AROUND, "--level", "3", "--write", "distance,normal,patch,class,level")
        self.assertEqual(list(mesh.arrays), ["distance", "normal", "patch", "class", "level"])
        self.assertEqual(sum(math.prod(h - l for l, h in zip(*box)) for box in mesh.boxes), 64)
        self.assertEqual(set(mesh.arrays["patch"]), {0})
        half = 1.05
        for n, (low, high) in enumerate(mesh.boxes):
            center = [(l + h) / 2 for l, h in zip(low, high)]
            level = mesh.arrays["level"][n]
            self.assertEqual(high[0] - low[0], 2.0 ** -level)
            self.assertAlmostEqual(mesh.arrays["distance"][n], box_distance(center, (half,) * 3), delta=1e-14)
            self.assertAlmostEqual(math.hypot(*mesh.arrays["normal"][n]), 1)
            if all(-half < l and h < half for l, h in zip(low, high)):
                kind = 0
            elif any(h < -half or l > half for l, h in zip(low, high)):
                kind = 1
            else:
                kind = 2
                self.assertEqual(level, 3)
            self.assertEqual(mesh.arrays["class"][n], kind)
        self.assertEqual(mesh.arrays["class"].count(2), 18 ** 3 - 16 ** 3)  # the outermost of -9/8 .. 9/8

    def test_bands(self):
        mesh = self.meshed(*self.AROUND, "--level", "3", "--band", "0.2:4", "--band", "0.5:2")
        self.assertEqual(list(mesh.arrays), ["distance", "class", "level"])
        for n, (low, high) in enumerate(mesh.boxes):
            distance, reach = abs(mesh.arrays["distance"][n]), math.dist(low, high) / 2
            if mesh.arrays["level"][n] < 4:
                self.assertGreater(distance, 0.2)
            if mesh.arrays["level"][n] < 2:
                self.assertGreater(distance, 0.5)
            if mesh.arrays["level"][n] == 4:
                self.assertLess(distance, 0.2 + 4 * reach)  # its parent is near, or it is next to such

    def two_patches(self):
        """A tetrahedron whose faces in the planes x, y, z = 0.01 are the patch base; the other is sides."""
        (self.folder / "two.obj").write_text(
            "v 0.01 0.01 0.01\nv 4.01 0.01 0.01\nv 0.01 4.01 0.01\nv 0.01 0.01 4.01\n"
            "g base\nf 1 3 2\nf 1 2 4\nf 1 4 3\ng sides\nf 2 3 4\n")
        return ("amr", "two.obj", "-o", "out.vtu", "--box", "-1,-1,-1,7,7,7", "--roots", "8", "--balance", "none")

    def test_patches(self):
        self.succeeds(*self.two_patches(), "--level", "1", "--patch", "base:3", "--write", "level,patches", "--quiet")
        mesh = Vtu(self.folder / "out.vtu")
        self.assertEqual(mesh.patch_names(), ["base", "sides"])
        counts = [0] * 4
        for (low, high), level, patches in zip(mesh.boxes, mesh.arrays["level"], mesh.arrays["patches"]):
            expected = 0
            for axis in range(3):
                others = [max(low[a], 0.01) for a in range(3) if a != axis]
                if (low[axis] <= 0.01 <= high[axis] and min(high) >= 0.01 and sum(others) <= 4.02):
                    expected = 1
            if min(high) >= 0.01 and sum(max(l, 0.01) for l in low) <= 4.03 <= sum(high):
                expected |= 2
            self.assertEqual(patches, expected)
            self.assertEqual(level, 3 if patches & 1 else level)
            self.assertLessEqual(level, 1 if patches == 2 and low[0] >= 1 and low[1] >= 1 and low[2] >= 1 else 3)
            counts[expected] += 1
        self.assertGreater(min(counts), 10)
        self.assertIn("no patch is called 'hull'; there are: base, sides",
                      self.fails(1, *self.two_patches(), "--level", "1", "--patch", "hull:3"))

    def test_rules_about_the_surface_in_a_cell(self):
        self.box("plate.off", "2.1,2.1,0.1")

        def levels(surface, *options):
            self.succeeds("amr", surface, "-o", "out.vtu", *self.AROUND, "--level", "2", "--balance", "none",
                          *options, "--quiet")
            mesh = Vtu(self.folder / "out.vtu")
            return list(zip(mesh.boxes, mesh.arrays["level"]))

        plain = levels("box.off")
        edges = levels("box.off", "--edges", "80:4")
        self.assertEqual(edges, levels("box.off", "--curvature", "80:4"))  # all that its normals do
        self.assertEqual(plain, levels("box.off", "--edges", "100:4"))
        for (low, high), level in edges:
            sides = sum(min(abs(l), abs(h)) <= 1.05 <= max(abs(l), abs(h)) for l, h in zip(low, high))
            outside = any(l > 1.05 or h < -1.05 for l, h in zip(low, high))
            self.assertEqual(level == 4 and not outside, sides >= 2 and not outside)
        # Sides are at -0.05 and 0.05: from [1/32, 2/32], three cells reach to -2/32, from [3/64, 4/64] to 0.
        walls = levels("plate.off", "--walls", "3:8")
        self.assertEqual(max(level for _, level in walls), 6)
        self.assertEqual(levels("plate.off", "--gaps", "3:8"), levels("plate.off"))

    def test_balance(self):
        turned = (*self.AROUND, "--rotate", "30,1,2,3", "--level", "4")
        counts = [len(self.meshed(*turned, "--balance", name).boxes) for name in ["none", "face", "edge", "corner"]]
        self.assertEqual(counts, sorted(set(counts)))
        self.assertEqual(len(self.meshed(*turned).boxes), counts[3])

    @unittest.skipIf(vtkXMLUnstructuredGridReader is None, "python3-vtk9 is not installed")
    def test_vtk_reads_it(self):
        mesh = self.meshed(*self.AROUND, "--level", "3", "--write", "distance,normal,patch,class,level")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.folder / "out.vtu"))
        reader.Update()
        grid = reader.GetOutput()
        self.assertEqual((reader.GetErrorCode(), grid.GetNumberOfCells()), (0, len(mesh.boxes)))
        for n, (low, high) in enumerate(mesh.boxes):
            x0, x1, y0, y1, z0, z1 = grid.GetCell(n).GetBounds()
            self.assertEqual(((x0, y0, z0), (x1, y1, z1)), (low, high))
        for name, values in mesh.arrays.items():
            array = grid.GetCellData().GetArray(name)
            read = [array.GetTuple(n) for n in range(len(mesh.boxes))]
            self.assertEqual(read, [v if isinstance(v, tuple) else (v,) for v in values])

    def test_the_box_follows_the_surface(self):
        mesh = self.meshed("--margin", "0.95", "--roots", "5", "--level", "0")
        self.assertEqual(len(mesh.boxes), 125)
        self.assertEqual(bounds([p for box in mesh.boxes for p in box]), (-2, -2, -2, 2, 2, 2))
        self.assertEqual(len(self.meshed("--level", "0").boxes), 16 ** 3)

    def test_the_same_bytes_for_any_number_of_threads(self):
        contents = set()
        for threads in [1, 2, 3]:
            self.meshed("--roots", "8", "--level", "3", "--threads", threads, "--write", "distance,normal,patch,class,level")
            contents.add((self.folder / "out.vtu").read_bytes())
        self.assertEqual(len(contents), 1)

    def test_says_what_it_did(self):
        text = self.succeeds("amr", "box.off", "-o", "out.vtu", *self.AROUND, "--level", "3")
        mesh = Vtu(self.folder / "out.vtu")
        self.assertIn(f"{len(mesh.boxes):,} cells".replace(",", " "), text)
        self.assertIn("roots: 4 x 4 x 4, from (-2, -2, -2) to (2, 2, 2)", text)
        for level in range(4):
            count = f"{mesh.arrays['level'].count(level):,}".replace(",", " ")
            self.assertRegex(text, rf"level +{level}: +{count} cells of {number(2.0 ** -level)}\n")
        self.assertIn("cut: 1 736, unknown: 0 cells", text)
        self.assertRegex(text, r"cells per second")
        self.assertEqual(self.succeeds("amr", "box.off", "-o", "out.vtu", "--level", "1", "--quiet"), "")

    def test_says_if_the_surface_is_elsewhere(self):
        away = ("--box", "5,5,5,6,6,6", "--level", "1")
        self.assertIn("no cell is cut", self.succeeds("amr", "box.off", "-o", "out.vtu", *away))
        self.assertNotIn("no cell is cut", self.succeeds("amr", "box.off", "-o", "out.vtu", "--level", "1"))

    def test_features(self):
        self.box("one.off", "1,1,1")
        text = self.succeeds("amr", "one.off", "-o", "out.vtu", "--features", *self.AROUND, "--level", "0",
                             "--translate", "0.5,0.5,0.5")  # it is a cell
        self.assertIn("solid 1 cells deep", text)
        self.assertIn("; as wide as its cell of level 0 already\n", text)
        self.box("plate.off", "2.1,2.1,0.1")
        text = self.succeeds("amr", "plate.off", "-o", "out.vtu", "--features", *self.AROUND, "--level", "1",
                             "--translate", "0,0,0.25")
        count = int(re.search(r"thin: .*: (\d+)", text)[1])
        self.assertEqual(len(re.findall("; level 4 resolves it\n", text)), 5)
        self.assertIn(f"    ... and {count - 5} more\n", text)

    def test_options_of_a_picture_need_one(self):
        for option, value in [("--axis", "y"), ("--at", "0"), ("--window", "0,0,1,1"), ("--size", "400x300"),
                              ("--title", "it"), ("--unit", "m")]:
            self.assertIn(f"{option} requires --picture",
                          self.fails(2, "amr", "box.off", "-o", "a.vtu", "--level", "1", option, value))

    def test_out_of_memory(self):
        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (150_000_000,) * 2)
        more = ("--max-memory", "1T")
        for command, advice in [(("amr", "-o", "a.vtu", "--level", "9", *more), "a lower --level"),
                                (("isosurface", "-o", "a.stl", "--cells", "6000", *more), "nodes; use fewer --cells"),
                                (("sample", "-o", "a.vti", "--cells", "600", *more), "values; use fewer --cells")]:
            done = subprocess.run([PROGRAM, *command, "box.off", "--threads", "1"], cwd=self.folder, text=True,
                                  capture_output=True, preexec_fn=limited, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, rf"\Acutwater: error: out of memory.*{advice}[^\n]*\n\Z")

    def test_out_of_memory_while_reading(self):
        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (150_000_000,) * 2)
        with open(self.folder / "large.stl", "wb") as large:
            large.truncate(400_000_000)
        for command in ("info",), ("amr", "-o", "a.vtu", "--level", "2"), ("repair", "-o", "a.stl"):
            done = subprocess.run([PROGRAM, command[0], "large.stl", *command[1:]], cwd=self.folder, text=True,
                                  capture_output=True, preexec_fn=limited, check=False)
            self.assertEqual((done.returncode, done.stderr),
                             (1, "cutwater: error: large.stl: out of memory while reading it\n"))

    def test_names_the_repair_of_an_open_surface_before_the_work(self):
        self.succeeds("make", "sphere", "--parts", "24", "-o", "ball.off")
        points, faces = read_off(self.folder / "ball.off")
        apart = [tuple(x + 1e-6 * math.sin(7 * n + 3 * axis) for axis, x in enumerate(points[corner]))
                 for n, face in enumerate(faces) for corner in face]
        self.surface("apart.off", apart, [(3 * n, 3 * n + 1, 3 * n + 2) for n in range(len(faces))])
        text = self.succeeds("amr", "apart.off", "-o", "out.vtu", "--level", "0")
        signs, advice, wrote = text.splitlines()[:3]
        self.assertIn("signs: winding number", signs)
        self.assertRegex(wrote, "^wrote ")
        command = re.search(r"a repair closes it: 'cutwater (repair apart.off .* --weld \S+)' \(", advice)[1]
        self.assertIn("closed then)", advice)
        self.succeeds(*command.split())
        self.assertNotIn("unbalanced", self.succeeds("amr", "repaired.ply", "-o", "out.vtu", "--level", "0"))
        self.assertNotIn("signs", self.succeeds("amr", "apart.off", "-o", "out.vtu", "--level", "0", "--quiet"))
        self.surface("open.off", BOX_POINTS, OPEN_BOX_FACES)
        self.assertIn("a repair closes it: see 'cutwater info open.off' (openings closed: 1; closed then)",
                      self.succeeds("amr", "open.off", "-o", "out.vtu", "--level", "0"))

    def test_refusals(self):
        self.assertIn("--level: '18': need a level up to 17, the finest with 16 roots",
                      self.fails(2, "amr", "box.off", "-o", "a.vtu", "--level", "18"))
        self.assertIn("--gaps: '20': need a level up to 19, the finest with 4 roots",
                      self.fails(2, "amr", "box.off", "-o", "a.vtu", *self.AROUND, "--level", "1", "--gaps", "3:20"))
        self.assertIn("no/such/a.vtu", self.fails(1, "amr", "box.off", "-o", "no/such/a.vtu", "--level", "1"))
        self.assertIn("missing.stl", self.fails(1, "amr", "missing.stl", "-o", "a.vtu", "--level", "1"))
        mesh = ("amr", "box.off", "-o", "a.vtu", *self.AROUND, "--level", "1", "--quiet")
        self.assertIn("--keep: '(9, 9, 9)': need a point within the mesh, (-2, -2, -2) to (2, 2, 2)",
                      self.fails(2, *mesh, "--keep", "9,9,9"))
        self.assertIn("--keep: '(0, 0, 0)': need a point in the fluid", self.fails(2, *mesh, "--keep", "0,0,0"))
        self.assertEqual([f.name for f in self.folder.iterdir()], ["box.off"])


class Slice(CommandTest):
    def test_shows_inside_and_outside(self):
        self.box()
        text = self.succeeds("slice", "box.off", "-o", "out.png", "--axis", "z", "--at", "0.5",
                             "--window", "-2,-2,2,2", "--size", "800x600")
        self.assertIn("z = 0.5", text)
        image = Png(self.folder / "out.png")
        self.assertEqual((image.width, image.height), (800, 600))
        colored = [(x, y) for y in range(600) for x in range(630)  # left of the colour bar
                   if abs(image.pixel(x, y)[0] - image.pixel(x, y)[2]) > 15]
        x0, x1 = min(x for x, _ in colored), max(x for x, _ in colored)
        y0, y1 = min(y for _, y in colored), max(y for _, y in colored)
        middle, side = ((x0 + x1) // 2, (y0 + y1) // 2), (x1 - x0) / 4  # the plot is 4 x 4
        red, _, blue = image.pixel(*middle)
        self.assertGreater(blue, red + 40)
        red, _, blue = image.pixel(x0 + 5, y0 + 5)
        self.assertGreater(red, blue + 40)
        outline = image.pixel(round(middle[0] - side), middle[1])
        self.assertLess(max(outline), 100)

    def test_default_title_and_plane(self):
        self.box()
        self.assertIn("y = 0", self.succeeds("slice", "box.off", "-o", "out.png"))
        self.assertEqual(self.succeeds("slice", "box.off", "-o", "a.png", "--quiet"), "")
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "out.png").read_bytes())

    def test_tells_where_there_is_no_surface(self):
        self.box()
        nothing = "the plane does not meet the surface"
        for options, told in [(("--at", "5"), nothing + "\n"), (("--at", "0.9"), None), (("--at", "1"), None),
                              (("--window", "2,2,3,3"), nothing + " in this window\n"),
                              (("--window=-0.5,-0.5,0.5,0.5",), nothing + " in this window\n"),
                              (("--window=-9,-9,9,9",), None), (("--window=0.9,0.9,9,9",), None)]:
            text = self.succeeds("slice", "box.off", "-o", "a.png", "--size", "320x240", *options)
            if told:
                self.assertTrue(text.endswith(told), (options, text))
            else:
                self.assertNotIn(nothing, text, options)


class Render(CommandTest):
    def drawn(self, *options, file="box.off"):
        """Pixels of the solid, found by having no axes and no text on the picture."""
        self.succeeds("render", file, "-o", "out.png", "--size", "400x300", "--no-axes", "--title", " ", *options)
        image = Png(self.folder / "out.png")
        self.assertEqual((image.width, image.height), (400, 300))
        pixels = {(x, y): image.pixel(x, y) for y in range(300) for x in range(400)}
        return {at: color for at, color in pixels.items() if color != (255, 255, 255)}

    def extent(self, pixels):
        return tuple(max(p[i] for p in pixels) - min(p[i] for p in pixels) + 1 for i in (0, 1))

    def test_views_show_their_sides(self):
        self.box(size="4,2,1")
        for view, ratio in [("-y", 4), ("+z", 2), ("+x", 2), ("90,0", 4)]:
            width, height = self.extent(self.drawn(f"--view={view}"))
            self.assertAlmostEqual(width / height, ratio, delta=0.05 * ratio, msg=view)

    def test_cuts_take_away_what_is_nearer(self):
        self.box(size="4,2,1")
        width, height = self.extent(self.drawn("--view=-y", "--cut", "x=1", "--cut", "z=0:upper"))
        self.assertAlmostEqual(width / height, 3 / 0.5, delta=0.2)
        # Seen from above, the plane's face is flat and yellowish; from below, keeping the rest, too.
        for view in "+z", "-z":
            pixels = self.drawn(f"--view={view}", "--cut", "z=0", "--color", "#4060ff").values()
            yellow = sum(1 for r, g, b in pixels if r > b)
            self.assertGreater(yellow, 0.9 * len(pixels))
        pixels = self.drawn("--view=+z", "--cut", "z=0:upper", "--color", "#4060ff").values()
        self.assertEqual(sum(1 for r, g, b in pixels if r > b + 40), 0)

    def test_patches_have_colours(self):
        (self.folder / "two.obj").write_text(
            "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\ng base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        colors = {}
        for view in "+x", "-z":
            pixels = self.drawn(f"--view={view}", file="two.obj")
            left = [color for (x, _), color in pixels.items() if x < 250]  # of the legend
            colors[view] = max(set(left), key=left.count)
        self.assertNotEqual(colors["+x"], colors["-z"])

    def test_surfaces_that_are_not_closed_are_shown_in_full(self):
        (self.folder / "sheet.off").write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
        self.assertIn("--solid", self.succeeds("render", "sheet.off", "-o", "a.png", "--size", "400x300"))
        self.assertGreater(len(self.drawn("--view=+z", file="sheet.off")), 20000)
        self.assertEqual(len(self.drawn("--view=+z", "--solid", file="sheet.off")), 0)
        (self.folder / "open.off").write_text(OPEN_BOX)
        both = [self.drawn(*options, file="open.off") for options in [(), ("--signs", "nearest")]]
        self.assertEqual(both[0], both[1])
        # By the nearest faces the solid has no end, and ends at the box of its faces.
        self.assertGreater(len(self.drawn("--signs", "nearest", "--solid", file="open.off")), 20000)

    def test_of_panels_on_each_other_the_one_that_looks_here_is_seen(self):
        (self.folder / "panel.obj").write_text(
            "v 0 0 0\nv 1 0.1 0.03\nv 0.2 1 0.07\nv 0.2 0.3 -1\nv 0.6 0.3 -1\nv 0.2 0.6 -1\n"
            "g blue\nf 1 3 2\ng orange\nf 1 2 3\ng open\nf 4 5 6\n")
        pixels = self.drawn("--view=+z", file="panel.obj").values()
        self.assertGreater(sum(1 for r, g, b in pixels if r > b), 0.9 * len(pixels))

    def on_a_terminal(self, *arguments):
        """What the command says if it writes to a terminal."""
        ours, terminal = pty.openpty()
        try:
            done = subprocess.run([PROGRAM, *arguments], stdout=terminal, stderr=subprocess.PIPE, cwd=self.folder)
            self.assertEqual((done.returncode, done.stderr), (0, b""))
            return os.read(ours, 4096).decode()
        finally:
            os.close(ours)
            os.close(terminal)

    def test_drafts_are_for_terminals(self):
        self.succeeds("make", "torus", "-o", "torus.stl")
        draw = lambda name, *options: ("render", "torus.stl", "--size", "400x300", "-o", name, *options)
        for quality in "draft", "final":
            self.succeeds(*draw(f"{quality}.png", "--quality", quality))
        self.succeeds(*draw("script.png"))
        told = self.on_a_terminal(*draw("terminal.png"))
        self.assertIn("a draft, as it is for a terminal; --quality final", told)
        self.assertNotIn("a draft", self.on_a_terminal(*draw("wanted.png", "--quality", "final")))
        draft, final, script, terminal, wanted = (
            (self.folder / f"{name}.png").read_bytes() for name in ("draft", "final", "script", "terminal", "wanted"))
        self.assertEqual([script, terminal, wanted], [final, draft, final])
        self.assertNotEqual(draft, final)
        one, other = Png(self.folder / "draft.png"), Png(self.folder / "final.png")
        apart = [max(abs(a - b) for a, b in zip(one.pixel(x, y), other.pixel(x, y)))
                 for y in range(300) for x in range(400)]
        self.assertLess(sum(apart) / len(apart), 1)
        self.assertLess(sum(1 for difference in apart if difference > 16), 0.005 * len(apart))
        self.assertIn("draft", self.fails(2, *draw("a.png", "--quality", "rough")))

    def test_says_what_it_wrote_and_how_long_it_took(self):
        self.box()
        text = self.succeeds("render", "box.off", "-o", "a.png", "--perspective", "40", "--unit", "m")
        self.assertRegex(text, r"\Awrote a.png: 1600 x 1000 pixels, in [\d.]+ (ms|s)\n\Z")
        self.assertEqual(self.succeeds("render", "box.off", "-o", "b.png", "--quiet", "--transparent"), "")


class Isosurface(CommandTest):
    def test_is_closed_and_where_the_surface_is(self):
        self.box()
        text = self.succeeds("isosurface", "box.off", "--cells", "30", "-o", "new.obj")
        self.assertRegex(text, r"wrote new.obj: [0-9 ]+ triangles, [0-9 ]+ points, from [0-9 ]+ nodes")
        self.assertIn("closed", self.succeeds("info", "new.obj"))
        vertices = [[float(x) for x in line.split()[1:]] for line in (self.folder / "new.obj").read_text().splitlines() if line.startswith("v ")]
        self.assertGreater(len(vertices), 1000)
        for axis in range(3):  # the sides of a cube of 2, cut off at edges by less than a cell
            self.assertAlmostEqual(min(v[axis] for v in vertices), -1, places=3)
            self.assertAlmostEqual(max(v[axis] for v in vertices), 1, places=3)

    def test_ends_with_the_box(self):
        self.box()
        self.succeeds("isosurface", "box.off", "--box", "0,-2,-2,2,2,2", "--cells", "40", "-o", "half.obj")
        self.assertIn("closed", self.succeeds("info", "half.obj"))
        self.assertIn("g end of grid", (self.folder / "half.obj").read_text())
        self.assertIn("no surface", self.fails(1, "isosurface", "box.off", "--box", "5,5,5,6,6,6", "-o", "a.stl"))

    def test_each_patch_is_one_group(self):
        self.surface("half.off", BOX_POINTS, OPEN_BOX_FACES)
        self.succeeds("repair", "half.off", "-o", "two.obj", "--cap", "z=1:top")
        self.succeeds("isosurface", "two.obj", "--cells", "12", "-o", "new.obj")
        groups = re.findall(r"^g (.*)$", (self.folder / "new.obj").read_text(), re.MULTILINE)
        self.assertEqual((len(groups), groups[-1]), (2, "top"))

    def test_tolerance_and_formats(self):
        self.box()
        for name in ["a.stl", "a.off", "a.vtk"]:
            self.assertEqual(self.succeeds("isosurface", "box.off", "--cells", "10", "-o", name, "--quiet"), "")
            self.assertIn("closed", self.succeeds("info", name))
        for wrong in "0.7", "1e-10":
            self.assertIn("--tolerance", self.fails(2, "isosurface", "box.off", "-o", "a.stl", "--tolerance", wrong))
        self.assertIn(".step", self.fails(2, "isosurface", "box.off", "--cells", "10", "-o", "a.step"))


class Convert(CommandTest):
    def test_every_format_keeps_the_surface(self):
        self.box("a.off", "2,3,4")
        for first, second in [("a.off", "b.obj"), ("b.obj", "c.ply"), ("c.ply", "d.STL"), ("d.STL", "e.off")]:
            self.succeeds("convert", first, second)
        points, faces = read_off(self.folder / "e.off")
        self.assertEqual((len(points), len(faces)), (8, 12))  # STL cut the quads in two
        self.assertEqual(bounds(points), (-1, -1.5, -2, 1, 1.5, 2))

    def test_ascii(self):
        self.box()
        self.succeeds("convert", "box.off", "text.stl", "--ascii", "--quiet")
        self.assertTrue((self.folder / "text.stl").read_text().startswith("solid"))


    def two_patches(self):
        (self.folder / "two.obj").write_text(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")

    def test_says_which_patches_are_lost(self):
        self.two_patches()
        for arguments in [("a.stl",), ("a.ply",), ("a.off",), ("a.vtk",), ("b.obj",), ("b.stl", "--ascii")]:
            wrote, *notes = self.succeeds("convert", "two.obj", *arguments).splitlines()
            kept = 2 if arguments[0].startswith("b") else 1
            self.assertEqual(wrote, f"wrote {arguments[0]}: 4 polygons, 4 points, {['1 patch', '2 patches'][kept - 1]}")
            self.assertEqual(["names of 2 patches" in note for note in notes], [] if kept == 2 else [True])
            self.assertIn(f"Patches: {kept}\n", self.succeeds("info", arguments[0]))

    def test_says_what_single_precision_costs(self):
        self.two_patches()
        far = ("--translate", "3e8,0,0")  # where numbers of single precision are 32 apart
        text = self.succeeds("convert", "two.obj", "far.stl", *far)
        self.assertIn("warning: single precision made 1 point equal to others, and 2 faces lose all area", text)
        self.assertIn(" .obj, .ply and --ascii ", text)
        for arguments in [("far.stl", "--ascii"), ("far.ply",)]:
            self.assertNotIn("warning", self.succeeds("convert", "two.obj", *arguments, *far))
        self.assertNotIn("warning", self.succeeds("convert", "two.obj", "near.stl"))
        self.assertIn("1 point equal", self.succeeds("repair", "two.obj", "-o", "far.stl", *far))
        text = self.succeeds("isosurface", "two.obj", "--cells", "9", "-o", "far.stl", *far)
        self.assertRegex(text, r"warning: single precision made \d+ points equal")
        self.assertIn("single precision", self.fails(1, "convert", "two.obj", "a.stl", "--scale", "1e39"))

    def test_says_why_nothing_is_left(self):
        self.two_patches()
        very_far = ("--translate", "3e11,3e11,0")
        for command in [("convert", "two.obj", "a.stl"), ("repair", "two.obj", "-o", "a.stl")]:
            why = self.fails(1, *command, *very_far)
            self.assertIn("a.stl: single precision, which binary STL has, makes points of every face equal", why)
            self.assertIn(" at (3e+11, 3e+11, 0.5); .obj, .ply and --ascii keep all digits, or move it to the origin: "
                          "--translate -3e+11,-3e+11,-0.5\n", why)
        self.assertFalse((self.folder / "a.stl").exists())
        self.succeeds("convert", "two.obj", "a.ply", *very_far)
        self.succeeds("convert", "a.ply", "a.stl", "--translate", "-3e+11,-3e+11,-0.5")
        small = self.fails(1, "convert", "two.obj", "b.stl", "--scale", "1e-60")
        self.assertIn("measures 1e-60 x 1e-60 x 1e-60; .obj, .ply and --ascii keep all digits\n", small)


class Prepare(CommandTest):
    def prepared(self, *options, surface="two.obj"):
        (self.folder / "two.obj").write_text(
            "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\ng base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        return self.succeeds("prepare", surface, "-o", "two.cutwater", *options)

    def sampled(self, surface, *options):
        self.succeeds("sample", surface, "-o", "out.vti", "--cells", "9", "--write", "distance,patch", "--quiet",
                      *options)
        return (self.folder / "out.vti").read_bytes()

    def test_other_commands_answer_as_from_the_surface(self):
        text = self.prepared()
        self.assertRegex(text, r"\Awrote two.cutwater: 4 triangles in double precision, [\d.]+ kB\n"
                               r"built in .*, written in .*, opened and verified in .*\n\Z")
        for options in [(), ("--signs", "winding"), ("--scale", "2"), ("--rotate", "30,z"), ("--translate", "1,2,3"),
                        ("--require-watertight",)]:
            self.assertEqual(self.sampled("two.cutwater", *options), self.sampled("two.obj", *options), options)
        pictures = set()
        for surface in ["two.obj", "two.cutwater"]:
            self.succeeds("slice", surface, "-o", "a.png", "--axis", "z", "--at", "1", "--window=-1,-1,5,5")
            picture = Png(self.folder / "a.png")
            pictures.add(tuple(picture.pixel(x, y) for x in range(200) for y in range(200, 400)))
        self.assertEqual(len(pictures), 1)

    def test_meshes_are_those_of_the_surface(self):
        self.prepared()
        for options in [(), ("--rotate", "30,z"), ("--signs", "winding")]:
            meshes, pictures = set(), set()
            for surface in ["two.obj", "two.cutwater"]:
                self.succeeds("amr", surface, "-o", "a.vtu", "--roots", "4", "--level", "3", "--keep=-0.1,0.1,0.1",
                              "--write", "distance,normal,patch,class,level", "--picture", "a.png", "--title", "two",
                              "--size", "400x300", "--quiet", *options)
                meshes.add((self.folder / "a.vtu").read_bytes())
                pictures.add((self.folder / "a.png").read_bytes())
            self.assertEqual((len(meshes), len(pictures)), (1, 1), options)

    def test_triangles_can_be_taken_out(self):
        self.prepared("--translate", "1,2,3")
        self.succeeds("convert", "two.cutwater", "out.off", "--translate=-1,-2,-3")
        points, faces = read_off(self.folder / "out.off")
        self.assertEqual(bounds(points), (0, 0, 0, 4, 4, 4))
        self.assertEqual(len(faces), 4)

    def test_info_tells_of_it(self):
        self.prepared()
        text = self.succeeds("info", "two.cutwater")
        self.assertRegex(text, r"format +prepared, double precision\n")
        self.assertRegex(text, r"File\n(.*\n)+  signs +nearest feature: closed(.*\n)+\nSurface")
        self.assertRegex(text, r"made from +a file of XXH64 [0-9a-f]{16}\n")
        self.assertRegex(text, r"Patches: 2\n +0  base +1 polygon\n +1  sides +3 polygons\n")

    def test_single_precision(self):
        self.assertIn("in single precision", self.prepared("--float"))
        self.assertIn("prepared, single precision", self.succeeds("info", "two.cutwater"))
        self.assertEqual(self.sampled("two.cutwater"), self.sampled("two.obj"))
        small = (self.folder / "two.cutwater").stat().st_size
        self.prepared()
        self.assertGreater((self.folder / "two.cutwater").stat().st_size, small)

    def test_the_same_bytes_whatever_the_threads_and_the_processor(self):
        self.succeeds("make", "torus", "--parts", 60, "-o", "t.stl")
        contents = set()
        for name, values in [("OMP_NUM_THREADS", "123"),
                             ("CUTWATER_INSTRUCTION_SET", ["portable", "baseline"])]:
            for value in values:
                done = subprocess.run([PROGRAM, "prepare", "t.stl", "-o", "t.cutwater"], cwd=self.folder, check=True,
                                      env={**os.environ, name: value}, capture_output=True)
                self.assertEqual(done.stderr, b"")
                contents.add((self.folder / "t.cutwater").read_bytes())
        self.assertEqual(len(contents), 1)

    def test_signs_are_kept(self):
        (self.folder / "open.off").write_text(OPEN_BOX)
        self.succeeds("prepare", "open.off", "-o", "open.cutwater", "--signs", "nearest")
        nearest = self.sampled("open.off", "--signs", "nearest")
        self.assertNotEqual(nearest, self.sampled("open.off"))
        self.assertEqual(nearest, self.sampled("open.cutwater"))
        self.assertIn("open.cutwater", self.fails(1, "slice", "open.cutwater", "-o", "a.png", "--require-watertight"))
        self.assertIn("open.off", self.fails(1, "prepare", "open.off", "-o", "a.cutwater", "--require-watertight"))

    def test_damaged_files(self):
        self.prepared()
        content = bytearray((self.folder / "two.cutwater").read_bytes())
        content[len(content) // 2] ^= 4
        (self.folder / "flipped.cutwater").write_bytes(content)
        (self.folder / "cut.cutwater").write_bytes(content[:1500])
        for command in [("info",), ("sample", "-o", "a.vti"), ("slice", "-o", "a.png"), ("convert", "a.stl"),
                        ("amr", "-o", "a.vtu", "--level", "1"), ("prepare", "-o", "a.cutwater")]:
            for file in ["flipped.cutwater", "cut.cutwater"]:
                why = self.fails(1, command[0], file, *command[1:])
                self.assertIn(f"{file}: the geometry file is damaged: ", why)
        self.assertFalse([f.name for f in self.folder.iterdir() if f.name.startswith("a.")])


class Limits(CommandTest):
    """What does not fit is refused before it is begun, and what does fit is named."""

    def setUp(self):
        super().setUp()
        self.box(size="2.1,2.1,2.1")

    def test_meshes(self):
        mesh = ("amr", "box.off", "-o", "a.vtu", "--roots", "4", "--box", "-2,-2,-2,2,2,2", "--max-memory", "5M", "--level")
        for finer in ("12", "18"):
            why = self.fails(1, *mesh, finer)
            said = re.search(r"this would take about [\d e+.]+ cells, \S+ [A-Z]+ of memory, (?:about|more).*; --max-memory allows 5 MB; "
                             r"--level (\d+) fits, with about ([\d ]+) cells\n", why)
            self.assertTrue(said, why)
            wrote = self.succeeds(*mesh, said[1])
            cells = int(re.search(r"a.vtu: ([\d ]+) cells", wrote)[1].replace(" ", ""))
            self.assertAlmostEqual(int(said[2].replace(" ", "")) / cells, 1, delta=0.1)
            self.fails(1, *mesh, int(said[1]) + 1)
        self.assertIn("; --max-cells allows 100; --level 0 fits, with about 64 cells\n",
                      self.fails(1, *mesh, "3", "--max-cells", "100"))
        self.assertIn("; no rule beyond level 0 fits,", self.fails(1, *mesh, "1", "--band", "1:3", "--max-cells", "100"))
        self.assertIn("; use fewer --roots\n", self.fails(1, *mesh, "1", "--max-cells", "63"))
        for wrong in ("0", "x", "5X", "G", "-1G"):
            self.assertIn("--max-memory", self.fails(2, *mesh, "1", "--max-memory", wrong))

    def test_the_memory_of_the_machine(self):
        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (160_000_000,) * 2)
        for command in [("amr", "--level", "12", "-o", "a.vtu"), ("sample", "--cells", "400", "-o", "a.vti"),
                        ("isosurface", "--cells", "4000", "-o", "a.stl")]:
            done = subprocess.run([PROGRAM, *command, "box.off", "--threads", "1"], cwd=self.folder, text=True,
                                  capture_output=True, preexec_fn=limited, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertIn("; three quarters of the memory here are 120 MB, and --max-memory allows more; --", done.stderr)
            self.assertIn(" fits", done.stderr)

    def test_grids(self):
        for command, what in [(("sample", "box.off", "-o", "a.vti", "--cells", "60"), "cells"),
                              (("isosurface", "box.off", "-o", "a.ply", "--cells", "60"), "triangles")]:
            for limit in (("--max-memory", "300k"), (f"--max-{what}", "9000")):
                why = self.fails(1, *command, *limit)
                self.assertRegex(why, rf"this would take (about )?[\d ]+ {what}, .* of memory")
                fits = re.search(r"(--spacing) (\S+) fits\n", why)
                wrote = self.succeeds(*command[:-2], *fits.groups(), *limit)
                count = int(re.search(rf"([\d ]+) {what}", wrote)[1].replace(" ", ""))
                if limit[1] == "9000":
                    self.assertLess(count, 9000 if what == "cells" else 9900)
                    self.assertGreater(count, 5000)

    def test_wraps(self):
        if "--wrap" not in self.succeeds("repair", "--help"):
            self.skipTest("built without Cutwater::Repair")
        why = self.fails(1, "repair", "box.off", "-o", "a.ply", "--wrap", "0.004", "--budget", "4")
        self.assertRegex(why, r"--wrap 0.004: this would take about [\d ]+ triangles, about .*, and there are 4 s; "
                              r"--wrap 0\.\d+ should fit, and --budget gives it more\n")

    def test_terminals_are_told(self):
        self.succeeds("make", "sphere", "--parts", "400", "-o", "ball.ply")
        for command, said in [(("amr", "box.off", "--level", "3", "-o", "a.vtu"), r"about [\d ]+ cells, .* of memory, about"),
                              (("sample", "box.off", "--cells", "9", "-o", "a.vti"), r"729 cells, 5.83 kB of memory"),
                              (("info", "ball.ply"), r"looking for self-intersections \.\.\.")]:
            main, side = pty.openpty()
            subprocess.run([PROGRAM, *command], cwd=self.folder, stderr=side, stdout=subprocess.DEVNULL, check=True)
            os.close(side)
            text = b""
            with contextlib.suppress(OSError):
                while part := os.read(main, 4096):
                    text += part
            os.close(main)
            self.assertRegex(text.decode(), said)


class Interruptions(CommandTest):
    """The program is ended while it writes a large file."""
    WORK = ("sample", "box.off", "--cells", "220", "--band", "1", "--threads", "1", "--quiet", "-o", "out.vti")

    def parts(self):
        return list(self.folder.glob(".cutwater-*.part"))

    def ended_by(self, number):
        """What it says on that signal; where the file was complete before the signal came, once more."""
        output = self.folder / "out.vti"
        before = output.read_text() if output.exists() else None
        for _ in range(20):
            program = subprocess.Popen([PROGRAM, *self.WORK], cwd=self.folder, stderr=subprocess.PIPE, text=True)
            while program.poll() is None and not any(part.stat().st_size > 0 for part in self.parts()):
                time.sleep(0.0005)
            program.send_signal(number)
            _, said = program.communicate(timeout=60)
            if program.returncode != 0:
                break
            output.unlink()
            if before is not None:
                output.write_text(before)
        self.assertEqual(program.returncode, -number)
        return said

    def setUp(self):
        super().setUp()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
            signal.signal(number, signal.SIG_DFL)  # under nohup they are ignored, and what is started inherits that
        self.box()

    def test_signals_leave_nothing(self):
        (self.folder / "out.vti").write_text("old")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
            self.assertEqual(self.ended_by(number), "")
            self.assertEqual(self.parts(), [])
        self.assertIn("limit on processor time", self.ended_by(signal.SIGXCPU))
        self.assertEqual(self.parts(), [])
        self.assertEqual((self.folder / "out.vti").read_text(), "old")

    def test_signals_that_are_ignored_stay_so(self):
        done = subprocess.Popen([PROGRAM, *self.WORK], cwd=self.folder,
                                preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        while done.poll() is None and not self.parts():
            time.sleep(0.0005)
        done.send_signal(signal.SIGHUP)
        self.assertEqual(done.wait(60), 0)
        self.assertTrue((self.folder / "out.vti").exists())

    def test_what_a_killed_run_left_goes_with_the_next(self):
        self.ended_by(signal.SIGKILL)
        self.assertEqual(len(self.parts()), 1)
        self.succeeds("sample", "box.off", "--cells", "4", "--quiet", "-o", "other.vti")
        self.assertEqual(len(self.parts()), 1)  # not that of this output
        self.succeeds("sample", "box.off", "--cells", "4", "--quiet", "-o", "out.vti")
        self.assertEqual(self.parts(), [])

    def test_a_limit_on_the_size_of_files(self):
        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (10_000,) * 2)
        for command in (("sample", "box.off", "--cells", "20", "-o", "out.vti"),
                        ("make", "sphere", "--parts", "40", "-o", "out.vti.ply"), ("slice", "box.off", "-o", "out.png")):
            done = subprocess.run([PROGRAM, *command], cwd=self.folder, preexec_fn=limited, capture_output=True,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"\Acutwater: error: out\.\S+: cannot write: [^\n]*: files of this process are "
                                          r"limited to 10000 bytes \(ulimit -f\)\n\Z")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["box.off"])


class Refusals(CommandTest):
    def test_missing_and_broken_files(self):
        for command in [("info",), ("sample", "-o", "a.vti"), ("slice", "-o", "a.png"), ("convert", "a.stl")]:
            self.assertIn("missing.stl", self.fails(1, command[0], "missing.stl", *command[1:]))
        (self.folder / "broken.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n")
        self.assertRegex(self.fails(1, "info", "broken.off"), r"broken\.off: line 4")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["broken.off"])

    def test_surfaces_that_are_not_watertight_if_told_to(self):
        (self.folder / "open.off").write_text(OPEN_BOX)
        for command in [("sample", "-o", "a.vti"), ("slice", "-o", "a.png")]:
            why = self.fails(1, command[0], "open.off", *command[1:], "--require-watertight")
            self.assertIn("open.off", why)
            self.assertIn("4 open edges", why)
        self.assertEqual([f.name for f in self.folder.iterdir()], ["open.off"])
        for command in [("sample", "-o", "a.vti", "--cells", "10"), ("slice", "-o", "a.png")]:
            self.assertIn("signs: winding number: 4 unbalanced edges",
                          self.succeeds(command[0], "open.off", *command[1:]))
        self.fails(2, "slice", "open.off", "-o", "a.png", "--signs", "guess")
        self.succeeds("slice", "open.off", "-o", "a.png", "--signs", "nearest")

    def test_surfaces_too_far_away(self):
        self.box()
        for command in [("info",), ("repair", "-o", "a.ply"), ("slice", "-o", "a.png"), ("convert", "a.ply")]:
            why = self.fails(1, command[0], "box.off", *command[1:], "--scale", "1e200")
            self.assertIn("box.off --scale 1e200: the point (-1e+200, ", why)

    def test_surfaces_without_faces(self):
        (self.folder / "points.off").write_text("OFF\n1 0 0\n0 0 0\n")
        self.assertIn("points.off", self.fails(1, "slice", "points.off", "-o", "a.png"))

    def test_places_that_cannot_be_written(self):
        self.box()
        for command in [("sample", "-o", "no/such/a.vti"), ("slice", "-o", "no/such/a.png")]:
            self.assertIn(command[2], self.fails(1, command[0], "box.off", *command[1:]))
        self.assertIn("no/such/a.ply", self.fails(1, "convert", "box.off", "no/such/a.ply"))

    def test_grids_beyond_all_bounds(self):
        self.box()
        for options in [("--spacing", "1e-9"), ("--spacing", "1e-300"), ("--cells", "2000000000"),
                        ("--total", "1e300"), ("--spacing", "1e-4")]:
            self.fails(1, "sample", "box.off", "-o", "a.vti", *options)

    def test_errors_stay_on_one_line(self):
        self.fails(1, "info", "two\nlines.stl")

    def test_names_stay_on_one_line(self):
        self.box("two\nlines.off")
        for command in [("info",), ("repair", "-o", "it's\na.ply"), ("sample", "--cells", "4", "-o", "\n\x1ba.vti"),
                        ("amr", "--level", "0", "-o", "\na.vtu"), ("convert", "\na.ply"), ("slice", "-o", "\na.png"),
                        ("prepare", "-o", "\na.cutwater")]:
            text = self.succeeds(command[0], "two\nlines.off", *command[1:])
            self.assertNotRegex(text, r"(?m)^(lines|a)\.|\x1b")
            self.assertIn(r"two\nlines.off" if command[0] == "info" else r"\na." if "\x1b" not in command[-1]
                          else r"\n\033a.vti", text)
        for text in (self.succeeds("info", "two\nlines.off"), self.succeeds("repair", "two\nlines.off", "-o", "it's\na.ply")):
            advice = re.search(r"cutwater (slice .*)", text)[1]
            self.assertIn("$'", advice)
            subprocess.run(["bash", "-c", f"{PROGRAM} {advice}"], cwd=self.folder, check=True, capture_output=True)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no device that is always full")
    def test_a_full_standard_output(self):
        self.box()
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([PROGRAM, "info", "box.off"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\Acutwater: error: [^\n]+\n\Z")


if __name__ == "__main__":
    unittest.main()
