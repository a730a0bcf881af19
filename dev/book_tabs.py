"""Tabs of the book: the same steps on the page, in a terminal and in Python, side by side. A hook of MkDocs; mkdocs.yml names it.

In the sources, and so on GitHub and in the archive, they are headings one after another:

    <!-- tabs -->
    #### The page
    ...
    #### Python
    ...
    <!-- end tabs -->

In the book, each heading is a tab of pymdownx.tabbed, which wants `=== "The page"` and its text indented.
"""

import re

TABS = re.compile(r"^<!-- tabs -->\n(?P<tabs>.*?)^<!-- end tabs -->$", re.S | re.M)
HEADING = "#### "
FENCE = "```"


def on_page_markdown(markdown, **_):
    """Headings between the two comments as tabs."""
    return TABS.sub(lambda match: tabbed(match["tabs"]), markdown)


def tabbed(text):
    lines, in_code = [], False
    for line in text.splitlines():
        if line.startswith(FENCE):
            in_code = not in_code
        if line.startswith(HEADING) and not in_code:
            lines += ["", f'=== "{line.removeprefix(HEADING)}"', ""]
        else:
            lines.append(f"    {line}" if line else "")
    return "\n".join(lines).strip("\n") + "\n"
