# SPDX-License-Identifier: GPL-3.0-or-later
"""Parcels of the clouds that the exported check case does not have (its own is a colliding one): kinematic in that case,
MPPIC and thermo in cases of Debian's openfoam-examples changed by the three lines of the docs. run_exports.py calls check()."""
import csv
import glob
import json
import os
import re
import shutil
import subprocess

EXAMPLES = "/usr/share/doc/openfoam-examples/examples/lagrangian"
# program, example, cloud, place on a wall [m], direction to that wall
CLOUDS = (
    ("MPPICFoam", "MPPICFoam/Goldschmidt", "kinematicCloud", (0.0, -0.075, 0.2), (0, -1, 0)),
    ("coalChemistryFoam", "coalChemistryFoam/simplifiedSiwek", "limestoneCloud1", (0.3, 0.0, 0.05), (0, -1, 0)),
)
GAS = """FoamFile { version 2.0; format ascii; class dictionary; object thermophysicalProperties; }
thermoType
{
    type hePsiThermo; mixture pureMixture; transport const; thermo hConst; equationOfState perfectGas; specie specie;
    energy sensibleEnthalpy;
}
mixture { specie { molWeight 28.9; } thermodynamics { Cp 1007; Hf 0; } transport { mu 1.8e-05; Pr 0.7; } }
"""
FIELD = """FoamFile { version 2.0; format ascii; class volScalarField; object %s; }
dimensions [%s];
internalField uniform %g;
boundaryField { ".*" { type zeroGradient; } }
"""
STEP = 1e-4     # of time [s]


def replaced(path, *changes):
    with open(path) as file:
        text = file.read()
    for pattern, replacement in changes:
        text, found = re.subn(pattern, replacement, text, flags=re.S)
        if not found:
            raise AssertionError("%s has no %s" % (path, pattern))
    with open(path, "w") as file:
        file.write(text)


def unpacked(folder):
    for place, _, files in os.walk(folder):
        for name in files:
            if name.endswith(".gz"):
                subprocess.run(["gunzip", "-f", os.path.join(place, name)], check=True)


def case_of(work, exported, program, example, cloud, wall, direction, impact):
    """A copy of the example with one parcel that meets the wall in the second time step, as the docs say it."""
    case = os.path.join(work, "cloud-" + program)
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(os.path.join(EXAMPLES, example), case)
    unpacked(case)
    shutil.copy(os.path.join(exported, "ashTable"), os.path.join(case, "constant"))
    velocity = impact["velocity"]["value"]
    place = tuple(x - 1.5 * STEP * velocity * u for x, u in zip(wall, direction))
    replaced(os.path.join(case, "system/controlDict"),
             (r"\nendTime\s[^;]*;", '\nendTime %g;\nlibs ("%s/src/libashImpact.so");' % (4 * STEP, exported)),
             (r"\ndeltaT\s[^;]*;", "\ndeltaT %g;" % STEP))
    control = os.path.join(case, "system/controlDict")
    with open(control) as file:
        text = file.read()
    text = re.sub(r"\nfunctions\s*\{.*", "\n", text, flags=re.S)
    with open(control, "w") as file:
        file.write(re.sub(r"adjustTimeStep\s+yes", "adjustTimeStep no", text))
    replaced(os.path.join(case, "constant", cloud + "Properties"),
             (r"patchInteractionModel\s+\w+;", "patchInteractionModel ashImpact; ashImpactCoeffs { record all; }"),
             (r"particleForces\s*\{.*?\n    \}", "particleForces {}"),
             (r"parcelBasisType\s+\w+;", "parcelBasisType fixed; nParticle 1;"),
             (r'positionsFile\s+"[^"]*"', 'positionsFile "ashParcel"'),
             (r"U0\s+\([^)]*\)", "U0 (%.17g %.17g %.17g)" % tuple(velocity * u for u in direction)),
             (r"dispersionModel\s+\w+;", "dispersionModel none;"),
             (r"sizeDistribution\s*\{.*?\}\s*\}", "sizeDistribution { type fixedValue; fixedValueDistribution { value %.17g; } }"
              % impact["diameter"]["value"]))
    with open(os.path.join(case, "constant/ashParcel"), "w") as file:
        file.write("FoamFile { version 2.0; format ascii; class vectorField; object ashParcel; }\n((%.17g %.17g %.17g))\n" % place)
    return case


