"""What tests of the command have in common: it is run in a folder of its own, as scripts would."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
BOX_POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
OPEN_BOX_FACES = [(0, 3, 2, 1), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
BOX_FACES = OPEN_BOX_FACES + [(4, 5, 6, 7)]


def off(points, faces):
    """The text of an OFF file."""
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(map(repr, p)) for p in points),
             *(" ".join(map(str, (len(f), *f))) for f in faces)]
    return "\n".join(lines) + "\n"


def keys_of(value):
    """Of all objects in it, the innermost too."""
    if isinstance(value, dict):
        return set(value).union(*map(keys_of, value.values()))
    return set().union(*map(keys_of, value)) if isinstance(value, list) else set()


OPEN_BOX = off(BOX_POINTS, OPEN_BOX_FACES)


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_it(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                              cwd=self.folder, timeout=100)

    def succeeds(self, *arguments):
        done = self.run_it(*arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
        return done.stdout

    def fails(self, status, *arguments):
        """Returns the one line that tells why."""
        done = self.run_it(*arguments)
        self.assertEqual(done.returncode, status, (arguments, done.stderr))
        self.assertRegex(done.stderr, r"\Acutwater: error: [^\n]+\n\Z", arguments)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def box(self, name="box.off", size="2,2,2"):
        self.succeeds("make", "cuboid", "--size", size, "-o", name)
        return name

    def json(self, *arguments):
        """What it says in JSON; the documentation has every key."""
        facts = json.loads(self.succeeds(*arguments, "--json"))
        keys = keys_of(facts) | {defect["key"] for defect in facts["defects"]}
        page = (pathlib.Path(__file__).resolve().parents[2] / "Docs/diagnosis.md").read_text()
        self.assertEqual([key for key in sorted(keys) if f"`{key}`" not in page], [])
        return facts

    def surface(self, name, points, faces):
        (self.folder / name).write_text(off(points, faces))
        return name
