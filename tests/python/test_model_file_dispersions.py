"""[dispersions] and [ensemble] of model files: what they mean, and what their errors say."""

import re
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelFileError
from freebody.model_file import load_model

PAGE = (Path(__file__).parents[2] / "docs" / "model-file.md").read_text()

BRICK = """\
[model]
name = "brick"
[body]
mass = 2.0
inertia_about_com = { principal = [2.0, 3.0, 4.0] }
[[forces]]
type = "uniform_gravity"
name = "gravity"
[simulation]
end = "2 s"
rtol = 1e-8
[output]
save_every = 0.5
"""


@pytest.fixture
def load(tmp_path):
    def load(text):
        path = tmp_path / "brick.toml"
        path.write_text(BRICK + text)
        return load_model(path)

    return load


@pytest.mark.parametrize(
    ("name", "table", "wanted"),
    [
        ("mass", 'kind = "truncated_normal"\nmean = "2 kg"\nsd = "50 g"\nlow = 1.5', None),
        (
            "mass",
            'kind = "uniform"\napplied = "factor"\nlow = 0.9\nhigh = 1.1',
            fb.Factor(fb.Uniform(0.9, 1.1)),
        ),
        ("mass", 'kind = "log_normal"\nmedian = "2 kg"\nsigma = 0.1', fb.LogNormal(2.0, 0.1)),
        ("attitude", 'kind = "normal"\nmean = 0\nsd = "180 deg"', fb.Normal(0.0, np.pi)),
        (
            "position",
            'kind = "normal"\napplied = "offset"\nmean = "[1, 2, 3] km"\nsd = 1.0',
            fb.Offset(fb.Normal([1000.0, 2000.0, 3000.0], 1.0)),
        ),
        ('"gravity.acceleration"', 'kind = "uniform"\nlow = 9.7\nhigh = 9.9', fb.Uniform(9.7, 9.9)),
        ("force_x", 'kind = "normal"\nmean = "2 kN"\nsd = 1', fb.Normal(2000.0, 1.0)),
    ],
)
def test_a_table_is_a_distribution(load, name, table, wanted):
    loaded = load(f"[dispersions.{name}]\n{table}\n")
    (given,) = loaded.dispersions.values()
    assert given == (wanted or fb.TruncatedNormal(2.0, 0.05, 1.5, np.inf))
    assert loaded.ensemble(3).run(loaded.t_span).ok.all()


def test_joint_distributions(load):
    loaded = load(
        '[dispersions.position]\nkind = "multivariate_normal"\nmean = "[1, 2, 3] m"\n'
        "covariance = [[2, 1, 0], [1, 2, 0], [0, 0, 1]]\n"
        '[dispersions.velocity_world]\nkind = "discrete"\nvalues = [[1, 0, 0], "[0, 3.6, 0] km/h"]\n'
        "weights = [1, 3]\n"
    )
    draws = loaded.ensemble(4000, seed=3).sample().dispersed
    # Six standard errors of 4000 draws.
    np.testing.assert_allclose(draws[:, :3].mean(axis=0), [1.0, 2.0, 3.0], atol=6 * np.sqrt(2.0 / 4000))
    np.testing.assert_allclose(draws[:, 3:5].mean(axis=0), [0.25, 0.75], atol=6 * np.sqrt(0.19 / 4000))


def test_values_of_a_file_have_the_units_of_its_headings(load, tmp_path):
    (tmp_path / "weights.csv").write_text("run,mass [lb]\n0,4.0\n1,5.0\n")
    loaded = load('[dispersions.mass]\nkind = "file"\ncsv = "weights.csv"\ncolumns = ["mass [lb]"]\n')
    np.testing.assert_allclose(
        loaded.ensemble(2).sample().dispersed[:, 0], [4.0 * 0.45359237, 5.0 * 0.45359237]
    )


def test_the_file_says_how_many_and_which(load):
    table = '[dispersions.mass]\nkind = "uniform"\nlow = 1\nhigh = 2\n'
    loaded = load(table + '[ensemble]\nn = 8\nseed = 5\nsampling = "sobol"\nchunk = 4\nsave_at = [1.0]\n')
    ensemble = loaded.ensemble()
    assert (ensemble.n, ensemble.seed, ensemble.sampling) == (8, 5, "sobol")
    assert loaded.ensemble(16, seed=6, sampling="random").seed == 6
    assert loaded.campaign_options == {"rtol": 1e-8, "chunk": 4, "save_at": np.array([1.0])}
    with pytest.raises(ModelFileError, match="say how many runs"):
        load(table).ensemble()
    with pytest.raises(ModelFileError, match="needs dispersions"):
        load("").ensemble(5)


MASS = "[dispersions.mass]\n"


@pytest.mark.parametrize(
    ("text", "line", "key", "says"),
    [
        (MASS + 'kind = "norml"', 15, "dispersions.mass.kind", "did you mean 'normal'?"),
        (MASS + "low = 1", 14, "dispersions.mass.kind", "the kind of distribution"),
        (MASS + 'kind = "normal"\nmean = 2', 14, "dispersions.mass.sd", "this key is missing"),
        (MASS + 'kind = "normal"\nmean = 2\nsd = "1 m"', 17, "dispersions.mass.sd", "is no unit of a mass"),
        (MASS + 'kind = "normal"\nmean = 2\nsd = 1', 14, "dispersions.mass", "use fb.TruncatedNormal"),
        (
            MASS + 'kind = "uniform"\nlow = 1\nhigh = 2\napplied = "times"',
            18,
            "dispersions.mass.applied",
            "unknown word 'times'",
        ),
        (
            '[dispersions.position]\nkind = "normal"\nmean = [1, 2]\nsd = 1',
            16,
            "dispersions.position.mean",
            "needs one number or 3 numbers",
        ),
        (
            '[dispersions.mas]\nkind = "normal"\nmean = 1\nsd = 1',
            14,
            "dispersions.mas",
            "did you mean 'mass'?",
        ),
        ("[ensemble]\nn = 0", 15, "ensemble.n", "greater than or equal to 1"),
        ("[ensemble]\nsave_at = [3.0]", 15, "ensemble.save_at", "from 0 to 2 s at most"),
        ('[ensemble]\nsampling = "halton"', 15, "ensemble.sampling", "unknown word 'halton'"),
    ],
)
def test_what_is_wrong_is_told_at_its_key(load, text, line, key, says):
    with pytest.raises(ModelFileError, match=re.escape(says)) as caught:
        load(text + "\n")
    assert (caught.value.line, caught.value.key) == (line, key)


def test_the_example_of_the_page_is_valid(tmp_path):
    brick, *others = re.findall(r"^```toml\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)
    (dispersions,) = [text for text in others if text.startswith("[dispersions")]
    named = brick.replace('type = "uniform_gravity"', 'type = "uniform_gravity"\nname = "gravity"')
    (tmp_path / "brick.toml").write_text(named + dispersions)
    loaded = fb.load(tmp_path / "brick.toml")
    assert loaded.ensemble(5).run(loaded.t_span).ok.all()
