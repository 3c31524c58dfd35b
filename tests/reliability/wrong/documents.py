# SPDX-License-Identifier: GPL-3.0-or-later
"""Right documents that together use every key of every input, and what is known of their places beyond the schema."""

import copy


class Rules:
    """What may stand at a place although its kind of value suggests otherwise."""

    def __init__(self, alone=(), may_be=None, needed=(), right=(), kinds=None, once=False):
        self.alone = alone  # keys below which nothing is spoiled
        self.allowed = may_be or {}  # key: what its value may be
        self.needed = needed  # ends of paths to keys that the program needs although the schema does not
        self.right = right  # (key, kind, test of a value): right although spoiled
        self.kinds = kinds  # the kinds of mistakes that are made, all if None
        self.once = once  # whether of places that differ by their index only one is spoiled

    def leave_alone(self, path):
        return bool(path) and path[-1] in self.alone

    def may_be(self, path):
        keys = [key for key in path if isinstance(key, str)]
        for key in reversed(keys[-2:]):
            if key in self.allowed:
                return self.allowed[key]
        return ()

    def is_needed(self, path):
        keys = tuple(key for key in path if isinstance(key, str))
        return any(keys[-len(end):] == end for end in self.needed)

    def is_right(self, path, kind, value):
        key = path[-1] if path else ""
        if self.kinds is not None and kind not in self.kinds:
            return True
        return any(key == name and kind == other and test(value) for name, other, test in self.right)

    def entries(self, values):
        if self.once:
            return range(min(1, len(values)))
        return range(len(values)) if len(values) < 3 else (0, len(values) - 1)


VELOCITIES = [0.54, 0.7, 0.9, 1.2, 1.6, 2.1, 2.8, 3.6]
RESTITUTIONS = [0, 0.06, 0.14, 0.21, 0.3, 0.37, 0.43, 0.46]
WALL = {"young_modulus": "193 GPa", "poisson_ratio": 0.29}
GLASSY = {"weight_fractions": {"quartz": "10 %", "mullite": "59 %"}, "amorphous": "remainder"}


def sample(**more):
    return {"name": "fine", "diameter": "88 um", "composition": copy.deepcopy(GLASSY), "density": "2300 kg/m3", **more}


def case(*samples, **more):
    return {"name": "A study", "wall": copy.deepcopy(WALL), "work_of_adhesion": "0.3 J/m2", "laws": ["hertz", "dmt"],
            "samples": list(samples) or [sample()], **more}


def pair(partner, **more):
    """A case of two spheres."""
    document = case(sample(**more.pop("sample", {})), partner=partner, **more)
    del document["wall"]
    return document


def quantity(value, unit, uncertainty):
    return {"value": value, "unit": unit, "standard_uncertainty": uncertainty, "origin": "measured", "source": "a table"}


PUBLISHED_SAMPLE = {
    "source": "a paper",
    "young_modulus": "148 GPa",
    "volume_fractions": {"quartz": 0.1, "mullite": 0.5},
    "damping_fits": {"dmt": {"a": "0.01 kg/s", "b": "-0.03 kg/s", "c": "0.02 kg/s"}},
    "damping_fit_uncertainty": "1e-5 kg/s",
    "critical_damping": {"dmt": "0.02 kg/s"},
    "critical_velocity": {"dmt": "1.4 m/s"},
    "measured_critical_velocity": "1.3 m/s",
    "contact_times": [{"law": "dmt", "velocity": "2 m/s", "contact_time": "300 ns"}],
    "critical_contact_times": {"dmt": "500 ns"},
}
PUBLISHED = {
    "source": "a paper",
    "remark": "read from its tables",
    "rounding": {"young_modulus": "1 GPa", "volume_fraction": "0.01 %", "damping_fit": "1e-5 kg/s",
                 "critical_damping": "1e-4 kg/s", "critical_velocity": "0.01 m/s", "contact_time": "1 ns"},
    "samples": {"fine": PUBLISHED_SAMPLE},
}


