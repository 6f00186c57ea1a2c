"""Runs the command on scenes, as people do. Usage: check_scene.py PROGRAM [group]"""
import json
import math
import pathlib
import unittest

from command import CommandTest
from readers import Png, Vti

BALL = '[ball]\nshape = "sphere"\ncenter = [1, 0, 0]\nradius = 0.5\npatch = "ball"\n'
ENDLESS = '[lattice]\nlattice = "octet"\ncell = [1, 1, 1]\nradius = 0.1\n'
ROOT = pathlib.Path(__file__).resolve().parents[2]


class SceneTest(CommandTest):
    def scene(self, text=BALL, name="it.toml"):
        (self.folder / name).write_text(text)
        return name


class Scenes(SceneTest):
    def test_sample_gives_the_distance(self):
        self.succeeds("sample", self.scene(), "--cells", "8", "--box", "0,-1,-1,2,1,1", "-o", "a.vti",
                      "--write", "distance,patch")
        vti = Vti(self.folder / "a.vti")
        self.assertEqual(len(vti.arrays["distance"]), 512)
        for p, value in zip(vti.positions(), vti.arrays["distance"]):
            self.assertAlmostEqual(value, math.dist(p, (1, 0, 0)) - 0.5, delta=1e-12)

    def test_motions_and_scale_act_on_the_solid(self):
        text = self.succeeds("info", self.scene(), "--scale", "2", "--rotate", "90,z", "--translate", "0,0,3")
        self.assertIn("(-1, 1, 2) to (1, 3, 4)", text)

    def test_a_mesh_is_that_of_its_surface(self):
        self.box()
        self.scene('[box]\nmesh = "box.off"\n')
        for extension, *command in ["vti", "sample", "--cells", "12"], ["vtu", "amr", "--level", "2"]:
            names = f"a.{extension}", f"b.{extension}"
            self.succeeds(*command, "box.off", "-o", names[0])
            self.succeeds(*command, "it.toml", "-o", names[1])
            self.assertEqual(*((self.folder / name).read_bytes() for name in names))
        for command in "slice", "render":
            self.succeeds(command, "box.off", "-o", "a.png", "--size", "400x300", "--title", "same")
            self.succeeds(command, "it.toml", "-o", "b.png", "--size", "400x300", "--title", "same")
            self.assertEqual(*((self.folder / name).read_bytes() for name in ("a.png", "b.png")))

    def test_amr_knows_patches(self):
        coarse = self.succeeds("amr", self.scene(), "--level", "1", "-o", "a.vtu")
        fine = self.succeeds("amr", "it.toml", "--level", "1", "--patch", "ball:3", "-o", "a.vtu")
        self.assertIn("level  3:", fine)
        self.assertNotIn("level  2:", coarse)

    def test_what_has_no_end_needs_a_box(self):
        self.scene(ENDLESS)
        for command in (["sample", "-o", "a.vti"], ["amr", "--level", "1", "-o", "a.vtu"], ["slice", "-o", "a.png"],
                        ["render", "-o", "a.png"]):
            self.fails(1, *command, "it.toml")
        box = ["--box", "0,0,0,2,2,2"]
        self.succeeds("sample", "it.toml", "-o", "a.vti", "--cells", "8", *box)
        self.succeeds("amr", "it.toml", "-o", "a.vtu", "--level", "1", *box)
        for at in [], ["--at", "0.5"]:
            self.succeeds("slice", "it.toml", "-o", "a.png", "--window", "0,0,2,2", *at)
        self.succeeds("render", "it.toml", "-o", "a.png", "--show", "0,0,0,2,2,2", "--size", "400x300")

    def test_upper_case_names_are_scenes_too(self):
        self.assertIn("Sphere", self.succeeds("info", self.scene(name="IT.TOML")))

    def test_keys(self):
        page = self.succeeds("scene", "--keys")
        self.assertIn(page, (ROOT / "Docs/scenes.md").read_text())
        self.assertEqual(self.succeeds("scene"), self.succeeds("scene", "--help"))

    def test_a_surface_is_made_of_one(self):
        self.succeeds("isosurface", self.scene(), "--cells", "12", "-o", "a.stl")
        self.assertRegex(self.succeeds("info", "a.stl"), r"watertight +yes")
        self.assertIn("or a scene", self.succeeds("isosurface", "--help"))


