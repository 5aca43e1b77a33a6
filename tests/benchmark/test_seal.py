"""Sealed tests: the secret is bound and hidden, and every byte is proved."""

from __future__ import annotations

import stat
from pathlib import Path

import pytest
from sdgen.benchmark import seal as sealing
from sdgen.benchmark.seal import Seal, Secret, opened, read_seal, seal, secret_of, without_seeds
from sdgen.dataset import Dataset
from sdgen.dataset.text import record_bytes
from sdgen.errors import InputError, SdgenError, UsageError

from tests import toy

SEED = sealing.LEAST_SEED + 7
SECRET = Secret(seed=SEED, nonce="0" * 64)


def made(path: Path, n: int = 4, seed: int = SEED) -> Dataset:
    return Dataset(toy.build(path, toy.small(n=n, seed=seed, twins=True)))


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return made(tmp_path_factory.mktemp("set") / "d")


def test_a_seal_tells_nothing_of_the_seed_and_has_every_scene(data: Dataset) -> None:
    sealed = seal(data, SECRET)
    text = record_bytes(sealed).decode()
    assert str(SEED) not in text
    assert SECRET.nonce not in text
    assert {scene.id for scene in sealed.scenes} == {entry.id for entry in data.entries}
    assert sealed.options.seed == 0


def test_the_commitment_hides_behind_its_nonce_and_binds_both() -> None:
    other = Secret(seed=SEED, nonce="1" * 64)
    assert other.commitment != SECRET.commitment
    assert Secret(seed=SEED + 1, nonce=SECRET.nonce).commitment != SECRET.commitment


def test_the_same_test_set_opens_clean_and_any_change_is_named(
    data: Dataset, tmp_path: Path
) -> None:
    sealed = seal(data, SECRET)
    again = made(tmp_path / "again")
    assert list(opened(sealed, SECRET, again)) == []
    file = again.path / "scenes" / "000003" / "scene.json"
    file.write_bytes(file.read_bytes() + b" ")
    problems = list(opened(sealed, SECRET, Dataset(again.path)))
    assert len(problems) == 1
    assert problems[0].startswith("scenes/000003/scene.json: changed since it was written")


def test_a_changed_picture_and_a_manifest_that_lies_are_found(
    data: Dataset, tmp_path: Path
) -> None:
    sealed = seal(data, SECRET)
    again = made(tmp_path / "again")
    picture = again.path / "scenes" / "000001" / "views" / "00" / "rgb.png"
    picture.write_bytes(picture.read_bytes() + b" ")
    assert "scenes/000001/views/00/rgb.png" in next(opened(sealed, SECRET, again))
    # Another scene, sealed by its own manifest, is not the one that was sealed.
    other = made(tmp_path / "other", seed=SEED + 1)
    problems = list(opened(sealed, SECRET, other))
    assert problems[0] == "dataset.json: seed: not the one of the secret"


def test_missing_and_further_scenes_are_named(data: Dataset, tmp_path: Path) -> None:
    sealed = seal(data, SECRET)
    few, many = made(tmp_path / "few", n=3), made(tmp_path / "many", n=5)
    assert "scenes/000003: is missing" in list(opened(sealed, SECRET, few))
    assert "scenes/000004: was not sealed" in list(opened(sealed, SECRET, many))


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def test_what_readers_go_by_beside_the_scenes_is_sealed_too(data: Dataset, tmp_path: Path) -> None:
    sealed = seal(data, SECRET)
    again = made(tmp_path / "again")
    entry = again.entries[0]
    to = "train" if entry.split != "train" else "test"
    change(again.path / "manifest.jsonl", f'"split": "{entry.split}"', f'"split": "{to}"')
    change(again.path / "dataset.json", '"licence"', '"licence" ')
    (again.path / "scenes" / entry.id / "extra.txt").write_text("x")
    (again.path / "scenes" / "000009").mkdir()
    table = again.path / "assets.jsonl"
    table.write_bytes(table.read_bytes() + b"\n")
    assert set(opened(sealed, SECRET, Dataset(again.path, partial=True))) == {
        f"manifest.jsonl: {entry.id}: not what was sealed (its split, what it holds)",
        f"scenes/{entry.id}/extra.txt: was not sealed",
        "scenes/000009: was not sealed",
        "assets.jsonl: not the one that was sealed",
    }
    info = again.info.model_copy(update={"hazards_enabled": again.info.hazards_enabled[1:]})
    (again.path / "dataset.json").write_bytes(record_bytes(info))
    problems = list(opened(sealed, SECRET, Dataset(again.path, partial=True)))
    assert "dataset.json: not the one that was sealed (its splits, counts or words)" in problems