def cases():
    """Right cases by name."""
    points = {"velocity": {"values": VELOCITIES, "unit": "m/s"}, "restitution": RESTITUTIONS}
    rebounds = [round(v * e, 4) for v, e in zip(VELOCITIES, RESTITUTIONS)]
    return {
        "settings": case(
            sample(restitution={**points, "velocity_uncertainty": [0.01] * 8, "restitution_uncertainty": [0.01] * 8,
                                "impacts": [5] * 8, "source": "a camera"},
                   measured_critical_velocity=quantity(0.6, "m/s", 0.05), work_of_adhesion=quantity(0.25, "J/m2", 0.01),
                   porosity={"law": "spriggs", "value": "5 %", "coefficient": 4}),
            **{"$schema": "case.schema.json"}, schema_version=1, phase_set="literature", mixture_rule="parallel", damping_law="constant",
            particle={"density": "2300 kg/m3", "poisson_ratio": 0.2, "yield_pressure": "5 GPa",
                      "cohesion_energy_density": "10 MJ/m3", "tabor": 2.0},
            laws=["hertz", "dmt", "jkr", "maugis-dugdale"], detachments={"jkr": "pull-off", "hertz": "zero-force"},
            histories={"points": 20, "critical_excess": 0.01}, paper_explicit={"time_step": "1 ns"},
            fit={"order": 2, "direct_order": 3, "robust": False, "flatness": 0.25, "outlier": 4, "size_scatter": 0.1,
                 "velocity_scale_uncertainty": 0.03},
            uncertainty={"samples": 16, "replicates": 2, "seed": 1, "damping": "held"},
            calibration={"free": [{"quantity": "work_of_adhesion", "per_sample": False}]},
            published="dong2013",
            camera={"frame_rate": 80000, "pixel_size": "2 um", "frames": 5, "position_in_pixels": 0.3}),
        "moduli": case(
            sample(contact_modulus="90 GPa", poisson_ratio=0.2, yield_pressure="5 GPa", density=quantity(2300, "kg/m3", 30),
                   cohesion_energy_density="10 MJ/m3", tabor=1.0,
                   restitution={"velocity": VELOCITIES, "rebound_velocity": {"values": rebounds, "unit": "m/s"},
                                "velocity_uncertainty": [0.02] * 8, "rebound_uncertainty": [0.02] * 8,
                                "velocity_correlation": [0.1] * 8, "rebound_resolution": [0.03] * 8, "noted_capture": [0] * 8, "tangential_velocity": [0.5] * 8, "binning": {"impacts_per_bin": 2}}),
            phases=[{"name": "mullite", "density": "3.1 g/cm3", "young_modulus": "220 GPa", "poisson_ratio": 0.28}],
            laws=["thornton-ning", "sjkr"], wall={"contact_modulus": "90 GPa"}),
        "adhesion": case(
            sample(composition={"volume_fractions": {"quartz": 0.1, "mullite": 0.5}, "amorphous": 0.4,
                                "amorphous_phase": "glass", "densities": {"quartz": "2.65 g/cm3"}, "source": "a table"},
                   cohesive_stress="700 MPa"),
            work_of_adhesion={"surface_energies": {"particle": "40 mJ/m2", "wall": "0.5 J/m2", "interfacial": "0.1 J/m2"},
                              "rule": "dupre"},
            laws=["dmt", "maugis-dugdale"], particle={"contact_modulus": "90 GPa"}, wall={"rigid": True},
            roughness=quantity(2, "nm", 0.5)),
        "xrd": case(
            sample(composition={"xrd": "ash.csv", "xrd_sample": "fine", "amorphous": {"crystalline_total": "53 %"}},
                   restitution={"file": "impacts.csv", "binning": {"width": "0.05 m/s"},
                                "camera": {"frame_rate": 80000, "pixel_size": "2 um"}}),
            sample(name="glassy", composition={"weight_fractions": {"quartz": 0.1}, "amorphous": {"value": 90, "unit": "%", "standard_uncertainty": 1}}),
            sample(name="listed", composition={
                "phases": [{"name": "quartz", "weight_fraction": "10 %", "density": "2.65 g/cm3"},
                           {"name": "mullite", "weight_fraction": 0.5}], "amorphous": {"weight_fraction": "40 %"}}),
            sample(name="listed by volume", composition={
                "phases": [{"name": "quartz", "volume_fraction": "10 %"}], "amorphous": {"volume_fraction": "90 %"}}),
            sample(name="peaks", composition={
                "peaks": [{"name": "quartz", "intensity": 100, "rir": 3.1}, {"name": "mullite", "intensity": 200, "rir": 2.5}],
                "amorphous": "none"}),
            sample(name="scaled", composition={"weight_fractions": {"quartz": 0.5}, "amorphous": {"remainder_scale": 1.0}}),
            sample(name="standard", cohesion_range="0.4 nm",
                   composition={"xrd": "standard.csv", "internal_standard": {"phase": "corundum", "added_fraction": "10 %"}}),
            sample(name="standard, older key", cohesion_range="0.4 nm",
                   composition={"xrd": "standard.csv", "internal_standard": {"phase": "corundum", "weight_fraction": "10 %"}}),
            particle={"cohesion_range": "0.4 nm"}),
        "two spheres": pair(
            {"diameter": quantity(200, "um", 4), "density": "7.8 g/cm3", **WALL},
            work_of_adhesion={"surface_energies": {"particle": "40 mJ/m2", "partner": "0.5 J/m2"}, "rule": "girifalco-good"}),
        "a rigid partner": pair({"diameter": "200 um", "mass": "30 ug", "rigid": True}),
        "a partner with E*": pair({"diameter": "200 um", "density": 7800, "contact_modulus": "90 GPa"}),
        "workbook": case(
            sample(composition={"xrd": "ash.xlsx", "xrd_sheet": "Phasen", "xrd_decimal": "point"},
                   restitution={"file": "ash.xlsx", "sheet": "Stöße", "decimal": "point"}, work_of_adhesion="0.3 J/m2"),
            laws=["dmt"]),
        "reconstructed": case(
            sample(restitution={"reconstruct": {"from": 0.05, "to": 0.5, "points": 5, "reference_law": "dmt",
                                                "damping_fits": {"dmt": {"a": "0.01 kg/s", "b": "-0.03 kg/s",
                                                                         "c": "0.02 kg/s"}},
                                                "coefficient_uncertainty": "1e-5 kg/s", "source": "a paper"}},
                   published=PUBLISHED_SAMPLE),
            laws=["dmt"], particle={"cohesive_stress": "700 MPa"}),
    }


