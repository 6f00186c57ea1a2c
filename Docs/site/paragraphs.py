"""Breathe leaves the formulas of a comment within its paragraphs, where HTML knows no blocks: they are
taken out, and the text around them is as many paragraphs."""
from docutils import nodes

BLOCKS = (nodes.literal_block, nodes.bullet_list, nodes.enumerated_list, nodes.field_list, nodes.table)


def split(paragraph):
    parts = [nodes.paragraph()]
    for child in paragraph.children:
        if isinstance(child, BLOCKS):
            parts += [child, nodes.paragraph()]
        else:
            parts[-1] += child
    return [part for part in parts if isinstance(part, BLOCKS) or part.astext().strip()]


def split_all(app, doctree):
    for paragraph in list(doctree.findall(nodes.paragraph)):
        if any(isinstance(child, BLOCKS) for child in paragraph.children):
            paragraph.replace_self(split(paragraph))


def setup(app):
    app.connect("doctree-read", split_all)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
