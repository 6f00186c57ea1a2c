"""What the corpus is made of: a case is a file's bytes and the answer that is due.

Templates of bad text have one "@" where the bad word goes: its line is where the error must be.
"""
import dataclasses


@dataclasses.dataclass
class Case:
    name: str
    content: bytes
    answer: str = "read"  # or an ErrorKind: File, Limit
    at: str = ""          # "line 7", "byte 84"; nothing: not looked at
    part: str = ""        # of the message
    points: int = 0
    faces: int = 0
    patches: int = 1
    reader: str = "surface"  # or "geometry"


def as_bytes(content):
    return content.encode() if isinstance(content, str) else content


def good(name, content, points=4, faces=4, patches=1):
    return Case(name, as_bytes(content), points=points, faces=faces, patches=patches)


def bad(name, content, at, part, answer="File"):
    return Case(name, as_bytes(content), answer, at, part)


def line_of(template):
    return "line %d" % (template[:template.index("@")].count("\n") + 1)


def bad_word(name, template, word, part, at=None):
    return bad(name, template.replace("@", word), at or line_of(template), part)


# What is no finite number, and what the message says of it.
NO_COORDINATES = {
    "nan": "not finite", "NaN": "not finite", "-nan": "not finite", "inf": "not finite",
    "-inf": "not finite", "Infinity": "not finite", "1e400": "out of range", "-1e999": "out of range",
    "1e-400": "out of range", "1,5": '"1,5"', "0x1p3": '"0x1p3"', "abc": '"abc"', "1.2.3": '"1.2.3"',
    "--1": '"--1"', "+-1": '"+-1"', "1e": '"1e"', "1d5": '"1d5"', ".": '"."', "1_000": '"1_000"',
    "\u0661": '"', "1f": '"1f"', "1.#INF": '"1.#INF"',
}

# What is no index of one among five points, counted from 0; "4" would be one.
NO_INDICES = {
    "5": "out of range", "4294967294": "out of range", "4294967295": "out of range",
    "4294967296": "out of range", "4294967297": "out of range", "9223372036854775807": "out of range",
    "9223372036854775808": "out of range", "18446744073709551617": "out of range",
    "-9223372036854775808": "out of range", "-2147483649": "out of range",
    "1.5": '"1.5"', "x": '"x"', "0x1": '"0x1"', "1e0": '"1e0"', "nan": '"nan"',
}

# What is no number of elements; "promises": more than the file has room for.
NO_COUNTS = {
    "-1": "-1", "abc": '"abc"', "1.5": '"1.5"', "1e3": '"1e3"', "0x10": '"0x10"',
    "4294967296": "promises 4294967296", "1000000000000": "promises 1000000000000",
    "9223372036854775807": "promises 9223372036854775807", "9223372036854775808": "out of range",
    "18446744073709551616": "out of range",
}


def bad_words(prefix, template, words):
    return [bad_word(f"{prefix}-{i:02}", template, word, part)
            for i, (word, part) in enumerate(words.items())]


def layouts(name, text, **counts):
    """The same text as different programs would write it."""
    variants = {
        "lf": text, "crlf": text.replace("\n", "\r\n"), "cr": text.replace("\n", "\r"),
        "no-last-line-end": text.rstrip("\n"), "byte-order-mark": "\ufeff" + text,
        "trailing-blanks": text.replace("\n", " \t\n"),
    }
    return [good(f"{name}-{variant}", content, **counts) for variant, content in variants.items()]




# A tetrahedron, as words and as numbers.
POINTS = [("0", "0", "0"), ("1.5", "0", "0"), ("0", "1", "0"), ("0", "0", "0.25")]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
NUMBERS = [tuple(float(word) for word in point) for point in POINTS]