# A number that may be of either sign; one that may be zero; one that may be as small as one likes.
SIGNED = ("negative", "zero", "tiny")
SMALL = ("zero", "tiny")
CASE_RULES = Rules(
    may_be={
        "a": SIGNED, "b": SIGNED, "c": SIGNED, "poisson_ratio": SIGNED, "velocity_correlation": SIGNED, "tangential_velocity": SIGNED, "rebound_resolution": SMALL, "noted_capture": ("zero",),
        "work_of_adhesion": ("zero",), "particle": ("zero",), "wall": ("zero",), "partner": ("zero",), "interfacial": ("zero",), "cohesion_energy_density": ("zero",),
        "critical_damping": ("zero",), "damping_fit_uncertainty": ("zero",), "coefficient_uncertainty": ("zero",),
        "roughness": SMALL,
        "weight_fractions": SMALL, "volume_fractions": SMALL, "amorphous": SMALL, "crystalline_total": SMALL,
        "remainder_scale": SMALL, "added_fraction": ("tiny",), "volume_fraction": SMALL, "weight_fraction": SMALL, "value": SMALL,
        "intensity": SMALL,
        "from": SMALL, "to": ("tiny",), "rounding": ("zero",)},
    needed=(("wall", "young_modulus"), ("wall", "poisson_ratio"), ("partner", "young_modulus"), ("partner", "poisson_ratio"),
            ("partner", "density"), ("partner", "mass"), ("surface_energies", "partner")))
SWEEP_RULES = Rules(may_be={
    "work_of_adhesion": ("zero",), "damping": ("zero",), "cohesion_energy_density": ("zero",), "resolution": ("tiny",),
    "mean": SIGNED, "minimum": SMALL})

