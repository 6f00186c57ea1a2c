"""Doxygen's XML of the headers, mended where Breathe and Sphinx would stumble over it."""
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree


def is_surplus(member, is_group):
    """Shown elsewhere: what a group repeats of its classes, where they define members out of line, and
    C's `typedef struct cw_mesh cw_mesh`."""
    definition = member.findtext("definition") or ""
    outer = (member.findtext("qualifiedname") or "").split("::")[:-1]
    in_class = any(word[0].isupper() for word in outer)
    return is_group and in_class or bool(re.fullmatch(r"typedef (struct|enum) (\w+) \2", definition))


def join_lines(para):
    """Breathe takes every end of a line for that of a paragraph; Doxygen leaves those within quotes."""
    for part in para.iter():
        if part.text and part.tag != "verbatim":
            part.text = part.text.replace("\n", " ")
        if part.tail:
            part.tail = part.tail.replace("\n", " ")


def mend(file):
    tree = ElementTree.parse(file)
    compound = tree.getroot().find("compounddef")
    if compound is None:
        return
    for section in compound.findall("sectiondef"):
        for member in section.findall("memberdef"):
            if is_surplus(member, compound.get("kind") == "group"):
                section.remove(member)
            value = member.find("initializer")
            if value is not None and re.match(r"= *\{ *\.", "".join(value.itertext())):
                member.remove(value)  # designated initializers, which Sphinx 5 does not know
    for para in compound.iter("para"):
        join_lines(para)
    tree.write(file, encoding="utf-8", xml_declaration=True)


def run_doxygen(root, folder):
    """Makes FOLDER/doxygen/xml from FOLDER/headers; returns what Doxygen warns of."""
    settings = (root / "Docs/site/Doxyfile").read_text()
    settings += (f'INPUT = "{folder}/headers"\nSTRIP_FROM_PATH = "{folder}/headers"\n'
                 f'OUTPUT_DIRECTORY = "{folder}/doxygen"\n')
    shutil.rmtree(folder / "doxygen", ignore_errors=True)  # of headers that are gone
    (folder / "doxygen").mkdir(parents=True)
    done = subprocess.run(["doxygen", "-"], input=settings, text=True, capture_output=True, check=True)
    for file in (folder / "doxygen/xml").glob("*.xml"):
        if file.name != "index.xml":
            mend(file)
    return [line.replace(f"{folder}/headers/", "") for line in done.stderr.splitlines() if line]
