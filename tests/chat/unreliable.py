"""An OpenAI-compatible endpoint on this machine that is unreliable on purpose.

What it does with a question is decided by a hash of the question and of how often it came before,
so that every run is the same: it is late, leaves, refuses with 429 or 500, talks HTML, half a JSON,
nothing, half an answer, of things nobody named, or in classes nobody asked for. Some questions it
never answers. Else it answers by a few keywords.
"""

from __future__ import annotations

import hashlib
import json
import re
import socket
import struct
import threading
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

#: How it fails -> its share of the tries. Those of the first kind pass, those of the second are
#: answers, good for nothing.
PASSING: Mapping[str, float] = {
    "late": 0.02,
    "leaves": 0.05,
    "429": 0.08,
    "500": 0.05,
    "html": 0.04,
    "half a reply": 0.04,
    "empty": 0.04,
}
BAD: Mapping[str, float] = {
    "nonsense": 0.03,
    "half an answer": 0.05,
    "invented": 0.06,
    "wrong classes": 0.05,
}
#: Of the questions, so many are never answered: whatever is tried.
STUBBORN = 0.03

_KEYWORDS = (
    (re.compile(r"knife|scissors|medic|bleach|pill|razor", re.I), "unsafe for children"),
    (re.compile(r"expired|milk|meat|dirty|rotten|overripe", re.I), "unsanitary"),
    (re.compile(r"spilled|puddle|broken|candle.*\(on|stove.*\(on|frayed", re.I), "unsafe"),
)


@dataclass
class Unreliable:
    """What it was asked, what it did, and how late it is (seconds, longer than who asks waits);
    ``pause_s``: before whatever it does."""

    late_s: float = 2.0
    reliable: bool = False
    pause_s: float = 0.0
    url: str = ""
    did: Counter[str] = field(default_factory=Counter)
    tries: Counter[str] = field(default_factory=Counter)
    answered: Counter[str] = field(default_factory=Counter)
    lock: threading.Lock = field(default_factory=threading.Lock)

    def mood(self, question: str) -> str:
        """What it does with a question that comes again, in a word."""
        with self.lock:
            attempt = self.tries[question]
            self.tries[question] += 1
        if self.reliable:
            return "answers"
        if _unit(question, "stubborn") < STUBBORN:
            return "500"
        drawn = _unit(question, attempt)
        for mood, share in {**PASSING, **BAD}.items():
            if drawn < share:
                return mood
            drawn -= share
        return "answers"


def _unit(*parts: object) -> float:
    digest = hashlib.sha256("|".join(map(str, parts)).encode()).digest()
    return int.from_bytes(digest[:6], "big") / 2**48


def label_of(text: str) -> str:
    """The class that it gives to some words."""
    return next((label for pattern, label in _KEYWORDS if pattern.search(text)), "normal")


def asked_in(prompt: str) -> list[str]:
    """The strings of the last list, or the sentences of the last description, of a prompt."""
    last = prompt.rpartition("Q: ")[2]
    listed = last.rpartition("[")[2].rpartition("]")[0]
    if "'" in listed:
        return re.findall(r"'([^']+)'", listed)
    return re.findall(r"There is an? (.*?)\.(?= |$|\n)", last)


def good_answer(prompt: str, pictures: int) -> str:
    """What somebody who knows a few keywords says."""
    if prompt.startswith("Simplify"):
        named = re.findall(
            r"unsafe for children|unsanitary|unsafe|normal", prompt.rpartition("\n\n")[2]
        )
        return named[0] if named else label_of(prompt.rpartition("\n\n")[2])
    if pictures:
        lines = [
            f"picture {k}: [{_unit(prompt, k) * 300:.0f}, {_unit(k, prompt) * 200:.0f}, 90, 80]: "
            f"'{('unsafe', 'unsanitary', 'unsafe for children')[k % 3]}': something"
            for k in range(1, pictures + 1)
        ]
        nodes = re.findall(r"^\[(\d+)\] (.*)$", prompt, re.M)
        lines += [f"[{n}]: '{label_of(w)}'" for n, w in nodes if label_of(w) != "normal"]
        return "\n".join(lines)
    found = [(string, label_of(string)) for string in asked_in(prompt)]
    if "Classify" in prompt:
        return "\n\n".join(f"'{string}': '{label}' as it is" for string, label in found)
    wrong = [(string, label) for string, label in found if label != "normal"]
    if "'unsanitary'" not in prompt:
        return "\n\n".join(f"'{string}'" for string, _ in wrong) or "none"
    return "\n\n".join(f"'{string}': '{label}'" for string, label in wrong) or "none"


