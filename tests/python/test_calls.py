"""How a call behaves: it lets others run, can be interrupted, tells its progress, and is at home in
the processes of multiprocessing and dask."""

import multiprocessing
import os
import signal
import threading
import time

import infoscene
import numpy as np
import pytest
from conftest import cube

# every pair on one thread: 20 faces a side take a second or two, 40 some tens
LONG = {"congruence": False, "threads": 1}


def test_ctrl_c_is_heard_long_before_the_end():
    mesh = cube(40)
    sent = []

    def press():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(1.0, press)
    # a shell starts what runs in the background deaf to Ctrl-C
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            infoscene.form_factors(mesh, **LONG)
    finally:
        signal.signal(signal.SIGINT, before)
    # half a second of grace, and the rest for a loaded machine; the work takes tens of seconds
    assert time.monotonic() - sent[0] < 5
    assert infoscene.form_factors("cube:1").shape == (6, 6)


def test_other_threads_run_meanwhile():
    counted = [0]
    stop = threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    begun = time.monotonic()
    infoscene.form_factors(cube(20), **LONG)
    taken, seen = time.monotonic() - begun, counted[0]
    stop.set()
    thread.join()
    # a thread that waited for the lock would have counted once or twice
    assert seen > 20 * taken


def test_progress_is_told_in_the_thread_of_the_caller():
    told, threads = [], set()

    def listen(progress):
        told.append(progress)
        threads.add(threading.get_ident())

    infoscene.form_factors(cube(20), progress=listen, **LONG)
    assert threads == {threading.get_ident()}
    assert told[-1].name == "pairs" and told[-1].done == told[-1].total == 2400 * 2399 // 2
    done = [one.done for one in told]
    assert done == sorted(done) and len(told) > 1


def test_what_a_callback_raises_ends_the_computation():
    class Enough(Exception):
        pass

    def listen(progress):
        raise Enough

    begun = time.monotonic()
    with pytest.raises(Enough):
        infoscene.form_factors(cube(40), progress=listen, **LONG)
    assert time.monotonic() - begun < 5


def sums(n):
    return infoscene.form_factors(cube(n)).values.sum()


def test_forked_and_spawned_processes_compute_after_their_parent_has():
    expected = [sums(n) for n in (2, 3)]
    for method in ("fork", "spawn"):
        with multiprocessing.get_context(method).Pool(2) as pool:
            found = pool.map_async(sums, (2, 3)).get(timeout=120)
        assert found == expected


def test_dask_computes_blocks_of_points_and_hands_over_its_own_arrays():
    dask = pytest.importorskip("dask")
    da = pytest.importorskip("dask.array")
    rng = np.random.default_rng(4)
    points = np.column_stack([rng.uniform(0.1, 0.9, (40, 2)), np.zeros(40)])
    whole = infoscene.point_form_factors("cube:2", points, [0, 0, 1]).values

    def rows(block):
        return infoscene.point_form_factors("cube:2", block, [0, 0, 1], threads=1).values

    blocks = da.from_array(points, chunks=(10, 3)).map_blocks(rows, dtype=float, chunks=(10, 24))
    with dask.config.set(scheduler="threads", num_workers=2):
        assert np.array_equal(blocks.compute(), whole)


def test_dask_distributed_passes_meshes_without_copies():
    distributed = pytest.importorskip("distributed")
    expected = sums(3)
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        vertices, faces = cube(3)
        # large enough for a frame of its own, which is read-only and may be misaligned
        vertices = np.vstack([vertices, np.zeros((50_000, 3))])
        futures = [client.submit(total, vertices, faces, k) for k in range(3)]
        assert [future.result(timeout=120) for future in futures] == [expected] * 3


def total(vertices, faces, _):
    return infoscene.form_factors((vertices, faces), threads=1).values.sum()
