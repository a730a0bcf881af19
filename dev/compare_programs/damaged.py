"""Models that were damaged at random, always in the same ways: what no person would think of."""

import random
import re
from collections.abc import Iterator

from calls import Case
from store import Store

COUNT = 320
WHOLE = (
    *("model.osim", "other.osim", "old.osim", "foot.osim"),
    *("materials.osim", "mixed.osim", "v40600.osim", "two_floors.osim"),
)
CALLS = (
    "inspect {m} --format json",
    "check {m} --spheres 2",
    "{m} --target-mass 500 --contacts-mass 70 --diff",
    "transfer {m} --from falisse2022 --spheres 2 --mass 70 --format json",
    "set {m} stiffness=x2 radius=0.05 -o out.osim",
    "design {m} --indentation 0.1 --restitution 0.8 --spheres 2 --mass 70 --diff --dry-run",
    "{m} --target-mass 80 --contacts-mass 62 --level --in-place && {m} --target-mass 70",
)
# How many of the calls each damaged model gets.
EACH = 3
NUMBER = re.compile(r">\s*[-+]?[\d.][^<>]*<")
NAME = re.compile(r'name="[^"]*"')
TAG = re.compile(r"</?\w+")
ODD_NUMBERS = (
    *("", "nan", "-1", "0", "1e400", "1,5", "1 2 3", "3 N"),
    *("0x10", " 5.0e-3\n", "<!-- -->7", "&#53;", "inf", "abc", "1e-320"),
)
ODD_NAMES = ('name=""', 'name="a b"', "name='heel_r'", 'name="&lt;x&gt;"', 'name="heel_l" name="b"', "", 'name="größe"')


def cases(store: Store) -> Iterator[Case]:
    """Damaged models, each with some of the calls."""
    for number in range(COUNT):
        name = f"damaged{number:03}.osim"
        whole = WHOLE[number % len(WHOLE)]
        store.files[name] = damaged(store.read(whole), number)
        for turn in range(EACH):
            call = CALLS[(number + turn * 2 + number // len(CALLS)) % len(CALLS)]
            yield store.case("damaged models", call.replace("{m}", name))


def damaged(data: bytes, seed: int) -> bytes:
    """The model with one to three things wrong."""
    dice = random.Random(seed)
    text = data.decode("latin-1")
    for _ in range(dice.randint(1, 3)):
        text = dice.choice(DAMAGES)(text, dice)
    return text.encode("latin-1", "xmlcharrefreplace")


def without_line(text: str, dice: random.Random) -> str:
    """A line is gone."""
    lines = text.splitlines(keepends=True)
    del lines[dice.randrange(len(lines))]
    return "".join(lines)


def with_line_twice(text: str, dice: random.Random) -> str:
    """A line is there again, perhaps elsewhere."""
    lines = text.splitlines(keepends=True)
    lines.insert(dice.randrange(len(lines)), dice.choice(lines))
    return "".join(lines)


def without_block(text: str, dice: random.Random) -> str:
    """An element with all in it is gone."""
    starts = list(re.finditer(r"<(\w+)[^<>/]*>", text))
    start = dice.choice(starts)
    end = text.find(f"</{start.group(1)}>", start.end())
    return text if end < 0 else text[: start.start()] + text[end + len(start.group(1)) + 3 :]


def cut(text: str, dice: random.Random) -> str:
    """The end is gone."""
    return text[: dice.randrange(len(text) // 2, len(text))]


def odd_byte(text: str, dice: random.Random) -> str:
    """A byte that does not belong there."""
    at = dice.randrange(len(text))
    return text[:at] + dice.choice("<>&\"'/\0\xe9 \t=!") + text[at + dice.randint(0, 1) :]


def odd_number(text: str, dice: random.Random) -> str:
    """A number that is none, or an odd one."""
    return replaced(text, NUMBER, f">{dice.choice(ODD_NUMBERS)}<", dice)


def odd_name(text: str, dice: random.Random) -> str:
    """A name that is none, or an odd one."""
    return replaced(text, NAME, dice.choice(ODD_NAMES), dice)


def other_tag(text: str, dice: random.Random) -> str:
    """A tag that is another one of the file."""
    return replaced(text, TAG, dice.choice(TAG.findall(text)), dice)


def replaced(text: str, pattern: re.Pattern[str], new: str, dice: random.Random) -> str:
    """One of the places that the pattern matches holds `new`."""
    found = list(pattern.finditer(text))
    if not found:
        return text
    match = dice.choice(found)
    return text[: match.start()] + new + text[match.end() :]


DAMAGES = (without_line, with_line_twice, without_block, cut, odd_byte, odd_number, odd_number, odd_name, other_tag)
