"""Links of the book to files outside of docs/: these files come into it, too. A hook of MkDocs; mkdocs.yml names it.

On GitHub and in the archive, the pages of docs/ lie beside the rest of the project. The book is made of docs/ alone. So what
they or the navigation link to (README.md, the changelog, schemas, tables) is added as `project/PATH`, and links lead there. Links of these
added pages to files that are not in the book become plain text.
"""

import posixpath
import re
from pathlib import Path

from mkdocs.structure.files import File

TOP = Path(__file__).resolve().parent.parent
OUTSIDE = "project/"

#: `[text](path)` and `[text](path#anchor)`, not addresses and not anchors of the page itself.
LINK = re.compile(r"(?P<text>\[[^\[\]]*\])\((?P<path>[^\s():#]+)(?P<anchor>#[^\s()]*)?\)")


def in_project(page):
    """The path of a page's source, from the top folder."""
    return page.removeprefix(OUTSIDE) if page.startswith(OUTSIDE) else f"docs/{page}"


def in_book(path):
    """The path in the book of a file of the project."""
    return path.removeprefix("docs/") if path.startswith("docs/") else OUTSIDE + path


def target(link, page):
    """The file that a link of a page leads to, from the top folder."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(in_project(page)), link["path"]))


def on_files(files, config):
    """Adds every file outside of docs/ that the navigation or a page of docs/ links to."""
    linked = [in_project(name) for name in pages_in_nav(config.nav) if name.startswith(OUTSIDE)]
    for page in files.documentation_pages():
        linked += [target(link, page.src_uri) for link in LINK.finditer(page.content_string)]
    for path in linked:
        name = in_book(path)
        if name.startswith(OUTSIDE) and (TOP / path).is_file() and files.get_file_from_path(name) is None:
            files.append(File.generated(config, name, abs_src_path=str(TOP / path)))
    return files


def pages_in_nav(nav):
    """The pages of the navigation, which nests lists and titles."""
    if isinstance(nav, str):
        return [nav]
    parts = nav.values() if isinstance(nav, dict) else nav or []
    return [name for part in parts for name in pages_in_nav(part)]


def on_page_markdown(markdown, page, config, files):
    """Links as they are in the book."""
    here = page.file.src_uri

    def linked(link):
        name = in_book(target(link, here))
        if here.startswith(OUTSIDE) and files.get_file_from_path(name) is None:
            return link["text"].strip("[]")
        return f"{link['text']}({posixpath.relpath(name, posixpath.dirname(here) or '.')}{link['anchor'] or ''})"

    return LINK.sub(linked, markdown)
