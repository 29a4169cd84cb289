"""Steps on the plate: what they impose, how increments adapt, and what is left where a step fails."""

import numpy as np
import pytest
from solid_meshes import Rubber, rounded_block

from softlub.solid.body import Body
from softlub.solid.elements import ElementInverted
from softlub.solid.equilibrium import NewtonSettings
from softlub.solid.increments import Stepping
from softlub.solid.plate import PlateContact
from softlub.solid.plate_laws import HardContact
from softlub.solid.steps import InContact, Loading, Sliding, run

MESH = rounded_block()
STEPS = [InContact(3e-6, 0.5), Loading(60.0, 2.0), Sliding(0.4, 0.25)]


@pytest.fixture(scope="module")
def in_one_go():
    return run(Body(MESH, Rubber()), PlateContact(), STEPS)


@pytest.fixture(scope="module")
def in_many_increments():
    return run(Body(MESH, Rubber()), PlateContact(), STEPS, Stepping(first=0.1, largest=0.25))


def test_every_step_ends_where_it_should(in_one_go):
    assert in_one_go.converged
    contact, loading, sliding = in_one_go.increments
    assert [contact.step, loading.step, sliding.step] == ["in-contact", "loading", "sliding"]
    assert contact.plate_height == 3e-6
    assert loading.load == pytest.approx(60.0, rel=1e-9)
    assert loading.friction == 0.0
    assert sliding.load == pytest.approx(60.0, rel=1e-9)
    assert sliding.friction == 0.4
    np.testing.assert_allclose([contact.time, loading.time, sliding.time], [0.5, 2.5, 2.75])
    np.testing.assert_array_equal(sliding.shear, 0.4 * sliding.normal)
    assert in_one_go.iterations == sum(increment.iterations for increment in in_one_go.increments)


def test_an_elastic_body_ends_alike_however_many_increments(in_one_go, in_many_increments):
    assert in_many_increments.converged
    assert len(in_many_increments.increments) > 12
    scale = np.abs(in_one_go.displacement).max()
    assert np.abs(in_many_increments.displacement - in_one_go.displacement).max() <= 1e-7 * scale
    assert in_many_increments.last.plate_height == pytest.approx(in_one_go.last.plate_height, rel=1e-7)


def test_times_and_loads_of_increments_ascend(in_many_increments):
    times = [increment.time for increment in in_many_increments.increments]
    assert np.all(np.diff(times) > 0)
    assert times[-1] == pytest.approx(2.75)
    loads = [increment.load for increment in in_many_increments.of("loading")]
    assert np.all(np.diff(loads) > 0)
    begin = in_many_increments.of("in-contact")[-1].load
    # Even in time: the load is where the time says.
    parts = (np.array([i.time for i in in_many_increments.of("loading")]) - 0.5) / 2.0
    np.testing.assert_allclose(loads, begin + parts * (60.0 - begin), rtol=1e-8)


def test_step_ends_hold_all_nodes_and_increments_the_edge(in_many_increments):
    assert [end.step for end in in_many_increments.ends] == ["in-contact", "loading", "sliding"]
    assert all(end.fraction == 1.0 for end in in_many_increments.ends)
    for end in in_many_increments.ends:
        last = in_many_increments.of(end.step)[-1]
        np.testing.assert_array_equal(end.displacement[MESH.edge], last.edge_displacement)


def test_a_contact_wider_than_the_edge_is_noticed(in_one_go):
    assert not in_one_go.last.reaches_edge_end
    flat = rounded_block(radius=8e-3)
    assert run(Body(flat, Rubber()), PlateContact(), [InContact(4e-5)]).last.reaches_edge_end


def test_sliding_without_a_load_step_keeps_the_height():
    history = run(Body(MESH, Rubber()), PlateContact(), [InContact(8e-6), Sliding(0.6)])
    assert history.converged
    assert history.last.plate_height == 8e-6
    assert history.last.friction == 0.6


def test_a_second_contact_starts_from_the_deformed_edge():
    history = run(Body(MESH, Rubber()), PlateContact(), [InContact(5e-6), InContact(2e-6)])
    assert history.converged
    lowest = (MESH.points[MESH.edge] + history.ends[0].displacement[MESH.edge])[:, 1].min()
    assert history.last.plate_height == pytest.approx(lowest + 2e-6, rel=1e-12)


