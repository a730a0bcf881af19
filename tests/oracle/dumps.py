"""A model as OpenSim prints it with all defaults, as XML to take objects out of before it is compared."""

import xml.etree.ElementTree as ElementTree

import compare


def parsed(dump):
    """A dump as XML, in which names of elements have no `::`."""
    return ElementTree.fromstring(dump.replace("::", "__"))


def has_note(dump):
    """Whether the credits end with a note."""
    return bool(compare.NOTE.search(parsed(dump).findtext("credits") or ""))


def without_elements(dump, goes):
    """The model without the objects of which `goes(tag, name)` is true, wherever they are, and without a note."""
    model = parsed(dump)
    for parent in list(model.iter()):
        for child in [child for child in parent if goes(child.tag, child.get("name"))]:
            parent.remove(child)
    credit = model.find("credits")
    rest = compare.NOTE.sub("", credit.text or "")
    credit.text = "" if rest == compare.NO_CREDITS else rest
    return ElementTree.canonicalize(ElementTree.tostring(model, encoding="unicode"), strip_text=True)
