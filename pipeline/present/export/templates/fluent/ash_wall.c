/* Wall boundary of ash particles in Ansys Fluent: hook `ash_wall` as the DPM boundary function of a wall.
 * Below the critical velocity of its size a particle stays on the wall, above it rebounds with the restitution of its
 * size and normal velocity, both from the table of ash_table_data.h. The wall is at rest. Particles of another density
 * than that of the table are reported once in each process.
 * Compiled and exercised against a stand-in for udf.h; not run in Fluent. */
#include "udf.h"

#include "ash_table.h"
#include "ash_table_data.h"

/* The coefficient of Coulomb friction is that of the export, ash_friction_coefficient in ash_table_data.h. The spin
 * before an impact is taken as none, that after it is not kept. */

/* The table holds for ash of these densities: a particle of another has another mass, and so another critical velocity. */
static void ash_compare_density(double density)
{
    static int warned = 0;
    if (warned || (density <= 1.01 * ash_greatest_density && density >= 0.99 * ash_least_density)) return;
    warned = 1;
    Message("ash_wall: warning: a particle of %g kg/m3 hit a wall; v_c and e are those of ash of %g to %g kg/m3: give the "
            "material of the injection that density, or export for the density of the injection\n",
            density, ash_least_density, ash_greatest_density);
}

DEFINE_DPM_BC(ash_wall, tp, t, f, f_normal, dim)
{
    double normal_velocity = 0.0, restitution = 0.0, push = 0.0, slip = 0.0, kept = 1.0;
    int i;

    for (i = 0; i < dim; ++i) normal_velocity += TP_VEL(tp)[i] * f_normal[i];
    if (normal_velocity <= 0.0) return PATH_ACTIVE; /* it flies away already */
    ash_compare_density(TP_RHO(tp));

    switch (ash_rebound(&ash_table, TP_DIAM(tp), normal_velocity, &restitution, &push)) {
        case ash_found:
            break;
        case ash_diameter_outside:
            Message("ash_wall: diameter %g m; the table holds %g to %g m: export one with --from-diameter and --to-diameter\n",
                    TP_DIAM(tp), ash_table.diameter[0], ash_table.diameter[ash_table.sizes - 1]);
            return PATH_ABORT;
        case ash_velocity_outside:
            Message("ash_wall: velocity %g m/s; the table holds %g to %g m/s: export one with --to-velocity\n",
                    normal_velocity, ash_table.from_velocity, ash_table.to_velocity);
            return PATH_ABORT;
    }
    if (restitution <= 0.0) return PATH_END; /* stays on the wall */

    for (i = 0; i < dim; ++i) {
        const double tangential = TP_VEL(tp)[i] - normal_velocity * f_normal[i];
        slip += tangential * tangential;
    }
    slip = sqrt(slip);
    if (slip > 0.0) kept = 1.0 - ash_friction(ash_friction_coefficient, push, slip) / slip;
    for (i = 0; i < dim; ++i) {
        const double normal = normal_velocity * f_normal[i];
        const double tangential = TP_VEL(tp)[i] - normal;
        TP_VEL(tp)[i] = kept * tangential - restitution * normal;
        TP_VEL0(tp)[i] = TP_VEL(tp)[i];
    }
    return PATH_ACTIVE;
}
