"""Requests to one source, and to nobody else: http(s) only, few redirects, counted tries.

The standard library's client does all that is needed (ranges, proxies, certificates), so no
package for it is asked of users.
"""

from __future__ import annotations

import http.client
import json
import re
import ssl
import string
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from email.message import Message
from typing import Any, TypeVar
from urllib.parse import quote, urljoin, urlsplit

import sdgen
from sdgen.errors import AssetError

TIMEOUT_S = 30.0
ATTEMPTS = 5
#: Seconds before the second try; each further one waits twice as long.
FIRST_WAIT_S = 1.0
LONGEST_WAIT_S = 60.0
MAX_REDIRECTS = 5
MAX_LIST_BYTES = 20_000_000
PIECE = 1 << 16

T = TypeVar("T")

_REDIRECTS = (301, 302, 303, 307, 308)
#: Answers that may be other ones soon.
_SOON = (408, 425, 429, 500, 502, 503, 504)
#: What a connection raises that does not come about, or breaks off.
BROKEN = (OSError, http.client.HTTPException)


class NotThere(AssetError):
    """The source has no such file (S3 says 403 of what is missing where listing is forbidden)."""


class TryAgain(Exception):
    """A fault that may pass; ``wait_s`` is how long the server asks to wait."""

    def __init__(self, why: str, wait_s: float = 0.0) -> None:
        self.wait_s = wait_s
        super().__init__(why)


class Answer:
    """What came back for a request: its status, headers and body."""

    def __init__(self, response: Any) -> None:
        self._response = response
        self.status: int = response.status
        self.headers: Message = response.headers

    def header(self, name: str) -> str:
        """A header's value; empty without one."""
        return str(self.headers.get(name) or "").strip()

    @property
    def length(self) -> int | None:
        """Bytes of the body, as the header has them."""
        text = self.header("Content-Length")
        return int(text) if text.isdecimal() and len(text) < 20 else None

    @property
    def validator(self) -> str:
        """What tells this version of the file from others: a strong ETag, else the date."""
        tag = self.header("ETag")
        return tag if tag.startswith('"') else self.header("Last-Modified")

    def pieces(self) -> Iterator[bytes]:
        """The body, piece by piece. Raises TryAgain when the connection breaks off."""
        while True:
            try:
                piece: bytes = self._response.read(PIECE)
            except BROKEN as error:
                raise TryAgain(f"broke off ({_why(error)})") from None
            if not piece:
                return
            yield piece


