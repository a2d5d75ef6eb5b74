"""How the tests of the structure end."""


def report(problems, what="", most=None):
    """Prints each problem, then how many there are (what: in which files); gives the exit status."""
    for problem in problems[:most]:
        print(problem)
    print(f"{len(problems)} problems{what}")
    return 1 if problems else 0
