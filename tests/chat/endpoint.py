"""An OpenAI-compatible endpoint on this machine, that answers what a test says."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any


@dataclass
class Fake:
    """What it answers, and what it was asked. ``drip_s``: seconds between the bytes of a body."""

    body: bytes = b""
    status: int = 200
    drip_s: float = 0.0
    url: str = ""
    asked: list[dict[str, Any]] = field(default_factory=list)
    keys: list[str] = field(default_factory=list)

    def says(self, content: object) -> Fake:
        self.body = json.dumps({"choices": [{"message": {"content": content}}]}).encode()
        return self


@contextmanager
def endpoint(fake: Fake) -> Iterator[Fake]:
    """The endpoint, listening at ``fake.url``."""

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            length = int(self.headers["Content-Length"])
            fake.asked.append(json.loads(self.rfile.read(length)))
            fake.keys.append(self.headers.get("Authorization", ""))
            self.send_response(fake.status)
            self.send_header("Content-Type", "application/json")
            self.end_headers()
            try:
                if not fake.drip_s:
                    self.wfile.write(fake.body)
                    return
                for byte in fake.body:
                    self.wfile.write(bytes([byte]))
                    self.wfile.flush()
                    time.sleep(fake.drip_s)
            except OSError:
                pass  # whoever asked has left

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    fake.url = f"http://127.0.0.1:{server.server_address[1]}/v1"
    try:
        yield fake
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
