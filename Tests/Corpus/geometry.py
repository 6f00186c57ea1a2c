"""Geometry files, damaged: as accidents do it, and with checksums made good as a forger would."""
import itertools
import struct

from cases import Case

MASK = (1 << 64) - 1
P1, P2, P3, P4, P5 = (0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9, 0x85EBCA77C2B2AE63,
                      0x27D4EB2F165667C5)


def rotl(x, bits):
    return (x << bits | x >> 64 - bits) & MASK


def mixed(state, word):
    return rotl((state + word * P2) & MASK, 31) * P1 & MASK


def xxh64(data):
    """XXH64 with seed 0, by its specification (Collet 2012)."""
    at = 0
    if len(data) >= 32:
        lanes = [P1 + P2 & MASK, P2, 0, -P1 & MASK]
        for at in range(0, len(data) - 31, 32):
            lanes = [mixed(lane, word) for lane, word in zip(lanes, struct.unpack_from("<4Q", data, at))]
        at += 32
        state = sum(rotl(lane, bits) for lane, bits in zip(lanes, (1, 7, 12, 18))) & MASK
        for lane in lanes:
            state = ((state ^ mixed(0, lane)) * P1 + P4) & MASK
    else:
        state = P5
    state = state + len(data) & MASK
    while at + 8 <= len(data):
        state = (rotl(state ^ mixed(0, struct.unpack_from("<Q", data, at)[0]), 27) * P1 + P4) & MASK
        at += 8
    if at + 4 <= len(data):
        state = (rotl(state ^ struct.unpack_from("<I", data, at)[0] * P1 & MASK, 23) * P2 + P3) & MASK
        at += 4
    for byte in data[at:]:
        state = rotl(state ^ byte * P5 & MASK, 11) * P1 & MASK
    state = (state ^ state >> 33) * P2 & MASK
    state = (state ^ state >> 29) * P3 & MASK
    return state ^ state >> 32


def made_good(content):
    """With the checksums of what it is now; of up to 2^20 bytes of arrays."""
    content = bytearray(content)
    header, = struct.unpack_from("<Q", content, 24)
    struct.pack_into("<Q", content, 48, xxh64(struct.pack("<Q", xxh64(bytes(content[header:])))))
    struct.pack_into("<Q", content, header - 8, xxh64(bytes(content[:header - 8])))
    return bytes(content)


def changed(content, at, form, number):
    content = bytearray(content)
    struct.pack_into(form, content, at, number)
    return bytes(content)


def damaged(name, content):
    header, = struct.unpack_from("<Q", content, 24)
    double = name.endswith("double")
    other = "float" if double else "double"
    assert made_good(content) == content, "the checksums as the library computes them"

    def bad(kind, broken, part=""):
        return Case(f"geometry-{name}-{kind}", broken, "File", "", part, reader=f"geometry-{'double' if double else 'float'}")

    yield bad("empty", b"", "nothing")
    for size in (1, 8, 24, 63, 64, 100, header - 1, header, header + 1, len(content) - 64, len(content) - 1):
        yield bad(f"cut-to-{size}", content[:size])
    yield bad("longer", content + bytes(64), "longer than its header")
    yield bad("zeros", bytes(len(content)), "")
    yield bad("magic", b"\x89cutwat" + content[7:])
    (own,) = struct.unpack_from("<I", content, 8)
    for version in (own - 1, own + 1):
        yield bad(f"version-{version}", changed(content, 8, "<I", version), f"version {version}")
    yield bad("byte-order", changed(content, 12, ">I", 0x01020304), "byte order")
    yield bad("text-mode", content.replace(b"\n", b"\r\n") + b"\r\n")
    for at in (24, 32, 48, header - 8, header, len(content) - 200):
        yield bad(f"bit-of-{at}", changed(content, at, "<B", content[at] ^ 16))
    # Offset, count and element size of the first arrays, each out of all bounds.
    for array, word, number in itertools.product(range(3), range(3), (1, 2**32, 2**61, 2**63, 2**64 - 1)):
        at = 64 + 8 * (3 * array + word)
        yield bad(f"forged-{array}-{word}-{number:x}", made_good(changed(content, at, "<Q", number)))
    yield Case(f"geometry-{name}", content, reader=f"geometry-{'double' if double else 'float'}", faces=12 if "closed" in name else 10)
    yield Case(f"geometry-{name}-as-{other}", content, "File", "", f"of {'double' if double else 'single'} precision",
               reader=f"geometry-{other}")


def cases(paths):
    return [case for path in paths for case in damaged(path.name, path.read_bytes())]