def sweeps():
    fixed = {"density": "2300 kg/m3", "contact_modulus": "90 GPa", "damping": "0.0141 kg/s"}
    return {
        "grid": {
            "schema_version": 1, "name": "a grid",
            "impact": {"laws": ["dmt", "jkr"], "radius": "44 um", **fixed, "detachments": {"jkr": "zero-overlap"},
                       "damping_law": "constant", "damping_over_sizes": {"power": 2, "at_radius": "44 um"},
                       "work_of_adhesion": "0.3 J/m2"},
            "variables": {"velocity": {"grid": "logarithmic", "from": "0.1 m/s", "to": "10 m/s", "points": 4}},
            "sampling": {"method": "grid"},
            "table": ["restitution", "contact_time"]},
        "parameters": {
            "impact": {"laws": ["thornton-ning", "sjkr", "maugis-dugdale"], "mass": "1 ug", "contact_modulus": "90 GPa",
                       "yield_pressure": "5 GPa", "cohesion_energy_density": "10 MJ/m3", "tabor": 1.0,
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s"},
            "variables": {"radius": {"values": [40, 44], "unit": "um"}, "damping": {"values": ["0.01 kg/s", "0.02 kg/s"]}},
            "sampling": {"method": "grid"}},
        "random": {
            "impact": {"laws": ["dmt"], **fixed},
            "variables": {
                "radius": {"distribution": "log-normal", "median": "22 um", "geometric_standard_deviation": 1.6,
                           "minimum": "1 um", "maximum": "100 um"},
                "velocity": {"distribution": "triangular", "from": "0.5 m/s", "mode": "1 m/s", "to": "5 m/s"},
                "work_of_adhesion": {"distribution": "normal", "mean": "0.3 J/m2", "standard_deviation": "0.1 J/m2",
                                     "minimum": "0.05 J/m2"}},
            "sampling": {"method": "quasi-random", "samples": 64, "seed": 1, "sequence": "sobol", "shifts": 4},
            "statistics": {"restitution": {"resolution": 0.01, "quantiles": [0.1, 0.9]}, "rebound_velocity": {},
                           "contact_time": {"resolution": 0.1}, "maximum_overlap": {}},
            "sensitivity": ["captured", "restitution"]},
        "all varied": {
            "impact": {"laws": ["thornton-ning", "sjkr", "maugis-dugdale"]},
            "variables": {
                "mass": {"values": [1e-9]}, "radius": {"values": [44e-6]}, "velocity": {"values": [2]},
                "contact_modulus": {"grid": "linear", "from": "90 GPa", "to": "95 GPa", "points": 2},
                "work_of_adhesion": {"values": [0.3]}, "yield_pressure": {"values": [5], "unit": "GPa"},
                "cohesion_energy_density": {"values": [1e7]}, "cohesive_stress": {"values": ["700 MPa"]},
                "damping": {"values": [0.01]}},
            "sampling": {"method": "grid"}},
        "density varied": {
            "impact": {"laws": ["dmt", "maugis-dugdale"], "radius": "44 um", "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s", "cohesion_range": "0.4 nm"},
            "variables": {"density": {"values": [2300]}},
            "sampling": {"method": "grid"}},
        "partner": {
            "impact": {"laws": ["dmt"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s", "partner_radius": "1 mm", "partner_mass": "1 mg"},
            "variables": {"damping": {"values": [0.01]}}, "sampling": {"method": "grid"}},
        "partner varied": {
            "impact": {"laws": ["dmt"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s", "partner_density": 2300},
            "variables": {"partner_radius": {"values": ["1 mm"]}}, "sampling": {"method": "grid"}},
        "partner's density varied": {
            "impact": {"laws": ["dmt"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s", "partner_radius": "1 mm"},
            "variables": {"partner_density": {"values": [2300]}}, "sampling": {"method": "grid"}},
        "partner's mass varied": {
            "impact": {"laws": ["dmt"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s", "partner_radius": "1 mm"},
            "variables": {"partner_mass": {"values": [1e-6]}}, "sampling": {"method": "grid"}},
        "stress": {
            "$schema": "sweep.schema.json",
            "impact": {"laws": ["maugis-dugdale"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "cohesive_stress": "700 MPa"},
            "variables": {"velocity": {"values": [2]}}, "sampling": {"method": "grid"}},
        "tabor varied": {
            "impact": {"laws": ["maugis-dugdale"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s"},
            "variables": {"tabor": {"values": [1.0]}}, "sampling": {"method": "grid"}},
        "range varied": {
            "impact": {"laws": ["maugis-dugdale"], "radius": "44 um", "density": 2300, "contact_modulus": "90 GPa",
                       "work_of_adhesion": "0.3 J/m2", "velocity": "2 m/s"},
            "variables": {"cohesion_range": {"values": ["0.4 nm"]}}, "sampling": {"method": "grid"}},
    }

# Of artifacts only what holds of any number: they may be edited, and signs differ from place to place.
ARTIFACT_RULES = Rules(may_be={}, kinds=("type", "missing", "unknown", "deep", "encoding", "control", "duplicate", "huge",
                                         "unit", "number", "long"), once=True)
