"""Lets OpenFOAM judge what `cutwater mesh` writes. Usage: check_openfoam.py PROGRAM [group]

CUTWATER_HULL names the hull of its tutorials; WM_PROJECT_DIR where it is installed."""
import json
import os
import pathlib
import re
import subprocess
import unittest

from command import BOX_FACES, BOX_POINTS, CommandTest, off

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
SYSTEM = {
    "controlDict": "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeInterval 1;"
                   " writeFormat ascii; writePrecision 12; timePrecision 6; runTimeModifiable false;",
    "fvSchemes": "ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }"
                 " divSchemes { default none; div(phi,U) bounded Gauss linear; div(div(phi,U)) Gauss linear; }"
                 " laplacianSchemes { default Gauss linear limited corrected 0.5; } interpolationSchemes { default linear; }"
                 " snGradSchemes { default limited corrected 0.5; }",
    "fvSolution": "solvers { Phi { solver GAMG; smoother DIC; tolerance 1e-9; relTol 0.01; } }"
                  " potentialFlow { nNonOrthogonalCorrectors 12; }",
}
# A stream against x, that walls and sides do not let through.
FIELDS = {
    "U": ("volVectorField", "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0); boundaryField {"
          " xMax { type fixedValue; value uniform (-1 0 0); } xMin { type zeroGradient; } \".*\" { type slip; } }"),
    "p": ("volScalarField", "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0; boundaryField {"
          " xMin { type fixedValue; value uniform 0; } \".*\" { type zeroGradient; } }"),
}


class OpenFoam(CommandTest):
    def setUp(self):
        super().setUp()
        for name, text in SYSTEM.items():
            self.put("system", name, "dictionary", text)

    def put(self, folder, name, kind, text):
        path = self.folder / "case" / folder
        path.mkdir(parents=True, exist_ok=True)
        (path / name).write_text(HEADER.format(kind, name) + text + "\n")

    def made(self, *arguments):
        self.succeeds("mesh", "case", *arguments, "--json", "totals.json")
        return json.loads((self.folder / "totals.json").read_text())

    def runs(self, *command):
        done = subprocess.run([*command, "-case", str(self.folder / "case")], capture_output=True, text=True, timeout=600,
                              env={"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ})
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr)
        return done.stdout

    def check(self, totals):
        """checkMesh finds what the totals say, and nothing else."""
        said = self.runs("checkMesh", "-allTopology")
        number = lambda pattern: float(re.search(pattern + r"\s*(-?[\d.e+-]+\d)", said).group(1))
        self.assertEqual([number(r"\n\s+" + what + ":") for what in ("points", "faces", "cells")],
                         [totals[what] for what in ("points", "faces", "cells")])
        self.assertIn("Face pyramids OK." if totals["invertedFaces"] == 0 else "incorrectly oriented", said)
        for flaw in ("zero or negative", "are not closed", "not used", "upper triangular", "unordered", "Topology"):
            self.assertNotIn(" ***" + flaw, said)
        self.assertAlmostEqual(number(r"Total volume =") / totals["meshVolume"], 1, places=7)
        self.assertAlmostEqual(number(r"non-orthogonality Max:"), totals["worstNonOrthogonality"], places=4)
        self.assertAlmostEqual(number(r"Max skewness ="), totals["worstSkewness"], places=6)
        skew = re.search(r"(\d+) highly skew faces", said)
        self.assertEqual(int(skew.group(1)) if skew else 0, totals["skewFaces"])
        illegal = re.search(r"Writing (\d+) illegal cells", said)
        self.assertEqual(int(illegal.group(1)) if illegal else 0, totals["fewFaces"])
        self.assertEqual("negative face area" in said, totals["flatFaces"] > 0)
        isGood = sum(totals[key] for key in ("skewFaces", "invertedFaces", "flatFaces", "fewFaces")) == 0
        self.assertEqual("Mesh OK." in said, isGood, said[-2000:])
        return isGood

    def flow(self, at_most=1e-5):
        """potentialFoam finds a flow through the mesh."""
        for name, (kind, text) in FIELDS.items():
            self.put("0", name, kind, text)
        said = self.runs("potentialFoam")
        self.assertLess(float(re.search(r"Continuity error = (\S+)", said).group(1)), at_most)
        self.assertNotIn("nan", said)

    def test_cells_around_a_hull(self):
        hull = os.environ["CUTWATER_HULL"]
        self.assertTrue(self.check(self.made(hull, "--roots", "64", "--level", "0", "--margin", "3")))
        around = (hull, "--roots", "16", "--level", "5", "--margin", "3")
        self.assertTrue(self.check(self.made(*around, "--band", "0.03:5")))
        self.assertTrue(self.check(self.made(*around, "--binary")))
        self.flow()

    def test_surfaces_of_its_tutorials(self):
        folder = pathlib.Path(os.environ["CUTWATER_HULL"]).parent
        for name, *how in (("flange.stl.gz", "--roots", "32", "--level", "1"), ("building_wtc2.obj.gz", "--roots", "64", "--level", "1"),
                           ("motorBike.obj.gz", "--cap-holes", "--roots", "64", "--level", "1")):
            self.assertTrue(self.check(self.made(str(folder / name), *how)), name)
            self.flow(at_most=1e-4)

    def test_zones_and_triangles(self):
        inner = [(0.4 * x + 0.3, 0.4 * y + 0.3, 0.4 * z + 0.3) for x, y, z in BOX_POINTS]
        walls = [tuple(face) for face in BOX_FACES] + [tuple(8 + n for n in reversed(face)) for face in BOX_FACES]
        (self.folder / "hollow.off").write_text(off(BOX_POINTS + inner, walls))
        place = ("--box", "-1.05,-1.05,-1.05,2.05,2.05,2.05", "--roots", "31", "--level", "0")
        for how in (("--cavities",), ("--within", "0.5,0.5,0.5")):
            self.assertTrue(self.check(self.made("hollow.off", *place, *how)), how)
        self.check(self.made("hollow.off", *place, "--wall-triangles", "--binary"))

    def test_a_gyroid_in_a_channel(self):
        """The sides of the block lie in planes of the grid, at -1 and 1."""
        (self.folder / "gyroid.toml").write_text(
            'solid = "core"\n[gyroid]\ntpms = "gyroid"\ncell = 1\nlevel = 0.4\n'
            '[block]\nshape = "cuboid"\nlower = [-1, -1, -1]\nupper = [1, 1, 1]\n'
            '[core]\nintersection = ["gyroid", "block"]\n')
        for box in ("-1.5,-1.2,-1.2,1.5,1.2,1.2", "-1.51,-1.22,-1.23,1.48,1.17,1.18"):
            totals = self.made("gyroid.toml", "--box", box, "--roots", "60", "--level", "0")
            self.check(totals)
            self.assertLess(totals["invertedFaces"] + totals["skewFaces"], 3)
            self.flow()


if __name__ == "__main__":
    unittest.main()
