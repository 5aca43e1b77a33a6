"""Building, resuming, extending and refusing: whole scenes or none, nothing good lost."""

import errno
import json
import multiprocessing
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from sdgen.dataset import Dataset, DatasetWriter
from sdgen.dataset import scene_folder as scene_folder_module
from sdgen.dataset.scene_folder import BUILD_FOLDER
from sdgen.errors import SdgenError
from sdgen.rejection import Cause
from sdgen.scene import cause_counts

from tests import toy


def tree(path: Path) -> dict[str, bytes]:
    """Every file below a folder by its relative name."""
    return {
        str(p.relative_to(path)): p.read_bytes() for p in sorted(path.rglob("*")) if p.is_file()
    }


def test_a_finished_data_set_has_exactly_the_promised_files(tmp_path: Path) -> None:
    names = set(tree(toy.build(tmp_path / "d", toy.small(n=1))))
    scene = {
        f"{n}.json" for n in ["scene", "graph", "anomalies", "household", "visibility", "physics"]
    }
    views = {
        f"views/{k:02d}/{name}"
        for k in range(2)
        for name in ("rgb.png", "depth.png", "instance.png", "part.png", "view.json")
    }
    top = {"dataset.json", "catalogue.json", "README.md", "manifest.jsonl", "assets.jsonl"}
    assert names == top | {f"scenes/000000/{name}" for name in scene | views}


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({"rgb": "jpg"}, {"rgb.jpg", "depth.png", "instance.png", "part.png", "view.json"}),
        ({"sensors": ("depth",)}, {"depth.png", "view.json"}),
        ({"sensors": ()}, {"view.json"}),
    ],
)
def test_views_hold_what_was_asked_for(
    tmp_path: Path, options: dict[str, Any], expected: set[str]
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1, **options))
    assert {p.name for p in (path / "scenes/000000/views/00").iterdir()} == expected


def test_two_builds_give_the_same_bytes(tmp_path: Path) -> None:
    one, two = toy.build(tmp_path / "a"), toy.build(tmp_path / "b")
    assert tree(one) == tree(two)


def test_bytes_do_not_depend_on_locale_hash_seed_or_folder(tmp_path: Path) -> None:
    code = (
        "import sys; from pathlib import Path; from tests import toy; toy.build(Path(sys.argv[1]))"
    )
    root = str(Path(__file__).resolve().parents[2])
    for name, seed, locale in (("a", "1", "C"), ("b", "2", "C.UTF-8")):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "LC_ALL": locale, "PYTHONUTF8": "0"}
        environment["PYTHONPATH"] = root + os.pathsep + environment.get("PYTHONPATH", "")
        subprocess.run(
            [sys.executable, "-c", code, str(tmp_path / name)],
            check=True,
            env=environment,
            cwd=tmp_path,
        )
    assert tree(tmp_path / "a") == tree(tmp_path / "b")


def test_content_digest_ignores_views_and_nothing_else(tmp_path: Path) -> None:
    def digests(name: str, **options: Any) -> list[str]:
        made = Dataset(toy.build(tmp_path / name, toy.small(n=2, **options)))
        return [entry.content_sha256 for entry in made.entries]

    assert digests("a") == digests("b", views=1, rgb="jpg", sensors=("rgb",))
    assert len(set(digests("c"))) == 2


def again(*ids: str) -> set[str]:
    """What is noted of damaged scenes."""
    return {f"scene {name} was damaged and will be made again" for name in ids}


def test_a_killed_build_resumes_to_the_same_bytes(tmp_path: Path) -> None:
    whole = toy.build(tmp_path / "whole")
    path = tmp_path / "d"
    with toy.open_writer(path) as writer:
        toy.add_scene(writer, 2)
        toy.add_scene(writer, 0)
        # Killed while scene 1 is half written.
        half = writer.scene_writer.begin(toy.bundle(1, writer.build.options))
        half.add(toy.frame(toy.bundle(1, writer.build.options), 0))
    assert not (path / "scenes" / "000001").exists()
    with toy.open_writer(path) as writer:
        assert sorted(writer.done) == ["000000", "000002"]
        assert writer.notes == ()
        assert not list((path / BUILD_FOLDER).glob("*.partial"))
    assert tree(toy.build(path)) == tree(whole)


def _damage_truncate(scene: Path) -> None:
    (scene / "views/00/depth.png").write_bytes(b"short")


def _damage_edit(scene: Path) -> None:
    text = (scene / "household.json").read_text(encoding="utf-8")
    (scene / "household.json").write_text(text.replace("38", "39"), encoding="utf-8")


