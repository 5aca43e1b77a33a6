"""The little server: the page, its pictures, and no file from anywhere else."""

import http.client
import os
import threading
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from sdgen.errors import SdgenError
from sdgen.gallery import serve


@pytest.fixture
def site(tmp_path: Path) -> tuple[str, int]:
    root = tmp_path / "site"
    (root / "view").mkdir(parents=True)
    (root / "view/index.html").write_text("the page")
    (tmp_path / "secret.txt").write_text("secret")
    os.mkfifo(root / "pipe.txt")
    (root / "link.txt").symlink_to(tmp_path / "secret.txt")
    ready = threading.Event()
    told: list[str] = []

    def tell(url: str) -> None:
        told.append(url)
        ready.set()

    run = threading.Thread(
        target=serve, args=(root, root / "view/index.html", 0, tell), daemon=True
    )
    run.start()
    assert ready.wait(20)
    parts = urlsplit(told[0])
    assert (parts.hostname, parts.path) == ("127.0.0.1", "/view/index.html")
    assert parts.port is not None
    return "127.0.0.1", parts.port


def get(site: tuple[str, int], path: str) -> tuple[int, bytes]:
    connection = http.client.HTTPConnection(*site, timeout=20)
    connection.putrequest("GET", path, skip_host=False)
    connection.endheaders()
    answer = connection.getresponse()
    return answer.status, answer.read()


def test_it_serves_the_page_and_nothing_outside(site: tuple[str, int]) -> None:
    assert get(site, "/view/index.html") == (200, b"the page")
    assert get(site, "/") == (302, b"")
    for path in ("/link.txt", "/pipe.txt", "/../secret.txt", "/%2e%2e/secret.txt", "/none"):
        status, body = get(site, path)
        assert status == 404, path
        assert b"secret" not in body.replace(b"secret.txt", b"")


def test_a_taken_port_is_one_clear_error(site: tuple[str, int], tmp_path: Path) -> None:
    with pytest.raises(SdgenError, match=f"port {site[1]}"):
        serve(tmp_path, tmp_path / "site/view/index.html", site[1], lambda url: None)
