"""Reports in a real browser: nothing is loaded, nothing overflows, everything can be read and printed.

    pytest tests/browser                  (with the program built: cargo build --release)
    OSIM_CONTACT_SCALE=path pytest tests/browser

Skipped where Chromium or its driver is not installed. axe-core (dev/install.sh browser) looks for what keeps people with a screen
reader or a keyboard out; that test says so where it is missing.
"""

import os
import pathlib
import shutil
import subprocess

import pytest

from browser import Browser, missing

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(os.environ.get("OSIM_CONTACT_SCALE", ROOT / "target/release/osim-contact-scale"))

pytestmark = pytest.mark.skipif(bool(missing()), reason=f"not installed: {', '.join(missing())}")

PAGES = {
    "rescale.html": "human.osim --target-mass 1190",
    "inspect.html": "inspect human.osim",
    "check.html": "check sunk_in.osim",
    "folder.html": "check library",
    "transfer.html": "transfer library --from falisse2022 --spheres 6 -d out",
    "reference.html": "transfer human.osim --from falisse2022 --spheres 4 --dry-run",
}
WIDTHS = (1920, 1280, 360)
SCHEMES = ("light", "dark")
AXE = pathlib.Path(__file__).parent / "node_modules/axe-core/axe.min.js"

# Contrast of every text with what is painted behind it (WCAG 2: 4.5, or 3 for large text), in closed details too.
CONTRAST = """
const part = c => { c /= 255; return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4 };
const light = ([r, g, b]) => 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
const numbers = text => text.match(/[\\d.]+/g).map(Number);
const behind = e => {
  for (; e; e = e.parentElement) {
    const c = numbers(getComputedStyle(e).backgroundColor);
    if (c.length < 4 || c[3] > 0) return c;
  }
  return matchMedia('(prefers-color-scheme: dark)').matches ? [0, 0, 0] : [255, 255, 255];
};
const bad = [];
for (const e of document.querySelectorAll('body *:not(svg *)')) {
  const own = [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim());
  if (!own || e.closest('svg')) continue;
  const style = getComputedStyle(e);
  const [a, b] = [light(numbers(style.color)), light(behind(e))].sort((x, y) => y - x);
  const size = parseFloat(style.fontSize);
  const large = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
  const contrast = (a + 0.05) / (b + 0.05);
  if (contrast < (large ? 3 : 4.5)) bad.push(`${e.tagName} ${e.textContent.trim().slice(0, 30)}: ${contrast.toFixed(2)}`);
}
return bad;
"""

# Contrast of what is drawn in plots with what is behind it: 4.5 for text, 3 for lines and dots. What is as light as the ground
# covers something, and what lets light through is a shade.
PLOTS = CONTRAST.split("const bad")[0] + """
const bad = new Set();
const ratio = (colour, ground) => {
  const [a, b] = [light(numbers(colour)), light(ground)].sort((x, y) => y - x);
  return (a + 0.05) / (b + 0.05);
};
for (const e of document.querySelectorAll('.plot svg *')) {
  const style = getComputedStyle(e), ground = behind(e.closest('.plot'));
  if (['title', 'desc', 'g'].includes(e.tagName)) continue;
  for (const [name, share] of [['fill', style.fillOpacity], ['stroke', style.strokeOpacity]]) {
    const colour = style[name];
    if (!/^rgb/.test(colour) || share < 1 || style.opacity < 1 || (name === 'stroke' && e.tagName === 'text')) continue;
    const contrast = ratio(colour, ground);
    if (contrast > 1.01 && contrast < (e.tagName === 'text' ? 4.5 : 3)) bad.add(`${e.tagName} ${name} ${colour}: ${contrast.toFixed(2)}`);
  }
}
const svg = document.querySelector('.plot svg rect');
if (svg && ratio(getComputedStyle(svg).fill, behind(svg.closest('.plot'))) > 1.01) bad.add('the ground of a plot is not that of the page');
return [...bad];
"""

# Tables that are wider than the box that would cut them on paper.
CUT = """
return [...document.querySelectorAll('.wide, .plot')]
  .filter(box => box.checkVisibility() && box.scrollWidth > box.clientWidth + 1).map(box => box.ariaLabel || box.className);
"""

