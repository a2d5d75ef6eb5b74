"""How the tests of the structure begin and end."""

import subprocess


def files_of(root):
    """Tracked files and those that could be; without git, everything outside build folders."""
    try:
        listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True,
                                check=True).stdout.splitlines()
    except (OSError, subprocess.CalledProcessError):
        listed = [str(p.relative_to(root)) for p in root.rglob("*") if p.is_file()]
    return sorted(f for f in listed if (root / f).is_file() and not f.startswith(("build/", "runs/")))


def report(problems, what="", most=None):
    """Prints each problem, then how many there are (what: in which files); gives the exit status."""
    for problem in problems[:most]:
        print(problem)
    print(f"{len(problems)} problems{what}")
    return 1 if problems else 0
