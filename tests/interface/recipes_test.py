#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes in packaging/recipes are files that their tools can read, of this version, and name what CMake looks for."""

import re
import sys
import tomllib
import types
from pathlib import Path

try:
    import yaml
except ImportError:
    print("SKIPPED: python3-yaml is missing; ./dev deps docs installs it")
    sys.exit(77)

root = Path(__file__).resolve().parents[2]
recipes = root / "packaging/recipes"

# Packages by the name that CMake looks for: of conda-forge, of spack.
PACKAGES = {
    "GSL": ("gsl", "gsl"),
    "Eigen3": ("eigen", "eigen"),
    "nlohmann_json": ("nlohmann_json", "nlohmann-json"),
    "spdlog": ("spdlog", "spdlog"),
    "CLI11": ("cli11", "cli11"),
    "FastFloat": ("fast_float", "fast-float"),
    "valijson": (None, "valijson"),
    "fmt": ("fmt", "fmt"),
    "Nettle": ("nettle", "nettle"),
    "Boost": ("libboost-headers", "boost"),
    "TBB": ("tbb-devel", "tbb"),
    "hwy": ("libhwy", "highway"),
    "ZLIB": ("zlib", "zlib-api"),
    "PkgConfig": ("pkg-config", "pkgconfig"),
    "MINIZIP": ("minizip", "minizip"),
    "pugixml": ("pugixml", "pugixml"),
    "MPI": ("openmpi", "mpi"),
    "HDF5": ("hdf5", "hdf5"),
}
TOOLS = {"c", "cxx", "cmake", "ninja", "python", "pybind11"}

project = (root / "CMakeLists.txt").read_text()
version = re.search(r"^project\(ashimpact VERSION ([0-9.]+)", project, re.MULTILINE)[1]
options = set(re.findall(r"^option\((\w+)", project + (root / "interface/python/CMakeLists.txt").read_text(), re.MULTILINE))
looked_for = set(re.findall(r"(?:find_package|pkg_check_modules)\((\w+)", (root / "cmake/Dependencies.cmake").read_text()))
looked_for.discard("doctest")  # of the tests
assert looked_for == set(PACKAGES), looked_for ^ set(PACKAGES)


def compare(recipe: str, named: set, which: int) -> None:
    wanted = {package[which] for package in PACKAGES.values()} - {None}
    assert named - TOOLS == wanted, f"{recipe}: {(named - TOOLS) ^ wanted}"


def is_option(name: str) -> bool:
    return name in options or name.startswith("CMAKE_") or name in ("ASHIMPACT_PYTHON_FOLDER", "VALIJSON_INCLUDE_DIR")


conda = yaml.safe_load((recipes / "conda-forge/recipe.yaml").read_text())
assert conda["context"]["version"] == version
assert (recipes / "conda-forge" / conda["source"][0]["path"] / "CMakeLists.txt").samefile(root / "CMakeLists.txt")
requirements = conda["requirements"]["build"] + conda["requirements"]["host"]
compare("conda-forge", {each.split()[0] for each in requirements if "${{" not in each}, 0)
assert all(is_option(name) for name in re.findall(r"-D(\w+)=", conda["build"]["script"][0]))
assert (root / conda["about"]["license_file"]).is_file()

# A stand-in for spack's module, which records the versions and dependencies of the recipe.
recorded = types.SimpleNamespace(depends=set(), versions=[])
spack = types.ModuleType("spack.package")
spack.CMakePackage = object
for directive in ("license", "variant", "generator"):
    setattr(spack, directive, lambda *_, **__: None)
spack.version = lambda number, **_: recorded.versions.append(number)
spack.depends_on = lambda spec, **_: recorded.depends.add(spec.split("@")[0])
sys.modules.update({"spack": types.ModuleType("spack"), "spack.package": spack})
names: dict = {}
exec(compile((recipes / "spack/package.py").read_text(), "package.py", "exec"), names)
assert recorded.versions == [version] and names["Ashimpact"].url.endswith(f"/ashimpact-{version}.tar.gz")
compare("spack", recorded.depends, 1)
recipe = names["Ashimpact"]()
recipe.define = recipe.define_from_variant = lambda name, _: name
assert all(is_option(name) for name in recipe.cmake_args())

wheel = tomllib.loads((recipes / "wheel/pyproject.toml").read_text())
assert wheel["project"]["version"] == version
settings = wheel["tool"]["scikit-build"]
assert (recipes / "wheel" / settings["cmake"]["source-dir"] / "CMakeLists.txt").samefile(root / "CMakeLists.txt")
assert all(is_option(name) for name in settings["cmake"]["define"])
python = (root / "interface/python/CMakeLists.txt").read_text()
assert all(f"({target} MODULE" in python for target in settings["build"]["targets"])
assert f"COMPONENT {settings['install']['components'][0]})" in python
print("3 recipes: version, sources, options and dependencies are those of CMake; not built")
