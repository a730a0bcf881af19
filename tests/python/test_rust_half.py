"""Tests of the compiled half: Ctrl-C, limits, and messages of errors."""

import subprocess
import sys

import osim_contact_scale as ocs
import pytest
from conftest import HUMAN
from osim_contact_scale import scaling

# No drop of 1e6 s can be followed to its end: the call computes for seconds, and then refuses. Ctrl-C comes meanwhile.
INTERRUPTED = f"""
import os, signal, threading
import osim_contact_scale as ocs
# What a shell starts in the background ignores Ctrl-C, and so would its children.
signal.signal(signal.SIGINT, signal.default_int_handler)
threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    ocs.drop_test({str(HUMAN)!r}, height="x0.25", duration=1e6)
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C goes to all programs of a console there")
def test_ctrl_c_is_not_lost_when_an_error_is_on_its_way():
    ran = subprocess.run([sys.executable, "-c", INTERRUPTED], capture_output=True, text=True)
    assert ran.stdout == "interrupted\n", ran.stderr


@pytest.mark.parametrize("mass", [10**30, 10**400, -(10**30)])
def test_a_whole_number_that_is_too_large_names_its_keyword(mass):
    with pytest.raises(ocs.RequestError, match=r"^target_mass: a whole number is too large") as caught:
        ocs.rescale(HUMAN, target_mass=mass)
    assert caught.value.keyword == "target_mass"


@pytest.mark.parametrize("keyword", ["report", "summary"])
def test_a_name_that_ends_wrongly_is_a_wrong_call(tmp_path, keyword):
    with pytest.raises(ocs.RequestError, match=f"^{keyword}='.*': expected") as caught:
        ocs.many("rescale", [HUMAN], target_mass=80, output_dir=tmp_path, **{keyword: tmp_path / "x.pdf"})
    assert caught.value.keyword == keyword


@pytest.mark.parametrize(
    ("keyword", "value", "words"),
    [
        ("target_mass", [5, 6], r"target_mass=\[5, 6\]: a list, expected one number"),
        ("target_mass", True, "expected a number or a text"),
        ("body_scale_file", "", "it is empty, expected the name of a file"),
    ],
)
def test_messages_name_expected_types_in_plain_words(keyword, value, words):
    with pytest.raises(ocs.RequestError, match=words) as caught:
        ocs.rescale(HUMAN, **{"target_mass": 80, keyword: value})
    assert caught.value.keyword == keyword


def test_a_set_without_a_property_explains_how_to_give_one():
    with pytest.raises(ocs.RequestError, match=r'say what to set, as in ocs\.set\("model\.osim", stiffness="x2"\)'):
        ocs.set(HUMAN)


# 1 m at 2400 pixels to the inch would take 45 GB.
def test_a_picture_of_too_many_pixels_is_refused():
    figure = ocs.plot("drop", HUMAN, dpi=2400, width=1000)
    with pytest.raises(ocs.ContactScaleError, match=r"94500 × .* pixels are more than .* say a smaller dpi or width"):
        figure.to_png()


@pytest.mark.parametrize("count", [10_001, 10**8, 10**11, 10**400, -1])
def test_a_ladder_has_a_number_of_steps_that_somebody_may_run(count):
    with pytest.raises(ocs.RequestError, match="expected a whole number from 2 to 10000") as caught:
        scaling.continuation_steps(first=1.0, last=10.0, count=count)
    assert caught.value.keyword == "count"
    assert len(scaling.continuation_steps(first=1.0, last=10.0, count=10_000).modulus_factor) == 10_000
