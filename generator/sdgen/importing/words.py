"""What a model's name says it is: its words, and the categories that they mean."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from sdgen.catalog.records import Catalog
from sdgen.catalog.words import Categories, Names, names_of
from sdgen.errors import InputError, did_you_mean
from sdgen.resources import data_path
from sdgen.scene import Record
from sdgen.strict import read
from sdgen.yaml_source import read_yaml

#: The longest phrase that is looked up, in words.
_LONGEST = 4
#: Characters read of a text: a stranger's description may be a book.
_LONGEST_TEXT = 500
#: Names of at most so many words may be no more than a fruit; in longer ones that is a colour.
_SHORT = 3
#: Categories of what nobody imports: parts of the building, spills.
_NO_THINGS = ("structure", "hazard_only")
# Camel case, and digits apart from letters: TVCabinet_01 is TV, Cabinet, 01.
_WORD = re.compile(r"[^\W\d_]+|\d+")
_CAMEL = re.compile(r"(?<=[^\W\d_A-Z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][^\W\d_A-Z])")
#: What scan collections append to a name to tell scans of one product apart.
_APPENDIX = re.compile(r"[_ ](?=[^_ ]*[a-z])(?=[^_ ]*[A-Z])(?=[^_ ]*\d)[A-Za-z0-9-]{11}$")
_IRREGULAR = {
    "knives": "knife",
    "shelves": "shelf",
    "loaves": "loaf",
    "leaves": "leaf",
    "shoes": "shoe",
    "tomatoes": "tomato",
    "potatoes": "potato",
    "mangoes": "mango",
}


def words_of(name: str) -> tuple[str, ...]:
    """The words of a name, lower case: snake, kebab and camel case, numbers left out."""
    name = _APPENDIX.sub("", name[:_LONGEST_TEXT])
    found = (
        part.lower()
        for word in _WORD.findall(name)
        for part in _CAMEL.split(word)
        if not word[0].isdigit()
    )
    return tuple(word for word in found if len(word) > 1)


def _stem(word: str) -> str:
    """A word without its plural; words that only differ by it have one stem."""
    word = _IRREGULAR.get(word, word)
    if word.endswith("ies"):
        return word[:-2]
    if word.endswith("y") and word[-2:-1] not in "aeiou":
        return word[:-1] + "i"
    if word.endswith(("sses", "xes", "ches", "shes", "zes")):
        return word[:-2]
    if word.endswith("s") and not word.endswith(("ss", "us")):
        return word[:-1]
    return word[:-1] if word.endswith("ie") else word


def _key(words: Sequence[str]) -> str:
    """How phrases are compared: without plurals, and with or without blanks (night stand)."""
    return "".join(map(_stem, words))


#: Characters of a name that are looked at.
_LONGEST = 500


@dataclass(frozen=True)
class Found:
    """What a text says it is: ``phrase`` of it, and the categories that it means, likeliest first.

    No categories: the phrase says that it is none of ours.
    """

    phrase: str
    categories: tuple[str, ...]


@dataclass(frozen=True)
class Words:
    """Phrases by how they are compared, and what they mean; see ``words.yaml``."""

    meant: Mapping[str, tuple[str, ...]]
    unreal: frozenset[str]
    toys: frozenset[str]
    colours: frozenset[str]
    then: frozenset[str]

    def find(self, text: str) -> tuple[Found, ...]:
        """What a name or description may say the thing is, likeliest first; empty: nothing.

        The phrase that ends last counts most, the longest of those; words that are colours, too,
        count least, and what comes after "with" or "for" only when nothing comes before. Where a
        phrase says that it is none of ours, nothing before that counts.
        """
        words = words_of(text[:_LONGEST])
        cut = next((at for at, word in enumerate(words) if word in self.then), len(words))
        found = tuple(self._phrases(words[:cut])) or tuple(self._phrases(words))
        real = not any(self._has(words, word) for word in self.unreal)
        return found if real else tuple(self._as_toy(one) for one in found)

    def _phrases(self, words: Sequence[str]) -> Iterator[Found]:
        colours: list[Found] = []
        end = len(words)
        while end > 0:
            start = next((s for s in self._starts(end) if _key(words[s:end]) in self.meant), None)
            if start is None:
                end -= 1
                continue
            key = _key(words[start:end])
            found = Found(" ".join(words[start:end]), self.meant[key])
            end = start
            if key in self.colours:
                colours.append(found)
                continue
            yield found
            if not found.categories:
                return
        if len(words) <= _SHORT:
            yield from colours

    @staticmethod
    def _starts(end: int) -> range:
        return range(max(0, end - _LONGEST), end)

    def _as_toy(self, found: Found) -> Found:
        toys = tuple(name for name in found.categories if name in self.toys)
        return Found(found.phrase if toys else f"toy {found.phrase}", toys)

    def _has(self, words: Sequence[str], key: str) -> bool:
        return any(_key(words[at : at + n]) == key for at in range(len(words)) for n in (1, 2))


_Phrases = Annotated[tuple[str, ...], names_of("word or phrase")]


class _WordsYaml(Record):
    also: dict[str, _Phrases]
    any_of: dict[str, Categories]
    nothing: _Phrases
    unreal: _Phrases
    toys: Categories
    colours: _Phrases
    then: _Phrases


def load_words(catalog: Catalog) -> Words:
    """The words that are shipped, and the names of the catalogue's categories.

    Raises InputError with all that is wrong in the file.
    """
    shown = "hazard_catalog/sources/words.yaml"
    source = read_yaml(data_path("hazard_catalog", "sources", "words.yaml"), shown)
    names = category_names(catalog)
    written = None if source.problems else read(source, (), source.value, _WordsYaml, names)
    if written is None:
        raise InputError(source.problems)
    meant: dict[str, tuple[str, ...]] = {}
    for path, phrase, categories in _phrases(written):
        key = _key(words_of(phrase))
        if key in meant:
            source.problem(path, f"{phrase!r} has a meaning already")
        meant[key] = categories
        for name in categories:
            if name not in names.categories:
                near = did_you_mean(name, names.categories)
                source.problem(path, f"unknown category {name!r}{near}")
    if source.problems:
        raise InputError(source.problems)
    own = {
        _key(words_of(category.name)): (category.name,)
        for category in catalog.categories
        if category.kind not in _NO_THINGS
    }
    # A word for several of ours may be the name of one (a chair); then it says more.
    return Words(
        meant={**own, **meant},
        unreal=_keys(written.unreal),
        toys=frozenset(written.toys),
        colours=_keys(written.colours),
        then=frozenset(written.then),
    )


def category_names(catalog: Catalog) -> Names:
    """The names that files about other people's models may use."""
    return Names(categories=tuple(sorted(c.name for c in catalog.categories)), rooms=())


def _phrases(
    written: _WordsYaml,
) -> Iterator[tuple[tuple[str | int, ...], str, tuple[str, ...]]]:
    for name, phrases in written.also.items():
        for phrase in phrases:
            yield ("also", name), phrase, (name,)
    for phrase, categories in written.any_of.items():
        yield ("any_of", phrase), phrase, categories
    for phrase in written.nothing:
        yield ("nothing",), phrase, ()


def _keys(phrases: Sequence[str]) -> frozenset[str]:
    return frozenset(_key(words_of(phrase)) for phrase in phrases)
