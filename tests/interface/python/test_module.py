# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module, from outside: results, shapes, errors, threads, signals, documents."""

import ctypes
import inspect
import json
import os
import signal
import subprocess
import sys
import threading
import time
import unittest
import warnings

import numpy as np

import ashimpact

ASH = dict(law="jkr", density=2160.0, contact_modulus=60e9, work_of_adhesion=0.3, damping=2e-6)


def program(*words):
    name = os.environ["ASHIMPACT_PROGRAM"]
    return subprocess.run([name, *words], capture_output=True, text=True, check=True).stdout


def typical_parameters(law):
    """A value of each parameter that a law takes, of alternatives the first."""
    values, choices = {}, set()
    for name, (_, _, laws, typical, choice) in ashimpact._core.law_parameters().items():
        if law in laws and choice not in choices:
            values[name] = typical
            choices |= {choice} - {0}
    return values


class Impacts(unittest.TestCase):
    def test_equals_the_command_line(self):
        words = ["--radius", "22 um", "--density", "2160 kg/m3", "--contact-modulus", "60 GPa", "--damping", "2e-6 kg/s"]
        adhesive = ["--work-of-adhesion", "0.3 J/m2"]
        cases = (
            ("hertz", {}, []),
            *((law, {"work_of_adhesion": 0.3}, adhesive) for law in ("dmt", "brach-dunn", "jkr")),
            ("thornton-ning", {"yield_pressure": 2e9, "work_of_adhesion": 0.3}, ["--yield-pressure", "2 GPa", *adhesive]),
            ("sjkr", {"cohesion_energy_density": 1e8}, ["--cohesion-energy-density", "100 MJ/m3"]),
            ("maugis-dugdale", {"tabor": 2.0, "work_of_adhesion": 0.3}, ["--tabor", "2", *adhesive]),
            ("maugis-dugdale", {"cohesive_stress": 7.7e8, "work_of_adhesion": 0.3},
             ["--cohesive-stress", "770 MPa", *adhesive]),
            ("maugis-dugdale", {"cohesion_range": 4e-10, "work_of_adhesion": 0.3},
             ["--cohesion-range", "0.4 nm", *adhesive]),
        )
        for law, own, options in cases:
            contact = dict(law=law, radius=22e-6, density=2160.0, contact_modulus=60e9, damping=2e-6, **own)
            with self.subTest(law=law, own=own):
                shown = json.loads(program("impact", "--law", law, *words, *options, "--velocity", "1.5 m/s", "--json"))
                ours = ashimpact.impacts(velocity=1.5, **contact)
                self.assertAlmostEqual(float(ours.restitution), shown["restitution"]["value"], delta=1e-10)
                overlap = float(ours.maximum_overlap) / shown["maximum_overlap"]["value"]
                self.assertAlmostEqual(overlap, 1.0, delta=1e-10)
                shown = json.loads(program("critical-velocity", "--law", law, *words, *options, "--json"))
                critical = float(ashimpact.critical_velocities(**contact).critical_velocity)
                self.assertAlmostEqual(critical / shown["critical_velocity"]["value"], 1.0, delta=1e-9)
                if law not in ("sjkr", "maugis-dugdale"):  # which take parameters of their own
                    continue
                without = {key: value for key, value in contact.items() if key != "damping"}
                found = ashimpact.dampings(velocity=5.0, restitution=0.7, **without)
                again = ashimpact.impacts(velocity=5.0, **dict(without, damping=found.damping))
                self.assertAlmostEqual(float(again.restitution), 0.7, delta=1e-9)

    def test_laws_with_parameters_of_their_own(self):
        base = dict(radius=22e-6, density=2160.0, contact_modulus=60e9, velocity=1.5)
        cohesion = np.array([[1e7], [1e8]])
        many = ashimpact.impacts(law="sjkr", **dict(base, velocity=[0.5, 1.0, 2.0]), cohesion_energy_density=cohesion)
        self.assertEqual(many.restitution.shape, (2, 3))
        alone = ashimpact.impacts(law="sjkr", **dict(base, velocity=2.0), cohesion_energy_density=1e8)
        self.assertEqual(many.restitution[1, 2], alone.restitution)
        for given, expected in (
            (dict(law="sjkr"), "cohesion_energy_density"),
            (dict(law="maugis-dugdale", work_of_adhesion=0.3), "tabor"),
            (dict(law="maugis-dugdale", work_of_adhesion=0.3, tabor=2.0, cohesion_range=4e-10), "tabor"),
            (dict(law="sjkr", cohesion_energy_density=-1.0), "cohesion_energy_density"),
        ):
            with self.subTest(given=given), self.assertRaises(ashimpact.InputError) as caught:
                ashimpact.impacts(**base, **given)
            self.assertIn(expected, str(caught.exception))

    def test_a_diameter_is_twice_the_radius(self):
        by_radius = ashimpact.impacts(velocity=[1.0, 2.0], radius=22e-6, **ASH)
        by_diameter = ashimpact.impacts(velocity=[1.0, 2.0], diameter=44e-6, **ASH)
        self.assertTrue(np.array_equal(by_radius.restitution, by_diameter.restitution))
        self.assertEqual(
            ashimpact.critical_velocities(diameter=44e-6, **ASH).critical_velocity,
            ashimpact.critical_velocities(radius=22e-6, **ASH).critical_velocity,
        )
        for given, expected in ((dict(radius=1e-5, diameter=2e-5), "both are given"), ({}, "neither is given")):
            with self.assertRaises(ashimpact.InputError) as caught:
                ashimpact.critical_velocities(**ASH, **given)
            self.assertIn(expected, str(caught.exception))

    def test_at_an_angle(self):
        words = ["--law", "jkr", "--radius", "22 um", "--density", "2160", "--contact-modulus", "60 GPa"]
        words += ["--work-of-adhesion", "0.3", "--damping", "2e-6", "--friction", "0.2"]
        sphere = dict(ASH, radius=22e-6, friction=0.2)
        angles = np.radians([5.0, 40.0, 80.0])
        ours = ashimpact.impacts(velocity=4.0, angle=angles, spin=[0.0, 3000.0, -3000.0], **sphere)
        for i, (angle, spin) in enumerate(((5, 0), (40, 3000), (80, -3000))):
            at = ["--velocity", "4", "--angle", f"{angle} deg", "--spin", f"{spin} rad/s"]
            shown = json.loads(program("impact", *words, *at, "--json"))
            self.assertEqual(ours.regime[i], shown["regime"])
            for name in ("tangential_restitution", "rebound_angle", "spin", "impulse_ratio"):
                self.assertAlmostEqual(getattr(ours, name)[i] / (shown[name]["value"] or 1.0), 1.0, delta=1e-9)
        split = ashimpact.impacts(velocity=4.0 * np.cos(angles), tangential_velocity=4.0 * np.sin(angles), spin=0.0, **sphere)
        self.assertTrue(np.all(split.restitution == ours.restitution))
        partner = dict(sphere, partner_radius=22e-6, partner_density=2160.0)
        pair = ashimpact.impacts(velocity=1.0, tangential_velocity=0.01, **partner)
        self.assertAlmostEqual(float(pair.spin), -5.0 / 7.0 * 0.01 / 22e-6 / 2.0, delta=1e-6)  # each sphere takes half
        normal = ashimpact.impacts(velocity=1.0, **ASH, radius=22e-6)
        self.assertIsNone(normal.regime)
        for given, expected in (
            (dict(angle=0.1), "friction is not given"),
            (dict(angle=0.1, tangential_velocity=1.0, friction=0.1), "both are given"),
            (dict(angle=45.0, friction=0.1), "angle is 45.0 rad"),
            (dict(angle=0.1, friction=-0.1), "friction is -0.1"),
        ):
            with self.assertRaises(ashimpact.InputError) as caught:
                ashimpact.impacts(velocity=1.0, radius=22e-6, **ASH, **given)
            self.assertIn(expected, str(caught.exception))

    def test_two_spheres(self):
        contact = dict(ASH, radius=22e-6, partner_radius=100e-6, partner_density=7800.0)
        words = ["--law", "jkr", "--radius", "22 um", "--density", "2160", "--contact-modulus", "60 GPa"]
        words += ["--work-of-adhesion", "0.3", "--damping", "2e-6", "--partner-radius", "100 um"]
        shown = json.loads(program("impact", *words, "--partner-density", "7800", "--velocity", "1.5", "--json"))
        ours = ashimpact.impacts(velocity=1.5, **contact)
        self.assertAlmostEqual(float(ours.restitution), shown["restitution"]["value"], delta=1e-10)
        self.assertAlmostEqual(float(ours.maximum_overlap) / shown["maximum_overlap"]["value"], 1.0, delta=1e-10)
        # equal spheres: half the mass and half the radius on a wall
        mass = 2160.0 * np.pi / 6.0 * 44e-6**3
        pair = ashimpact.critical_velocities(**dict(contact, partner_radius=22e-6, partner_density=2160.0))
        wall = dict(ASH, radius=11e-6, mass=mass / 2.0)
        del wall["density"]
        alone = ashimpact.critical_velocities(**wall)
        self.assertAlmostEqual(float(pair.critical_velocity / alone.critical_velocity), 1.0, delta=1e-9)
        # a large partner is a wall; one call takes partners of several sizes
        wall = ashimpact.critical_velocities(**dict(ASH, radius=22e-6)).critical_velocity
        pairs = ashimpact.critical_velocities(**dict(contact, partner_radius=[1e-3, 1.0, 1e3])).critical_velocity
        distance = np.abs(pairs / wall - 1.0)
        self.assertTrue(np.all(np.diff(distance) < 0.0))
        self.assertLess(distance[-1], 1e-6)
        back = ashimpact.dampings(
            velocity=1.5, restitution=ours.restitution, **{k: v for k, v in contact.items() if k != "damping"}
        )
        self.assertAlmostEqual(float(back.damping) / ASH["damping"], 1.0, delta=1e-6)
        for wrong, said in (
            (dict(partner_radius=None), "partner_radius is not given"),
            (dict(partner_density=None), "partner_density, partner_mass: neither is given"),
            (dict(partner_mass=1e-9), "partner_density, partner_mass: both are given"),
            (dict(partner_radius=-1e-6), "partner_"),
        ):
            with self.assertRaisesRegex(ashimpact.InputError, said):
                ashimpact.impacts(velocity=1.5, **dict(contact, **wrong))

    def test_every_parameter_of_a_law_is_an_argument(self):
        functions = (ashimpact.impacts, ashimpact.critical_velocities, ashimpact.dampings, ashimpact.analyse_impacts)
        for function in functions:
            for name in ashimpact._core.law_parameters():
                self.assertIn(name, inspect.signature(function).parameters, function.__name__)
        units = ashimpact._core.damping_laws()
        stated = [*(f"{name}: " for name in ashimpact._core.law_parameters()), *ashimpact.laws()]
        for text in (*stated, *(f"{unit} {law}" for law, unit in units.items())):
            self.assertIn(text, ashimpact.impacts.__doc__)

    def test_the_bits_of_the_c_library(self):
        library = ctypes.CDLL(os.environ["ASHIMPACT_LIBRARY"])

        class Named(ctypes.Structure):
            _fields_ = [("name", ctypes.c_char_p), ("value", ctypes.c_double)]

        class Column(ctypes.Structure):
            _fields_ = [("name", ctypes.c_char_p), ("values", ctypes.c_void_p), ("stride", ctypes.c_size_t)]

        class Output(ctypes.Structure):
            _fields_ = [("name", ctypes.c_char_p), ("values", ctypes.c_void_p)]

        radius = np.geomspace(0.5e-6, 50e-6, 301)
        velocity = 0.05 * np.exp(5 * np.abs(np.sin(np.arange(radius.size))))
        for law in ashimpact.laws():
            constants = {"density": 2160.0, "contact_modulus": 60e9, "damping": 2e-6, **typical_parameters(law)}
            if law not in ("hertz", "sjkr"):
                constants["work_of_adhesion"] = 0.3
            named = (Named * len(constants))(*((key.encode(), value) for key, value in constants.items()))
            model = ctypes.c_void_p()
            self.assertEqual(0, library.ashimpact_open(law.encode(), None, None, named, ctypes.c_size_t(len(named)),
                                                       ctypes.byref(model), None))
            diameter = 2.0 * radius
            columns = (Column * 2)((b"diameter", diameter.ctypes.data, 1), (b"velocity", velocity.ctypes.data, 1))
            fields = ("restitution", "contact_time", "approach_time", "maximum_overlap")
            theirs = {field: np.empty_like(radius) for field in fields}
            outputs = (Output * 4)(*((field.encode(), theirs[field].ctypes.data) for field in fields))
            self.assertEqual(0, library.ashimpact_solve_impacts(model, ctypes.c_size_t(radius.size), columns,
                                                                ctypes.c_size_t(2), outputs, ctypes.c_size_t(4), None))
            ours = ashimpact.impacts(law=law, radius=radius, velocity=velocity, **constants)
            for field in fields:
                same = getattr(ours, field).view(np.uint64) == theirs[field].view(np.uint64)
                both_missing = np.isnan(getattr(ours, field)) & np.isnan(theirs[field])
                self.assertTrue((same | both_missing).all(), f"{law} {field}")
            critical = np.empty_like(radius)
            library.ashimpact_critical_velocities(model, ctypes.c_size_t(radius.size), ctypes.c_void_p(diameter.ctypes.data),
                                                  ctypes.c_void_p(critical.ctypes.data), None)
            ours = ashimpact.critical_velocities(law=law, radius=radius, **constants).critical_velocity
            np.testing.assert_array_equal(ours, critical)
            library.ashimpact_close(model)

    def test_shapes_broadcast(self):
        radius = np.geomspace(1e-6, 50e-6, 7)
        velocity = np.array([[0.1], [1.0], [10.0]])
        result = ashimpact.impacts(radius=radius, velocity=velocity, **ASH)
        self.assertEqual(result.restitution.shape, (3, 7))
        self.assertEqual(result.captured.dtype, bool)
        for row in range(3):
            for column in range(7):
                alone = ashimpact.impacts(radius=radius[column], velocity=velocity[row, 0], **ASH)
                self.assertEqual(alone.restitution.shape, ())
                self.assertEqual(alone.restitution, result.restitution[row, column])
        np.testing.assert_array_equal(np.isnan(result.contact_time), result.captured)
        empty = ashimpact.impacts(radius=np.array([]), velocity=1.0, **ASH)
        self.assertEqual(empty.restitution.shape, (0,))
        strided = ashimpact.impacts(radius=np.repeat(radius, 2)[::2], velocity=velocity.T[0, 0], **ASH)
        np.testing.assert_array_equal(strided.restitution, result.restitution[0])

    def test_no_bit_depends_on_threads_or_chunks(self):
        radius = np.geomspace(0.5e-6, 50e-6, 70_001)
        velocity = 0.05 * np.exp(5 * np.abs(np.sin(np.arange(radius.size))))
        for method in ("integration", "table"):
            one = ashimpact.impacts(radius=radius, velocity=velocity, threads=1, method=method, **ASH)
            all_cores = ashimpact.impacts(radius=radius, velocity=velocity, method=method, **ASH)
            np.testing.assert_array_equal(one.restitution, all_cores.restitution)
            part = ashimpact.impacts(radius=radius[50_000:], velocity=velocity[50_000:], method=method, **ASH)
            np.testing.assert_array_equal(part.contact_time, one.contact_time[50_000:])
        self.assertIsNone(all_cores.maximum_overlap)

    def test_the_method_used_is_in_the_result(self):
        many = dict(radius=np.full(100_000, 22e-6), velocity=2.0, **{**ASH, "damping": 1e-5})
        asked_for_less = ashimpact.impacts(turning_point=False, **many)
        self.assertEqual(asked_for_less.method, "table")
        self.assertIsNone(asked_for_less.approach_time)
        table = ashimpact.impacts(method="table", **many)
        self.assertEqual(table.method, "table")
        np.testing.assert_array_equal(asked_for_less.restitution, table.restitution)
        few = ashimpact.impacts(turning_point=False, **dict(many, radius=22e-6))
        self.assertEqual(few.method, "integration")
        self.assertIsNone(few.maximum_overlap)
        everything = ashimpact.impacts(radius=22e-6, velocity=2.0, **ASH)
        self.assertEqual(everything.method, "integration")
        self.assertIsNotNone(everything.maximum_overlap)
        without = dict(ASH, damping_law="brach-dunn-damping", damping=0.2, adhesion_damping=0.1, radius=22e-6, velocity=2.0)
        self.assertEqual(ashimpact.impacts(**without).method, "integration")
        with self.assertRaisesRegex(ashimpact.InputError, "has no table; allowed: integration"):
            ashimpact.impacts(method="table", **without)

        for of_three_numbers in (dict(law="maugis-dugdale", tabor=1.0), dict(law="thornton-ning", yield_pressure=2e9)):
            with self.subTest(**of_three_numbers):
                impact = {**ASH, **of_three_numbers, "damping": 1e-5, "radius": 22e-6, "velocity": 2.0}
                self.assertEqual(ashimpact.impacts(turning_point=False, **impact).method, "integration")
                one, by_table = (
                    ashimpact.impacts(turning_point=False, method=method, **impact) for method in ("integration", "table")
                )
                self.assertEqual(by_table.method, "table")
                self.assertAlmostEqual(float(by_table.restitution), float(one.restitution), delta=1e-9)

    def test_dampings_come_back(self):
        radius = np.geomspace(5e-6, 50e-6, 20)
        contact = {key: value for key, value in ASH.items() if key != "damping"}
        found = ashimpact.dampings(radius=radius, velocity=5.0, restitution=0.5, **contact)
        reachable = ~np.isnan(found.damping)
        self.assertTrue(reachable.any())
        again = ashimpact.impacts(radius=radius[reachable], velocity=5.0, **dict(contact, damping=found.damping[reachable]))
        np.testing.assert_allclose(again.restitution, 0.5, rtol=1e-9)
        self.assertTrue((found.greatest_restitution[~reachable] < 0.5).all())

    def test_verdicts(self):
        hertz = dict(law="hertz", radius=22e-6, density=2160.0, contact_modulus=60e9)
        self.assertTrue(ashimpact.critical_velocities(**hertz).never_captured)
        tsuji = ashimpact.critical_velocities(damping=5.0, damping_law="tsuji", **hertz)
        self.assertTrue(tsuji.always_captured)
        self.assertTrue(np.isinf(tsuji.critical_velocity))

    def test_implausible_numbers_warn(self):
        for numbers, doubt in (
            (dict(radius=44.0), "radius: 44 m is outside of what is plausible, 5 nm to 2.5 mm"),
            (dict(radius=[22e-6, 22e-6], density=[2.3, 2300.0]), "density: 2.3 kg/m3"),
            (dict(radius=22e-6, damping=10.0), "above 500 m/s, outside the model"),
            (dict(radius=[22e-6, 44e-6], damping=1e-3), "damping: one coefficient for radii of 2.2e-05 m to 4.4e-05 m"),
            (dict(radius=44e-6, partner_radius=[3e-5, 3e-4], partner_density=2300.0, damping=1e-3), "one coefficient for radii of 1.78e-05"),
            (dict(law="maugis-dugdale", tabor=2.0, radius=[22e-6, 44e-6], damping=[1e-3, 2e-3]), "tabor: stays the same while radius varies"),
            (dict(radius=22e-6, density=None, mass=1.0), "mass: 1 kg is outside of what is plausible"),
            (dict(radius=22e-6, density=None, mass=[1e-10, 1e-6]), "mass: density of the sphere: 2.242e\\+07 kg/m3 is outside"),
        ):
            with self.subTest(doubt=doubt), self.assertWarnsRegex(UserWarning, doubt) as caught:
                ashimpact.critical_velocities(**{**ASH, **numbers})
            self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            ashimpact.impacts(radius=22e-6, velocity=2.0, **{**ASH, "work_of_adhesion": 0.0})
            own = {"damping": 0.0, "damping_law": "brach-dunn-damping", "adhesion_damping": 1.0}
            self.assertLess(ashimpact.impacts(radius=22e-6, velocity=2.0, **{**ASH, **own}).restitution, 0.999)
            ashimpact.impacts(radius=[22e-6, 44e-6], velocity=2.0, **{**ASH, "damping": [1e-3, 2e-3]})

    def test_errors_say_what_is_allowed(self):
        cases = (
            (dict(law="jrk"), "jkr"),
            (dict(detachment="zero-force"), "pull-off"),
            (dict(damping_law="linear"), "tsuji"),
            (dict(method="magic"), "table"),
            (dict(mass=1e-10), "one of the two"),
            (dict(velocity=np.ones(3), radius=np.ones(2)), "broadcast"),
            (dict(contact_modulus="60 GPa"), "SI"),
            (dict(velocity=np.array([1.0] * 50_000 + [-2.0])), "impact 50000: velocity is -2"),
            (dict(law=["jkr"]), "hertz, dmt"),
            (dict(law=None), "hertz, dmt"),
            (dict(law="jkr\0"), "hertz, dmt"),
            (dict(law="\udc80"), "hertz, dmt"),
            (dict(damping_law=["tsuji"]), "constant, contact-radius, tsuji, hunt-crossley"),
            (dict(detachment=["pull-off"]), "zero-overlap"),
            (dict(method=["table"]), "auto, integration, table"),
            (dict(threads=True), "threads is True"),
            (dict(threads=1.5), "threads is 1.5"),
            (dict(threads=-1), "threads is -1"),
            (dict(velocity=np.ma.array([1.0, 2.0], mask=[False, True])), "velocity has masked values"),
            (dict(velocity=np.ma.masked), "velocity has masked values"),
            (dict(velocity=np.array(["2026-01-01"], dtype="datetime64[D]")), "velocity holds datetime64"),
            (dict(velocity=np.array([3], dtype="timedelta64[s]")), "velocity holds timedelta64"),
            (dict(velocity=True), "velocity holds bool"),
            (dict(velocity=np.array([1.0 + 2.0j])), "velocity holds complex128"),
            (dict(velocity=["1", "2"]), "velocity holds str"),
            (dict(velocity=np.array([1.0, "2"], dtype=object)), "velocity holds str"),
            (dict(velocity=np.array([1.0, True], dtype=object)), "velocity holds bool"),
            (dict(velocity=np.array([1.0, None])), "velocity holds NoneType"),
            (dict(velocity=[1.0, np.nan]), "impact 1: velocity is nan"),
            (dict(radius=[1e-6, -2e-6]), "radius is -2e-06; allowed: > 0"),
            (dict(velocity=(each for each in (1.0, 2.0))), "velocity holds generator"),
            (dict(velocity={"value": 1.0}), "velocity holds dict"),
            (dict(velocity=[[1.0], [1.0, 2.0]]), "velocity holds list"),
            (dict(velocity=[True, 2.0]), "velocity holds bool"),
            (dict(velocity=10**400), "velocity is no number"),
            (dict(work_of_adhesion=None), "work_of_adhesion is missing"),
            (dict(law="thornton-ning"), "yield_pressure is missing"),
        )
        for change, expected in cases:
            with self.subTest(change=change), self.assertRaises(ValueError) as caught:
                ashimpact.impacts(**dict(ASH, radius=22e-6, velocity=1.0) | change)
            self.assertIsInstance(caught.exception, ashimpact.InputError)
            self.assertIn(expected, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaises(TypeError):
            ashimpact.impacts("jkr", 22e-6)  # keywords only

    def test_numbers_of_any_kind(self):
        import decimal
        import pandas

        expected = ashimpact.impacts(**dict(ASH, radius=22e-6, velocity=[1.0, 2.0])).restitution
        read_only = np.array([1.0, 2.0])
        read_only.flags.writeable = False
        series = pandas.Series([1.0, 2.0], index=[7, 3])
        for velocity in (
            (1, 2), np.array([2.0, 1.0])[::-1], np.array([1.0, 9.0, 2.0])[::2], np.array([1, 2], dtype=">f8"), np.array([1, 2], dtype="f2"),
            np.array([1, 2], dtype=np.longdouble), np.array([1, 2], dtype="u1"), read_only, series, series.astype(object),
            series.astype("Float64"), np.ma.array([1.0, 2.0]), [decimal.Decimal(1), np.array(2.0)], np.asfortranarray([[1.0, 2.0]])[0],
        ):
            with self.subTest(velocity=velocity):
                np.testing.assert_array_equal(ashimpact.impacts(**dict(ASH, radius=22e-6, velocity=velocity)).restitution, expected)
        with self.assertRaisesRegex(ashimpact.InputError, "radius and velocity have different indices"):
            ashimpact.impacts(**dict(ASH, radius=pandas.Series([1e-6, 2e-6]), velocity=series))

    def test_what_changes_nothing_is_warned_of(self):
        base = dict(radius=22e-6, density=2160.0, contact_modulus=60e9)
        for given, expected in (
            (dict(law="hertz", work_of_adhesion=0.3), "work_of_adhesion: hertz does not use it, so it changes nothing"),
            (dict(law="jkr", work_of_adhesion=0.3, yield_pressure=1e9), "yield_pressure: jkr never yields, so it changes nothing"),
            (dict(law="jkr", work_of_adhesion=0.3, tabor=2.0), "tabor: jkr does not use it, so it changes nothing"),
            (dict(law="hertz", damping_law="tsuji"), "damping_law: there is no damping, so it changes nothing"),
        ):
            with self.assertWarnsRegex(UserWarning, expected) as caught:
                ashimpact.critical_velocities(**base, **given)
            self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            ashimpact.critical_velocities(law="hertz", **base)


class LongCalls(unittest.TestCase):
    slow = dict(ASH, radius=np.geomspace(1e-6, 50e-6, 30_000_000), velocity=2.0)

    def test_other_threads_go_on(self):
        beats = []
        done = threading.Event()

        def beat():
            while not done.is_set():
                beats.append(time.monotonic())
                time.sleep(0.01)

        thread = threading.Thread(target=beat)
        thread.start()
        start = time.monotonic()
        ashimpact.impacts(**dict(self.slow, radius=self.slow["radius"][:1_000_000]), threads=1)
        elapsed = time.monotonic() - start
        done.set()
        thread.join()
        self.assertGreater(sum(beat > start for beat in beats), 5 * elapsed)

    def test_an_interrupt_is_heard(self):
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            ashimpact.impacts(**self.slow, threads=1)
        timer.cancel()


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            cls.artifacts = ashimpact.run()

    def test_a_run(self):
        self.assertIn("7-critical-velocity", self.artifacts)
        samples = self.artifacts["comparison"]["result"]["samples"]
        self.assertGreater(samples[0]["dynamic_critical_velocity"]["jkr"]["value"], 0.0)
        series = self.artifacts["4-restitution"]["result"]["samples"][0]["series"][0]
        velocity = ashimpact.columns(series)["velocity"]
        self.assertEqual(velocity.shape, (len(series["velocity"]["values"]),))

    def test_errors_of_the_program(self):
        with self.assertRaises(ashimpact.InputError) as caught:
            ashimpact.run("/nowhere/case.json")
        self.assertIn("/nowhere/case.json", str(caught.exception))
        with self.assertRaises(ashimpact.InputError):
            ashimpact.modulus("/nowhere/ash.csv")

    def test_a_long_warning_is_one(self):
        from ashimpact._program import _messages

        written = "warning: one that is so long that it\n  goes on in a second line\n  and a third\nwarning: another\n"
        self.assertEqual(
            _messages(written),
            ["warning: one that is so long that it goes on in a second line and a third", "warning: another"],
        )

    def test_contact_figure_and_export(self):
        import pathlib
        import tempfile

        ash = dict(diameter=88e-6, density=2300.0, contact_modulus=90e9, work_of_adhesion="0.3 J/m2")
        found = ashimpact.contact(**ash, soften=100.0)
        words = ["--diameter", "88 um", "--density", "2300", "--contact-modulus", "90 GPa", "--work-of-adhesion", "0.3"]
        self.assertEqual(found, json.loads(program("contact", *words, "--soften", "100", "--json")))
        with self.assertRaisesRegex(ashimpact.InputError, "--adhesion-rule"):
            ashimpact.contact(**{**ash, "work_of_adhesion": None, "surface_energy": 0.1})
        with tempfile.TemporaryDirectory() as folder:
            ashimpact.run(folder=folder + "/results")
            drawn = ashimpact.figure("restitution", folder + "/results", folder + "/e.svg", width="single")
            self.assertTrue(drawn.read_text(encoding="utf-8").startswith(("<?xml", "<svg")))
            field = ashimpact.figure("critical-velocity-by-size", folder + "/results/comparison.json", folder + "/field.svg")
            self.assertIn("arffman2015", field.read_text(encoding="utf-8"))
            made = ashimpact.export("table", folder + "/results", folder=folder + "/table", sample="88 um")
            self.assertTrue((pathlib.Path(made) / "expected.json").is_file())
            with self.assertRaisesRegex(ashimpact.InputError, "allowed"):
                ashimpact.export("ansys", folder + "/results", folder=folder + "/other")
            tube = dict(tube_diameter=0.038, gas_velocity=12.0, gas_temperature="900 C", ash_load="10 g/m3")
            stays = ashimpact.deposit(folder + "/results", sizes="rosin-rammler: 20 um, 1.2", **tube)["result"]["total"]
            self.assertGreater(stays["deposition_flux"]["value"], 0)
            one = ashimpact.deposit(folder + "/results", sizes=96e-6, folder=folder + "/tube", **tube)["result"]
            self.assertEqual(one["total"]["supported_fraction"]["value"], 1)
            self.assertTrue((pathlib.Path(folder) / "tube" / "deposit.html").is_file())
            with self.assertRaisesRegex(ashimpact.InputError, "sizes"):
                ashimpact.deposit(folder + "/results", sizes="coarse", **tube)

    def test_modulus_of_a_file(self, ):
        import tempfile

        with tempfile.TemporaryDirectory() as folder:
            program("init", folder + "/case")
            found = ashimpact.modulus(folder + "/case/ash.csv", amorphous_fraction=0.42)
            shown = json.loads(program("modulus", folder + "/case/ash.csv", "--amorphous-fraction", "0.42", "--json"))
            self.assertEqual(found, shown)
            with open(folder + "/grouped.csv", "w", encoding="utf-8") as file:
                file.write("phase;ppm\nQuartz;401,250\nMullite;598,750\n")
            with self.assertRaisesRegex(ashimpact.InputError, "401.250 or 401250"):
                ashimpact.modulus(folder + "/grouped.csv", amorphous_fraction="none")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                read = ashimpact.modulus(folder + "/grouped.csv", amorphous_fraction="none", decimal="point")
            self.assertAlmostEqual(read["phases"][0]["weight_fraction"], 0.40125)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                analysed = ashimpact.analyse_impacts(
                    folder + "/case/impacts.csv", law="dmt", radius=44e-6, density=2600.0, contact_modulus=90e9,
                    work_of_adhesion=0.3,
                )
                self.assertGreater(analysed["impacts"], 0)
                import pandas

                table = pandas.read_csv(folder + "/case/impacts.csv", comment="#", sep=None, engine="python")
                again = ashimpact.analyse_impacts(
                    table, law="dmt", radius=44e-6, density=2600.0, contact_modulus=90e9, work_of_adhesion=0.3
                )
            self.assertEqual(analysed["impacts"], again["impacts"])
            self.assertEqual(analysed["extrapolated"], again["extrapolated"])

    def test_a_composition_may_be_a_pandas_table(self):
        import pandas

        table = pandas.DataFrame({"Phase": ["Quartz", "Mullite"], "FA1 [wt%]": [40.125, 59.875], "esd": [0.5, np.nan]})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            read = ashimpact.modulus(table, amorphous_fraction="none")
        self.assertAlmostEqual(read["phases"][0]["weight_fraction"], 0.40125)
        with self.assertRaisesRegex(ashimpact.InputError, "^row 0, cell 2"):
            ashimpact.modulus(pandas.DataFrame({"Phase": ["Quartz"], "wt%": ["x"]}))
        with self.assertRaisesRegex(ashimpact.InputError, "file is a list; allowed: a file name, a pandas table$"):
            ashimpact.modulus([1.0])
        with self.assertLogs("ashimpact", "INFO") as logged, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ashimpact.modulus(table, amorphous_fraction="none")
        self.assertTrue(logged.output[0].startswith("INFO:ashimpact:read as 1 sample; phases:"), logged.output)

    def test_options_are_what_they_are_meant_to_be(self):
        import pandas

        columns = dict(velocity=[1.0, 2.0, 3.0], restitution=[0.0, 0.2, 0.3])
        contact = dict(law="dmt", radius=44e-6, density=2600.0, contact_modulus=90e9, work_of_adhesion=0.3)
        table = pandas.DataFrame({"v_in [m/s]": [1.0, 2.0], "e_n": [False, True]})
        for given, expected in (
            (dict(columns, impacts="impacts.csv"), "impacts, velocity, restitution: both are given"),
            (dict(columns, impacts=table), "impacts, velocity, restitution: both are given"),
            (dict(columns, rebound_velocity=[0.0, 0.4, 0.9]), "velocity, rebound_velocity, restitution is given"),
            (dict(velocity=[1.0]), "velocity is given"),
            (dict(), "nothing is given"),
            (dict(impacts=table), '"False" in column "e_n" is not a number'),
            (dict(columns, velocity=np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0])), "velocity has masked values"),
            (dict(columns, velocity=[1.0, 2.0]), "shapes do not fit"),
            (dict(columns, captured=[1, 0, 0]), "captured is 3 of int64; allowed: 3 truth values, one an impact"),
            (dict(columns, captured=[True]), "captured is 1 of bool; allowed: 3 truth values, one an impact"),
            (dict(columns, captured=np.ma.array([True, False, False], mask=[0, 1, 0])), "captured has masked values"),
            (
                dict(velocity=pandas.Series([1.0, 2.0]), restitution=[0.1, 0.2], captured=pandas.Series([True, False], index=[1, 0])),
                "velocity and captured have different indices",
            ),
            (dict(columns, impacts=table, captured=[True]), "impacts, velocity, restitution, captured: both are given"),
            (dict(columns, order=True), "order holds bool; allowed: numbers"),
            (dict(columns, order=2.5), "--order"),
            (dict(columns, robust=2), "robust is 2; allowed: True or False"),
            (dict(columns, frame_rate=False), "frame_rate holds bool"),
            (dict(columns, tabor=True), "tabor holds bool"),
            (dict(columns, radius=np.datetime64("2020")), "radius holds datetime64"),
            (dict(columns, radius=np.ma.masked), "radius has masked values"),
            (dict(columns, law=True), "law is True; allowed: a text"),
            (dict(columns, law=["dmt"]), "hertz, dmt"),
            (dict(columns, decimal="comma"), "decimal is given with numbers"),
            (dict(columns, sheet=""), "--sheet: is empty"),
            (dict(columns, sheet="--json"), "a sheet is named"),
        ):
            with self.subTest(given=given), self.assertRaises(ashimpact.InputError) as caught:
                ashimpact.analyse_impacts(**contact | given)
            self.assertIn(expected, str(caught.exception))
            self.assertNotIn("tmp", str(caught.exception))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            read = ashimpact.analyse_impacts(
                velocity=[1.0, 2.0, 3.0, 0.4, 0.5], restitution=[0.1, 0.2, 0.3, np.nan, 0.02],
                captured=np.array([False, False, False, True, True]), **contact
            )
        self.assertEqual((read["impacts"], read["captures"]), (5, 2))
        self.assertEqual(list(ashimpact.columns(read["inversion"])["captured_at"]), [0.4, 0.5])
        for call, expected in (
            (lambda: ashimpact.modulus("ash.csv", porosity=True), "porosity holds bool"),
            (lambda: ashimpact.run(allow_outside=1), "allow_outside is 1"),
            (lambda: ashimpact.calibrate(compare="yes"), "compare is 'yes'"),
            (lambda: ashimpact.sweep({}, threads=True), "threads holds bool"),
        ):
            with self.assertRaisesRegex(ashimpact.InputError, expected):
                call()

    def test_a_sweep_from_a_dict(self):
        spec = {
            "impact": {
                "laws": ["dmt"],
                "density": 2600.0,
                "contact_modulus": 90e9,
                "work_of_adhesion": 0.3,
                "damping": 0.0001,
            },
            "variables": {
                "velocity": {"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"},
                "radius": {"distribution": "log-normal", "median": "44 um", "geometric_standard_deviation": 1.5},
            },
            "sampling": {"method": "quasi-random", "samples": 1024, "seed": 1},
        }
        result = ashimpact.sweep(spec)
        self.assertIn("result", result)

    def test_literature(self):
        silver = {"law": "jkr", "density": 10490.0, "contact_modulus": 43.2e9}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            (source,) = ashimpact.literature("arffman2015", work_of_adhesion=0.1, **silver)["sources"]
            found = ashimpact.calibrate(sizes="arffman2015", uncertainty=0.1, free="work_of_adhesion", **silver)
        self.assertEqual(source["velocities"][0]["critical_velocity"]["upper"]["value"], 14)
        self.assertAlmostEqual(source["velocities"][0]["by_law"]["exponent"], -5 / 6, 5)
        self.assertIs(found["fits"], False)

    def test_calibrate(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = ashimpact.calibrate(free="work_of_adhesion")
        self.assertIsInstance(found, dict)

    def test_tables(self):
        import pandas

        node = self.artifacts["5-damping"]["result"]["samples"][0]["dmt"]
        table = ashimpact.to_pandas(node)
        self.assertIsInstance(table, pandas.DataFrame)
        self.assertIn("damping [kg/s]", table.columns)
        sizes = self.artifacts["comparison"]["result"]["by_size"]
        by_size = ashimpact.to_pandas(sizes)
        self.assertEqual(len(by_size), len(sizes))
        self.assertIn("critical_velocity [m/s]", by_size.columns)
        self.assertEqual(by_size["diameter [m]"][0], sizes[0]["diameter"]["value"])
        frame = ashimpact.impacts(radius=[1e-6, 2e-6], velocity=1.0, **ASH).to_pandas()
        self.assertEqual(len(frame), 2)

    def test_figures(self):
        import matplotlib

        matplotlib.use("Agg")
        from ashimpact import plot
        from matplotlib import pyplot

        names = ("composition", "restitution", "damping", "damping_fit", "contact_time", "critical_velocity",
                 "histories", "energy")
        for name in names:
            axes = getattr(plot, name)(self.artifacts)
            drawn = len(axes.lines) + len(axes.patches) + len(axes.containers)
            self.assertGreater(drawn, 0, name)
            self.assertIn("[", axes.get_ylabel(), name)
            axes.figure.canvas.draw()
        contact = dict(ASH)
        self.assertEqual(len(plot.sizes(radius=np.geomspace(1e-6, 50e-6, 50), **contact).lines), 1)
        axes = plot.restitution_curve(velocity=np.geomspace(0.01, 20, 50), radius=5e-6, **contact)
        self.assertEqual(len(axes.lines), 2)
        with self.assertRaises(ashimpact.InputError):
            plot.restitution(self.artifacts, sample="none")
        pyplot.close("all")


if __name__ == "__main__":
    unittest.main()
