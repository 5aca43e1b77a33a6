"""Models come whole, in their source's own layout; a second run fetches what is not as it was."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Sequence
from pathlib import Path

import pytest
from sdgen.errors import AssetError, InputError, SdgenError, UsageError
from sdgen.importing.client import Client
from sdgen.importing.fetch import FetchReport, chosen, client_of, fetch
from sdgen.importing.fetched import FILE
from sdgen.importing.listing import list_models
from sdgen.importing.sources import Source, load_sources
from sdgen.library.licences import LICENCES
from sdgen.locks import FileLock

from tests.importing.evil_archives import everything_below, zip_of
from tests.importing.fake_sources import (
    GSO,
    HUB,
    HUB_FILES,
    HUB_LIST,
    YCB,
    gso_path,
    put_gso,
    put_hub,
    put_ycb,
    ycb_path,
)
from tests.importing.file_server import Site


def run(
    site: Site, source_id: str, out: Path, names: Sequence[str] = (), attempts: int = 1
) -> FetchReport:
    """Fetch models (none named: all) from the source on this machine."""
    source = load_sources()[source_id].at(site.base)
    client = Client(source.base, source.redirects, attempts=attempts, wait=lambda _: None)
    models = list_models(source, client)
    return fetch(source, chosen(models, names or list(models)), out, client)


def listed(site: Site, source_id: str) -> list[str]:
    source = load_sources()[source_id].at(site.base)
    return list(list_models(source, Client(source.base, attempts=1)))


def note(out: Path) -> dict[str, dict[str, object]]:
    value = json.loads((out / FILE).read_text(encoding="utf-8"))
    return {model["name"]: model for model in value["models"]}


def model_requests(site: Site) -> list[str]:
    lists = ("objects.json", "models?per_page", "tree/main", "/page2")
    return [path for path, _ in site.asked if not any(part in path for part in lists)]


def test_ycb_comes_in_its_own_layout(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    out = tmp_path / "scans" / "ycb"
    report = run(site, "ycb", out, ["002_can", "025_mug"])
    assert (report.fetched, report.kept, report.problems) == (("002_can", "025_mug"), (), ())
    assert everything_below(out) == {
        FILE,
        "002_can",
        "002_can/google_16k",
        "002_can/google_16k/textured.obj",
        "002_can/google_16k/texture_map.png",
        "025_mug",
        "025_mug/tsdf",
        "025_mug/tsdf/textured.obj",
    }


def test_gso_comes_in_its_own_layout(site: Site, tmp_path: Path) -> None:
    put_gso(site)
    assert run(site, "gso", tmp_path).fetched == tuple(sorted(GSO))
    for name in GSO:
        assert (tmp_path / name / "meshes" / "model.obj").read_text() == f"# {name}\n"
        assert (tmp_path / name / "model.config").is_file()


def test_replicacad_comes_as_the_data_set_it_is(site: Site, tmp_path: Path) -> None:
    put_hub(site)
    out = tmp_path / "out"
    assert listed(site, "replicacad") == ["common", "fridge", "frl_sofa", "scenes"]
    assert run(site, "replicacad", out, ["frl_sofa"]).fetched == ("common", "frl_sofa")
    found = {name for name in everything_below(out) if (out / name).is_file()} - {FILE}
    common = {"LICENSE.txt", "replicaCAD.scene_dataset_config.json"}
    assert found == common | {name for name in HUB_FILES if "sofa" in name}
    run(site, "replicacad", out)
    found = {name for name in everything_below(out) if (out / name).is_file()} - {FILE}
    assert found == {name for name in HUB_FILES if ".." not in name and "nav" not in name}
    assert all((out / name).read_bytes() == HUB_FILES[name] for name in found)
    assert not (tmp_path / "evil.glb").exists()


def test_names_that_cannot_be_folders_are_left_out(site: Site) -> None:
    put_ycb(site)
    put_gso(site)
    assert listed(site, "ycb") == sorted(YCB)
    assert listed(site, "gso") == sorted(GSO)


def test_what_was_fetched_is_noted(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    run(site, "ycb", tmp_path, ["002_can"])
    whole = json.loads((tmp_path / FILE).read_text(encoding="utf-8"))
    (model,) = whole.pop("models")
    source = load_sources()["ycb"]
    assert whole == {
        "format": 1,
        "source": "ycb",
        "homepage": source.homepage,
        "licence": "CC-BY-4.0",
        "licence_url": source.licence_url,
        "attribution": source.attribution,
    }
    body = site.files[ycb_path("002_can")].body
    assert model["downloads"] == [
        {
            "address": f"{site.base}{ycb_path('002_can')}",
            "bytes": len(body),
            "sha256": hashlib.sha256(body).hexdigest(),
            "validator": site.files[ycb_path("002_can")].tag(),
        }
    ]
    assert model["licence"] == "CC-BY-4.0"
    for file in model["files"]:
        raw = (tmp_path / file["path"]).read_bytes()
        assert (file["bytes"], file["sha256"]) == (len(raw), hashlib.sha256(raw).hexdigest())
    assert len(model["files"]) == 2


def test_the_same_models_make_the_same_note(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    run(site, "ycb", tmp_path / "a", ["002_can", "025_mug"])
    run(site, "ycb", tmp_path / "b", ["025_mug"])
    run(site, "ycb", tmp_path / "b", ["002_can"])
    assert (tmp_path / "a" / FILE).read_bytes() == (tmp_path / "b" / FILE).read_bytes()


@pytest.mark.parametrize(
    ("source_id", "put"), [("ycb", put_ycb), ("gso", put_gso), ("replicacad", put_hub)]
)
def test_a_second_run_fetches_nothing(
    source_id: str, put: object, site: Site, tmp_path: Path
) -> None:
    put(site)  # type: ignore[operator]
    names = {"ycb": YCB[:3], "gso": GSO, "replicacad": ["frl_sofa", "fridge"]}[source_id]
    first = run(site, source_id, tmp_path, names)
    before = (tmp_path / FILE).read_bytes()
    site.asked.clear()
    second = run(site, source_id, tmp_path, names)
    assert (second.fetched, second.problems) == ((), ())
    assert set(second.kept) == set(first.fetched)
    assert (tmp_path / FILE).read_bytes() == before
    # The lists of two sources tell versions; the third is asked, and has nothing new.
    asked = [headers.get("if-none-match") for _, headers in site.asked[1:]]
    assert len(model_requests(site)) == (3 if source_id == "ycb" else 0)
    assert source_id != "ycb" or all(asked)


@pytest.mark.parametrize("harm", ["changed", "shorter", "missing", "folder", "link"])
def test_a_second_run_mends_what_is_damaged(harm: str, site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    run(site, "ycb", tmp_path, YCB[:3])
    file = tmp_path / "002_can" / "google_16k" / "textured.obj"
    good = file.read_bytes()
    if harm == "changed":
        file.write_bytes(good[:-1] + b"x")
    elif harm == "shorter":
        file.write_bytes(good[:-1])
    elif harm == "missing":
        file.unlink()
    elif harm == "folder":
        file.unlink()
        file.mkdir()
    else:
        file.rename(tmp_path / "moved")
        file.symlink_to(tmp_path / "moved")
    assert run(site, "ycb", tmp_path, YCB[:3]).fetched == ("002_can",)
    assert file.read_bytes() == good
    assert not file.is_symlink()


def test_a_newer_version_is_fetched(site: Site, tmp_path: Path) -> None:
    put_gso(site)
    put_ycb(site)
    put_hub(site)
    gso, ycb, hub = tmp_path / "gso", tmp_path / "ycb", tmp_path / "hub"
    run(site, "gso", gso)
    run(site, "ycb", ycb, YCB[:3])
    run(site, "replicacad", hub)
    page = site.files["/1.0/GoogleResearch/models?per_page=100&page=2"]
    page.body = page.body.replace(b'"version": 1', b'"version": 2')
    site.put(gso_path("Café_Set"), zip_of({"model.config": b"<new/>"}))
    assert run(site, "gso", gso).fetched == ("Café_Set",)
    assert everything_below(gso / "Café_Set") == {"model.config"}  # nothing of the old one
    site.put(ycb_path("002_can"), zip_of({"google_16k/textured.obj": b"# new"}))
    assert run(site, "ycb", ycb, YCB[:3]).fetched == ("002_can",)
    assert (ycb / "002_can/google_16k/textured.obj").read_bytes() == b"# new"
    old, new = HUB_FILES["objects/frl_sofa.glb"], b"Gltf" * 5000
    listing = site.files[HUB_LIST]
    for text in (hashlib.sha256, lambda raw: hashlib.sha1(b"blob %d\0" % len(raw) + raw)):
        listing.body = listing.body.replace(
            text(old).hexdigest().encode(), text(new).hexdigest().encode()
        )
    site.put(f"{HUB}/objects/frl_sofa.glb", new)
    assert run(site, "replicacad", hub).fetched == ("frl_sofa",)
    assert (hub / "objects/frl_sofa.glb").read_bytes() == new


def test_one_model_that_fails_leaves_the_others(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    evil = zip_of({"a": b"", "../evil": b"", "/etc/evil": b""})
    site.put(ycb_path("063-a_marbles"), evil)
    report = run(site, "ycb", tmp_path)
    assert report.fetched == ("002_can", "025_mug")
    assert report.absent == ("099_gone",)
    address = f"063-a_marbles: {site.base}{ycb_path('063-a_marbles')}"
    assert report.problems == (
        f"{address}: ../evil: climbs out of its folder ('..')",
        f"{address}: /etc/evil: is an absolute path",
    )
    assert not any("evil" in name or "marbles" in name for name in everything_below(tmp_path))
    assert set(note(tmp_path)) == {"002_can", "025_mug"}


def test_a_listed_file_that_is_not_there_is_a_problem(site: Site, tmp_path: Path) -> None:
    put_hub(site)
    del site.files[f"{HUB}/objects/frl_sofa.glb"]
    (problem,) = run(site, "replicacad", tmp_path, ["frl_sofa"]).problems
    assert problem == f"frl_sofa: {site.base}{HUB}/objects/frl_sofa.glb: is not there (answer 404)"


def test_a_wrong_checksum_leaves_nothing(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    put_hub(site)
    site.files[ycb_path("002_can")].etag = '"' + "0" * 32 + '"'
    (problem,) = run(site, "ycb", tmp_path / "ycb", ["002_can"]).problems
    assert "its checksum is not the one its source states" in problem
    site.put(f"{HUB}/objects/frl_sofa.glb", b"x" * len(HUB_FILES["objects/frl_sofa.glb"]))
    report = run(site, "replicacad", tmp_path / "hub", ["frl_sofa"])
    assert "its checksum" in report.problems[0]
    assert report.fetched == ("common",)
    assert not (tmp_path / "hub" / "objects").exists()
    assert not (tmp_path / "ycb").exists()  # nothing came


def test_what_has_come_of_a_model_waits_for_the_next_run(site: Site, tmp_path: Path) -> None:
    put_hub(site)
    big = "/".join([HUB, "objects/frl_sofa.glb"])
    served = site.files[big]
    served.cut_after, served.cuts = 8000, 1
    report = run(site, "replicacad", tmp_path, ["frl_sofa"])
    assert "broke off after 8000 of 20000 bytes" in report.problems[0]
    assert not (tmp_path / "objects").exists()
    assert list((tmp_path / ".fetching").glob("*.part"))
    site.asked.clear()
    assert run(site, "replicacad", tmp_path, ["frl_sofa"]).fetched == ("frl_sofa",)
    assert [headers.get("range") for path, headers in site.asked if path == big] == ["bytes=8000-"]
    # The files that had come whole are not fetched again.
    assert model_requests(site) == [big]
    assert not (tmp_path / ".fetching").exists()


def test_a_stricter_licence_than_the_accepted_one_is_refused(site: Site, tmp_path: Path) -> None:
    put_gso(site, "Creative Commons Attribution Non Commercial 4.0 International")
    report = run(site, "gso", tmp_path, ["Mug_Blue"])
    assert report.problems == (
        "Mug_Blue: its licence is 'Creative Commons Attribution Non Commercial 4.0 International', "
        "not the CC-BY-4.0 accepted",
    )
    assert model_requests(site) == []


def test_a_licence_a_model_states_is_noted(site: Site, tmp_path: Path) -> None:
    put_gso(site)
    run(site, "gso", tmp_path, ["Mug_Blue"])
    licence = note(tmp_path)["Mug_Blue"]["licence"]
    assert licence == "Creative Commons Attribution 4.0 International"


def test_what_was_not_fetched_is_not_written_over(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    put_hub(site)
    mine = tmp_path / "ycb" / "002_can" / "mine.obj"
    mine.parent.mkdir(parents=True)
    mine.write_text("mine")
    report = run(site, "ycb", tmp_path / "ycb", ["002_can", "025_mug"])
    assert report.fetched == ("025_mug",)
    assert report.problems == (
        f"002_can: {mine.parent}: is there, and was not fetched; move it away",
    )
    assert os.listdir(mine.parent) == ["mine.obj"]
    (tmp_path / "hub").mkdir()
    (tmp_path / "hub" / "LICENSE.txt").symlink_to(mine)
    (problem,) = run(site, "replicacad", tmp_path / "hub", ["common"]).problems
    assert "is there, and was not fetched" in problem
    assert mine.read_text() == "mine"


def test_a_folder_is_of_one_source(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    put_gso(site)
    run(site, "ycb", tmp_path, ["002_can"])
    with pytest.raises(AssetError, match="lists models of 'ycb'; name another --out"):
        run(site, "gso", tmp_path, ["Mug_Blue"])


@pytest.mark.parametrize("spoil", ["{", "[]", '{"format": 2}', "climbs", "link"])
def test_a_note_that_is_not_ours_is_told(spoil: str, site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    run(site, "ycb", tmp_path, ["002_can"])
    path = tmp_path / FILE
    if spoil == "climbs":
        path.write_text(path.read_text().replace("002_can/google_16k/textured", "../textured"))
    elif spoil == "link":
        path.rename(tmp_path / "moved")
        path.symlink_to(tmp_path / "moved")
    else:
        path.write_text(spoil)
    with pytest.raises(AssetError, match=FILE):
        run(site, "ycb", tmp_path, ["002_can"])


def test_one_fetch_at_a_time(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    (tmp_path / ".fetching").mkdir()
    lock = FileLock.take(tmp_path / ".fetching" / "lock")
    assert lock is not None
    with pytest.raises(SdgenError, match="another fetch is at work"):
        run(site, "ycb", tmp_path, ["002_can"])
    lock.release()
    assert run(site, "ycb", tmp_path, ["002_can"]).fetched == ("002_can",)


def test_no_data_set_and_no_link_is_fetched_into(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    (tmp_path / "dataset.json").write_text("{}")
    (tmp_path / "scenes").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "scenes")
    for place in ("link", "scenes/in"):
        with pytest.raises(SdgenError):
            run(site, "ycb", tmp_path / place, ["002_can"])
    assert os.listdir(tmp_path / "scenes") == []


def test_an_unknown_model_is_told_with_the_nearest(site: Site, tmp_path: Path) -> None:
    put_ycb(site)
    with pytest.raises(UsageError, match="no model '025_mugg' \\(did you mean '025_mug'\\?\\)"):
        run(site, "ycb", tmp_path / "out", ["025_mugg"])
    assert model_requests(site) == []
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("source_id", "path", "body"),
    [
        ("ycb", "/data/objects.json", b"[]"),
        ("ycb", "/data/objects.json", b'{"objects": {"a": 1}}'),
        ("ycb", "/data/objects.json", b'{"objects": []}'),
        ("ycb", "/data/objects.json", b"<html>"),
        ("gso", "/1.0/GoogleResearch/models?per_page=100&page=1", b"{}"),
        ("gso", "/1.0/GoogleResearch/models?per_page=100&page=1", b"[]"),
        ("replicacad", HUB_LIST, b'{"error": "gone"}'),
        ("replicacad", HUB_LIST, b'[1, {"type": "file", "path": 3, "size": "x"}]'),
    ],
)
def test_a_list_that_is_none_is_one_clear_error(
    source_id: str, path: str, body: bytes, site: Site
) -> None:
    site.put(path, body)
    with pytest.raises(AssetError) as caught:
        listed(site, source_id)
    (problem,) = caught.value.problems
    assert problem.removeprefix(site.base).removeprefix(path) in (
        ": is no JSON",
        ": is no list of models",
        ": lists no model",
    )


def test_a_list_that_is_not_there_is_one_clear_error(site: Site) -> None:
    for source_id in ("ycb", "gso", "replicacad"):
        with pytest.raises(AssetError, match="is not there"):
            listed(site, source_id)


def test_the_shipped_sources_are_as_the_importers_need_them() -> None:
    sources = load_sources()
    assert list(sources) == ["ycb", "gso", "replicacad", "fantastic-breaks"]
    for source in sources.values():
        if source.base:
            assert source.base.startswith("https://")
            assert client_of(source).base == source.base
            assert source.licence_url
        # What may not be sold is what the library takes only when told to.
        assert source.non_commercial == (source.licence not in LICENCES)
    assert "disagree" in sources["replicacad"].note


def test_what_no_program_may_fetch_says_what_to_do() -> None:
    source = load_sources()["fantastic-breaks"]
    for one in (source, source.at("http://127.0.0.1:1")):
        with pytest.raises(SdgenError, match=r"hand it out themselves.*FantasticBreaks"):
            client_of(one)


@pytest.mark.parametrize(
    "url",
    [
        "",
        "host",
        "ftp://host",
        "file:///x",
        "http://",
        "http://me:x@host",
        "http://a?b",
        "http://[",
    ],
)
def test_a_mirror_is_an_http_address(url: str) -> None:
    with pytest.raises(UsageError, match="--base-url"):
        load_sources()["ycb"].at(url)


def test_sources_are_read_strictly(tmp_path: Path) -> None:
    path = tmp_path / "addresses.yaml"
    path.write_text("sources:\n  - {id: x, titel: X}\n  - {id: y, base: z}\n")
    with pytest.raises(InputError) as caught:
        load_sources(path)
    assert any("titel" in problem for problem in caught.value.problems)
    path.write_text("[]")
    with pytest.raises(InputError):
        load_sources(path)
    assert isinstance(load_sources()["ycb"], Source)