# Boxes that stick out of the window and are not inside a box that scrolls.
OVERFLOW = """
const out = [];
for (const e of document.querySelectorAll('main *, header *, nav *')) {
  const box = e.getBoundingClientRect();
  if (box.width && box.right > innerWidth + 1 && !e.closest('.wide') && !e.closest('svg')) out.push(e.tagName + ' ' + e.className);
}
return out;
"""

# Neighbours in the flow that lie on each other.
OVERLAP = """
const out = [];
for (const parent of document.querySelectorAll('main, section, .model, .plots, .findings, dl, .explained')) {
  const boxes = [...parent.children].map(e => [e, e.getBoundingClientRect()]).filter(([, b]) => b.width && b.height);
  for (let i = 0; i < boxes.length; i++) for (let j = i + 1; j < boxes.length; j++) {
    const [a, b] = [boxes[i][1], boxes[j][1]];
    const [w, h] = [Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)];
    if (w > 1 && h > 1) out.push(boxes[i][0].tagName + ' on ' + boxes[j][0].tagName);
  }
}
return out;
"""


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """A folder with one page of each kind."""
    folder = tmp_path_factory.mktemp("pages")
    fixtures = ROOT / "fixtures"
    shutil.copy(fixtures / "table1/human_62kg_smooth_sphere.osim", folder / "human.osim")
    shutil.copy(fixtures / "check/sunk_in.osim", folder)
    (folder / "library").mkdir()
    # Up to 20 models are open on paper. One cannot be read.
    checked = sorted((fixtures / "check").glob("*.osim"))[:11]
    for model in [*(fixtures / "table1").glob("*_smooth_sphere.osim"), *checked, fixtures / "bad/truncated.osim"]:
        shutil.copy(model, folder / "library")
    for page, call in PAGES.items():
        ran = subprocess.run([PROGRAM, *call.split(), "--report", page], cwd=folder, capture_output=True, text=True)
        assert ran.returncode in (0, 1), ran.stderr
    return folder


