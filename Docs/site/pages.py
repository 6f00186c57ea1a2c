"""The site's source: a copy of the repository's pages where they are, so that links between them hold,
and the pages that are made from other things: the front page, one for every example, and the reference."""
import hashlib
import re
import shutil
import xml.etree.ElementTree as ElementTree

from headers import LAYERS, group, introduction, layer, write_if_changed

LANGUAGES = {".hpp": "cpp", ".cpp": "cpp", ".c": "c", ".f90": "fortran", ".toml": "toml"}


def site_links(text):
    """Links to files that are shown as a page lead to that page."""
    text = re.sub(r"(\]\([./]*Examples/\w+/)main\.\w+\)", r"\1README.md)", text)
    text = re.sub(r"(\]\([./]*)README\.md([#)])", r"\1index.md\2", text)
    text = re.sub(r"(\]\([./]*Examples)(/README\.md)?\)", r"\1/index.md)", text)
    return re.sub(r"\]\(([./]*)Bindings/C/cutwater\.h\)", r"](\1Docs/reference/C.md)", text)


def example_page(folder):
    """The example's README, and the code that it is about."""
    parts = [(folder / "README.md").read_text()]
    for file in sorted(folder.iterdir()):
        if file.suffix in LANGUAGES:
            parts.append(f"\n## {file.name}\n\n```{{literalinclude}} {file.name}\n"
                         f":language: {LANGUAGES[file.suffix]}\n```\n")
    return "".join(parts)


def examples_index(text, folders):
    """The page of all examples, which has to lead to each."""
    missing = [folder.name for folder in folders if f"]({folder.name}/README.md)" not in text]
    if missing:
        raise SystemExit(f"Examples/README.md does not mention: {', '.join(missing)}")
    entries = "\n".join(f"{folder.name}/README" for folder in folders)
    return f"{text}\n```{{toctree}}\n:hidden:\n{entries}\n```\n"


def digest(folder):
    """Of all headers as Doxygen read them: Sphinx does not see that they have changed."""
    texts = [file.read_bytes() for file in sorted(folder.rglob("*.h*"))]
    return hashlib.sha256(b"\0".join(texts)).hexdigest()


def layer_page(name, headers, version):
    """A section for each header of a layer, with what it says of itself and all that it declares."""
    heading = LAYERS[name][0].upper() + LAYERS[name][1:]
    lines = [f"% of the headers {version}", f"# {name}", "", heading + ".", ""]
    for path, file in headers.items():
        title = path if "/" not in path else path.split("/", 2)[2].removesuffix(".hpp")
        lines += [f"## {title}", "", "```cpp", f"#include <{path}>", "```", "",
                  introduction(path, file.read_text()), "",
                  f"```{{doxygengroup}} {group(path)}", ":content-only:", ":members:",
                  ":protected-members:", ":undoc-members:", "```", ""]
    return "\n".join(lines)


def reference_index(layers):
    rows = "\n".join(f"- [{name}]({name}.md): {LAYERS[name]}" for name in layers)
    entries = "\n".join(layers)
    return ("# Reference\n\nEvery header that is installed, by layer; what is in `namespace detail` is "
            f"left out.\n\n{rows}\n\n```{{toctree}}\n:hidden:\n{entries}\n```\n")


def declares_something(xml, path):
    file = xml / f"group__{group(path).replace('_', '__')}.xml"
    compound = ElementTree.parse(file).getroot().find("compounddef") if file.exists() else None
    return compound is not None and (compound.find("innerclass") is not None or
                                     compound.find("innernamespace") is not None or
                                     next(compound.iter("memberdef"), None) is not None)


def write_reference(folder, xml, headers):
    unknown = {layer(path) for path in headers} - LAYERS.keys()
    if unknown:
        raise SystemExit(f"Docs/site/headers.py does not describe the layers {sorted(unknown)}")
    shown = {path: file for path, file in headers.items() if declares_something(xml, path)}
    version = digest(xml.parents[1] / "headers")
    layers = [name for name in LAYERS if any(layer(path) == name for path in shown)]
    for name in layers:
        its = {path: file for path, file in shown.items() if layer(path) == name}
        page = layer_page(name, its, version)
        write_if_changed(folder / f"{name}.md", page)
    write_if_changed(folder / "index.md", reference_index(layers))


def write_pages(root, site, xml, headers):
    """Writes the site's source into the folder `site`."""
    front = (root / "README.md").read_text() + "\n" + (root / "Docs/site/contents.md").read_text()
    write_if_changed(site / "index.md", site_links(front))
    for page in [root / "CHANGELOG.md", root / "CONTRIBUTING.md", *(root / "Docs").glob("*.md")]:
        write_if_changed(site / page.relative_to(root), site_links(page.read_text()))
    shutil.copytree(root / "Docs/pictures", site / "Docs/pictures", dirs_exist_ok=True)
    for file in ("LICENSE", "CITATION.cff"):
        shutil.copy2(root / file, site / file)

    folders = sorted(file.parent for file in (root / "Examples").glob("*/README.md"))
    for folder in folders:
        target = site / "Examples" / folder.name
        write_if_changed(target / "README.md", site_links(example_page(folder)))
        for file in folder.iterdir():
            if file.suffix in LANGUAGES:
                shutil.copy2(file, target / file.name)
    text = (root / "Examples/README.md").read_text()
    write_if_changed(site / "Examples/index.md", site_links(examples_index(text, folders)))
    write_reference(site / "Docs/reference", xml, headers)
