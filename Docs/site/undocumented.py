"""What is public and has no comment.

A comment holds for its paragraph: for the declarations below it up to the next empty line, so that the
three motions of a solid share one. What it says of a class holds for its constructors, assignments and
comparisons; that of a function also for its overrides. An accessor that returns a private member needs
none beyond the member's name.
"""
import re
import xml.etree.ElementTree as ElementTree

ACCESSOR = re.compile(r"\(\) const( noexcept)? \{ return \*?\w+_(\.\w+(\(\))?)?; \}")
SPECIAL = re.compile(r"~.*|operator(=|==|<=>)")
STANDARD = re.compile(r"begin|end|size|empty|operator(\*|\+\+|\[\])|value_type|difference_type")
ACCESS = re.compile(r"(public|protected|private):|namespace\b")


def has_comment(entity):
    texts = [entity.find(tag) for tag in ("briefdescription", "detaileddescription")]
    return any("".join(text.itertext()).strip() for text in texts if text is not None)


def shares_comment(lines, number):
    """Whether a comment stands above line `number`, in its paragraph."""
    for line in reversed(lines[:number - 1]):
        line = line.strip()
        if not line or ACCESS.match(line):
            return False
        if line.startswith("///") or "///<" in line:
            return True
    return False


def explains_itself(member, owner, line):
    name = member.find("name").text or ""
    return (member.get("kind") == "friend" or member.find("reimplements") is not None or
            "override" in (member.findtext("argsstring") or "").split() or
            name == owner.rpartition("::")[2].split("<")[0] or
            bool(SPECIAL.fullmatch(name) or STANDARD.fullmatch(name)) or bool(ACCESSOR.search(line)))


def entities(compound):
    """(entity, name) of a class, a group or a namespace, and of its members that are not private."""
    owner = compound.findtext("compoundname")
    if compound.get("prot") == "private":
        return
    if compound.get("kind") in ("class", "struct", "union", "concept"):
        yield compound, owner
    for member in compound.iter("memberdef"):
        if member.get("prot") != "private":
            yield member, f"{owner}::{member.findtext('name')}" if compound.get("id")[:5] != "group" \
                else member.findtext("qualifiedname") or member.findtext("name")


def undocumented(xml, headers):
    """Lines `path:line: name` of what has no comment, from Doxygen's folder of XML and the headers as
    Doxygen read them."""
    texts = {path: (headers / path).read_text().splitlines() for path in
             (file.relative_to(headers).as_posix() for file in headers.rglob("*.h*"))}
    found = set()
    for file in xml.glob("*.xml"):
        compound = ElementTree.parse(file).getroot().find("compounddef")
        if compound is None or compound.get("kind") in ("file", "dir", "page", "namespace"):
            continue
        for entity, name in entities(compound):
            location = entity.find("location")
            path, number = location.get("file"), int(location.get("line") or 0)
            if has_comment(entity) or path not in texts:
                continue
            lines = texts[path]
            if shares_comment(lines, number):
                continue
            if entity is not compound and explains_itself(entity, name.rpartition("::")[0], lines[number - 1]):
                continue
            found.add((path, number, name))
    return [f"{path}:{number}: {name}" for path, number, name in sorted(found)]
