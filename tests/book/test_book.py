"""The book in target/book, which `python -m mkdocs build --strict` has made: complete, read as meant, and good without a network.

    pytest tests/book

That every link and every anchor leads somewhere is what `--strict` says.
"""

import ast
import html
import json
import re
import sys
import time
from pathlib import Path

import pytest

TOP = Path(__file__).resolve().parents[2]
BOOK = TOP / "target" / "book"
PACKAGE = TOP / "python" / "osim_contact_scale"

sys.path[:0] = [str(TOP / "tests" / "browser"), str(TOP / "dev")]
import decision_chart  # noqa: E402
from browser import Browser, missing  # noqa: E402

if not (BOOK / "index.html").is_file():
    pytest.exit("there is no book in target/book: dev/install.sh book, then target/book-venv/bin/python -m mkdocs build --strict", 2)

PAGES = sorted(BOOK.rglob("*.html"))


def public(module):
    """The names that a module lists in `__all__`."""
    tree = ast.parse((PACKAGE / module).read_text(encoding="utf-8"))
    (names,) = (node.value for node in tree.body if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
    return ast.literal_eval(names)


def functions(module):
    """The public functions of a module, with their keywords."""
    tree = ast.parse((PACKAGE / module).read_text(encoding="utf-8"))
    nodes = [node for node in tree.body if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")]
    return [(node.name, [each.arg for each in node.args.kwonlyargs]) for node in nodes]


def text_of(page):
    """The article of a page without what is code in it."""
    page = page.read_text(encoding="utf-8").split("<article", 1)[1].split("</article>", 1)[0]
    return re.sub(r"<(pre|code)\b.*?</\1>", "", page, flags=re.S)


def entry(name):
    """The entry of a public name in the reference, up to the next one."""
    page = (BOOK / "reference" / "api.html").read_text(encoding="utf-8")
    match = re.search(rf'<h\d id="osim_contact_scale\.{re.escape(name)}".*?(?=<h[1-4] id=|</article>)', page, re.S)
    assert match, f"docs/reference/api.md has no {name}"
    return match[0]


@pytest.mark.parametrize("name", [*public("__init__.py"), *(f"scaling.{name}" for name in public("scaling.py"))])
def test_every_public_name_is_in_the_reference(name):
    # The title, what it is called with, and at least a sentence.
    said = re.sub(r"<[^>]*>", "", re.sub(r"<(h\d|pre)\b.*?</\1>", "", entry(name), flags=re.S))
    assert len(said.split()) >= 3, said


@pytest.mark.parametrize("module, prefix", [("_verbs.py", ""), ("scaling.py", "scaling.")])
def test_every_keyword_has_a_row_in_the_table_of_its_function(module, prefix):
    for name, keywords in functions(module):
        rows = re.findall(r'<tr class="doc-section-item">\s*<td>\s*<code>(\w+)</code>', entry(prefix + name))
        assert set(keywords) <= set(rows), name


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(BOOK).as_posix())
def test_markdown_is_read_as_on_github(page):
    if page.name == "404.html":
        return
    text = text_of(page)
    for mark in ("```", "](", ":::", "------", ":func:", ":class:", ":meth:", ":mod:"):
        assert mark not in text, mark
    # Lines of a list that ended in a paragraph; on GitHub they are a list without an empty line before them, too.
    assert not re.search(r"<p>[^<]*\n *(- |\* |\d+\. )", text)


def test_the_chart_is_drawn_from_the_list_beside_it():
    lines = (TOP / "docs" / "README.md").read_text(encoding="utf-8").splitlines()
    # Every case of the list is in the chart; none has another form than the others.
    cases = decision_chart.cases("\n".join(lines))
    assert sum(len(leaves) for _, leaves in cases) == sum(line.startswith("    - ") for line in lines)
    # Its letters are 0.6 of 13 pixels wide, and the box ends 12 before the page.
    room = (decision_chart.PAGE - decision_chart.CALL - 20) / 7.8
    assert all(len(call) <= room for _, leaves in cases for _, call, _ in leaves)
    known = (TOP / "docs" / "chart.svg").read_text(encoding="utf-8")
    assert known == decision_chart.chart(), "draw it again: python3 dev/decision_chart.py"


def test_tabs_hold_the_same_step_three_times():
    page = (BOOK / "tutorial.html").read_text(encoding="utf-8")
    sets = re.findall(r'<div class="tabbed-labels">(.*?)</div>', page, re.S)
    labels = [re.findall(r"<label[^>]*>(?:<a[^>]*>)?([^<]+)", each) for each in sets]
    assert len(labels) >= 5 and all(each == ["The page", "The terminal", "Python"] for each in labels), labels
    assert "<!-- tabs -->" not in page


def test_figures_and_terms_are_found():
    index = json.loads((BOOK / "search" / "search_index.json").read_text(encoding="utf-8"))
    pages = {entry["location"].split("#")[0] for entry in index["docs"] if "dissipation" in entry["text"]}
    assert {"reference/api.html", "reference/equations.html", "python.html", "project/index.html"} <= pages


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(BOOK).as_posix())
def test_nothing_is_loaded_from_elsewhere(page):
    text = page.read_text(encoding="utf-8")
    loaded = re.findall(r'<(?:script|img|iframe|source|link)\b[^>]*?\b(?:src|href)="([^"]*)"', text)
    elsewhere = [html.unescape(address) for address in loaded if re.match(r"(https?:)?//", address)]
    assert loaded and not elsewhere


@pytest.mark.skipif(bool(missing()), reason=f"not installed: {', '.join(missing())}")
def test_search_works_from_the_disk():
    with Browser() as browser:
        browser.open(BOOK / "index.html", 1280, "light")
        browser.run(
            "document.querySelector('#__search').click();"
            "const field = document.querySelector('input[name=query]');"
            "field.focus(); field.value = 'hunt_crossley_smoothing';"
            "for (const kind of ['input', 'keyup']) field.dispatchEvent(new Event(kind, {bubbles: true}));"
        )
        links = "return [...document.querySelectorAll('a.md-search-result__link')].map(link => link.href)"
        until = time.monotonic() + 30
        while not (found := browser.run(links)) and time.monotonic() < until:
            time.sleep(0.1)
        assert any(re.search(r"/api\.html\?.*#osim_contact_scale\.scaling\.hunt_crossley_smoothing$", link) for link in found), found
        assert all(address.startswith(("file:", "data:", "blob:")) for address in browser.requests())
        assert not browser.logs("browser")


def test_fields_of_json_have_what_their_schemas_say():
    page = (BOOK / "reference" / "json.html").read_text(encoding="utf-8")
    assert page.count("<table>") > 40
    assert "largest force of all feet along the normal of the floor" in page