def kinematic_case(work, exported):
    """The exported check case with the gas that uncoupledKinematicParcelFoam wants."""
    case = os.path.join(work, "cloud-kinematic")
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(os.path.join(exported, "check"), case)
    for name in glob.glob(os.path.join(case, "0.*")) + glob.glob(os.path.join(case, "postProcessing")):
        shutil.rmtree(name)
    for name, text in (("constant/thermophysicalProperties", GAS), ("0/p", FIELD % ("p", "1 -1 -2 0 0 0 0", 1e5)),
                       ("0/T", FIELD % ("T", "0 0 0 1 0 0 0", 300))):
        with open(os.path.join(case, name), "w") as file:
            file.write(text)
    replaced(os.path.join(case, "system/controlDict"), (r'libs\s[^;]*;', 'libs ("%s/src/libashImpact.so");' % exported))
    replaced(os.path.join(case, "constant/kinematicCloudProperties"), ("mu cell;", "thermo:mu cell;"))
    return case


def bed_case(work, exported):
    """The fluidised bed of Goldschmidt, 24,750 beads of 2.5 mm, with the three lines of the docs and a shorter time."""
    case = os.path.join(work, "bed")
    shutil.rmtree(case, ignore_errors=True)
    shutil.copytree(os.path.join(EXAMPLES, "MPPICFoam/Goldschmidt"), case)
    unpacked(case)
    shutil.copy(os.path.join(exported, "ashTable"), os.path.join(case, "constant"))
    replaced(os.path.join(case, "system/controlDict"),
             (r"\nendTime\s[^;]*;", '\nendTime 0.02;\nlibs ("%s/src/libashImpact.so");' % exported))
    replaced(os.path.join(case, "constant/kinematicCloudProperties"),
             (r"patchInteractionModel\s+\w+;",
              "patchInteractionModel ashImpact;\nashImpactCoeffs { record stuck; patches (bottom walls); }"))
    return case


def check_bed(work, exported, fail):
    """Beads that fall on the bottom, a patch that is no wall, stay there, each below the critical velocity; none leaves."""
    case = bed_case(work, exported)
    problem = run(case, ("blockMesh", "MPPICFoam"))
    with open(os.path.join(exported, "expected.json")) as file:
        captures = [i["velocity"]["value"] for i in json.load(file)["impacts"] if i["outcome"] == "capture"]
    rows = impacts_of(case)
    print("openfoam  Goldschmidt's bed: %d beads stuck" % len(rows), flush=True)
    if problem or not rows:
        fail("Goldschmidt's bed: %s" % (problem or "nothing stuck"))
    for row in rows:
        if row["patch"] not in ("bottom", "walls") or not float(row["velocity [m/s]"]) < 1.02 * max(captures):
            fail("Goldschmidt's bed: %s" % row)
    kept = [int(n) for n in re.findall(r"Current number of parcels\s+= (\d+)", output_of(case, "MPPICFoam"))]
    if not kept or kept[-1] != max(kept):
        fail("Goldschmidt's bed: of %d beads %d are left" % (max(kept, default=0), kept[-1] if kept else 0))
    replaced(os.path.join(case, "constant/kinematicCloudProperties"), (r"patches \(bottom walls\)", "patches (bottom)"))
    refused = run(case, ("MPPICFoam",)) or ""
    if "patches does not name the wall walls" not in refused:
        fail("Goldschmidt's bed: a wall without a model is not refused: %s" % refused)


