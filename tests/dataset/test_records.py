"""What the records of a data set add up to."""

import time

from sdgen.dataset.records import ManifestEntry, count


def _entry(index: int, home: str) -> ManifestEntry:
    return ManifestEntry(
        id=f"{index:06d}",
        index=index,
        home=home,
        split=("train", "val")[index % 2],
        anomalies=10 - index % 3,
        lookalikes=0,
        objects=2,
        views=1,
        all_visible=True,
        content_sha256="0" * 64,
        files={},
    )


def test_values_are_counted_in_the_order_of_their_names() -> None:
    found = count(tuple(_entry(k, ("b", "a")[k % 2]) for k in range(3)))
    assert list(found.scenes_by_home.items()) == [("a", 1), ("b", 2)]
    assert list(found.scenes_by_split.items()) == [("train", 2), ("val", 1)]
    assert list(found.scenes_by_anomalies.items()) == [("10", 1), ("8", 1), ("9", 1)]


def test_homes_of_their_own_take_no_time_to_count() -> None:
    # Procedural homes: as many names as scenes. Each looked for among all took half a minute.
    entries = tuple(_entry(k, f"home_{k}") for k in range(50_000))
    start = time.process_time()
    assert len(count(entries).scenes_by_home) == 50_000
    assert time.process_time() - start < 5.0
