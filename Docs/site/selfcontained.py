"""Lets a built site stand alone: it must work from any folder, from a disk, and without a server."""
import pathlib
import re
import shutil

SYSTEM = pathlib.Path("/usr/share/javascript")  # what Debian's style sheets call /javascript


def take_along(html):
    """Copies style sheets that others import from the system, and lets these import the copies."""
    for sheet in html.rglob("*.css"):
        text = sheet.read_text()
        for path in set(re.findall(r"url\(/javascript/([^)\"']+)\)", text)):
            copy = sheet.with_name(pathlib.Path(path).name)
            shutil.copyfile(SYSTEM / path, copy)
            text = text.replace(f"url(/javascript/{path})", f"url({copy.name})")
        sheet.write_text(text)


def reaches_outside(html):
    """What the site would load from elsewhere: a line for each reference, with its file."""
    loads = {".css": r"""url\(\s*["']?([^)"']+)|@import\s+["']([^"']+)""",
             ".html": r"""<(?:script|img|source|iframe)\b[^>]*?\bsrc="([^"]+)"|"""
                      r"""<link\b(?=[^>]*\brel="(?:stylesheet|icon|preload)")[^>]*?\bhref="([^"]+)"|"""
                      r"""<a\b[^>]*?\bhref="(/[^"]*|file:[^"]*)\""""}
    found = []
    for file in sorted(html.rglob("*")):
        for match in re.finditer(loads[file.suffix], file.read_text()) if file.suffix in loads else ():
            target = next(group for group in match.groups() if group)
            if re.match(r"/|[a-z]+:", target) and not target.startswith("data:"):
                found.append(f"{file.relative_to(html)}: reaches outside of the site: {target}")
    return found
