"""``--graph-view`` and how badly is perceived, for commands that run detectors."""

from pathlib import Path

import click
import pytest
from click.testing import CliRunner
from sdgen.cli.perception_options import VIEWS, shown_options
from sdgen.dataset.graph_views import GRAPH_VIEWS
from sdgen.errors import UsageError

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("options") / "d", toy.small(n=2))


@click.command()
@click.argument("dataset", type=click.Path(path_type=Path))
@click.option("--split")
@shown_options
def command(dataset, split, shown):
    """Says what the last scene's graph holds."""
    graph = shown.open(dataset, split=split)[-1].shown_graph
    states = sum(len(node.states) for node in graph.nodes)
    click.echo(f"{len(graph.nodes)} {states} {sorted({n.class_name for n in graph.nodes})[0]}")


def run(*args):
    result = CliRunner().invoke(command, [str(arg) for arg in args], catch_exceptions=False)
    assert result.exit_code == 0, result.output
    nodes, states, first = result.output.split()
    return int(nodes), int(states), first


def test_views_are_those_of_data_sets():
    assert VIEWS == GRAPH_VIEWS


def test_the_data_set_is_shown_as_asked(path):
    full, neutral = run(path), run(path, "--graph-view", "neutral")
    assert full[0] == neutral[0]
    assert full[1] > neutral[1] == 0
    seen = run(path, "--graph-view", "perceived")
    assert 8 < seen[0] < full[0]
    assert seen[1] > 0
    assert run(path, "--graph-view", "perceived", "--no-states")[:2] == (seen[0], 0)
    assert run(path, "--graph-view", "perceived", "--missed", "1")[0] == 8
    assert run(path, "--graph-view", "perceived", "--coarse")[2] == "Appliances"
    assert run(path, "--graph-view", "perceived", "--confused", "1")[0] == seen[0]


@pytest.mark.parametrize("noise", [["--missed", "0.1"], ["--coarse"], ["--no-states"]])
def test_noise_is_of_perceived_graphs_only(path, noise):
    with pytest.raises(UsageError, match="add --graph-view perceived"):
        run(path, *noise)


@pytest.mark.parametrize("noise", [["--missed", "2"], ["--confused", "-1"], ["--missed", "nan"]])
def test_senseless_shares_are_a_usage_error(path, noise):
    result = CliRunner().invoke(command, [str(path), "--graph-view", "perceived", *noise])
    said = result.output if result.exit_code == 2 else str(result.exception)
    assert "range" in said
    assert result.exit_code == 2 or isinstance(result.exception, UsageError)
