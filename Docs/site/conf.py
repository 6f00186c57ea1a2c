"""Sphinx's settings. Docs/site/build.py runs it on what Docs/site/pages.py has written."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
root = pathlib.Path(__file__).resolve().parents[2]

project = "Cutwater"
copyright = "the authors of Cutwater"
release = re.search(r"VERSION (\S+)", (root / "CMakeLists.txt").read_text().split("project(")[1])[1]

extensions = ["myst_parser", "breathe", "mathml", "paragraphs", "searchorder"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
breathe_default_project = "cutwater"
breathe_domain_by_extension = {"hpp": "cpp", "h": "cpp"}
breathe_show_include = False
primary_domain = "cpp"
highlight_language = "none"
html_math_renderer = "mathml"

html_theme = "furo"
html_title = f"Cutwater {release}"
html_copy_source = False
html_static_path = ["static"]
html_css_files = ["site.css"]
