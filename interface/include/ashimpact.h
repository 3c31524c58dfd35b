/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Impacts of fly-ash particles on a wall, as a C library. Plain C89; usable from C++, Fortran and CFD codes.
 *
 * A model is a contact law with the constants of a particle and a wall. It gives the coefficient of
 * restitution e_n of an impact and the critical velocity v_c below which a particle stays on the wall:
 *
 *     const ashimpact_parameter ash[] = {{"density", 2160.0}, {"contact_modulus", 60e9},
 *                                        {"work_of_adhesion", 0.3}, {"damping", 1e-5}};
 *     ashimpact_model *model;
 *     ashimpact_error error;
 *     double e;
 *     if (ashimpact_open("jkr", NULL, NULL, ash, 4, &model, &error) != ASHIMPACT_OK) puts(error.message);
 *     if (ashimpact_restitution(model, 44e-6, 2.0, &e, &error) != ASHIMPACT_OK) puts(error.message);
 *     ashimpact_close(model);
 *
 * Units: SI throughout; each number names its unit. Numbers that no ash has are computed with, without the
 * warning that the program gives (docs/case.md has the ranges). Errors: every function returns a status and
 * never throws or ends the program; if it is not ASHIMPACT_OK, only the error has a meaning. Threads: a model
 * is immutable, so any number of threads may use it at once; only ashimpact_close() needs it to be idle.
 * Floating point: no function raises a trap or leaves a flag, a rounding mode or a mask behind, and none
 * depends on those of the caller. Source of the model: Dong et al. 2013; docs/laws names that of each law. */
#ifndef ASHIMPACT_H
#define ASHIMPACT_H

#include <stddef.h>

#if defined(__GNUC__)
#define ASHIMPACT_API __attribute__((visibility("default")))
#else
#define ASHIMPACT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What became of a call; the numbers are the exit statuses of the program ashimpact. */
typedef enum {
    ASHIMPACT_OK = 0,
    ASHIMPACT_DEFECT = 1,       /* a defect of this library, or no memory left */
    ASHIMPACT_INPUT_ERROR = 2,  /* a number or a name that is not admissible */
    ASHIMPACT_NOT_CONVERGED = 3 /* a computation did not converge */
} ashimpact_status;

/* Where a function writes what went wrong: one line, with what is allowed. NULL is allowed in its place.
 * After ASHIMPACT_OK it is empty, or names parameters and columns that change nothing with the law. */
typedef struct {
    char message[512];
} ashimpact_error;

/* A constant of a model by its name:
 *   density            of the particle [kg/m3]; needed by every function that takes a diameter
 *   contact_modulus    E*, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 of particle and wall [Pa]; required
 *   work_of_adhesion   w, energy to separate unit area, not a surface energy [J/m2]; needed with adhesion, 0 for none
 *   damping            coefficient of the damping law [unit of that law]; 0 unless given
 *   yield_pressure     p_y, needed by laws that yield (thornton-ning) [Pa]
 *   ...                a law's own parameters; `ashimpact impact --help` lists them, with hyphens [SI]
 *   friction, tangential_velocity, spin   of impacts at an angle, in ashimpact_solve_impacts()
 *   effective_radius, mass   R* [m] and m* [kg] instead of diameter and density, in functions that take
 *                      columns: for two spheres, or a particle that is no sphere */
typedef struct {
    const char* name;
    double value;
} ashimpact_parameter;

/* Numbers that change from one impact to the next: value i is values[i * stride], so that a stride of 0 means
 * one number for all. Names are those of the parameters, and diameter [m], velocity [m/s] (of approach, > 0)
 * and restitution [1], each once. A column replaces the model's parameter of that name. */
typedef struct {
    const char* name;
    const double* values;
    size_t stride;
} ashimpact_column;

/* An array for a result, by its name, each once; the function that fills it lists those it knows. */
typedef struct {
    const char* name;
    double* values;
} ashimpact_output;

/* A contact law with its constants. */
typedef struct ashimpact_model ashimpact_model;

/* The version of the library that is loaded, such as "1.0.0". */
ASHIMPACT_API const char* ashimpact_version(void);

/* Makes a model.
 *   law          hertz, dmt, brach-dunn, jkr, ...; `ashimpact impact --help` lists them
 *   detachment   where contact ends: zero-overlap, zero-force, pull-off, load-controlled; NULL: the law's own
 *   damping_law  constant [kg/s], contact-radius [Pa s], tsuji [1], hunt-crossley [s/m],
 *                brach-dunn-damping [s/m]; NULL: constant
 *   parameters   count of them, each name once
 *   model        receives the model; NULL on an error. Give it back with ashimpact_close().
 * The first call of a kind takes up to some milliseconds, for tables that all models then share. */