def test_another_renderer_excuses_pictures_and_nothing_else(data: Dataset, tmp_path: Path) -> None:
    sealed = seal(data, SECRET).model_copy(update={"renderers": ("another",)})
    again = made(tmp_path / "again")
    assert list(opened(sealed, SECRET, again)) == []
    folder = again.path / "scenes" / "000002"
    (folder / "views" / "00" / "rgb.png").write_bytes(b"junk")
    (problem,) = opened(sealed, SECRET, again)
    assert problem.startswith("scenes/000002/views/00/rgb.png: changed")
    # Nor is a file struck from the manifest, or the lines of it in another order.
    entries = [
        one.model_copy(update={"files": {k: v for k, v in one.files.items() if "rgb" not in k}})
        if one.id == "000002"
        else one
        for one in again.entries
    ]
    lines = [record_bytes(one).replace(b"\n", b"") + b"\n" for one in reversed(entries)]
    (again.path / "manifest.jsonl").write_bytes(b"".join(lines))
    problems = list(opened(sealed, SECRET, Dataset(again.path, partial=True)))
    assert "manifest.jsonl: its scenes stand in another order" in problems
    assert "manifest.jsonl: 000002: not what was sealed (its split, what it holds)" in problems
    none = sealed.model_copy(update={"renderers": ()})
    assert "the seal is of a data set without pictures" in list(opened(none, SECRET, data))


def test_a_linked_folder_is_a_stray(data: Dataset, tmp_path: Path) -> None:
    sealed = seal(data, SECRET)
    again = made(tmp_path / "again")
    views = again.path / "scenes" / "000001" / "views"
    views.rename(tmp_path / "views")
    views.symlink_to(tmp_path / "views")
    assert "scenes/000001/views: was not sealed" in list(opened(sealed, SECRET, again))


def test_errors_tell_no_seed() -> None:
    error = UsageError(f"built with seed {SEED} (now {SEED + 1}), --n 4")
    told = without_seeds(error)
    assert str(told) == "built with seed (secret) (now (secret)), --n 4"
    assert told.exit_code == error.exit_code


def test_a_seal_has_each_scene_once_and_one_at_least(data: Dataset, tmp_path: Path) -> None:
    sealed = seal(data, SECRET)
    path = tmp_path / "seal.json"
    for scenes in ((), (sealed.scenes[0], sealed.scenes[0])):
        path.write_bytes(record_bytes(sealed.model_copy(update={"scenes": scenes})))
        with pytest.raises(InputError, match="scenes"):
            read_seal(path)
    path.write_bytes(record_bytes(sealed.model_copy(update={"tables": {}})))
    with pytest.raises(InputError, match="tables"):
        read_seal(path)


def test_what_a_bad_secret_holds_is_not_told(tmp_path: Path) -> None:
    path = tmp_path / "secret.json"
    path.write_text('{"seed": 987654321, "nonce": "MYSECRETWORD"}')
    with pytest.raises(InputError) as caught:
        secret_of(path)
    assert "nonce" in str(caught.value)
    assert "MYSECRETWORD" not in str(caught.value)
    assert "987654321" not in str(caught.value)


def test_another_secret_opens_nothing(data: Dataset) -> None:
    sealed = seal(data, SECRET)
    with pytest.raises(SdgenError, match="not the secret that the seal commits to"):
        list(opened(sealed, Secret(seed=SEED, nonce="2" * 64), data))
    with pytest.raises(SdgenError, match="was not built with the seed"):
        seal(data, Secret(seed=SEED + 1, nonce="0" * 64))


def test_a_part_is_not_sealed(data: Dataset) -> None:
    with pytest.raises(SdgenError, match="a whole data set"):
        seal(Dataset(data.path, split="train"), SECRET)


def test_a_new_secret_is_made_once_and_for_its_owner_alone(tmp_path: Path) -> None:
    path = tmp_path / "keep" / "secret.json"
    one = secret_of(path, make=True)
    assert secret_of(path, make=True) == one == secret_of(path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert sealing.new_secret() != one


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("7", "expected a mapping"),
        ('{"seed": 7, "nonce": "' + "0" * 64 + '"}', "seed"),
        ('{"seed": 281474976710700}', "missing key 'nonce'"),
        ('{"seed": 281474976710700, "nonce": "ABC"}', "nonce"),
        ("{", "not JSON"),
    ],
)
def test_a_bad_secret_is_located(tmp_path: Path, text: str, expected: str) -> None:
    path = tmp_path / "secret.json"
    path.write_text(text)
    with pytest.raises(InputError, match=expected) as caught:
        secret_of(path)
    assert all(problem.startswith(str(path)) for problem in caught.value.problems)


def test_a_seal_reads_back_and_its_digest_binds_all_of_it(data: Dataset, tmp_path: Path) -> None:
    sealed = seal(data, SECRET)
    path = tmp_path / "seal.json"
    path.write_bytes(record_bytes(sealed))
    assert read_seal(path) == sealed
    changed = sealed.model_copy(update={"scenes": sealed.scenes[:-1]})
    assert isinstance(changed, Seal)
    assert changed.digest != sealed.digest
    path.write_text('{"format": "sdgen seal 2"}')
    with pytest.raises(InputError):
        read_seal(path)
