"""A stopping rule looks at the first runs alone, and stops as soon as they are enough."""

import itertools

import numpy as np
import pytest

from freebody import statistics
from freebody.errors import InputError
from python.statistics.samples import NON_FINITE, NOT_RUN, dataset, ended, runs

RULES = ["drift:mean:0.2", "miss:q0.9:5%", "miss:p>10:0.02", "event:crossing:p:0.03", "drift:p<0:4%"]


@pytest.mark.parametrize("rule", RULES)
def test_it_stops_at_the_first_checkpoint_that_meets_it(rule):
    data, precision = runs(20_000), statistics.parse_precision(rule)
    stopped = statistics.run_until(lambda k: data, precision, limit=20_000, start=100)
    assert stopped.met
    assert [verdict.met for verdict in stopped.history] == [False] * (len(stopped.history) - 1) + [True]
    for verdict in stopped.history:
        again = precision.judge(data.isel(run=slice(0, verdict.runs)))
        assert again == verdict
        assert verdict.met == (verdict.interval.half_width <= verdict.wanted)


def test_more_runs_than_asked_for_change_nothing():
    """A campaign that works in chunks, or with many workers, has made more than the first k runs."""
    data, precision = runs(20_000), statistics.parse_precision("drift:mean:0.2")
    asked = []

    def exactly(k):
        asked.append(k)
        return data.isel(run=slice(0, k))

    def generous(k):
        return ended(data, NOT_RUN, *range(k + 500, 20_000))

    alone = statistics.run_until(exactly, precision, limit=20_000)
    assert alone == statistics.run_until(generous, precision, limit=20_000)
    assert asked == [verdict.runs for verdict in alone.history]


def test_several_rules_must_all_be_met():
    data = runs(20_000)
    rules = [statistics.parse_precision(rule) for rule in RULES]
    together = statistics.run_until(lambda k: data, rules, limit=20_000)
    alone = [statistics.run_until(lambda k: data, rule, limit=20_000) for rule in rules]
    assert together.met
    # A quantile's interval may widen again, so together can be later than the last alone, not earlier.
    assert together.runs >= max(stopped.runs for stopped in alone)


def test_the_limit_ends_it():
    stopped = statistics.run_until(
        lambda k: runs(3000), statistics.Precision("drift", absolute=1e-6), limit=3000
    )
    assert (stopped.met, stopped.runs) == (False, 3000)
    assert [verdict.runs for verdict in stopped.history] == [1000, 1500, 2250, 3000]
    assert "not met" in str(stopped.table())


def test_checkpoints_grow_and_fill_whole_chunks():
    assert list(statistics.checkpoints(100, 1000, 2.0)) == [100, 200, 400, 800, 1000]
    assert list(statistics.checkpoints(100, 1000, 1.5, multiple=300)) == [300, 600, 900, 1000]
    assert list(statistics.checkpoints(5000, 1000)) == [1000]
    steps = list(itertools.pairwise(statistics.checkpoints(1, 10, 1.01)))
    assert all(a < b for a, b in steps)


def test_runs_that_ended_badly_do_not_count():
    data = ended(runs(1000), NON_FINITE, *range(0, 1000, 4))
    verdict = statistics.Precision("drift", absolute=1.0).judge(data)
    assert (verdict.runs, verdict.interval.count) == (1000, 750)


@pytest.mark.parametrize("rule", RULES)
def test_without_a_run_that_ended_well_nothing_is_met(rule):
    data = ended(runs(10), NON_FINITE, *range(10))
    assert not statistics.parse_precision(rule).judge(data).met


def test_the_interval_holds_the_truth_where_it_stopped():
    """Of 500 campaigns that stop themselves, of exponential misses, whose mean is 1."""
    repetitions, confidence = 500, 0.95
    draws = np.random.default_rng(12).exponential(size=(repetitions, 4000))
    rule = statistics.Precision("miss", confidence=confidence, relative=0.1)
    held = 0
    for row in draws:
        data = dataset({"miss": (row, "m")}, {"mass": (row, "kg")})
        stopped = statistics.run_until(lambda k, data=data: data, rule, limit=4000, start=200)
        assert stopped.met
        interval = stopped.history[-1].interval
        held += interval.low <= 1.0 <= interval.high
    # Stopping at a look, and skew runs: two hundredths of the coverage; and four deviations of the count.
    least = confidence - 0.02
    assert held >= repetitions * least - 4 * np.sqrt(repetitions * least * (1 - least))


def test_runs_that_repeat_each_others_numbers_are_refused():
    data = runs(100).assign_attrs(sampling="saltelli")
    with pytest.raises(InputError, match='sampling="random"'):
        statistics.Precision("drift", absolute=1.0).judge(data)


@pytest.mark.parametrize(
    ("rule", "expected"),
    [
        ("miss:mean:0.5", statistics.Precision("miss", absolute=0.5)),
        ("output:miss:mean:1%", statistics.Precision("output:miss", relative=0.01)),
        ("miss:q0.99:2e-1", statistics.Precision("miss", "quantile", probability=0.99, absolute=0.2)),
        ("miss:p>-3.5:0.01", statistics.Precision("miss", "probability", above=-3.5, absolute=0.01)),
        ("miss:p<3:10%", statistics.Precision("miss", "probability", below=3.0, relative=0.1)),
        ("event:apogee:p:0.01", statistics.Precision("event:apogee", "probability", absolute=0.01)),
    ],
)
def test_a_rule_can_be_one_word(rule, expected):
    assert statistics.parse_precision(rule) == expected


@pytest.mark.parametrize(
    "rule", ["miss", "miss:mean", "miss:median:1", "miss:mean:one", "miss:p>:1", "miss:q:1"]
)
def test_another_word_is_refused(rule):
    with pytest.raises(InputError, match=r"column:statistic:half-width .*miss:mean:0\.5"):
        statistics.parse_precision(rule)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "absolute, relative: give one"),
        ({"absolute": -1.0}, "absolute: got -1.0; give one finite positive number"),
        ({"statistic": "median", "absolute": 1.0}, "statistic: got 'median'"),
        ({"statistic": "quantile", "absolute": 1.0}, "probability: goes with"),
        ({"probability": 0.5, "absolute": 1.0}, "probability: goes with"),
        ({"above": 3.0, "absolute": 1.0}, "above: give one of above, below, with statistic='probability'"),
        (
            {"statistic": "probability", "above": 3.0, "below": 1.0, "absolute": 1.0},
            "above and below: give one",
        ),
        ({"confidence": 95, "absolute": 1.0}, "confidence: got 95"),
    ],
)
def test_what_does_not_go_together_is_refused(options, message):
    with pytest.raises(InputError, match=message):
        statistics.Precision("miss", **options)


def test_growth_must_grow():
    with pytest.raises(InputError, match=r"growth: got 1\.0; give a number above 1"):
        list(statistics.checkpoints(10, 100, 1.0))
