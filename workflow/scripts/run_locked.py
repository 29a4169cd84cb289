"""Run a command while holding a lock that the kernel drops with the process, however that ends.

Snakemake's own lock outlives a killed run. The make targets switch it off and hold this one instead, so that two runs
never meet in one folder and a killed one blocks nobody.

Usage: python run_locked.py LOCKFILE COMMAND [ARGUMENT ...]
"""

import fcntl
import os
import sys


def main() -> None:
    """Take the lock, or say who else may hold it; then become the command, which inherits it."""
    lock_file, *command = sys.argv[1:]
    handle = os.open(lock_file, os.O_RDWR | os.O_CREAT, 0o644)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit(f"another run holds {lock_file}: wait until it ends, or stop it, then try again")
    os.set_inheritable(handle, True)
    os.execvp(command[0], command)


main()
