"""``python -m asymptotics`` is the command ``asymptotics``."""

import sys

from asymptotics.cli.main import main

sys.exit(main())