def _damage_missing(scene: Path) -> None:
    (scene / "views/01/rgb.png").unlink()


def _damage_extra(scene: Path) -> None:
    (scene / "views/00/rgb.jpg").write_text("sdgen writes such a file, but not here")


def _damage_link(scene: Path) -> None:
    (scene / "graph.json").rename(scene.parent.parent / "graph.json")
    (scene / "graph.json").symlink_to(scene.parent.parent / "graph.json")


@pytest.mark.parametrize(
    "damage", [_damage_truncate, _damage_edit, _damage_missing, _damage_extra, _damage_link]
)
@pytest.mark.parametrize("finished", [False, True])
def test_a_damaged_scene_is_made_again(tmp_path: Path, damage: Any, finished: bool) -> None:
    whole = tree(toy.build(tmp_path / "whole", toy.small(n=2)))
    path = tmp_path / "d"
    with toy.open_writer(path, toy.small(n=2)) as writer:
        toy.add_scene(writer, 0)
        toy.add_scene(writer, 1)
        if finished:
            writer.finish()
    damage(path / "scenes" / "000001")
    with toy.open_writer(path, toy.small(n=2)) as writer:
        assert again("000001") <= set(writer.notes)
        assert list(writer.done) == ["000000"]
        toy.add_scene(writer, 1)
        writer.finish()
    (path / "graph.json").unlink(missing_ok=True)
    assert tree(path) == whole


@pytest.mark.parametrize("name", [".DS_Store", "notes.txt", "views/00/notes.txt"])
def test_a_user_s_file_is_no_damage(tmp_path: Path, name: str) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    (path / "scenes/000001" / name).write_text("mine")
    before = tree(path)
    with toy.open_writer(path, toy.small(n=2)) as writer:
        assert writer.notes == ()
        writer.finish()
    assert tree(path) == before


def test_a_user_s_files_in_a_damaged_scene_are_set_aside_and_said(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    whole = tree(path)
    for turn in ("", "-2"):
        (path / "scenes/000001/views/00/mine.txt").write_text("my notes" + turn)
        _damage_truncate(path / "scenes/000001")
        with toy.open_writer(path, toy.small(n=2)) as writer:
            assert again("000001") <= set(writer.notes)
            damaged, aside = writer.notes
            assert "damaged and will be made again" in damaged
            assert str(path / f"set-aside/000001{turn}") in aside
            toy.add_scene(writer, 1)
            writer.finish()
    kept = {name: data for name, data in tree(path).items() if name.startswith("set-aside")}
    assert kept == {
        "set-aside/000001/views/00/mine.txt": b"my notes",
        "set-aside/000001-2/views/00/mine.txt": b"my notes-2",
    }
    assert {name: data for name, data in tree(path).items() if name not in kept} == whole


def test_overwrite_sets_a_user_s_files_aside(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    (path / "scenes/000001/notes.txt").write_text("mine")
    (path / "scenes/README").write_text("mine too")
    with toy.open_writer(path, toy.small(n=1, seed=9), overwrite=True) as writer:
        toy.add_scene(writer, 0)
        writer.finish()
    assert (path / "set-aside/000001/notes.txt").read_text() == "mine"
    assert (path / "scenes/README").read_text() == "mine too"
    assert not (path / "scenes/000001").exists()


def test_an_interrupted_build_remembers_what_drew_its_pictures(tmp_path: Path) -> None:
    whole = tree(toy.build(tmp_path / "whole", toy.small(n=2)))
    path = tmp_path / "d"
    for number in (0, 1):
        with toy.open_writer(path, toy.small(n=2)) as writer:
            toy.add_scene(writer, number)
    with toy.open_writer(path, toy.small(n=2)) as writer:
        assert writer.finish().renderers == ("painted",)
    assert tree(path) == whole


def test_a_larger_n_extends_to_the_bytes_of_a_whole_build(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    assert tree(toy.build(path, toy.small(n=4))) == tree(toy.build(tmp_path / "w", toy.small(n=4)))


def test_while_it_is_extended_the_old_data_set_can_be_read(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    with toy.open_writer(path, toy.small(n=4)) as writer:
        toy.add_scene(writer, 3)
    assert len(Dataset(path)) == 2


def test_a_smaller_n_is_refused(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=3))
    with pytest.raises(SdgenError, match="--n 3"):
        toy.open_writer(path, toy.small(n=2))


@pytest.mark.parametrize("finished", [False, True])
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"seed": 8}, "seed 7 (now 8)"),
        ({"views": 3}, "views 2 (now 3)"),
        ({"sensors": ("rgb",)}, "sensors rgb,depth,instance (now rgb)"),
    ],
)
def test_other_options_are_refused_and_nothing_is_touched(
    tmp_path: Path, finished: bool, change: dict[str, Any], words: str
) -> None:
    path = tmp_path / "d"
    with toy.open_writer(path, toy.small(n=1)) as writer:
        toy.add_scene(writer, 0)
        if finished:
            writer.finish()
    before = tree(path)
    with pytest.raises(SdgenError) as caught:
        toy.open_writer(path, toy.small(n=1, **change))
    assert words in str(caught.value)
    assert "--overwrite" in str(caught.value)
    after = tree(path)
    after.pop(f"{BUILD_FOLDER}/lock", None)
    before.pop(f"{BUILD_FOLDER}/lock", None)
    assert after == before


