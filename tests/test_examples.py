"""The examples run on a data set that takes seconds to build."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.cli.main import run

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples"

pytestmark = pytest.mark.xdist_group("examples")  # one data set, one worker


@pytest.fixture(scope="module")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("examples") / "homes"
    options = "--n 2 --seed 7 --hazards 2-3 --views 4 --size 160x120 --workers 1 --catalog"
    code = run(["build", *options.split(), str(EXAMPLES / "extra_catalog"), "--out", str(out)])
    assert code == 0
    return out


def call(script: str, *args: object) -> str:
    command = [sys.executable, str(EXAMPLES / script), *map(str, args)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_my_detector_can_be_scored(
    homes: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "predictions.jsonl"
    call("my_detector.py", homes, out)
    assert len(out.read_text(encoding="utf-8").splitlines()) == 2
    capsys.readouterr()
    assert run(["evaluate", str(homes), str(out)]) == 0
    assert "AS" in capsys.readouterr().out


@pytest.mark.slow
def test_crops_shows_every_visible_anomaly(homes: Path, tmp_path: Path) -> None:
    listed = call("crops.py", homes, tmp_path).split()
    assert listed
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(
        Path(name).name for name in listed
    )


@pytest.mark.slow
def test_an_agent_walks_through_every_home(homes: Path) -> None:
    pytest.importorskip("gymnasium")
    lines = call("agent_walk.py", homes).splitlines()
    assert [line[:6] for line in lines] == ["000000", "000001"]


@pytest.mark.slow
def test_a_detector_of_ones_own_sees_through_an_explorer(homes: Path) -> None:
    lines = call("agent_detector.py", homes).splitlines()
    assert len(lines) == 2 * 2 + 2 * 2
    assert {line.split()[1] for line in lines} == {"on_or_open", "rules"}


@pytest.mark.slow
def test_an_array_of_tasks_makes_the_bytes_of_one_build(tmp_path: Path) -> None:
    """As SLURM would run it: a task a number, then the merge."""
    options = "--views 1 --sensors none"
    env = {
        **os.environ,
        "N": "2",
        "PIECE": "1",
        "OUT": str(tmp_path / "homes"),
        "SDGEN": f"{sys.executable} -m sdgen",
        "OPTIONS": options,
        "SLURM_CPUS_PER_TASK": "1",
    }
    script = str(EXAMPLES / "slurm_array.sh")
    for task in range(3):  # the last has nothing to do
        task_env = {**env, "SLURM_ARRAY_TASK_ID": str(task)}
        done = subprocess.run([script], env=task_env, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    done = subprocess.run([script, "merge"], env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "2 of 2 scenes" in done.stdout
    whole = tmp_path / "whole"
    assert run(["build", "--n", "2", "--seed", "7", *options.split(), "--out", str(whole)]) == 0
    assert contents(tmp_path / "homes") == contents(whole)
    names = {path.name for path in tmp_path.iterdir()}
    assert names == {"homes", "homes.piece-000000", "homes.piece-000001", "whole"}


def test_what_slurm_signals_is_the_build_itself(tmp_path: Path) -> None:
    """By ``--signal=B:`` SLURM signals the process it started, and no other."""
    started = tmp_path / "started"
    stub = tmp_path / "sdgen"
    stub.write_text(
        f"#!/bin/sh\ntrap 'exit 143' TERM\necho \"$@\" > {started}.part\n"
        f"mv {started}.part {started}\nwhile :; do sleep 0.02; done\n"
    )
    stub.chmod(0o755)
    env = {**os.environ, "N": "25", "PIECE": "10", "OUT": "homes", "SDGEN": str(stub)}
    script = EXAMPLES / "slurm_array.sh"
    task = subprocess.Popen([script], env={**env, "SLURM_ARRAY_TASK_ID": "2"})
    try:
        deadline = time.monotonic() + 20
        while not started.exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        task.terminate()
        assert task.wait(20) == 143
    finally:
        task.kill()
        task.wait()
    assert "--range 20:25 --out homes.piece-000002" in started.read_text()
    assert "#SBATCH --signal=B:TERM@60\n" in script.read_text(encoding="utf-8")


def test_the_guide_submits_the_array_as_the_script_says() -> None:
    """The merge waits for the end of all tasks: one that lacks a scene ends with 3."""
    script = (EXAMPLES / "slurm_array.sh").read_text(encoding="utf-8")
    guide = (EXAMPLES.parent / "docs" / "cluster.md").read_text(encoding="utf-8")
    lines = [line.removeprefix("#").strip() for line in script.splitlines() if " sbatch " in line]
    assert len(lines) == 2
    assert "--dependency=afterany:JOBID" in lines[1]
    assert all(f"\n{line}\n" in guide for line in lines)


def contents(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def test_the_extra_catalogue_adds_one_hazard() -> None:
    shipped = {hazard.id for hazard in load_catalog().hazards}
    extended = {hazard.id for hazard in load_catalog([EXAMPLES / "extra_catalog"]).hazards}
    assert extended - shipped == {"paper_on_stove"}
    assert shipped <= extended


@pytest.mark.parametrize("path", sorted(EXAMPLES.iterdir()), ids=lambda path: path.name)
def test_every_example_is_listed(path: Path) -> None:
    listed = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    assert path.name in listed or path.name in ("README.md", "__pycache__")


#: As much of PyTorch as the example uses: arrays for tensors, batches one after another.
TORCH = """
import numpy as np

