"""A Sphinx extension: the search lists template and function parameters after what they belong to."""
from sphinx.domains.cpp import CPPDomain

LAST = 2  # Sphinx's number for objects that matter little
PARAMETERS = {"templateParam", "functionParam"}


class Domain(CPPDomain):
    def get_objects(self):
        for name, shown, kind, page, anchor, priority in super().get_objects():
            yield name, shown, kind, page, anchor, LAST if kind in PARAMETERS else priority


def setup(app):
    app.add_domain(Domain, override=True)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
