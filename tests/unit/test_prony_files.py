"""Files of a user's own: Prony series and measured moduli."""

import numpy as np
import pytest

from softlub.solid.materials.dmta import read_dmta
from softlub.solid.materials.prony import PronySeries
from softlub.solid.materials.prony_file import read_prony

GOOD = "# measured in spring\n# normalised: long_term\nrelaxation_time [s],term\n1e-3,2.5\n\n1e-1,0.4\n"


@pytest.fixture
def written(tmp_path):
    def write(text, encoding="utf-8"):
        path = tmp_path / "table.csv"
        path.write_bytes(text.encode(encoding))
        return path

    return write


def test_a_series_comes_back_as_it_was_written(written):
    assert read_prony(written(GOOD)) == PronySeries((1e-3, 1e-1), (2.5, 0.4), "long_term")


@pytest.mark.parametrize(
    "text",
    [
        GOOD.replace("\n", "\r\n"),
        "\ufeff" + GOOD,
        GOOD.replace("[s]", " [ s ] ").replace(",", " , "),
        "# normalised: long_term\nterm [1],relaxation_time [ms]\n2.5,1\n0.4,100\n",
    ],
    ids=["windows", "byte order mark", "blanks", "other order and unit"],
)
def test_the_same_series_written_otherwise(written, text):
    assert read_prony(written(text)) == PronySeries((1e-3, 1e-1), (2.5, 0.4), "long_term")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", r"table.csv: the file is empty; it needs the header relaxation_time \[s\],term \[1\]"),
        (GOOD.replace("# normalised: long_term\n", ""), "put a line '# normalised: long_term'"),
        (GOOD.replace("long_term", "initial"), '"initial" is unknown; allowed: long_term, instantaneous'),
        (GOOD.replace("long_term", "instantaneous"), "table.csv: .*add up to 2.9"),
        (
            GOOD.replace("relaxation_time [s],", "tau [s],"),
            'line 3: the column "tau" is unknown; .* relaxation_time',
        ),
        (GOOD.replace(",term\n", "\n"), "line 3: the column term is missing"),
        (GOOD.replace("term\n", "term,term\n"), "line 3: a column stands there twice"),
        (GOOD.replace(" [s]", ""), r"relaxation_time has no unit; allowed: s, ms, .* relaxation_time \[s\]"),
        (
            GOOD.replace("[s]", "[min]"),
            'the unit "min" of the column relaxation_time is unknown; allowed: s, ms',
        ),
        (GOOD.replace("term\n", "term [MPa]\n"), 'the unit "MPa" of the column term is unknown; allowed: 1'),
        (GOOD.replace("2.5", "2,5"), "line 4: 3 entries below 2 columns; a decimal comma"),
        (GOOD.replace("2.5", '"2,5"'), 'line 4: term = "2,5" has a decimal comma'),
        (GOOD.replace(",", ";").replace(".", ","), "columns are separated by semicolons"),
        (GOOD.replace(",", "\t"), "columns are separated by tabs"),
        (GOOD.replace("2.5", "nan"), "line 4: term = nan is not finite"),
        (GOOD.replace("2.5", ""), 'line 4: term = "" is no number'),
        (GOOD.replace("2.5", "-2.5"), r"table.csv: PronySeries: terms\[0\] = -2.5 must be at least 0"),
        (GOOD.replace("1e-3", "0"), r"times\[0\] = 0 must be above 0 s"),
        (GOOD.split("1e-3")[0], "no rows below the header of line 3"),
    ],
)
def test_what_is_wrong_with_a_series_is_said(written, text, words):
    with pytest.raises(ValueError, match=words):
        read_prony(written(text))


def test_files_that_are_no_text_or_not_there(written, tmp_path):
    with pytest.raises(ValueError, match="is no text in UTF-8"):
        read_prony(written(GOOD, "utf-16"))
    with pytest.raises(FileNotFoundError, match=r"none.csv: no such file"):
        read_prony(tmp_path / "none.csv")


MODULI = "frequency [Hz],storage_modulus [MPa],loss_modulus [kPa]\n10,4.5,90\n1,4,40\n100,5,200\n1000,6,400\n"


def test_moduli_are_read_in_si_and_sorted(written):
    measured = read_dmta(written(MODULI))
    np.testing.assert_allclose(measured.angular_frequency, 2 * np.pi * np.array([1, 10, 100, 1000]))
    np.testing.assert_allclose(measured.storage, [4e6, 4.5e6, 5e6, 6e6])
    np.testing.assert_allclose(measured.loss, [4e4, 9e4, 2e5, 4e5])
    np.testing.assert_allclose(measured.loss_factor[0], 0.01)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            MODULI.replace("Hz", "1/s"),
            'the unit "1/s" of the column frequency is unknown; allowed: rad/s, Hz',
        ),
        (MODULI.replace(",90", ",0"), "loss_modulus = 0 in row 1 must be above 0"),
        (MODULI.replace("\n1,", "\n-1,"), "frequency = -6.28.* in row 2 must be above 0"),
        (MODULI.replace("\n1,", "\n10,"), "4 frequencies, 3 of them different"),
        (MODULI.replace("1000,6,400\n", ""), "3 frequencies, 3 of them different; .* at least 4"),
    ],
)
def test_what_is_wrong_with_moduli_is_said(written, text, words):
    with pytest.raises(ValueError, match=words):
        read_dmta(written(text))