def test_other_versions_assets_or_catalogue_are_refused(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    with pytest.raises(SdgenError, match="numpy none"):
        toy.open_writer(path, toy.small(n=1), versions={**toy.VERSIONS, "numpy": "2"})
    catalog = toy.catalog()
    fewer = catalog.model_copy(update={"hazards": catalog.hazards[1:]})
    with pytest.raises(SdgenError, match="another catalogue; other assets"):
        DatasetWriter.open(
            path, toy.small(n=1), fewer, toy.infos(), "b" * 64, versions=toy.VERSIONS
        )


@pytest.mark.parametrize("content", ["file", "folder", "hidden"])
def test_a_foreign_folder_is_refused_even_with_overwrite(tmp_path: Path, content: str) -> None:
    path = tmp_path / "d"
    path.mkdir()
    if content == "folder":
        (path / "scenes").mkdir()
    else:
        (path / ("thesis.tex" if content == "file" else ".git")).write_text("x")
    for overwrite in (False, True):
        with pytest.raises(SdgenError, match="not empty and holds no data set"):
            toy.open_writer(path, overwrite=overwrite)
    assert len(list(path.iterdir())) == 1


@pytest.mark.parametrize("overwrite", [False, True])
@pytest.mark.parametrize("name", ["dataset.json", ".build/state", ".build/README"])
def test_other_tools_folders_are_refused_whatever_their_names(
    tmp_path: Path, name: str, overwrite: bool
) -> None:
    (tmp_path / "d" / ".build").mkdir(parents=True)
    (tmp_path / "d" / "scenes").mkdir()
    (tmp_path / "d" / "README.md").write_text("mine")
    (tmp_path / "d" / name).write_text('{"name": "another tool"}')
    before = tree(tmp_path / "d")
    with pytest.raises(SdgenError, match="holds no data set of sdgen"):
        toy.open_writer(tmp_path / "d", overwrite=overwrite)
    assert tree(tmp_path / "d") == before


def test_a_build_killed_at_its_very_start_can_be_begun_again(tmp_path: Path) -> None:
    (tmp_path / "d" / BUILD_FOLDER).mkdir(parents=True)
    (tmp_path / "d" / BUILD_FOLDER / "lock").touch()
    with toy.open_writer(tmp_path / "d") as writer:
        assert writer.done == {}


def test_a_file_as_destination_is_refused(tmp_path: Path) -> None:
    (tmp_path / "d").write_text("x")
    with pytest.raises(SdgenError, match="is a file"):
        toy.open_writer(tmp_path / "d")


def test_overwrite_starts_anew_and_keeps_what_is_not_ours(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=3))
    (path / "notes.txt").write_text("mine")
    with toy.open_writer(path, toy.small(n=1, seed=9), overwrite=True) as writer:
        assert writer.done == {}
        toy.add_scene(writer, 0)
        writer.finish()
    assert [p.name for p in (path / "scenes").iterdir()] == ["000000"]
    assert (path / "notes.txt").read_text() == "mine"
    assert Dataset(path).info.seed == 9


def test_a_killed_overwrite_does_not_bring_the_old_scenes_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))

    def killed(folder: Path) -> None:
        if folder.parent.name == "scenes":
            raise KeyboardInterrupt
        shutil.rmtree(folder, ignore_errors=True)

    monkeypatch.setattr("sdgen.dataset.scene_folder.remove_tree", killed)
    with pytest.raises(KeyboardInterrupt):
        toy.open_writer(path, toy.small(n=2, seed=9), overwrite=True)
    monkeypatch.undo()
    with toy.open_writer(path, toy.small(n=2, seed=9)) as writer:
        assert writer.done == {}
        assert again("000000", "000001") <= set(writer.notes)


