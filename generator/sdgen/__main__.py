"""``python -m sdgen`` is the ``sdgen`` command."""

from sdgen.cli.main import main

if __name__ == "__main__":
    main()