ASHIMPACT_API ashimpact_status ashimpact_open(const char* law, const char* detachment,
                                              const char* damping_law, const ashimpact_parameter* parameters,
                                              size_t count, ashimpact_model** model, ashimpact_error* error);

/* How the model's restitutions and contact times are found: "table", from a table of the law's impacts, or
 * "integration", each impact by itself, which takes some hundred times as long. The errors are the same.
 * Approach times and greatest overlaps always are integrated. NULL for no model. */
ASHIMPACT_API const char* ashimpact_method(const ashimpact_model* model);

ASHIMPACT_API void ashimpact_close(ashimpact_model* model); /* gives a model back; NULL is allowed */

/* Restitution e_n(d, v) of a sphere on a flat wall; 0 for a capture [1].
 *   diameter [m], velocity of approach, normal to the wall, > 0 [m/s]
 * Error: |d(e^2)| <= 1e-12 (1 + |U_min|/(m v^2/2)), U_min the depth of the adhesive well. */
ASHIMPACT_API ashimpact_status ashimpact_restitution(const ashimpact_model* model, double diameter,
                                                     double velocity, double* restitution,
                                                     ashimpact_error* error);

/* The same for count spheres: arrays of that length. Nothing depends on how impacts are spread over calls. */
ASHIMPACT_API ashimpact_status ashimpact_restitutions(const ashimpact_model* model, size_t count,
                                                      const double* diameter, const double* velocity,
                                                      double* restitution, ashimpact_error* error);

/* Critical velocity v_c(d) of a sphere on a flat wall: it is captured below v_c and rebounds above [m/s].
 * 0 where it always rebounds, HUGE_VAL where it is always captured. Relative error 1e-10. */
ASHIMPACT_API ashimpact_status ashimpact_critical_velocity(const ashimpact_model* model, double diameter,
                                                           double* critical_velocity, ashimpact_error* error);

/* The same for count spheres: arrays of that length. */
ASHIMPACT_API ashimpact_status ashimpact_critical_velocities(const ashimpact_model* model, size_t count,
                                                             const double* diameter,
                                                             double* critical_velocity,
                                                             ashimpact_error* error);

/* Many impacts; any parameter may be a column, velocity must be one. Outputs, all of length count:
 *   restitution        e_n = v_r/v_in; 0 for a capture [1]
 *   contact_time       first touch to detachment; NaN for a capture [s]
 *   approach_time      first touch to greatest overlap; NaN if that is never reached [s]
 *   maximum_overlap    greatest overlap, or its limit if that is never reached [m]
 * The last two take some ten times as long as the others. With friction (mu, 1) and tangential_velocity
 * [m/s], spin [rad/s], or both, as parameters or columns, also those of a rigid sphere that slides or rolls:
 *   tangential_restitution      e_t = v_t'/v_t; 0 for a capture, NaN without v_t [1]
 *   rebound_tangential_velocity, rebound_spin   v_t' [m/s] and spin [rad/s]; NaN for a capture
 *   rebound_angle               from the normal, negative where v_t' has turned; NaN for a capture [rad]
 *   impulse_ratio               friction over normal impulse; NaN for a capture [1]
 *   regime                      0 sliding, 1 rolling, 2 none, 3 captured
 * Spin is positive where it adds to the slip of v_t > 0. With effective_radius and mass of two spheres,
 * sphere_radius and sphere_mass are those of the one that spins. */
ASHIMPACT_API ashimpact_status ashimpact_solve_impacts(const ashimpact_model* model, size_t count,
                                                       const ashimpact_column* columns, size_t column_count,
                                                       const ashimpact_output* outputs, size_t output_count,
                                                       ashimpact_error* error);

/* Many critical velocities; any parameter may be a column, velocity not. Output:
 *   critical_velocity  v_c; 0 where it always rebounds, HUGE_VAL where it is always captured [m/s] */
ASHIMPACT_API ashimpact_status ashimpact_solve_critical_velocities(
    const ashimpact_model* model, size_t count, const ashimpact_column* columns, size_t column_count,
    const ashimpact_output* outputs, size_t output_count, ashimpact_error* error);

/* Dampings that give measured restitutions back; velocity and restitution must be columns. Outputs:
 *   damping               coefficient [unit of the damping law]; for restitution 0 the smallest that
 *                         captures; NaN for a restitution above greatest_restitution
 *   greatest_restitution  restitution without damping [1] */
ASHIMPACT_API ashimpact_status ashimpact_solve_dampings(const ashimpact_model* model, size_t count,
                                                        const ashimpact_column* columns, size_t column_count,
                                                        const ashimpact_output* outputs, size_t output_count,
                                                        ashimpact_error* error);

#ifdef __cplusplus
}
#endif

#endif