class AboutScenes(SceneTest):
    def test_page(self):
        text = self.succeeds("info", self.scene(BALL + '[it]\ncomplement = "ball"\n'))
        for words in "scene", "Complement", "    Sphere: exact", "bounding box", "Patches: 1", "ball", "build":
            self.assertIn(words, text)

    def test_what_rounding_leaves_near_0_is_0(self):
        bar = '[bar]\nshape = "cuboid"\nlower = [1e-17, 0, 0]\nupper = [3, 3, 3]\n'
        self.assertIn("(0, 0, 0) to (3, 3, 3)", self.succeeds("info", self.scene(bar)))
        small = bar.replace("1e-17", "1e-6")
        self.assertIn("(1e-06, 0, 0) to (3, 3, 3)", self.succeeds("info", self.scene(small)))

    def test_json(self):
        facts = json.loads(self.succeeds("info", self.scene(), "--json"))
        self.assertEqual(facts["file"], {"name": "it.toml", "format": "scene"})
        self.assertEqual(len(facts["expression"]), 2)
        for corner, expected in ("lower", [0.5, -0.5, -0.5]), ("upper", [1.5, 0.5, 0.5]):
            for value, exact in zip(facts["boundingBox"][corner], expected, strict=True):
                self.assertAlmostEqual(value, exact, delta=1e-12)
        self.assertEqual(facts["patches"], ["ball"])
        page = (ROOT / "Docs/scenes.md").read_text()
        for key in [*facts, *facts["file"], *facts["seconds"]]:
            self.assertIn(f"`{key}`", page)
        facts = json.loads(self.succeeds("info", self.scene(ENDLESS), "--json"))
        self.assertEqual(facts["boundingBox"]["upper"], [None, None, None])


class SceneRefusals(SceneTest):
    def test_errors_name_the_line(self):
        for command in (["info"], ["sample", "-o", "a.vti"], ["amr", "--level", "1", "-o", "a.vtu"],
                        ["slice", "-o", "a.png"], ["render", "-o", "a.png"]):
            self.assertIn('it.toml: line 2: [ball]: there is no shape "bal"',
                          self.fails(1, command[0], self.scene('[ball]\nshape = "bal"\n'), *command[1:]))
        self.fails(1, "info", "none.toml")

    def test_options_for_surfaces(self):
        self.scene()
        for options in ["--signs", "winding"], ["--require-watertight"]:
            self.assertIn("in a scene", self.fails(1, "sample", "it.toml", "-o", "a.vti", *options))
        self.assertIn("--float", self.fails(1, "info", "it.toml", "--float"))

    def test_commands_for_surfaces(self):
        self.scene()
        for command in (["convert", "it.toml", "a.stl"], ["prepare", "it.toml", "-o", "a.cutwater"],
                        ["repair", "it.toml", "-o", "a.stl"]):
            self.assertRegex(self.fails(1, *command), "a scene has no surface mesh.*'cutwater isosurface' makes one")


class Examples(SceneTest):
    """Each scene beside the documentation is drawn, and has something on its picture."""

    def test_pictures(self):
        scenes = sorted((ROOT / "Examples/Scenes").glob("*.toml"))
        self.assertGreaterEqual(len(scenes), 3)
        for scene in scenes:
            self.succeeds("render", scene, "-o", "a.png", "--size", "400x300", "--no-axes", "--title", " ")
            image = Png(self.folder / "a.png")
            drawn = sum(image.pixel(x, y) != (255, 255, 255) for y in range(300) for x in range(400))
            self.assertGreater(drawn, 12000, scene)


if __name__ == "__main__":
    unittest.main()
