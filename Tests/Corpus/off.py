from cases import FACES, NO_COORDINATES, NO_COUNTS, NO_INDICES, POINTS, bad, bad_word, bad_words, good, layouts

ROWS = "".join(" ".join(point) + "\n" for point in POINTS)
TRIANGLES = "".join("3 " + " ".join(map(str, face)) + "\n" for face in FACES)
TEXT = f"OFF\n4 4 6\n{ROWS}{TRIANGLES}"
FIVE = f"OFF\n5 2 0\n{ROWS}1 1 1\n3 0 1 2\n"


def cases():
    yield from layouts("off", TEXT)
    yield from bad_words("off-coordinate", f"OFF\n5 4 0\n{ROWS}0 @ 0\n{TRIANGLES}",
                         {**NO_COORDINATES, "1.#INF": "missing"})  # a comment begins
    yield from bad_words("off-index", FIVE + "3 0 @ 2\n", {**NO_INDICES, "-1": "out of range"})
    yield from bad_words("off-points", f"OFF\n@ 4 0\n{ROWS}{TRIANGLES}", NO_COUNTS)
    yield from bad_words("off-faces", f"OFF\n4 @ 0\n{ROWS}{TRIANGLES}", NO_COUNTS)
    yield from bad_words("off-corners", FIVE + "@ 0 1 2\n", NO_COUNTS)
    yield from [
        good("off-comments", TEXT.replace("\n", " # a\n# b\n")),
        good("off-blank-lines", "\n\n" + TEXT.replace("\n", "\n\n")),
        good("off-counts-behind-keyword", TEXT.replace("OFF\n", "OFF ")),
        good("off-no-edges", TEXT.replace("4 4 6", "4 4")),
        good("off-lower-case", TEXT.replace("OFF", "off")),
        good("off-vertex-colours", TEXT.replace("OFF", "COFF").replace("0.25\n", "0.25 255 0 0 255\n")),
        good("off-vertex-normals", TEXT.replace("OFF", "NOFF").replace("0.25\n", "0.25 0 0 1\n")),
        good("off-everything", TEXT.replace("OFF", "STCNOFF").replace("0.25\n", "0.25 0 0 1 1 1 1 1 0 0\n")),
        good("off-face-colours", TEXT.replace("2 1\n", "2 1 255 0 0\n")),
        good("off-quads", FIVE + "5 0 1 2 3 4\n", points=5, faces=2),
        good("off-no-normals-after-all", TEXT.replace("OFF", "NOFF")),
    ]
    for name, old, new, at, part in [
            ("one-point-more", "4 4 6", "5 4 6", "line 10", "a face should be"),
            ("one-point-less", "4 4 6", "3 4 6", "line 6", "0 corners"),
            ("one-face-more", "4 4 6", "4 5 6", "line 10", "a face should be"),
            ("one-face-less", "4 4 6", "4 3 6", "line 10", "more lines"),
            ("no-faces", f"4 4 6\n{ROWS}{TRIANGLES}", f"4 0 0\n{ROWS}", "line 6", "no faces"),
            ("nothing", f"4 4 6\n{ROWS}{TRIANGLES}", "0 0 0\n", "line 2", "no faces"),
            ("one-count", "4 4 6", "4", "line 2", "missing"),
            ("bad-edges", "4 4 6", "4 4 x", "line 2", '"x"'),
            ("binary", "OFF\n", "OFF BINARY\n", "line 1", "binary"),
            ("two-corners", "3 0 2 1", "2 0 2", "line 7", "2 corners"),
            ("no-corners", "3 0 2 1", "0", "line 7", "0 corners"),
            ("missing-corner", "3 0 2 1", "3 0 2", "line 7", "missing"),
            ("bad-colour", "3 0 2 1", "3 0 2 1 red", "line 7", '"red"'),
            ("two-coordinates", "0 1 0\n", "0 1\n", "line 5", "missing"),
            ("nul", "0 1 0\n", "0 1 0\0\n", "line 5", "NUL"),
            ("long-line", "0 1 0\n", "0 1 0" + " " * 65536 + "\n", "line 5", "64 kB")]:
        yield bad(f"off-{name}", TEXT.replace(old, new), at, part)
    yield bad("off-only-keyword", "OFF\n", "line 1", "number of points")
    yield bad_word("off-cut", f"OFF\n4 4 6\n{ROWS}{TRIANGLES[:-8]}@", "3 2 0", "promises 3")
