"""``python -m asymptotics`` is the command ``asymptotics``."""

import sys

from asymptotics.cli.entry import main

sys.exit(main())
