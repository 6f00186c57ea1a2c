"""What is no surface, or is one in a gzip file."""
import gzip
import zlib

import obj
import off
import ply
import stl
import vtk
from cases import bad, good

SAMPLES = {
    "stl-ascii": stl.ASCII, "stl-binary": stl.binary(), "obj": obj.TEXT, "off": off.TEXT,
    "ply-ascii": ply.TEXT, "ply-little": ply.binary("little"), "ply-big": ply.binary("big"),
    "vtk-ascii": vtk.OLD, "vtk-ascii-offsets": vtk.NEW, "vtk-binary": vtk.binary(),
    "vtk-binary-offsets": vtk.binary("5.1"),
}


def packed(content):
    return gzip.compress(content.encode() if isinstance(content, str) else content, mtime=0)


def foreign():
    yield bad("empty", "", "", "empty")
    for name, content, part in [
            ("zip", b"PK\x03\x04" + bytes(200), "zip"), ("xz", b"\xfd7zXZ\0" + bytes(200), "xz"),
            ("bzip2", b"BZh91AY&SY" + bytes(200), "bzip2"), ("zstd", b"\x28\xb5\x2f\xfd" + bytes(200), "zstd"),
            ("png", b"\x89PNG\r\n\x1a\n" + bytes(200), "PNG"), ("gltf", b"glTF\2\0\0\0" + bytes(200), "glTF"),
            ("vtp", b"<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"/>\n", "XML"),
            ("step", b"ISO-10303-21;\nHEADER;\n", "STEP"), ("program", b"\x7fELF" + bytes(200), "program"),
            ("geometry", b"\x89Cutwat" + bytes(200), "geometry file")]:
        yield bad(f"foreign-{name}", content, "byte 0", part)
    for name, content in [
            ("prose", "hello, world\n"), ("blanks", " \t\n\n"), ("comment", "# only a comment\n"), ("number", "1 2 3\n"),
            ("json", '{"v": [0, 0, 0]}\n'), ("solidus", "solidus\nfacet normal 0 0 1\n"), ("plyx", "plyx\nformat ascii 1.0\n"),
            ("office", "OFFICE\n1 1 1\n"), ("one-byte", "v"[:0] + "x"), ("nul", "\0"), ("83-nuls", "\0" * 83),
            ("utf-16", "solid a\n".encode("utf-16").decode("latin-1"))]:
        yield bad(f"foreign-{name}", content.encode("latin-1"), "byte 0", "none of")
    yield bad("foreign-84-nuls", bytes(84), "byte 80", "0 triangles")
    yield bad("foreign-noise", bytes((i * 167 + 13) % 256 for i in range(3000)), "byte 80", "promises")


def compressed():
    for name, content in SAMPLES.items():
        whole = packed(content)
        yield good(f"gzip-{name}", whole)
        yield bad(f"gzip-{name}-cut", whole[:-1], "", "truncated")
        yield bad(f"gzip-{name}-half", whole[:len(whole) // 2], "", "truncated")
        yield bad(f"gzip-{name}-checksum", whole[:-6] + bytes([whole[-6] ^ 1]) + whole[-5:], "", "corrupt")
    whole = packed(obj.TEXT)
    for name, content, part in [
            ("header", whole[:5], "truncated"), ("magic", whole[:2], "truncated"), ("tail", whole + b"tail", "behind the gzip"),
            ("method", whole[:2] + b"\7" + whole[3:], "corrupt"), ("block", whole[:10] + b"\xff" + whole[11:], "corrupt"),
            ("in-gzip", packed(whole), "gzip file in a gzip file"), ("of-nothing", packed(b""), "empty"),
            ("of-prose", packed("hello\n"), "none of")]:
        yield bad(f"gzip-{name}", content, "", part)
    middle = obj.TEXT.index("f ")
    yield good("gzip-members", packed(obj.TEXT[:middle]) + packed("") + packed(obj.TEXT[middle:]))
    yield good("gzip-zeros-behind", whole + bytes(512))
    yield good("gzip-of-many-blank-lines", packed(obj.TEXT + "\n" * 1000000))
    # 40 MB in 40 kB; the test's limit is below.
    engine = zlib.compressobj(9, wbits=31)
    bomb = engine.compress(obj.TEXT.encode()) + b"".join(engine.compress(bytes(1 << 20)) for _ in range(40)) + engine.flush()
    yield bad("gzip-bomb", bomb, "", "decompresses to more than the limit", "Limit")


def cases():
    return [*foreign(), *compressed()]
