"""Runs `cutwater cells` as people and scripts do. Usage: check_cells.py PROGRAM [group]"""
import json
import math
import unittest

from command import BOX_FACES, BOX_POINTS, OPEN_BOX_FACES, CommandTest
from readers import Png, VtkXml


class Cells(CommandTest):
    def setUp(self):
        super().setUp()
        self.box()  # of side 2 about the origin

    def totals(self, *arguments):
        said = self.succeeds("cells", *arguments, "--json", "totals.json")
        return said, json.loads((self.folder / "totals.json").read_text())

    def duct(self):
        """From x = 0.5 to 2.5, of 1 x 1; "inlet" and "outlet" are its ends."""
        corners = [(0.5 + 2 * x, y, z) for x, y, z in BOX_POINTS]
        ends = {(3, 0, 4, 7): "inlet", (1, 2, 6, 5): "outlet"}
        lines = [f"v {x} {y} {z}" for x, y, z in corners]
        for face in BOX_FACES:
            lines += [f"g {ends.get(face, 'wall')}", "f " + " ".join(str(n + 1) for n in face)]
        (self.folder / "duct.obj").write_text("\n".join(lines) + "\n")

    def test_totals_are_those_of_the_surface(self):
        said, totals = self.totals("box.off", "--box", "-1.3,-1.3,-1.3,1.3,1.3,1.3", "--cells", "13")
        self.assertIn("cut 602 of 13 x 13 x 13 = 2 197 cells", said)
        self.assertEqual((totals["cells"], totals["cutCells"], totals["multiPieceCells"]), (2197, 602, 0))
        self.assertAlmostEqual(totals["bodyVolume"], 8, places=13)
        self.assertAlmostEqual(totals["fluidVolume"], 2.6**3 - 8, places=13)
        self.assertAlmostEqual(totals["boundaryArea"], 24, places=13)
        for key in ("volumeError", "areaError", "worstClosure"):
            self.assertLess(totals[key], 1e-14)
        _, inside = self.totals("box.off", "--inside", "--spacing", "0.3")
        self.assertAlmostEqual(inside["fluidVolume"], 8, places=13)
        self.assertLess(inside["volumeError"], 1e-14)

    def test_a_plate_leaves_two_pieces_that_no_corner_sees(self):
        self.box("plate.off", "6,6,1e-6")
        said, totals = self.totals("plate.off", "--box", "-1,-1,-1.1,1,1,0.9", "--cells", "8")
        self.assertIn("64 cells have several, in 64 all corners are on one side", said)
        self.assertIn("part of the surface is outside the grid", said)
        self.assertEqual((totals["pieces"], totals["thinCells"]), (128, 64))
        self.assertIsNone(totals["volumeError"])
        self.assertAlmostEqual(totals["bodyVolume"], 4e-6, places=15)

    def test_writes_polyhedra(self):
        self.succeeds("cells", "box.off", "--spacing", "0.3", "-o", "cut.vtu")
        cut = VtkXml(self.folder / "cut.vtu")
        self.assertEqual(set(cut.arrays["types"]), {42})
        self.assertAlmostEqual(sum(cut.arrays["wall_area"]), 24, places=12)
        self.assertEqual(cut.patch_names(), ["box"])
        self.succeeds("cells", "box.off", "--spacing", "0.3", "--whole-cells", "-o", "all.vtu")
        everything = VtkXml(self.folder / "all.vtu")
        self.assertEqual(set(everything.arrays["types"]), {12, 42})
        low, high = (pick(everything.arrays["Points"]) for pick in (min, max))
        size = [b - a for a, b in zip(low, high)]
        self.assertAlmostEqual(sum(everything.arrays["volume"]), size[0] * size[1] * size[2] - 8, places=11)

    def test_follows_placement_and_threads(self):
        moved = ["box.off", "--rotate", "30,z", "--translate", "0.1,0.2,5", "--cells", "20"]
        for threads in (1, 3):
            self.succeeds("cells", *moved, "--threads", threads, "-o", f"{threads}.vtu")
        self.assertEqual((self.folder / "1.vtu").read_bytes(), (self.folder / "3.vtu").read_bytes())
        _, totals = self.totals(*moved)
        self.assertLess(totals["volumeError"], 1e-14)

    def test_draws_a_layer(self):
        box = ["box.off", "--box", "-1.3,-1.3,-1.3,1.3,1.3,1.3", "--spacing", "0.2", "--size", "600x500"]
        said = self.succeeds("slice", *box, "--at", "0.05", "-o", "layer.png")
        self.assertIn("of the cells from y = -0.1 to 0.1", said)
        self.assertIn("40 of 169 are cut; 0 have several pieces, and in 0 all corners", said)
        picture = Png(self.folder / "layer.png")
        self.assertEqual((picture.width, picture.height), (600, 500))
        self.succeeds("slice", *box, "--at", "0.05", "--threads", "3", "-q", "-o", "again.png")
        self.assertEqual((self.folder / "layer.png").read_bytes(), (self.folder / "again.png").read_bytes())
        within = self.succeeds("slice", *box, "--axis", "z", "--inside", "--window", "0.85,0.85,1.15,1.05", "-o", "a.png")
        self.assertIn("3 of 6 are cut", within)  # the walls at x = 1 and y = 1 meet in one
        self.box("plate.off", "6,6,1e-6")
        plate = self.succeeds("slice", "plate.off", "--box", "-1,-1,-1.1,1,1,0.9", "--cells", "8", "-o", "plate.png")
        self.assertIn("8 of 64 are cut; 8 have several pieces, and in 8 all corners", plate)

    def test_draws_leaves(self):
        place = ["slice", "box.off", "--box", "-1.4,-1.4,-1.4,1.4,1.4,1.4", "--at", "0.1", "--title", "Box"]
        self.succeeds(*place, "--spacing", "0.35", "-o", "grid.png")
        said = self.succeeds(*place, "--roots", "4", "--level", "1", "--band", "9:1", "-o", "leaves.png")
        self.assertIn("of the cells of an octree where y = 0.175", said)
        self.assertIn("20 of 64 are cut; 0 have several pieces", said)
        self.assertEqual((self.folder / "grid.png").read_bytes(), (self.folder / "leaves.png").read_bytes())
        # 8 x 8 roots. Those at the four edges are 7 leaves each, of which 5 are cut, beside 16 roots at the walls.
        mixed = self.succeeds(*place, "--roots", "8", "--level", "0", "--edges", "30:2", "--balance", "none",
                              "-o", "mixed.png")
        self.assertIn("36 of 88 are cut", mixed)
        self.assertNotEqual((self.folder / "grid.png").read_bytes(), (self.folder / "mixed.png").read_bytes())
        window = self.succeeds(*place, "--roots", "8", "--level", "0", "--window", "-1.4,-1.4,-1.1,1.4", "-o", "w.png")
        self.assertIn("0 of 8 are cut", window)
        self.tank()
        self.succeeds("slice", "tank.obj", "--inside", "--baffle", "sail", "--level", "3", "-o", "tank.png")

    def test_refuses_leaves(self):
        leaves = ["slice", "box.off", "-o", "a.png", "--level"]
        self.assertIn("--period is for grids", self.fails(1, *leaves, "2", "--period", "4,0,0"))
        self.assertIn("no cells in the window where y = ", self.fails(1, *leaves, "2", "--at", "9"))
        self.assertIn("no cells in the window where y = ", self.fails(1, *leaves, "2", "--window", "8,8,9,9"))
        self.assertIn("pixels cannot show", self.fails(1, *leaves, "7", "--size", "400x300"))
        self.assertIn("--max-cells allows 100", self.fails(1, *leaves, "4", "--max-cells", "100"))
        self.fails(2, *leaves, "2", "--cells", "9")
        self.fails(2, "slice", "box.off", "-o", "a.png", "--edges", "30:2")
        self.assertFalse((self.folder / "a.png").exists())

    def test_refuses_layers(self):
        self.assertIn("no cells where y = 9", self.fails(1, "slice", "box.off", "--cells", "9", "--at", "9", "-o", "a.png"))
        self.assertIn("no cells in the window", self.fails(1, "slice", "box.off", "--cells", "9", "--window", "8,8,9,9",
                                                           "-o", "a.png"))
        self.assertIn("pixels cannot show", self.fails(1, "slice", "box.off", "--cells", "5000", "-o", "a.png"))
        self.assertIn("are for a picture of cells", self.fails(1, "slice", "box.off", "--inside", "-o", "a.png"))
        self.assertFalse((self.folder / "a.png").exists())

    def test_an_octree_of_one_level_gives_the_totals_of_the_grid(self):
        place = ["box.off", "--box", "-1.3,-1.3,-1.3,1.3,1.3,1.3"]
        _, grid = self.totals(*place, "--cells", "13")
        said, octree = self.totals(*place, "--roots", "13", "--level", "0")
        self.assertIn("cut 602 of 2 197 cells of an octree", said)
        self.assertEqual(set(grid), set(octree))
        for key in ("cells", "cutCells", "pieces", "multiPieceCells", "thinCells"):
            self.assertEqual(grid[key], octree[key])
        for key in ("fluidVolume", "bodyVolume", "boundaryArea"):
            self.assertAlmostEqual(grid[key], octree[key], places=12)

    def test_leaves_are_polyhedra_of_several_levels(self):
        said, totals = self.totals("box.off", "--roots", "4", "--level", "1", "--edges", "30:3",
                                   "--whole-cells", "-o", "leaves.vtu")
        self.assertIn("of an octree, the finest of", said)
        self.assertAlmostEqual(totals["bodyVolume"], 8, places=12)
        for key in ("volumeError", "areaError", "worstClosure"):
            self.assertLess(totals[key], 1e-13)
        leaves = VtkXml(self.folder / "leaves.vtu")
        self.assertEqual(set(leaves.arrays["types"]), {12, 42})
        self.assertAlmostEqual(sum(leaves.arrays["volume"]), totals["fluidVolume"], places=11)
        cut = [level for level, kind in zip(leaves.arrays["level"], leaves.arrays["types"]) if kind == 42]
        self.assertEqual((min(cut), max(cut), len(cut)), (1, 3, totals["pieces"]))
        inside = self.totals("box.off", "--roots", "4", "--level", "2", "--inside")[1]
        self.assertAlmostEqual(inside["fluidVolume"], 8, places=12)

    def test_open_patches_are_no_walls(self):
        self.duct()
        place = ["duct.obj", "--inside", "--box", "0,-1,-1,3,2,2"]
        _, closed = self.totals(*place, "--spacing", "0.25")
        self.assertAlmostEqual(closed["boundaryArea"], 10, places=13)
        for grid in (["--spacing", "0.25"], ["--roots", "6", "--level", "1"]):
            _, open_ = self.totals(*place, *grid, "--open", "inlet", "--open", "outlet", "-o", "duct.vtu")
            self.assertAlmostEqual(open_["boundaryArea"], 8, places=13)
            self.assertAlmostEqual(open_["fluidVolume"], 2, places=13)
            for key in ("volumeError", "areaError", "worstClosure"):
                self.assertLess(open_[key], 1e-14)
            duct = VtkXml(self.folder / "duct.vtu")
            self.assertAlmostEqual(sum(duct.arrays["wall_area"]), 8, places=12)
        # So many that time is estimated with larger cells, whose planes lie elsewhere.
        said, _ = self.totals("duct.obj", "--inside", "--box", "0.4765625,-0.25,-0.25,2.5234375,1.25,1.25",
                              "--spacing", "0.0078125", "--open", "inlet", "--open", "outlet")
        self.assertIn("wall 8;", said)

    def test_a_layer_shows_no_wall_where_a_patch_is_open(self):
        self.duct()
        place = ["slice", "duct.obj", "--inside", "--box", "0,-1,-1,3,2,2", "--spacing", "0.25", "--at", "0.4"]
        ends = ["--open", "inlet", "--open", "outlet"]
        for name, options in (("closed", []), ("open", ends), ("again", ends + ["--threads", "3"])):
            # A cell is cut by the walls and the openings that bound it.
            self.assertIn("20 of 144 are cut", self.succeeds(*place, *options, "-o", f"{name}.png"))
        closed, open_, again = ((self.folder / f"{name}.png").read_bytes() for name in ("closed", "open", "again"))
        self.assertNotEqual(closed, open_)
        self.assertEqual(open_, again)
        self.assertIn('the open patch "outlet" lies in no plane of the grid at (2.5, ',
                      self.fails(1, *place[:-3], "0.2", "--open", "outlet", "-o", "a.png"))
        self.assertIn("are for a picture of cells", self.fails(1, "slice", "duct.obj", *ends, "-o", "a.png"))
        self.assertFalse((self.folder / "a.png").exists())

    def tank(self, faces=tuple(BOX_FACES)):
        """Of side 2 about the origin, with a sail of 1 x 1 in the plane x = 0."""
        points = [(2 * x - 1, 2 * y - 1, 2 * z - 1) for x, y, z in BOX_POINTS]
        points += [(0, y, z) for y, z in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
        lines = [f"v {x} {y} {z}" for x, y, z in points]
        for patch, polygons in (("wall", faces), ("sail", [(8, 9, 10, 11)])):
            lines += [f"g {patch}", *("f " + " ".join(str(n + 1) for n in face) for face in polygons)]
        (self.folder / "tank.obj").write_text("\n".join(lines) + "\n")

    def test_baffles_are_walls_on_both_sides(self):
        self.tank()
        sail = ["tank.obj", "--inside", "--baffle", "sail", "--rotate", "20,z"]
        box = ["--box", "-1.5,-1.5,-1.3,1.5,1.5,1.3"]
        for grid in (["--spacing", "0.26"], ["--spacing", "0.26", "-o", "tank.vtu"], ["--roots", "4", "--level", "1"]):
            said, totals = self.totals(*sail, *box, *grid)
            self.assertAlmostEqual(totals["fluidVolume"], 8, places=12)
            self.assertAlmostEqual(totals["boundaryArea"], 24 + 2 * 1, places=12)
            self.assertLess(totals["volumeError"], 1e-13)
            self.assertIsNone(totals["areaError"])
            self.assertLess(totals["worstClosure"], 1e-13)
            self.assertTrue(said.startswith("cut "), said)  # no advice to close the sail
            self.assertRegex(said, r"own by \S+ of the volume\n")
        outside = self.totals(*sail[:1], *sail[2:], *box, "--spacing", "0.26")[1]
        self.assertAlmostEqual(outside["boundaryArea"], 24, places=12)  # the sail is in the body
        period = ["--period", "2.5,2.5,0", "--translate", "1,0.2,0.1", "--margin", "0.2", "--cells", "9"]
        repeated = self.totals(*sail[:-2], *period)[1]  # across its end, along x
        self.assertAlmostEqual(repeated["fluidVolume"], 8, places=12)
        self.assertAlmostEqual(repeated["boundaryArea"], 24 + 2 * 1, places=12)
        self.assertIn('no patch is called "fin"', self.fails(1, "cells", "tank.obj", "--baffle", "fin"))
        self.assertIn('open at patches "sail"', self.fails(1, "cells", "tank.obj", "-q"))

    def test_a_layer_shows_baffles_as_walls_in_fluid(self):
        self.tank()
        place = ["--box", "-1.25,-1.25,-1.25,1.25,1.25,1.25", "--spacing", "0.5", "--at", "0.1", "--axis", "z",
                 "--size", "1200x900"]
        self.succeeds("slice", "tank.obj", "--inside", "--baffle", "sail", *place, "-o", "sail.png")
        self.box("box.off")
        self.succeeds("slice", "box.off", "--inside", *place, "--title", "tank.obj, z = 0", "-o", "none.png")
        sail, none = (Png(self.folder / f"{name}.png") for name in ("sail", "none"))
        changed = [(x, y) for y in range(none.height) for x in range(none.width)
                   if sail.pixel(x, y) != none.pixel(x, y)]
        dark = [at for at in changed if sum(sail.pixel(*at)) < 100]
        self.assertGreater(len(dark), 100)
        # One upright line, and the colours beside it in cells that it halves: none is body.
        self.assertLess(max(x for x, _ in dark) - min(x for x, _ in dark), 4)

    def test_caps_holes(self):
        self.surface("open.off", [(2 * x - 1, 2 * y - 1, 2 * z - 1) for x, y, z in BOX_POINTS], OPEN_BOX_FACES)
        place = ["open.off", "--inside", "--cap-holes", "--box", "-1.5,-1.5,-1.5,1.5,1.5,1"]
        said, totals = self.totals(*place, "--spacing", "0.5")
        self.assertAlmostEqual(totals["fluidVolume"], 8, places=13)
        self.assertAlmostEqual(totals["boundaryArea"], 24, places=13)
        self.assertIsNone(totals["volumeError"])
        self.assertTrue(said.startswith("cut "), said)
        open_ = self.totals(*place, "--spacing", "0.5", "--open", "cap")[1]
        self.assertAlmostEqual(open_["boundaryArea"], 20, places=13)
        self.succeeds("slice", *place, "--spacing", "0.5", "--open", "cap", "-o", "a.png")

    def test_a_grid_covers_one_period(self):
        # A plate across the period, of which a part sticks out and comes in at the other end.
        self.box("plate.off", "1,1,0.25")
        period = ["plate.off", "--translate", "0.3,0.1,0.05", "--period", "1,1,0"]
        for grid in (["--cells", "10"], ["--total", "3000"], ["--spacing", "0.125"], ["--cells", "7x5x9"],
                     ["--box", "-0.7,3,-1,0.3,4,1", "--cells", "16"]):
            margin = [] if "--box" in grid else ["--margin", "0.5"]
            _, totals = self.totals(*period, *margin, *grid)
            height = totals["fluidVolume"] + totals["bodyVolume"]  # over 1 x 1
            self.assertAlmostEqual(totals["bodyVolume"], 0.25, places=13)
            self.assertAlmostEqual(totals["boundaryArea"], 2, places=13)  # its ends are no walls
            self.assertGreater(height, 1.2)
            self.assertLess(totals["worstClosure"], 1e-13)
            self.assertIsNone(totals["volumeError"])
        # A box that two sides of the period cut: as if it were whole.
        self.box("dice.off", "0.5,0.5,0.5")
        dice_at = ["dice.off", "--translate", "0.9,0.2,0.1", "--period", "1,2,0"]
        _, dice = self.totals(*dice_at, "--box", "0,-1,-0.5,1,1,0.5", "--spacing", "0.125",
                              "-o", "dice.vtu")
        self.assertAlmostEqual(dice["fluidVolume"], 2 - 0.125, places=13)
        self.assertAlmostEqual(dice["boundaryArea"], 6 * 0.25, places=13)
        self.assertEqual(dice["cells"], 8 * 16 * 8)
        dice = VtkXml(self.folder / "dice.vtu")
        self.assertAlmostEqual(sum(dice.arrays["wall_area"]), 6 * 0.25, places=13)
        self.succeeds("slice", *dice_at, "--cells", "20", "-o", "dice.png")

    def test_refuses_periods(self):
        period = ["cells", "box.off", "--period", "4,0,0"]
        self.assertIn("--period is for grids", self.fails(1, *period, "--level", "3"))
        self.assertIn("--box is 5 long along x, and --period 4: a grid covers one period",
                      self.fails(1, *period, "--box", "-3,-2,-2,2,2,2"))
        self.assertIn("no whole number of cells from two on, 0.3 long along x, makes the period of 4",
                      self.fails(1, *period, "--spacing", "0.3"))
        self.assertIn("two cells or more", self.fails(1, *period, "--cells", "1x5x5"))
        for wrong in ("0,0,0", "1,-1,0", "1,2"):
            self.assertIn("--period", self.fails(2, "cells", "box.off", "--period", wrong))
        refusal = self.fails(1, *period, "--cells", "1000", "--max-cells", "1e5")
        self.totals(*period[1:], "--cells", refusal.split("--cells ")[1].split()[0], "--max-cells", "1e5")
        self.assertIn("are for a picture of cells",
                      self.fails(1, "slice", "box.off", "--period", "4,0,0", "-o", "a.png"))

    def test_refuses_open_patches(self):
        self.duct()
        place = ["cells", "duct.obj", "--inside", "--box", "0,-1,-1,3,2,2", "--open", "outlet"]
        self.assertIn('no patch is called "pump" that could be open; there are:',
                      self.fails(1, *place, "--spacing", "0.25", "--open", "pump"))
        self.assertIn('the open patch "outlet" lies in no plane of the grid at (2.5, ',
                      self.fails(1, *place, "--spacing", "0.2"))

    def test_solids_of_scenes(self):
        (self.folder / "floor.toml").write_text('[floor]\nshape = "plane"\npoint = [0, 0, 0.5]\nnormal = [0, 0, 1]\n')
        (self.folder / "ball.toml").write_text('[ball]\nshape = "sphere"\nradius = 1\n')
        volume = 4 / 3 * math.pi
        text = self.succeeds("cells", "ball.toml", "--cells", "20", "-o", "ball.vtu", "--json", "ball.json")
        self.assertIn("as cells estimate it", text)
        totals = json.loads((self.folder / "ball.json").read_text())
        self.assertAlmostEqual(totals["bodyVolume"], volume, delta=max(1e-6, totals["statedError"] * volume))
        self.assertAlmostEqual(totals["boundaryArea"], 4 * math.pi, delta=1e-5)
        self.assertIsNone(totals["volumeError"])
        self.assertGreater(totals["largestError"], 0)
        self.assertGreater((self.folder / "ball.vtu").stat().st_size, 100_000)
        # The same in leaves, with less care, and from within.
        self.succeeds("cells", "ball.toml", "--level", "2", "--roots", "6", "--inside", "--tolerance", "0.01",
                      "-o", "leaves.vtu", "--json", "leaves.json")
        self.assertGreater((self.folder / "leaves.vtu").stat().st_size, 100_000)
        leaves = json.loads((self.folder / "leaves.json").read_text())
        self.assertAlmostEqual(leaves["fluidVolume"], volume, delta=1e-3)
        self.succeeds("slice", "ball.toml", "--cells", "12", "--axis", "z", "-o", "ball.png")
        self.assertGreater((self.folder / "ball.png").stat().st_size, 1000)
        self.succeeds("slice", "ball.toml", "--level", "3", "--roots", "3", "-o", "leaves.png")
        self.assertGreater((self.folder / "leaves.png").stat().st_size, 1000)
        # Across the ends of a period, as if it were whole.
        self.succeeds("cells", "ball.toml", "--period", "3,3,3", "--box", "0,0,0,3,3,3", "--cells", "12", "-o", "parts.vtu",
                      "--json", "parts.json")
        parts = json.loads((self.folder / "parts.json").read_text())
        self.assertAlmostEqual(parts["bodyVolume"], volume, delta=1e-4)
        self.assertAlmostEqual(parts["fluidVolume"], 27 - volume, delta=1e-4)
        self.assertLess(parts["worstClosure"], 1e-13)
        self.assertIn("--period is for grids", self.fails(1, "cells", "ball.toml", "--period", "3,3,3", "--level", "2"))
        self.assertIn("bounds, or that is the same a period further",
                      self.fails(1, "cells", "floor.toml", "--period", "1,1,1", "--box", "0,0,0,1,1,1"))
        # No wall in the box: all of it is fluid.
        away = self.succeeds("cells", "ball.toml", "--box", "2,2,2,3,3,3", "--cells", "4")
        self.assertIn("cut 0 of 4 x 4 x 4", away)

    def test_refusals_of_octrees(self):
        refusal = self.fails(1, "cells", "box.off", "--level", "9", "--max-cells", "1e5", "-o", "cut.vtu")
        level = refusal.split("--level ")[1].split()[0]
        self.succeeds("cells", "box.off", "--level", level, "--max-cells", "1e5")
        self.assertIn("memory", self.fails(1, "cells", "box.off", "--level", "9", "--max-memory", "0.1"))
        self.fails(2, "cells", "box.off", "--level", "2", "--cells", "9")
        self.fails(2, "cells", "box.off", "--edges", "30:2")
        self.assertIn("a level up to", self.fails(2, "cells", "box.off", "--roots", "5000", "--level", "20"))
        self.assertEqual([f.name for f in self.folder.iterdir() if f.name.startswith("cut.")], [])

    def test_refusals(self):
        self.surface("open.off", BOX_POINTS, OPEN_BOX_FACES)
        self.assertIn("need a surface that is closed", self.fails(1, "cells", "open.off", "-q"))
        self.assertIn("--whole-cells", self.fails(1, "cells", "box.off", "--whole-cells"))
        self.assertIn("'cut.txt'", self.fails(2, "cells", "box.off", "-o", "cut.txt"))
        refusal = self.fails(1, "cells", "box.off", "--cells", "1000", "--max-cells", "1e5", "-o", "cut.vtu")
        self.assertRegex(refusal, r"about [\d ]+ cells, [\d.]+ [MG]B of memory, about [\d.]+ (ms|s);")
        spacing = float(refusal.split("--spacing ")[1].split()[0])
        self.succeeds("cells", "box.off", "--spacing", spacing, "--max-cells", "1e5")
        (self.folder / "ball.toml").write_text('[ball]\nshape = "sphere"\nradius = 1\n')
        for option in (["--open", "wall"], ["--baffle", "wall"], ["--cap-holes"]):
            self.assertIn("are for surfaces", self.fails(1, "cells", "ball.toml", "--box", "0,0,0,1,1,1", *option))
        self.assertIn("surfaces cut cells exactly", self.fails(1, "cells", "box.off", "--tolerance", "0.1"))
        self.fails(2, "cells", "ball.toml", "--tolerance", "0")
        self.assertEqual([f.name for f in self.folder.iterdir() if f.name.startswith("cut.")], [])


if __name__ == "__main__":
    unittest.main()
