import struct

from cases import FACES, NO_COORDINATES, NUMBERS, POINTS, bad, bad_word, bad_words, good, layouts


def facet(corners, normal="0 0 1"):
    rows = "".join(f"   vertex {' '.join(corner)}\n" for corner in corners)
    return f" facet normal {normal}\n  outer loop\n{rows}  endloop\n endfacet\n"


FACETS = "".join(facet([POINTS[i] for i in face]) for face in FACES)
ASCII = f"solid hull\n{FACETS}endsolid hull\n"
ONE = facet([("0", "0", "0"), ("1", "0", "0"), ("0", "@", "0")])
BEHIND = "solid a\n" + facet(POINTS[:3])


def binary(header=b"", count=None, triangles=FACES, attribute=0):
    content = header.ljust(80, b"\0") + struct.pack("<I", len(triangles) if count is None else count)
    for face in triangles:
        content += struct.pack("<12fH", 0, 0, 1, *(x for i in face for x in NUMBERS[i]), attribute)
    return content


def with_float(number, at):
    content = bytearray(binary())
    struct.pack_into("<f", content, at, number)
    return bytes(content)


def ascii_cases():
    yield from layouts("stl-ascii", ASCII)
    yield from bad_words("stl-ascii-coordinate", BEHIND + ONE, NO_COORDINATES)
    yield good("stl-ascii-upper-case", ASCII.upper())
    yield good("stl-ascii-blank-lines", ASCII.replace("\n", "\n\n"))
    yield good("stl-ascii-tabs", "solid a\n" + FACETS.replace(" ", "\t"))
    yield good("stl-ascii-one-line", "solid a\n" + FACETS.replace("\n", " "))
    yield good("stl-ascii-no-endsolid", "solid a\n" + FACETS)
    yield good("stl-ascii-no-name", ASCII.replace(" hull", ""))
    yield good("stl-ascii-plus-signs", ASCII.replace("1.5", "+1.5e+00"))
    yield good("stl-ascii-negative-zero", ASCII.replace("vertex 0", "vertex -0"))
    yield good("stl-ascii-nan-normals", ASCII.replace("normal 0 0 1", "normal nan -nan(ind) 1.#QNAN"))
    yield good("stl-ascii-several-solids", ASCII + ASCII.replace("hull", "left rudder") + ASCII,
               faces=12, patches=2)
    yield good("stl-ascii-name-is-a-keyword", "solid facet normal\n" + FACETS)
    yield good("stl-ascii-zero-area", BEHIND + ONE.replace("@", "0"), points=4, faces=2)
    yield good("stl-ascii-extreme-numbers", ASCII.replace("1.5", "1e308").replace("0.25", "1e-308"))
    line = "line 15"
    for name, old, new, part in [
            ("two-vertices", "   vertex 1 0 0\n", "", "2 vertices"),
            ("four-vertices", "vertex 1 0 0\n", "vertex 1 0 0\nvertex 1 0 0\n", "4 vertices"),
            ("two-coordinates", "vertex 1 0 0", "vertex 1 0", "missing"),
            ("four-coordinates", "vertex 1 0 0", "vertex 1 0 0 0", "expected"),
            ("no-normal", " normal 0 0 1", "", "normal"),
            ("short-normal", "normal 0 0 1", "normal 0 0", "missing"),
            ("bad-normal", "normal 0 0 1", "normal 0 z 1", '"z"'),
            ("no-loop", "outer loop", "outer", '"loop"'),
            ("bad-word", "  endloop", "  endlop", '"endlop"'),
            ("no-endfacet", " endfacet\n", "", "endfacet"),
            ("nul", "vertex 1", "vertex \0 1", "NUL"),
            ("long-line", "vertex 1", "vertex" + " " * 65536 + "1", "64 kB")]:
        yield bad(f"stl-ascii-{name}", (BEHIND + ONE.replace("@", "1")).replace(old, new), "", part)
    yield bad("stl-ascii-facet-behind-endsolid", ASCII + FACETS, "line 31", '"facet"')
    yield bad("stl-ascii-text-behind-endsolid", ASCII + "end\n", "line 31", '"end"')
    yield bad("stl-ascii-no-facets", "solid a\nendsolid a\n", "line 2", "no faces")
    yield bad("stl-ascii-only-solid", "solid", "", "no faces")
    yield bad_word("stl-ascii-cut-in-a-facet", BEHIND + " @", "facet normal 0 0 1", "too early")
    yield bad_word("stl-ascii-decimal-commas", "solid a\n" + facet([("0,0", "0", "0")]).replace(
        "vertex", "vertex @"), "", '"0,0"')


def binary_cases():
    whole = binary()
    yield good("stl-binary", whole)
    for name, header in [("solid", b"solid hull"), ("facet", b"solid facet normal 0 0 1"),
                         ("text", b"exported by a program, 80 columns of it".ljust(80)),
                         ("lines", b"solid a\nfacet normal 0 0 1\nouter loop\n"),
                         ("color", b"COLOR=\xff\x00\x00\xff"), ("noise", bytes(range(128, 208)))]:
        yield good(f"stl-binary-header-{name}", binary(header))
        if name == "lines":  # only what is wrong with it as text can be said
            yield bad("stl-binary-header-lines-cut", binary(header)[:-1], "line 4", "NUL")
            continue
        yield bad(f"stl-binary-header-{name}-cut", binary(header)[:-1], "byte 80", "cut off")
        yield bad(f"stl-binary-header-{name}-count-more", binary(header, 5), "byte 80", "promises 5")
        yield bad(f"stl-binary-header-{name}-count-less", binary(header, 3), "byte 80", "holds 4")
    yield good("stl-binary-attributes", binary(attribute=0x7fff))
    yield good("stl-binary-bytes-behind", whole + b"tail")
    yield good("stl-binary-49-bytes-behind", whole + bytes(49))
    yield bad("stl-binary-50-bytes-behind", whole + bytes(50), "byte 80", "holds 5")
    yield bad("stl-binary-100-bytes-behind", whole + bytes(100), "byte 80", "holds 6")
    yield bad("stl-binary-no-triangles", binary(triangles=[]), "byte 80", "0 triangles")
    yield bad("stl-binary-count-zero", binary(count=0), "byte 80", "0 triangles")
    for count in (100, 2**31 - 1, 2**31, 2**32 - 1):
        yield bad(f"stl-binary-count-{count}", binary(count=count), "byte 80", f"promises {count}")
    for size in (84, 85, 133, 134, 184, 283):
        part = "promises 4" if size < 283 else "cut off"
        yield bad(f"stl-binary-cut-to-{size}", whole[:size], "byte 80", part)
    for size in (1, 79, 83):
        yield bad(f"stl-binary-cut-to-{size}", whole[:size], "byte 0", f"too short: {size} of the 84 bytes")
    for name, number in [("nan", float("nan")), ("inf", float("inf")), ("minus-inf", float("-inf"))]:
        yield bad(f"stl-binary-{name}", with_float(number, 84 + 150 + 44), "byte 234", "not finite")
        yield good(f"stl-binary-normal-{name}", with_float(number, 84))


def cases():
    return [*ascii_cases(), *binary_cases()]
