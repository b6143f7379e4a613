"""Information from Python: the paper's numbers."""

import infoscene
import numpy as np
import pytest
from conftest import cube, squares


def information(F, areas):
    """Eq. (3) in numpy."""
    w = areas / areas.sum()
    joint = w[:, None] * F
    terms = joint * np.log2(np.where(joint > 0, F / w[None, :], 1))
    return terms.sum()


def test_information_is_that_of_the_matrix():
    F = infoscene.form_factors(cube(3))
    I = infoscene.mutual_information(cube(3))
    # 54² terms of at most 0.1, each rounded some times
    assert I.bits == pytest.approx(information(F.values, F.areas), abs=1e-13)
    assert float(I) == I.bits and I.grade == "bound" and I.error < 1e-12
    # equal areas: H = log₂ n
    assert I.positional_entropy == pytest.approx(np.log2(54), abs=1e-13)
    assert I.positional_entropy - I.entropy_rate == pytest.approx(I.bits, abs=1e-13)
    assert I.contributions.sum() == pytest.approx(I.bits, abs=1e-14)


def test_an_open_scene_needs_a_state_outside():
    with pytest.raises(ValueError, match=r"open=True adds the state outside"):
        infoscene.mutual_information(squares())
    I = infoscene.mutual_information(squares(), open=True)
    assert not I.closed and I.outside_contribution is not None


def test_chains_of_light_need_light():
    lit = {"reflectance": 0.5, "emittance": 1.0}
    I = infoscene.mutual_information(cube(2), chain="radiosity", **lit)
    # in a furnace all radiosities are equal, and the chain is that of visibility
    assert I.bits == pytest.approx(infoscene.mutual_information(cube(2)).bits, abs=1e-11)
    with pytest.raises(ValueError, match="visibility chain has no light"):
        infoscene.mutual_information(cube(2), **lit)
    with pytest.raises(ValueError, match='chain is "markov"'):
        infoscene.mutual_information(cube(2), chain="markov")


def test_the_continuous_information_of_a_cube_is_above_the_discrete():
    found = [infoscene.continuous_information(cube(n)) for n in (1, 2, 4)]
    discrete = [one.discrete.bits for one in found]
    assert discrete == sorted(discrete)
    for one in found:
        assert one.bits == pytest.approx(found[0].bits, abs=1e-9)
        assert one.discrete.bits < one.bits
    with pytest.raises(ValueError):
        infoscene.continuous_information(squares())


def test_the_best_cut_of_fig_2():
    cut = infoscene.best_split("two-squares", precision=60)
    assert f"{cut.position:.2f}" == "0.40"  # as the paper prints
    assert cut.axis == "u" and cut.gain > cut.gain_at_middle
    lower, upper = map(float, cut.enclosure.position)
    assert lower <= cut.position + cut.position_error and upper >= cut.position - cut.position_error
    both = infoscene.best_split("three-squares", 0, against=[1, 2])
    assert both.face == 0
    with pytest.raises(ValueError, match='axis is "w"'):
        infoscene.best_split("two-squares", axis="w")
    with pytest.raises(ValueError, match="leave out parts"):
        infoscene.best_split("two-squares", parts=3, precision=60)


def test_claims_are_judged():
    told = []
    claims = infoscene.reproduce("fig2-parallel-cut", "theorem-1", progress=told.append)
    assert [claim.id for claim in claims] == ["theorem-1", "fig2-parallel-cut"]
    assert all(claim.verdict == claim.recorded == "confirmed" for claim in claims)
    assert told[-1].done == 2
    with pytest.raises(ValueError, match=r"reproduce\(\) without ids has all"):
        infoscene.reproduce("fig2")