class Tensor:
    def __init__(self, a): self.a = a
    def permute(self, *axes): return Tensor(self.a.transpose(axes))
    def float(self): return Tensor(self.a.astype("float32"))
    def __truediv__(self, k): return Tensor(self.a / k)
    def __gt__(self, k): return Tensor(self.a > k)
    def mean(self): return float(self.a.mean())
    shape = property(lambda self: self.a.shape)

from_numpy = Tensor
"""
TORCH_DATA = """
import pickle
from multiprocessing import get_context
from torch import Tensor
import numpy as np

class DataLoader:
    def __init__(self, data, batch_size, shuffle, num_workers):
        self.data, self.size, self.workers = data, batch_size, num_workers

    def __iter__(self):
        # As PyTorch's workers do: the data set goes to other processes and is indexed there.
        with get_context("fork").Pool(self.workers) as pool:
            data = pickle.loads(pickle.dumps(self.data))
            items = pool.map(data.__getitem__, range(len(data)))
        for k in range(0, len(items), self.size):
            part = items[k : k + self.size]
            yield {
                key: Tensor(np.stack([item[key].a for item in part]))
                for key in ("rgb", "depth_m", "target")
            }
"""


@pytest.mark.slow
def test_the_torch_loader_says_what_it_needs_and_loads(homes: Path, tmp_path: Path) -> None:
    script = [sys.executable, str(EXAMPLES / "torch_loader.py"), str(homes)]
    (tmp_path / "without").mkdir()
    (tmp_path / "without" / "torch.py").write_text("raise ImportError")
    (tmp_path / "with" / "torch" / "utils" / "data").mkdir(parents=True)
    (tmp_path / "with" / "torch" / "__init__.py").write_text(TORCH)
    (tmp_path / "with" / "torch" / "utils" / "__init__.py").write_text("")
    (tmp_path / "with" / "torch" / "utils" / "data" / "__init__.py").write_text(TORCH_DATA)

    def loaded(folder: str) -> subprocess.CompletedProcess[str]:
        paths = os.pathsep.join([str(tmp_path / folder), os.environ.get("PYTHONPATH", "")])
        environment = {**os.environ, "PYTHONPATH": paths}
        return subprocess.run(script, capture_output=True, text=True, env=environment)

    refused = loaded("without")
    assert (refused.returncode, refused.stderr) == (
        1,
        "this example needs PyTorch: pip install torch\n",
    )
    done = loaded("with")
    assert done.returncode == 0, done.stderr
    first, *batches = done.stdout.splitlines()
    assert first.startswith("8 views of <sdgen.Dataset ")
    assert [line.split(" 0.")[0].split(")")[0] for line in batches] == ["(4, 3, 120, 160"] * 2
    assert any("0.00%" not in line for line in batches)
