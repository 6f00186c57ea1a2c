"""Runs cutwater-mpi beside cutwater. Usage: check_command.py CUTWATER CUTWATER_MPI MPIEXEC"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Tools"))
from readers import Vtu  # noqa: E402

ALONE, ON_RANKS, MPIEXEC = sys.argv[1:4]
del sys.argv[1:4]
MESH = ["--level", "4", "--roots", "6", "--band", "0.2:3", "--write", "distance,normal,patch,class,level"]


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.run_it(ALONE, "make", "torus", "-o", "torus.stl")

    def run_it(self, *words, status=0):
        done = subprocess.run([*words], capture_output=True, text=True, cwd=self.folder, timeout=60)
        self.assertEqual(done.returncode, status, (words, done.stdout, done.stderr))
        return done

    def on_ranks(self, ranks, *words, status=0):
        return self.run_it(MPIEXEC, "--oversubscribe", "-n", str(ranks), ON_RANKS, *words, status=status)

    @staticmethod
    def told(output):
        """What must be the same however many ranks there are."""
        lines = output.split("\n")
        mesh = [line for line in lines if line.startswith(("roots: ", "level ", "inside: "))]
        return mesh, re.search(r"cells and values ([0-9a-f]{16})", output)[1]

    def pieces(self, name):
        text = (self.folder / name).read_text()
        return [Vtu(self.folder / piece) for piece in re.findall(r'<Piece Source="([^"]+)"', text)]

    def test_mesh_is_the_same_on_any_number_of_ranks(self):
        expected = self.told(self.run_it(ALONE, "amr", "torus.stl", *MESH, "-o", "one.vtu").stdout)
        whole = Vtu(self.folder / "one.vtu")
        forests = set()
        for ranks in (1, 3):
            output = self.on_ranks(ranks, "amr", "torus.stl", *MESH, "-o", "m.pvtu").stdout
            self.assertEqual(self.told(output), expected)
            forests.add(re.search(r"p8est (\d+)", output)[1])
            pieces = self.pieces("m.pvtu")
            self.assertEqual(len(pieces), ranks)
            self.assertEqual([box for piece in pieces for box in piece.boxes], whole.boxes)
            for name, values in whole.arrays.items():
                parts = [value for piece in pieces for value in piece.arrays[name]]
                self.assertEqual(parts, list(values), name)
        self.assertEqual(len(forests), 1)

    def test_own_copies_and_prepared_files_give_the_same(self):
        self.run_it(ALONE, "prepare", "torus.stl", "-o", "torus.cutwater")
        runs = [("torus.stl", "--private"), ("torus.cutwater",),
                ("torus.cutwater", "--private", "--threads", "2", "--cut-weight", "9")]
        told = [self.told(self.on_ranks(2, "amr", *words, *MESH, "-o", "m.pvtu").stdout)
                for words in runs]
        self.assertEqual(told, told[:1] * len(told))

    def test_errors_are_told_once(self):
        cases = [(1, ["missing.stl", "--level", "2", "-o", "m.pvtu"], "missing.stl"),
                 (1, ["torus.stl", "--level", "19", "--roots", "1", "-o", "m.pvtu"], "level"),
                 (1, ["torus.stl", "--level", "2", "-o", "none/m.pvtu"], "none"),
                 (1, ["ball.toml", "--level", "2", "-o", "m.pvtu"], "ball.toml: .* takes surfaces only"),
                 (2, ["torus.stl", "--level", "18", "-o", "m.pvtu"], "--level: '18': need a level up to 17"),
                 (2, ["torus.stl", "--level", "2"], "--output")]
        for status, words, reason in cases:
            done = self.on_ranks(3, "amr", *words, status=status)
            errors = [line for line in done.stderr.split("\n") if "error:" in line]
            self.assertEqual(len(errors), 1, done.stderr)
            self.assertRegex(errors[0], f"^cutwater-mpi: error: .*{reason}")
            self.assertNotIn("wrote", done.stdout)
        self.assertEqual(list(self.folder.glob("m*")), [])

    def test_ranks_with_other_options_end(self):
        same = ["amr", "torus.stl", "-o", "m.pvtu", "--level"]
        for other in ([*same, "3"], [*same, "30"], ["amr"], [*same, "2", "--private"]):
            done = self.run_it(MPIEXEC, "--oversubscribe", "-n", "1", ON_RANKS, *same, "2", ":", "-n", "2", ON_RANKS,
                               *other, status=1)
            errors = [line for line in done.stderr.split("\n") if "error:" in line]
            self.assertEqual(errors, ["cutwater-mpi: error: the ranks have different command lines"])
        self.assertEqual(list(self.folder.glob("m*")), [])

    def test_quiet_is_quiet_and_help_is_told_once(self):
        self.assertEqual(self.on_ranks(2, "amr", "torus.stl", *MESH, "-q", "-o", "m.pvtu").stdout, "")
        self.assertEqual(self.on_ranks(2, "amr", "--help").stdout.count("--cut-weight N"), 1)


unittest.main()