def test_an_increment_that_fails_is_tried_smaller_and_the_next_larger():
    newton = NewtonSettings(most_iterations=4)
    history = run(Body(MESH, Rubber()), PlateContact(), STEPS, newton=newton)
    assert history.converged
    assert history.rejected > 0
    assert history.wasted_iterations > 0
    assert history.iterations > sum(increment.iterations for increment in history.increments)


def test_a_step_that_fails_says_where_and_keeps_what_was_reached():
    """Pressed towards the holder until the elements are squashed: the last good state is kept, and in equilibrium."""
    body = Body(MESH, Rubber())
    stepping = Stepping(first=0.25, smallest=0.02)
    history = run(body, PlateContact(), [InContact(4e-6), Loading(1e6), Sliding(0.3)], stepping)
    assert not history.converged
    failure = history.failure
    assert failure.step == "loading"
    assert failure.increment == len(history.of("loading")) + 1
    assert failure.reason
    assert f"step loading stopped at {100 * failure.fraction:.3g} %" in str(failure)
    assert [end.step for end in history.ends] == ["in-contact", "loading"]
    assert history.ends[-1].fraction == failure.fraction < 1
    last = history.last
    forces = body.forces(history.displacement).reshape(-1, 2)
    assert forces[MESH.held, 1].sum() == pytest.approx(-last.load, rel=1e-6)


def test_without_contact_first_nothing_is_reached_and_the_reason_is_told():
    history = run(Body(MESH, Rubber()), PlateContact(), [Loading(10.0)])
    assert "no node is in contact" in history.failure.reason
    assert history.increments == ()
    np.testing.assert_array_equal(history.displacement, 0)
    with pytest.raises(ValueError, match="no increment was reached: step loading stopped"):
        _ = history.last


class ForgettingBody(Body):
    """Refuses every displacement beyond a limit, and counts what is asked of its memory."""

    def __init__(self, limit):
        super().__init__(MESH, Rubber())
        self.limit, self.calls = limit, []

    def forces(self, displacement):
        if np.abs(displacement).max() > self.limit:
            raise ElementInverted("element 0 is turned inside out")
        return super().forces(displacement)

    def begin_increment(self, duration):
        self.calls.append(duration)

    def accept(self):
        self.calls.append("accept")

    def restore(self, checkpoint):
        self.calls.append("restore")
        super().restore(checkpoint)


def test_memory_is_accepted_or_restored_at_every_increment():
    body = ForgettingBody(4e-6)
    stepping = Stepping(smallest=0.05)
    history = run(body, PlateContact(HardContact(1e13)), [InContact(8e-6, duration=2.0)], stepping)
    assert history.failure is not None
    assert "inside out" in history.failure.reason
    durations, fates = body.calls[::2], body.calls[1::2]
    assert fates.count("accept") == len(history.increments)
    assert fates.count("restore") == history.rejected
    done = sum(duration for duration, fate in zip(durations, fates, strict=True) if fate == "accept")
    assert done == pytest.approx(2.0 * history.failure.fraction)
    assert durations[0] == 2.0


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: InContact(0.0), "InContact: overlap = 0 must be above 0 m"),
        (lambda: Loading(-1.0), "Loading: load = -1 must be above 0 N/m"),
        (lambda: Loading(1.0, duration=-1.0), "Loading: duration = -1 must be at least 0 s"),
        (lambda: Sliding(float("inf")), "Sliding: friction = inf must be any finite number"),
        (lambda: Stepping(growth=1.0), "Stepping: growth = 1 must be above 1"),
        (lambda: Stepping(first=0.0), "Stepping: first = 0 must be above 0"),
    ],
)
def test_impossible_values_are_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_steps_end_without_a_sliver():
    stepping = Stepping(first=0.3, growth=1.5)
    assert stepping.reach(0.7, 0.3) == 1.0
    assert stepping.reach(0.0, 0.3) == 0.3
    assert stepping.smaller(1e-3) is None
    assert stepping.smaller(2e-3) == 1e-3
