from cases import FACES, NO_COORDINATES, NO_INDICES, POINTS, bad, bad_word, bad_words, good, layouts

VERTICES = "".join(f"v {' '.join(point)}\n" for point in POINTS)
TRIANGLES = "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in FACES)
TEXT = VERTICES + TRIANGLES
FIVE = VERTICES + "v 1 1 1\nf 1 2 3\n"  # lines 1 to 6


def corners(form):
    """With every corner written another way."""
    lines = ["f " + " ".join(form(i + 1) for i in face) + "\n" for face in FACES]
    return VERTICES + "vt 0 0\nvn 0 0 1\n" + "".join(lines)


def cases():
    yield from layouts("obj", TEXT)
    yield from bad_words("obj-coordinate", VERTICES + "v 0 @ 0\nf 1 2 3\n", NO_COORDINATES)
    indices = {word: part for word, part in NO_INDICES.items() if word != "5"}
    yield from bad_words("obj-index", FIVE + "f 1 @ 3\n", {**indices, "0": "out of range",
                         "6": "out of range", "-6": "out of range", "1/2/x": '"1/2/x"'})
    yield from [
        good("obj-texture", corners(lambda i: f"{i}/1")),
        good("obj-texture-normal", corners(lambda i: f"{i}/1/1")),
        good("obj-normal", corners(lambda i: f"{i}//1")),
        good("obj-negative", corners(lambda i: str(i - 5))),
        good("obj-forward-references", TRIANGLES + VERTICES),
        good("obj-colours", TEXT.replace("0.25\n", "0.25 1 0.5 0\n")),
        good("obj-weights", TEXT.replace("0.25\n", "0.25 1.0\n")),
        good("obj-unused-vertices", TEXT + "v 7 7 7\nv 8 8 8\n", points=6),
        good("obj-duplicate-vertices", TEXT + VERTICES + TRIANGLES, faces=8),
        good("obj-quads", FIVE + "f 1 2 3 4\nf 1 2 3 4 5\n", points=5, faces=3),
        good("obj-repeated-corners", FIVE + "f 1 1 1\n", points=5, faces=2),
        good("obj-groups", VERTICES + "g a b\nf 1 2 3\ng c\nf 2 3 4\ng a b\nf 1 2 4\n", faces=3, patches=2),
        good("obj-objects", VERTICES + "o a\nf 1 2 3\no b\nf 2 3 4\n", faces=2, patches=2),
        good("obj-materials", VERTICES + "usemtl a\nf 1 2 3\nusemtl b\nf 2 3 4\n", faces=2, patches=2),
        good("obj-mtllib", "mtllib /no/such/file.mtl ../../another.mtl\n" + TEXT),
        good("obj-continued-lines", TEXT.replace("f 1 2 4", "f 1 \\\n 2 \\\r\n 4")),
        good("obj-comments", "# one\n" + TEXT.replace("\n", " # more\n")),
        good("obj-tabs-and-blanks", TEXT.replace(" ", " \t\v\f ")),
        good("obj-lines-and-points", TEXT + "l 1 2\np 1\n"),
        good("obj-free-form", TEXT + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n"),
        good("obj-last-line-continued", TEXT + "# \\"),
        good("obj-long-lines", "#" + "a" * 65535 + "\n" + TEXT),
    ]
    for name, word, part in [
            ("long-line", "#" + "a" * 65536, "64 kB"), ("two-coordinates", "v 0 0", "missing"),
            ("bad-colour", "v 0 0 0 red", '"red"'), ("nul", "v 0 0 0\0", "NUL"),
            ("unknown-statement", "vx 0 0 0", '"vx"'), ("upper-case", "V 0 0 0", '"V"'),
            ("two-corners", "f 1 2", "2 corners"), ("no-corners", "f", "0 corners"),
            ("empty-corner", "f 1 2 /3", "missing"), ("decimal-commas", "v 0,5 1,5 2,5", '"0,5"'),
            ("binary", "f 1 2 3\x01", '"3?"'), ("markup", "<v>0 0 0</v>", '"<v>0"')]:
        yield bad_word(f"obj-{name}", FIVE + "@\n", word, part)
    yield bad("obj-no-faces", VERTICES, "line 4", "no faces")
    yield bad("obj-only-lines", VERTICES + "l 1 2 3\n", "line 5", "no faces")
    yield bad("obj-no-points", "f 1 2 3\n", "line 1", "0 points")
    yield bad("obj-index-never-defined", "f 1 2 3\nf 1 2 9\n" + VERTICES, "line 2", "index 9")