def _other_seed(path: Path) -> None:
    """Nothing is wrong with the folder: it is asked for another build."""


def _broken_manifest(path: Path) -> None:
    (path / "manifest.jsonl").write_text("no line of ours\n")


@pytest.mark.parametrize(
    ("spoil", "seed", "words"),
    [(_other_seed, 9, "holds a data set built with seed 7"), (_broken_manifest, 7, "manifest")],
)
def test_a_refused_build_leaves_a_finished_data_set_as_it_was(
    tmp_path: Path, spoil: Any, seed: int, words: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    spoil(path)
    before = sorted(path.rglob("*"))
    with pytest.raises(SdgenError, match=words):
        toy.open_writer(path, toy.small(n=2, seed=seed))
    assert sorted(path.rglob("*")) == before


def test_a_refused_build_leaves_an_unfinished_one_to_go_on_with(tmp_path: Path) -> None:
    path = tmp_path / "d"
    with toy.open_writer(path) as writer:
        toy.add_scene(writer, 0)
    with pytest.raises(SdgenError, match="seed 7"):
        toy.open_writer(path, toy.small(seed=9))
    with toy.open_writer(path) as writer:
        assert list(writer.done) == ["000000"]


def _try_to_open(path: str, queue: Any) -> None:
    try:
        with toy.open_writer(Path(path), toy.small(n=1)):
            queue.put("opened")
    except SdgenError as error:
        queue.put(str(error))


def test_a_second_build_on_one_folder_says_so_and_leaves_it_be(tmp_path: Path) -> None:
    context = multiprocessing.get_context("spawn")
    queue = context.Queue()
    with toy.open_writer(tmp_path / "d", toy.small(n=1)) as writer:
        toy.add_scene(writer, 0)
        before = tree(tmp_path / "d")
        process = context.Process(target=_try_to_open, args=(str(tmp_path / "d"), queue))
        process.start()
        assert "another build is writing here" in queue.get(timeout=60)
        process.join()
        assert tree(tmp_path / "d") == before
        writer.finish()
    with toy.open_writer(tmp_path / "d", toy.small(n=1)):
        pass  # the lock is free again


def test_a_full_disk_loses_nothing_and_leaves_no_half_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "d"
    with toy.open_writer(path, toy.small(n=2)) as writer:
        toy.add_scene(writer, 0)

        def full(target: Path) -> None:
            raise OSError(errno.ENOSPC, "No space left on device", str(target))

        monkeypatch.setattr(scene_folder_module, "sync_file", full)
        with pytest.raises(OSError, match="No space left"):
            toy.add_scene(writer, 1)
        monkeypatch.undo()
        assert [p.name for p in (path / "scenes").iterdir()] == ["000000"]
        assert not list((path / BUILD_FOLDER).glob("*.partial"))
    assert len(Dataset(toy.build(path, toy.small(n=2)))) == 2


def test_an_interrupted_finish_keeps_every_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "d"
    with toy.open_writer(path, toy.small(n=1)) as writer:
        toy.add_scene(writer, 0)
        monkeypatch.setattr("sdgen.dataset.writer.card", lambda *info: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            writer.finish()
        monkeypatch.undo()
    with toy.open_writer(path, toy.small(n=1)) as writer:
        assert list(writer.done) == ["000000"]


def test_range_pieces_and_failed_scenes_are_recorded(tmp_path: Path) -> None:
    causes = {Cause("home", "no_free_floor"): 5, Cause("hazards", "no_place", "spill"): 2}
    with toy.open_writer(tmp_path / "d", toy.small(n=4)) as writer:
        toy.add_scene(writer, 2)
        info = writer.finish(failed={"000003": causes})
    assert info.n == 4
    assert info.counts.scenes == 1
    assert info.failed == {"000003": cause_counts(causes)}
    assert "000003" in (tmp_path / "d" / "README.md").read_text(encoding="utf-8")
    with toy.open_writer(tmp_path / "d", toy.small(n=4)) as writer:
        toy.add_scene(writer, 1)  # another range: what failed before is still missing
        assert writer.finish().failed == {"000003": cause_counts(causes)}
    with toy.open_writer(tmp_path / "d", toy.small(n=4)) as writer:
        toy.add_scene(writer, 3)
        assert writer.finish().failed == {}


def test_dataset_json_counts_what_is_there(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    info = json.loads((path / "dataset.json").read_text(encoding="utf-8"))
    assert info["counts"]["anomalies"] == 0 + 1 + 2 + 3
    assert info["counts"]["anomalies_by_hazard"] == {
        "refrigerated_food_out": 1,
        "sharp_object": 2,
        "stove_on": 3,
    }
    assert info["counts"]["scenes_by_anomalies"] == {"0": 1, "1": 1, "2": 1, "3": 1}
    assert info["renderers"] == ["painted"]
    assert "RED" not in info["vocabularies"]["states"]
    assert "ON" in info["vocabularies"]["states"]


def test_vocabularies_cover_all_words_of_the_graphs(tmp_path: Path) -> None:
    made = Dataset(toy.build(tmp_path / "d"))
    words = made.info.vocabularies
    for item in made:
        for node in item.scene_graph.nodes:
            assert node.class_name in {*words.categories, *words.room_types}
            assert node.category in words.superclasses
            assert set(node.states) <= set(words.states)
            assert set(node.tags) <= set(words.tags)
            assert set(node.properties) <= set(words.properties)
        assert {e.relation_type for e in item.scene_graph.edges} <= set(words.relations)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_read_only_destination_is_an_os_error(tmp_path: Path) -> None:
    tmp_path.chmod(0o555)
    with pytest.raises(OSError):
        toy.open_writer(tmp_path / "d")


def test_twins_are_written_beside_their_scenes_and_not_counted(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 4)
    data = Dataset(path)
    assert [item.id for item in data] == [f"{k:06d}" for k in range(4)]
    twins = Dataset(path, twins=True)
    assert [item.id for item in twins] == [f"{k:06d}-twin" for k in range(4)]
    assert (data.info.n, data.info.counts.scenes, data.info.counts.twins) == (4, 4, 4)
    assert data.info.counts.anomalies == 6
    assert twins[3].anomalies.anomalies == ()
    assert twins[3].cameras == data[3].cameras
    kept = {item.id for item in twins[3].scene.objects}
    assert kept == {item.id for item in data[3].scene.objects} - {600}


def test_toggles_are_written_beside_their_scenes_and_counted_apart(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 4, toggles=True)
    data, toggles = Dataset(path), Dataset(path, toggles=True)
    assert [item.id for item in data] == [f"{k:06d}" for k in range(4)]
    wanted = [f"{k:06d}-undo-a{a:02d}" for k in range(4) for a in range(k)]
    assert [item.id for item in toggles] == wanted
    assert [item.id for item in Dataset(path, twins=True)] == [f"{k:06d}-twin" for k in range(4)]
    assert len(Dataset(path, twins=True, toggles=True)) == 4 + len(wanted)
    counts = data.info.counts
    assert (counts.scenes, counts.twins, counts.toggles, counts.anomalies) == (4, 4, 6, 6)
    assert "6 toggles" in repr(toggles)
    for item in toggles:
        scene = data.scene(str(item.scene.twin_of))
        (undone,) = item.anomalies.undone
        labels = {one.id: one for one in scene.anomalies.anomalies}
        assert item.id == f"{scene.id}-undo-{undone.anomaly_id}"
        assert {one.id: one.message for one in item.anomalies.anomalies} == {
            key: one.message for key, one in labels.items() if key != undone.anomaly_id
        }
        assert item.cameras == scene.cameras


def test_a_scene_without_its_toggles_is_made_again(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 3, toggles=True)
    before = tree(path)
    shutil.rmtree(path / "scenes" / "000002-undo-a01")
    with toy.open_writer(path, toy.small(n=3, twins=True, toggles=True)) as writer:
        gone = {"000002", "000002-undo-a01"}
        assert set(writer.done) == {p.name for p in (path / "scenes").iterdir()} - {"000002"}
        assert gone.isdisjoint(writer.done)
    assert tree(toy.build_with_twins(path, 3, toggles=True)) == before


def test_a_scene_without_its_twin_is_made_again(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 2)
    before = tree(path)
    shutil.rmtree(path / "scenes" / "000001-twin")
    with toy.open_writer(path, toy.small(n=2, twins=True)) as writer:
        assert sorted(writer.done) == ["000000", "000000-twin"]
    assert tree(toy.build_with_twins(path, 2)) == before


@pytest.mark.parametrize("place", ["scenes/000000/x", "scenes", ".build/x"])
def test_no_data_set_is_made_within_another(tmp_path: Path, place: str) -> None:
    whole = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    before = sorted(whole.rglob("*"))
    with pytest.raises(SdgenError, match=f"belongs to the data set {whole}; choose another place"):
        toy.open_writer(whole / place, toy.small(n=1))
    assert sorted(whole.rglob("*")) == before
    with toy.open_writer(whole / "beside", toy.small(n=1)):
        pass
