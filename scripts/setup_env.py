#!/usr/bin/env python3
"""Make ``.venv`` and install sdgen into it. Needs only a Python 3 with pip; run by the Makefile.

PyBullet has wheels for CPython up to 3.11, so 3.11 and 3.10 are preferred; on a newer Python it
is compiled from source here, against numpy. Safe to run again: it does nothing when nothing
changed.
"""

import argparse
import ctypes.util
import glob
import hashlib
import json
import os
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
VENV = os.path.join(ROOT, ".venv")
PYTHON = os.path.join(VENV, "bin", "python")
STAMP = os.path.join(VENV, "sdgen-stamp.json")
PIP = [PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
PYBULLET = "pybullet>=3.2.5"
EGL_PACKAGES = "libegl1 libgl1-mesa-dri libgl1"

#: Best first. ``python3`` may be any version.
NAMES = ["python3.11", "python3.10", "python3.12", "python3.13", "python3.14", "python3", "python"]
PROBE = "import sys; print('%d.%d' % sys.version_info[:2])"


def say(text):
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


def stop(text):
    sys.stderr.write("error: " + text + "\n")
    sys.exit(1)


def dotted(version):
    """(3, 11) -> "3.11"."""
    return ".".join(map(str, version))


def run(*command):
    """Run a command whose failure ends the set-up; its own output says why."""
    if subprocess.call(list(command), cwd=ROOT) != 0:
        stop("this step failed: " + " ".join(command))


def version_of(python):
    """(3, 11) of an interpreter that runs, else None: a shim may exist and not work."""
    try:
        text = subprocess.check_output([python, "-c", PROBE], stderr=subprocess.DEVNULL)
        major, minor = text.decode().strip().split(".")
        return int(major), int(minor)
    except (OSError, ValueError, subprocess.CalledProcessError):
        return None


def has_pip(python):
    """False for a missing environment, and for one whose making was interrupted."""
    try:
        return subprocess.call([python, "-c", "import pip"], stderr=subprocess.DEVNULL) == 0
    except OSError:
        return False


def candidates():
    """Interpreters to try, best first: ``$PYTHON``, names on the PATH, pyenv's."""
    if os.environ.get("PYTHON"):
        return [os.environ["PYTHON"]]
    found = [path for path in map(shutil.which, NAMES) if path]
    pyenv = os.environ.get("PYENV_ROOT", os.path.join(os.path.expanduser("~"), ".pyenv"))
    found += sorted(glob.glob(os.path.join(pyenv, "versions", "3.1[0-9]*", "bin", "python")))
    return [*found, sys.executable]


def rank(version):
    """3.11 and 3.10 first, then the newer ones from old to new."""
    return [(3, 11), (3, 10)].index(version) if version in ((3, 11), (3, 10)) else version[1]


def find_python():
    """(path, version) of the best interpreter."""
    usable = []
    for path in candidates():
        version = version_of(path)
        if version is not None and version >= (3, 10):
            usable.append((rank(version), path, version))
    if not usable:
        stop(
            "no Python 3.10 or newer found. Install one, for example on Debian or Ubuntu "
            "'apt-get install python3.11 python3.11-venv', or set PYTHON=/path/to/python3.11"
        )
    _, path, version = min(usable, key=lambda item: item[0])
    return path, version


def make_venv(python, version):
    """A fresh ``.venv`` with pip."""
    say(f"creating .venv with {python} (Python {dotted(version)})")
    shutil.rmtree(VENV, ignore_errors=True)
    if subprocess.call([python, "-m", "venv", VENV]) == 0:
        return
    if subprocess.call([python, "-m", "virtualenv", VENV], stderr=subprocess.DEVNULL) == 0:
        return
    shutil.rmtree(VENV, ignore_errors=True)
    stop(
        f"{python} can't make virtual environments; on Debian or Ubuntu: "
        f"'apt-get install python{dotted(version)}-venv', or 'pip install virtualenv'"
    )


def install_pybullet(version):
    """PyBullet from a wheel when there is one, else compiled here with numpy present."""
    wheel = [*PIP, "--only-binary", ":all:", PYBULLET]
    if subprocess.call(wheel, cwd=ROOT, stderr=subprocess.DEVNULL) == 0:
        return
    say(
        f"PyBullet has no wheel for Python {dotted(version)} on this machine: compiling it from\n"
        "source, once; this takes some minutes. Python 3.10 or 3.11 would skip this."
    )
    header = "import os, sysconfig as s; print(os.path.join(s.get_paths()['include'], 'Python.h'))"
    python_h = subprocess.check_output([PYTHON, "-c", header]).decode().strip()
    if not (shutil.which("g++") or shutil.which("c++")) or not os.path.exists(python_h):
        stop(
            "compiling PyBullet needs a C++ compiler and Python's headers; on Debian or Ubuntu: "
            f"'apt-get install g++ python{dotted(version)}-dev', then run this again"
        )
    # Built without numpy in sight, PyBullet returns images as tuples and is many times slower.
    run(*PIP, "numpy>=1.24", "setuptools", "wheel")
    run(*PIP, "--no-build-isolation", "--no-cache-dir", PYBULLET)


def check_pybullet():
    """Stop when the installed PyBullet can't hand over images as numpy arrays."""
    code = "import pybullet, sys; sys.exit(0 if pybullet.isNumpyEnabled() else 1)"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    if subprocess.call([PYTHON, "-c", code], **quiet) != 0:
        stop("PyBullet was built without numpy; remove .venv and run this again")


def egl_missing():
    """What the EGL renderer lacks: names of missing things, empty when all is there."""
    missing = [name for name in ("EGL", "GL") if ctypes.util.find_library(name) is None]
    drivers = (
        "/usr/lib/*/dri/swrast_dri.so",
        "/usr/lib/*/libgallium-*.so",
        "/usr/lib/dri/*.so",
        "/usr/lib64/dri/*.so",
    )
    if not any(glob.glob(pattern) for pattern in drivers):
        missing.append("Mesa's drivers")
    return missing


def wanted_stamp(extras):
    digest = hashlib.sha256()
    for name in ("pyproject.toml", os.path.join("scripts", "setup_env.py")):
        with open(os.path.join(ROOT, name), "rb") as handle:
            digest.update(handle.read())
    return {"sha256": digest.hexdigest(), "extras": sorted(extras), "root": ROOT}


def up_to_date(wanted):
    """The environment was made from these very files, with at least these extras."""
    try:
        with open(STAMP) as handle:
            stamp = json.load(handle)
    except (OSError, ValueError):
        return False
    same = stamp.get("sha256") == wanted["sha256"] and stamp.get("root") == wanted["root"]
    return same and set(wanted["extras"]) <= set(stamp["extras"]) and version_of(PYTHON)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--extras", default="", help="extras of the package, for example dev")
    extras = [name for name in parser.parse_args().extras.split(",") if name]
    wanted = wanted_stamp(extras)
    if not up_to_date(wanted):
        if not has_pip(PYTHON):
            make_venv(*find_python())
        install_pybullet(version_of(PYTHON))
        say("installing sdgen and what it needs")
        target = "." + ("[" + ",".join(extras) + "]" if extras else "")
        run(*PIP, "--editable", target)
        check_pybullet()
        with open(STAMP, "w") as handle:
            json.dump(wanted, handle)
    missing = egl_missing()
    if missing:
        say(
            f"note: the fast EGL renderer lacks {', '.join(missing)};\n"
            "      going on with PyBullet's CPU renderer.\n"
            f"      On Debian or Ubuntu: apt-get install {EGL_PACKAGES}"
        )


if __name__ == "__main__":
    main()
