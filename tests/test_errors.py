"""Errors stay what they are when they cross from one process to another."""

import pickle
from importlib import import_module
from pkgutil import walk_packages

import sdgen
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.errors import (
    InputError,
    SceneRejected,
    SdgenError,
    Stopped,
    did_you_mean,
    nearest,
)
from sdgen.rejection import Cause


def all_error_classes() -> list[type[SdgenError]]:
    for module in walk_packages(sdgen.__path__, "sdgen."):
        # Tasks of other harnesses are copied to people, never imported here.
        harness = module.name.startswith("sdgen.export.harness.")
        if module.name not in ("sdgen.__main__", "sdgen.engines.on_ray") and not harness:
            import_module(module.name)
    found, left = [], [SdgenError]
    while left:
        one = left.pop()
        found.append(one)
        left += one.__subclasses__()
    return [one for one in found if one.__module__.startswith("sdgen.")]


TEXTS = st.text(max_size=30)
CAUSES = st.dictionaries(
    st.builds(
        Cause,
        st.sampled_from(["home", "hazards", "worker"]),
        TEXTS,
        st.none() | TEXTS,
        st.none() | TEXTS,
        st.none() | TEXTS,
    ),
    st.integers(1, 99),
    max_size=4,
)


def same(one: BaseException) -> None:
    two = pickle.loads(pickle.dumps(one))
    assert type(two) is type(one)
    assert str(two) == str(one)
    assert vars(two) == vars(one)


@settings(deadline=None)  # the first time, all modules are imported
@given(TEXTS, st.lists(TEXTS, max_size=4), CAUSES)
def test_every_error_class_survives_pickling(
    text: str, problems: list[str], causes: dict[Cause, int]
) -> None:
    classes = all_error_classes()
    assert len(classes) >= 8
    for one in classes:
        if issubclass(one, InputError):
            same(one(problems))
        elif issubclass(one, SceneRejected):
            same(one(text, causes, len(causes)))
        else:
            same(one(text))


def test_a_signal_has_the_exit_code_shells_expect() -> None:
    same(Stopped(15))
    assert Stopped(15).exit_code == 143
    assert not isinstance(Stopped(2), Exception)


def test_the_nearest_word_or_the_few_there_are() -> None:
    few, many = ["build", "view"], [f"w{k}" for k in range(20)]
    assert nearest("biuld", few) == "build"
    assert nearest("zzz", few) is None
    assert did_you_mean("biuld", few) == " (did you mean 'build'?)"
    assert did_you_mean("zzz", few) == " (one of: build, view)"
    assert did_you_mean("zzz", many) == ""