def impacts_of(case):
    rows = []
    for path in glob.glob(os.path.join(case, "postProcessing/ashImpact/*/impacts_*.csv")):
        with open(path) as file:
            rows += list(csv.DictReader(file))
    return rows


def output_of(case, program):
    with open(os.path.join(case, "log." + program)) as file:
        return file.read()


def run(case, programs):
    for program in programs:
        ran = subprocess.run(program.split(), cwd=case, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        with open(os.path.join(case, "log." + program.split()[0]), "w") as file:
            file.write(ran.stdout)
        if ran.returncode != 0:
            return "%s: %s" % (program, ran.stdout[-1500:])
    return None


def check_ranks(work, exported, fail):
    """The parcels of expected.json on two ranks; those at an angle cross from one to the other."""
    os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    folder = os.path.join(work, "openfoam-ranks")
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(exported, folder, ignore=shutil.ignore_patterns("0.0*", "postProcessing"))
    case = os.path.join(folder, "check")
    replaced(os.path.join(case, "system/blockMeshDict"), (r"\(1 1 1\) simple", "(8 1 1) simple"))
    with open(os.path.join(case, "system/decomposeParDict"), "w") as file:
        file.write("FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
                   "numberOfSubdomains 2; method simple; simpleCoeffs { n (2 1 1); delta 0.001; }\n")
    root = "--allow-run-as-root " if os.geteuid() == 0 else ""
    problem = run(case, ("blockMesh", "decomposePar", "mpirun %s--oversubscribe -n 2 icoUncoupledKinematicParcelFoam -parallel"
                         % root, "reconstructPar"))
    ran = subprocess.run(["python3", "compare.py"], cwd=folder, stdout=subprocess.PIPE, universal_newlines=True)
    print("openfoam  two ranks: %s" % ran.stdout.strip().splitlines()[-1], flush=True)
    if problem or ran.returncode != 0:
        fail("openfoam on two ranks: %s" % (problem or ran.stdout))


def check(work, exported, fail):
    """The impacts of expected.json in the kinematic cloud, a capture and a rebound in the others."""
    os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    with open(os.path.join(exported, "expected.json")) as file:
        expected = json.load(file)
    kinematic = kinematic_case(work, exported)
    problem = run(kinematic, ("blockMesh", "uncoupledKinematicParcelFoam"))
    found = [(float(row["diameter [m]"]), float(row["velocity [m/s]"]), float(row["restitution [1]"]))
             for row in impacts_of(kinematic)]
    close = sum(any(abs(d / i["diameter"]["value"] - 1) < 1e-9 and abs(v / i["velocity"]["value"] - 1) < 1e-6
                    and (e > 0) == (i["outcome"] == "rebound")
                    and abs(e - i["restitution"]["value"]) <= expected["tolerance"] for d, v, e in found)
                for i in expected["impacts"])
    print("openfoam  uncoupledKinematicParcelFoam: %d of %d impacts agree" % (close, len(expected["impacts"])), flush=True)
    if problem or close != len(expected["impacts"]):
        fail("kinematic cloud: %s" % (problem or found))
    if not os.path.isdir(EXAMPLES):
        fail("openfoam-examples is not installed")
        return
    for program, example, cloud, wall, direction in CLOUDS:
        for outcome in ("capture", "rebound"):
            impact = [i for i in expected["impacts"] if i["outcome"] == outcome][-1]
            case = case_of(work, exported, program, example, cloud, wall, direction, impact)
            problem = run(case, ("blockMesh",) + (("topoSet",) if "coal" in program else ()) + (program,))
            if problem:
                fail(problem)
                continue
            e = impact["restitution"]["value"]
            found = [float(row["restitution [1]"]) for row in impacts_of(case)]
            print("openfoam  %-18s %s: e %s, expected %.9f" % (program, outcome, found, e), flush=True)
            if len(found) != 1 or (found[0] > 0) != (e > 0) or abs(found[0] - e) > expected["tolerance"]:
                fail("%s: %s of %s, not %g" % (program, outcome, found, e))
