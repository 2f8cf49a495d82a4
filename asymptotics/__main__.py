"""``python -m asymptotics`` is the command ``asymptotics``."""

import sys

from asymptotics.shell.entry import main

sys.exit(main())