@pytest.fixture(scope="module")
def browser():
    with Browser() as browser:
        yield browser


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("page", PAGES)
def test_page(browser, pages, page, scheme):
    browser.open(pages / page, WIDTHS[0], scheme)
    assert browser.logs("browser") == []
    assert browser.requests() == [(pages / page).resolve().as_uri()], "nothing but the page itself is loaded"
    browser.run("for (const d of document.querySelectorAll('details')) d.open = true")
    for width in WIDTHS:
        browser.resize(width)
        scroll, inner = browser.run("return [document.documentElement.scrollWidth, innerWidth]")
        assert scroll <= inner == width
        assert browser.run(OVERFLOW) == [], width
        assert browser.run(OVERLAP) == [], width
    assert browser.run(CONTRAST) == []
    assert browser.run(PLOTS) == []
    dark = browser.run("return getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)"
    assert dark == (scheme == "dark")


@pytest.mark.skipif(not AXE.exists(), reason="axe-core is not installed: dev/install.sh browser")
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("page", PAGES)
def test_axe_finds_nothing(browser, pages, page, scheme):
    browser.open(pages / page, 1280, scheme)
    # The other details are like the first two, and would take the most time.
    browser.run("document.querySelectorAll('details').forEach((d, index) => { d.open = index < 2 })")
    browser.run(AXE.read_text(encoding="utf-8") + ";window.axe = axe")
    found = browser.run_async(
        "axe.run({resultTypes: ['violations']}).then(found => done(found.violations.map("
        "v => [v.id, v.help, v.nodes.length, v.nodes[0].html.slice(0, 200)])), error => done(String(error)))"
    )
    assert found == []


@pytest.mark.parametrize("page", PAGES)
def test_what_is_on_it(browser, pages, page):
    browser.open(pages / page, 1280, "light")
    levels = browser.run("return [...document.querySelectorAll('h1,h2,h3,h4,h5,h6')].map(h => +h.tagName[1])")
    assert levels[0] == 1 and levels.count(1) == 1
    assert all(after <= before + 1 for before, after in zip(levels, levels[1:]))
    assert browser.run("return document.querySelectorAll('.findings li .tag').length") > 0
    first = browser.run("return document.querySelector('main section').id")
    assert first == "glance", "counts come first"
    assert browser.run("return [...document.querySelectorAll('figure svg')].every(s => s.querySelector('title').textContent)")
    assert browser.run("return document.querySelectorAll('figure svg').length") >= 3
    assert browser.run("return [...document.querySelectorAll('table')].every(t => t.caption && t.caption.textContent)")
    assert browser.run("return document.documentElement.lang") == "en"
    assert browser.run("return ['header', 'nav', 'main'].every(name => document.querySelectorAll(name).length === 1)")


def test_keyboard(browser, pages):
    """The first key leads past the contents; the element with the focus is visible; the box of a table can be scrolled with keys."""
    browser.open(pages / "rescale.html", 400, "light")
    for kind in ("rawKeyDown", "keyUp"):
        browser.protocol("Input.dispatchKeyEvent", type=kind, key="Tab", code="Tab", windowsVirtualKeyCode=9)
    focus = "const e = document.activeElement, b = e.getBoundingClientRect();"
    assert browser.run(focus + "return e.className") == "skip"
    assert browser.run(focus + "return b.left >= 0 && b.top >= 0 && getComputedStyle(e).outlineStyle") == "solid"
    boxes = browser.run("return [...document.querySelectorAll('.wide')].every(b => b.tabIndex === 0 && b.ariaLabel)")
    assert boxes


def test_a_link_opens_the_model_it_leads_to(browser, pages):
    browser.open(pages / "folder.html", 1280, "light")
    browser.run("document.querySelector('#models tbody a').click()")
    assert browser.run("return document.querySelectorAll('details[open]').length") == 1


def test_failures_come_before_everything_else(browser, pages):
    browser.open(pages / "transfer.html", 1280, "light")
    titles = browser.run("return [...document.querySelectorAll('main h2, main h3')].map(h => h.textContent)")
    assert titles[:2] == ["At a glance", "Failed models"]


def test_a_table_that_scrolls_says_so(browser, pages):
    """A shadow marks the edge beyond which a table continues; names of files are broken at folders."""
    browser.open(pages / "transfer.html", 360, "light")
    box = "const box = [...document.querySelectorAll('.wide')].find(b => b.scrollWidth > b.clientWidth + 1);"
    assert "radial-gradient" in browser.run(box + "return getComputedStyle(box).backgroundImage")
    assert browser.run("return document.querySelectorAll('th[scope=row] wbr').length") > 0


@pytest.mark.parametrize("page", PAGES)
def test_paper(browser, pages, page):
    """Nothing is cut at the width of A4, in light colours whatever the screen has."""
    browser.open(pages / page, 680, "light")
    browser.media("print", "dark")
    assert browser.run(CUT) == []
    assert browser.run("return getComputedStyle(document.documentElement).getPropertyValue('--back').trim()") == "#fff"
    assert browser.run("return getComputedStyle(document.querySelector('thead')).display") == "table-header-group"
    for kept in ("tr", "figure"):
        script = f"return getComputedStyle(document.querySelector('{kept}')).breakInside"
        assert browser.run(script) == "avoid"
    assert browser.run(PLOTS) == []


@pytest.mark.parametrize("page", PAGES)
def test_print(browser, pages, page):
    browser.open(pages / page, 1280, "dark")
    pdf = browser.print()
    assert pdf.startswith(b"%PDF-")
    (pages / page).with_suffix(".pdf").write_bytes(pdf)
    if shutil.which("pdftotext") is None:
        pytest.skip("pdftotext is not installed: what is on paper was not read")
    text = subprocess.run(["pdftotext", "-", "-"], input=pdf, capture_output=True, check=True).stdout.decode()
    # Closed details are open on paper, and the contents, which lead nowhere there, are gone.
    assert "Load, indentation and restitution of the spheres" in text and "Skip to the content" not in text
    assert "restitution" in text
