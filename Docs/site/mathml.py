"""Formulas as MathML, which browsers draw by themselves: no script from elsewhere, no LaTeX."""
from docutils.nodes import SkipNode
from docutils.utils.math.latex2mathml import parse_latex_math


def markup(node, inline):
    root = parse_latex_math(node.astext(), inline=inline)
    return "".join(root.xml())


def visit_math(self, node):
    self.body.append(markup(node, inline=True))
    raise SkipNode


def visit_display(self, node):
    self.body.append(f'<div class="math">{markup(node, inline=False)}</div>')
    raise SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", inline_renderers=(visit_math, None),
                               block_renderers=(visit_display, None))
    return {"parallel_read_safe": True}