class Client:
    """Asks ``base`` (an origin and perhaps a path) and, by redirect, the hosts of ``redirects``."""

    def __init__(
        self,
        base: str,
        redirects: Sequence[str] = (),
        timeout_s: float = TIMEOUT_S,
        attempts: int = ATTEMPTS,
        wait: Callable[[float], None] = time.sleep,
    ) -> None:
        self.base = base
        self._origin = _origin(base)
        self._redirects = tuple(redirects)
        self._timeout_s = timeout_s
        self._attempts = attempts
        self._wait = wait
        self._opener = urllib.request.OpenerDirector()
        # Neither files nor ftp, and redirects are ours: what is not handled here is not done.
        for handler in (
            urllib.request.ProxyHandler(),
            urllib.request.HTTPHandler(),
            urllib.request.HTTPSHandler(),
        ):
            self._opener.add_handler(handler)

    def trying(self, address: str, do: Callable[[], T]) -> T:
        """What ``do`` returns, tried again while it raises TryAgain; AssetError in the end."""
        attempt = 1
        while True:
            try:
                return do()
            except TryAgain as error:
                if attempt == self._attempts:
                    raise AssetError([f"{address}: {error} ({attempt} tries)"]) from None
                wait_s = max(FIRST_WAIT_S * 2 ** (attempt - 1), error.wait_s)
            self._wait(min(wait_s, LONGEST_WAIT_S))
            attempt += 1

    @contextmanager
    def get(self, address: str, headers: Mapping[str, str] | None = None) -> Iterator[Answer]:
        """The answer to one request, after its redirects: 200, or what ``headers`` ask for.

        Raises TryAgain for what may pass, NotThere, or AssetError for what will not.
        """
        first = address
        for _ in range(MAX_REDIRECTS + 1):
            response = self._open(address, headers or {})
            try:
                answer = Answer(response)
                if answer.status not in _REDIRECTS:
                    _check(first, answer)
                    yield answer
                    return
                target = _joined(address, answer.header("Location"))
            finally:
                response.close()
            if not self._may_go(target):
                raise AssetError([f"{first}: sends us to {target[:80]!r}, where it may not"])
            address = target
        raise AssetError([f"{first}: redirects more than {MAX_REDIRECTS} times"])

    def json(self, address: str) -> tuple[Any, str]:
        """A JSON document, and the address of the next page (empty: there is none)."""

        def ask() -> tuple[Any, str]:
            with self.get(address) as answer:
                raw = bytearray()
                for piece in answer.pieces():
                    raw += piece
                    if len(raw) > MAX_LIST_BYTES:
                        raise AssetError([f"{address}: is a list of more than 20 MB"])
                if answer.length is not None and len(raw) < answer.length:
                    raise TryAgain("broke off")
                link = re.search(r'<([^<>]+)>\s*;\s*rel="?next"?', answer.header("Link"))
            try:
                value = json.loads(raw)
            except (ValueError, RecursionError):
                raise AssetError([f"{address}: is no JSON"]) from None
            following = _joined(address, link[1]) if link else ""
            if following and _origin(following) != self._origin:
                raise AssetError([f"{address}: goes on at another host: {following[:80]!r}"])
            return value, following

        return self.trying(address, ask)

    def _may_go(self, target: str) -> bool:
        try:
            scheme, host, port = _origin(target)
        except AssetError:
            return False
        if (scheme, host, port) == self._origin:
            return True
        if (scheme, port) != ("https", 443):
            return False
        return any(host == to or (to[0] == "." and host.endswith(to)) for to in self._redirects)

    def _open(self, address: str, headers: Mapping[str, str]) -> Any:
        known = {"User-Agent": f"sdgen/{sdgen.__version__}", "Accept-Encoding": "identity"}
        request = urllib.request.Request(address, headers={**known, **headers})
        try:
            return self._opener.open(request, timeout=self._timeout_s)
        except BROKEN as error:
            why = f"cannot be reached ({_why(error)})"
            if isinstance(getattr(error, "reason", None), ssl.SSLCertVerificationError):
                raise AssetError([f"{address}: {why}"]) from None
            raise TryAgain(why) from None


def _check(address: str, answer: Answer) -> None:
    status = answer.status
    if status in (403, 404, 410):
        raise NotThere([f"{address}: is not there (answer {status})"])
    if status in _SOON:
        text = answer.header("Retry-After")
        wait_s = float(text) if text.isdecimal() and len(text) < 5 else 0.0
        raise TryAgain(f"the server is busy or broken (answer {status})", wait_s)
    if status not in (200, 206, 304, 416):
        raise AssetError([f"{address}: the server refuses (answer {status})"])
    if answer.header("Content-Encoding") not in ("", "identity"):
        raise AssetError([f"{address}: comes packed in a way that was not asked for"])


def _joined(address: str, reference: str) -> str:
    """Where a reference leads, quoted; what makes no sense as it is."""
    reference = quote(reference, safe=string.punctuation)
    try:
        return urljoin(address, reference)
    except ValueError:
        return reference


def _origin(address: str) -> tuple[str, str, int]:
    try:
        parts = urlsplit(address)
        port = parts.port
    except ValueError:
        raise AssetError([f"{address[:80]!r}: is no address"]) from None
    if parts.scheme not in ("http", "https") or not parts.hostname or parts.username:
        raise AssetError([f"{address[:80]!r}: is no http(s) address"])
    return parts.scheme, parts.hostname, port or (443 if parts.scheme == "https" else 80)


def _why(error: BaseException) -> str:
    reason = error.reason if isinstance(error, urllib.error.URLError) else error
    text = " ".join(str(getattr(reason, "strerror", None) or reason).split())
    return text or type(reason).__name__
