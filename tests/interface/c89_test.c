/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The C interface as a C program uses it; compiled as C89 with every warning an error. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ashimpact.h>

static int failures = 0;

static void expect(int holds, const char *what) {
    if (!holds) {
        printf("failed: %s\n", what);
        ++failures;
    }
}

static const ashimpact_parameter ash[] = {
    {"density", 2160.0}, {"contact_modulus", 60e9}, {"work_of_adhesion", 0.3}, {"damping", 1e-5}};

static void test_one_by_one(const ashimpact_model *model) {
    ashimpact_error error;
    double critical = -1.0, below = -1.0, above = -1.0;
    expect(ashimpact_critical_velocity(model, 44e-6, &critical, &error) == ASHIMPACT_OK, "a critical velocity");
    expect(critical > 1e-3 && critical < 10.0, "a critical velocity as fly ash has them");
    expect(ashimpact_restitution(model, 44e-6, 0.999 * critical, &below, &error) == ASHIMPACT_OK, error.message);
    expect(ashimpact_restitution(model, 44e-6, 1.001 * critical, &above, NULL) == ASHIMPACT_OK, "no error struct");
    expect(below == 0.0, "captured below the critical velocity");
    expect(above > 0.0 && above < 1.0, "rebounding above the critical velocity");
}

static void test_batches(const ashimpact_model *model) {
    enum { count = 5000 };
    static double diameter[count], velocity[count], batch[count], time[count], critical[count];
    ashimpact_column columns[3];
    ashimpact_output outputs[2];
    double alone, density = 2160.0;
    int i;
    for (i = 0; i < count; ++i) {
        diameter[i] = 1e-6 + 20e-9 * i;
        velocity[i] = 0.01 + 1e-3 * i;
    }
    expect(ashimpact_restitutions(model, count, diameter, velocity, batch, NULL) == ASHIMPACT_OK, "a batch");
    expect(ashimpact_critical_velocities(model, count, diameter, critical, NULL) == ASHIMPACT_OK, "a batch of v_c");
    for (i = 0; i < count; i += 7) {
        ashimpact_restitution(model, diameter[i], velocity[i], &alone, NULL);
        expect(alone == batch[i], "a batch gives the bits of single impacts");
        expect((batch[i] == 0.0) == (velocity[i] < critical[i]), "captured if and only if below v_c");
    }
    columns[0].name = "diameter";
    columns[0].values = diameter;
    columns[0].stride = 1;
    columns[1].name = "velocity";
    columns[1].values = velocity;
    columns[1].stride = 1;
    columns[2].name = "density";
    columns[2].values = &density;
    columns[2].stride = 0;
    outputs[0].name = "restitution";
    outputs[0].values = critical;
    outputs[1].name = "contact_time";
    outputs[1].values = time;
    expect(ashimpact_solve_impacts(model, count, columns, 3, outputs, 2, NULL) == ASHIMPACT_OK, "columns");
    expect(memcmp(critical, batch, sizeof batch) == 0, "columns give the same bits");
    for (i = 0; i < count; ++i) expect((batch[i] == 0.0) == (time[i] != time[i]), "a capture has no contact time");
}

static void test_errors(const ashimpact_model *model) {
    ashimpact_error error;
    ashimpact_model *none;
    double e = 7.0;
    expect(ashimpact_open("jrk", NULL, NULL, ash, 4, &none, &error) == ASHIMPACT_INPUT_ERROR, "an unknown law");
    expect(none == NULL && strstr(error.message, "jkr") != NULL, "the message lists the laws");
    expect(ashimpact_restitution(model, -1.0, 2.0, &e, &error) == ASHIMPACT_INPUT_ERROR, "a negative diameter");
    expect(e == 7.0 && error.message[0] != '\0' && strchr(error.message, '\n') == NULL, "one line, nothing written");
    expect(ashimpact_restitution(NULL, 1e-6, 2.0, &e, &error) == ASHIMPACT_INPUT_ERROR, "no model");
    expect(ashimpact_restitution(model, 1e-6, 2.0, NULL, &error) == ASHIMPACT_INPUT_ERROR, "no place for results");
    ashimpact_close(NULL);
}

int main(void) {
    ashimpact_model *model;
    ashimpact_error error;
    expect(strlen(ashimpact_version()) >= 5, "a version");
    expect(ashimpact_open("jkr", NULL, NULL, ash, 4, &model, &error) == ASHIMPACT_OK, error.message);
    if (model == NULL) return 1;
    test_one_by_one(model);
    test_batches(model);
    test_errors(model);
    ashimpact_close(model);
    printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
