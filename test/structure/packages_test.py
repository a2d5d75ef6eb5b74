#!/usr/bin/env python3
"""config/packages.txt names every package that a build and the unit tests use themselves, not only by way of another package.

Libraries: what our sources include, found as the compiler finds it, belongs to a listed package.  Programs: those that the
build files and scripts start.  And what cmake/*.cmake and ./twinbus tell people to install is listed.  Any line that is taken
out of the list must be named.  Skipped where there is no dpkg.

    packages_test.py [LIST]
"""

import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
# Whatever a C++ compiler brings along.
COMPILER = re.compile(r"(libc6|linux-libc|libstdc\+\+-\d+|libgcc-\d+|libcrypt|lib(asan|tsan|ubsan|lsan)\d+)-dev$|g\+\+|gcc")
# Programs that are started by name, and Python's modules, with what they belong to.
STARTED = {"cmake": "cmake", "ctest": "cmake", "ninja": "ninja-build", "c++": "g++", "pkg-config": "pkg-config", "git": "git",
           "ccache": "ccache", "lcm-gen": "liblcm-bin", "javac": "default-jdk-headless", "jar": "default-jdk-headless",
           "python3": "python3", "ip": "iproute2"}
FILES = {"/usr/share/java/lcm.jar": "liblcm-java"}
CAMPAIGN = ("campaign/", "test/campaign/", "test/bench/peers/")  # listed for `campaign:` only; peers say what they need
PEERS = ("test/bench/peers",)  # optional: said when absent
FACE = ("bridge/adaptors/unitree_dds/",)  # what it needs is listed for `face:` only; types of DDS are made while it is built
NANOBIND = re.compile(r"nanobind/")  # pip brings it to a wheel (python/pyproject.toml); the module is left out without it


def output(*words, stdin=None):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, input=stdin).stdout


def listed(text):
    """Packages that every command gets, without those of one command only."""
    names = [line.split()[0] for line in text.splitlines() if line.strip() and not line.startswith("#")]
    return {name for name in names if not name.endswith(":")}


def told():
    """(package, where) that a build file or ./twinbus names as what to install."""
    for names in re.findall(r"apt-get install ([\w.+ -]+)", (ROOT / "python/CMakeLists.txt").read_text()):
        for name in names.split():
            yield name, "python/CMakeLists.txt"
    for file in sorted((ROOT / "cmake").glob("*.cmake")):
        text = re.sub(r"#.*", "", file.read_text())
        for pattern in (r"twinbus_pkg_config\(\w+ \S+ ([\w+.-]+)\)", r"twinbus_package\(([\w+.-]+) \w", r'twinbus_missing\("[^"$]*" ([\w+.-]+)\)'):
            for name in re.findall(pattern, text):
                if not COMPILER.match(name) or name == "g++":
                    yield name, f"cmake/{file.name}"
    line = re.search(r"for pair in (.*); do", (ROOT / "twinbus").read_text()).group(1)
    for pair in line.split():
        yield pair.split(":")[1], "./twinbus"


def included():
    """{header: file that includes it} of our C++ and C sources."""
    found = {}
    for file in sorted(ROOT.rglob("*.[ch]*")):
        path = file.relative_to(ROOT).as_posix()
        if file.suffix not in (".h", ".hpp", ".cpp", ".c") or path.startswith(("build/", "runs/", *PEERS, *FACE)):
            continue
        text = file.read_text(errors="replace")
        for header in re.findall(r"^\s*#\s*include\s*<([^>]+)>", text, re.MULTILINE):
            if f"__has_include(<{header}>)" not in text and not NANOBIND.match(header):
                found.setdefault(header, path)
    return found


def folders():
    """Where the compiler looks, and where pkg-config sends it for the libraries of cmake/libraries.cmake."""
    said = subprocess.run(["c++", "-E", "-x", "c++", "-v", "/dev/null"], capture_output=True, text=True).stderr
    search = re.search(r"search starts here:\n(?:.*\n)*?End of search", said).group(0)
    places = [pathlib.Path(line.strip()) for line in search.splitlines() if line.startswith(" ")]
    modules = re.findall(r"twinbus_pkg_config\(\w+ (\S+)", "".join(f.read_text() for f in (ROOT / "cmake").glob("*.cmake")))
    for module in [*modules, "eigen3"]:
        places += [pathlib.Path(word[2:]) for word in output("pkg-config", "--cflags-only-I", module).split()]
    return list(dict.fromkeys(place.resolve() for place in places))


def owners(files):
    """{file: package} by dpkg, which may know a file by the name before a link."""
    names = {name: file for file in files for name in (file, file.replace("/usr/lib/", "/lib/", 1))}
    known = {}
    for line in output("dpkg-query", "-S", *names).splitlines():
        packages, _, name = line.rpartition(": ")
        if name in names:
            known[names[name]] = packages.split(",")[0].split(":")[0]
    return known


def used():
    """(package, what uses it); an empty package where nothing here has it."""
    where = {}
    places = folders()
    for header, user in included().items():
        file = next((place / header for place in places if (place / header).is_file()), None)
        where[header] = (str(file.resolve()) if file else None, user)
    packages = owners({file for file, _ in where.values() if file})
    for header, (file, user) in where.items():
        yield packages.get(file, ""), f"<{header}> of {user}"
    for program, package in STARTED.items():
        yield package, f"the program {program}"
    for file, package in FILES.items():
        yield package, file
    for file in sorted(ROOT.rglob("*.py")):
        if re.search(r"^(import|from) yaml\b", file.read_text(), re.MULTILINE):
            if not file.relative_to(ROOT).as_posix().startswith(CAMPAIGN):
                yield "python3-yaml", f"import yaml of {file.relative_to(ROOT)}"


def unversioned(package):
    """libboost-dev for libboost1.74-dev: the name that stays from release to release."""
    return re.sub(r"(?<=[a-z])\d[\d.]*(?=-)", "", package)


def problems(names, uses, tells):
    found = []
    for package, what in uses:
        if not package:
            found.append(f"{what}: no installed package has it")
        elif not {package, unversioned(package)} & names and not COMPILER.match(package):
            found.append(f"{unversioned(package) if '.' in package else package} is used ({what}), and config/packages.txt does not name it")
    for package, where in tells:
        if package not in names:
            found.append(f"{package} is what {where} tells people to install, and config/packages.txt does not name it")
    return sorted(set(found))


def main():
    if not shutil.which("dpkg-query") or not shutil.which("c++"):
        print("no dpkg or no compiler: skipped")
        return SKIPPED
    names = listed(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "config/packages.txt").read_text())
    uses, tells = list(used()), list(told())
    found = problems(names, uses, tells)
    print("\n".join(found) or f"{len(names)} packages, {len(uses)} uses")
    unnamed = [name for name in sorted(names) if not any(line.startswith(f"{name} is ") for line in problems(names - {name}, uses, tells))]
    for name in unnamed:
        print(f"{name} is in config/packages.txt, and nothing here uses it")
    return 1 if found or unnamed else 0


sys.exit(main())
