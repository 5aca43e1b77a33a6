"""Serves a data set and its page to this machine's browser, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import IO, Any
from urllib.parse import quote

from sdgen.errors import SdgenError


class _Quiet(SimpleHTTPRequestHandler):
    """Files below one folder: no listings, no links that lead out of it, no pipes, no log.

    Who asks for nothing is sent to ``front``.
    """

    def __init__(self, *args: Any, front: str, **kwargs: Any) -> None:
        self.front = front
        super().__init__(*args, **kwargs)

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""

    def list_directory(self, path: str) -> None:  # type: ignore[override]
        """A folder without an index is not found."""
        self.send_error(404)

    def send_head(self) -> IO[bytes] | None:  # type: ignore[override]
        """The file asked for, unless it lies elsewhere."""
        root = Path(self.directory).resolve()
        target = Path(self.translate_path(self.path)).resolve()
        if self.path == "/" and not (root / "index.html").exists():
            self.send_response(302)
            self.send_header("Location", self.front)
            self.send_header("Content-Length", "0")
            self.end_headers()
            return None
        odd = target.exists() and not target.is_file() and not target.is_dir()
        if odd or (target != root and root not in target.parents):
            self.send_error(404)
            return None
        return super().send_head()


def serve(root: Path, page: Path, port: int, ready: Callable[[str], None]) -> None:
    """Serve ``root`` on 127.0.0.1 until interrupted; ``ready`` is told the page's address.

    ``port`` 0 takes any free one. Raises SdgenError when it is taken.
    """
    path = page.resolve().relative_to(root.resolve()).as_posix()
    handler = partial(_Quiet, directory=str(root.resolve()), front=f"/{quote(path)}")
    try:
        server = ThreadingHTTPServer(("127.0.0.1", port), handler)
    except OSError as error:
        raise SdgenError(f"port {port}: {error.strerror}; choose another --port") from None
    with server:
        ready(f"http://127.0.0.1:{server.server_address[1]}/{path}")
        server.serve_forever()