def spoilt(answer: str, mood: str) -> str:
    """A good answer as it comes out in such a mood."""
    if mood == "nonsense":
        return "As a large language model I like turtles.\n```\n{[}\n```"
    if mood == "half an answer":
        return answer[: len(answer) // 2]
    if mood == "invented":
        return f"'unicorn INSIDE ballroom ON chandelier': 'unsafe'\n\n{answer}\n\n[99999]: 'unsafe'"
    if mood == "wrong classes":
        return re.sub(r"'(unsafe|unsanitary|normal)[^']*'", "'quite risky'", answer)
    return answer


@contextmanager
def unreliable(fake: Unreliable) -> Iterator[Unreliable]:
    """The endpoint, listening at ``fake.url``."""

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = self.rfile.read(int(self.headers["Content-Length"]))
            question = hashlib.sha256(body).hexdigest()
            mood = fake.mood(question)
            with fake.lock:
                fake.did[mood] += 1
            time.sleep(fake.pause_s)
            with suppress(OSError):  # whoever asked has left
                self._reply(mood, json.loads(body), question)

        def _reply(self, mood: str, request: dict[str, Any], question: str) -> None:
            if mood == "leaves":
                # Closed with a reset, in the middle of a reply.
                linger = struct.pack("ii", 1, 0)
                self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, linger)
                self.wfile.write(b"HTTP/1.1 200 OK\r\nContent-Length: 9999\r\n\r\n{")
                self.close_connection = True
                return
            if mood == "late":
                time.sleep(fake.late_s)
            if mood == "429":
                self._send(429, b'{"error": {"message": "slower"}}', {"Retry-After": "0.05"})
            elif mood == "500":
                self._send(500, b'{"error": {"message": "broken over here"}}')
            elif mood == "html":
                self._send(200, b"<html><h1>502</h1></html>", {"Content-Type": "text/html"})
            elif mood == "empty":
                self._send(200, b'{"choices": [{"message": {"content": ""}}]}')
            else:
                self._send(200, self._answer(mood, request, question))

        def _answer(self, mood: str, request: dict[str, Any], question: str) -> bytes:
            content = request["messages"][-1]["content"]
            parts = content if isinstance(content, list) else [{"text": content}]
            pictures = sum("image_url" in part for part in parts)
            prompt = str(parts[0]["text"])
            text = spoilt(good_answer(prompt, pictures), mood)
            reply: dict[str, Any] = {
                "choices": [{"message": {"content": text}, "finish_reason": "stop"}]
            }
            if mood == "half an answer":
                reply["choices"][0]["finish_reason"] = "length"
            if _unit(question, "counts") < 0.8:
                reply["usage"] = {
                    "prompt_tokens": len(prompt) // 4,
                    "completion_tokens": len(text) // 4,
                }
            body = json.dumps(reply).encode()
            if mood == "half a reply":
                return body[: len(body) // 2]
            if mood != "late":  # nobody is there any more
                with fake.lock:
                    fake.answered[question] += 1
            return body

        def _send(self, status: int, body: bytes, headers: Mapping[str, str] | None = None) -> None:
            self.send_response(status)
            for name, value in {"Content-Type": "application/json", **(headers or {})}.items():
                self.send_header(name, value)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

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
