"""A category whose models are made by different functions, chosen by their `form`."""

from __future__ import annotations

import inspect
from collections.abc import Callable

from toolkit.model import Model


def by_form(name: str, forms: dict[str, Callable[..., Model]]) -> Callable[..., Model]:
    """One maker of several: it calls forms[form] with those parameters that function knows."""

    def make(form: str, **parameters) -> Model:
        known = inspect.signature(forms[form]).parameters
        return forms[form](**{k: v for k, v in parameters.items() if k in known})

    make.__name__ = name
    return make
