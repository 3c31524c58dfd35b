/* Restitution of ash by diameter and normal velocity, from a table of ashimpact. C99 and C++, SI units.
 *
 * ln v_0 comes from the cubic in ln d with the values and slopes of the two diameters around d; v_0 is the critical
 * velocity, or where nothing is captured the smallest velocity. Then e is linear in ln d and in
 * t = asinh(sqrt(v/v_0 - 1)). So the critical velocity is exact and |de| <= 2e-4. */
#ifndef ASH_TABLE_H
#define ASH_TABLE_H

#include <math.h>

typedef struct {
    int sizes;                    /* diameters */
    int nodes;                    /* values of t for each */
    const double* diameter;       /* rising [m] */
    const double* start_velocity; /* v_0 [m/s] */
    const double* slope;          /* d ln v_0 / d ln d */
    const double* restitution;    /* nodes of the first diameter, of the second, ... */
    const double* attraction;     /* at the same nodes: time integral of the attraction over m v; null: there is none */
    double step;                  /* of t */
    double from_velocity;         /* [m/s] */
    double to_velocity;           /* [m/s] */
    int captures;                 /* whether v_0 is a critical velocity */
} AshTable;

typedef enum { ash_found, ash_diameter_outside, ash_velocity_outside } AshStatus;

/* Number of the interval of diameters that holds d; the place in it, 0 to 1; its width in ln d. */
static int ash_interval(const AshTable* table, double diameter, double* place, double* width)
{
    int low = 0, high = table->sizes - 1;
    *place = 0.0;
    *width = 1.0;
    if (high == 0) return 0;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (table->diameter[middle] <= diameter) low = middle;
        else high = middle;
    }
    *width = log(table->diameter[low + 1] / table->diameter[low]);
    *place = log(diameter / table->diameter[low]) / *width;
    return low;
}

/* v_0 of a diameter within the table [m/s]. */
static double ash_start_velocity(const AshTable* table, double diameter)
{
    double s, width;
    const int i = ash_interval(table, diameter, &s, &width);
    const int j = table->sizes == 1 ? i : i + 1;
    return exp((1 + 2 * s) * (1 - s) * (1 - s) * log(table->start_velocity[i])
               + s * s * (3 - 2 * s) * log(table->start_velocity[j])
               + s * (1 - s) * width * ((1 - s) * table->slope[i] - s * table->slope[j]));
}

static double ash_along_t(const AshTable* table, const double* values, int size, double place)
{
    const double* row = values + (long)size * table->nodes;
    int j = (int)place;
    if (j > table->nodes - 2) j = table->nodes - 2;
    return row[j] + (place - j) * (row[j + 1] - row[j]);
}

/* e of an impact, 0 for a capture, and the impulse over the mass with which the surfaces push [m/s], on which friction
 * acts: (1 + e) v, more with adhesion. Diameters and velocities within 1e-9 of the
 * ends count as within. */
static AshStatus ash_rebound(const AshTable* table, double diameter, double velocity, double* restitution, double* push)
{
    const double smallest = table->diameter[0], largest = table->diameter[table->sizes - 1];
    double start, place, s, width, attraction = 0.0;
    int i;
    *restitution = *push = 0.0;
    if (!(diameter >= smallest * (1 - 1e-9) && diameter <= largest * (1 + 1e-9))) return ash_diameter_outside;
    if (!(velocity >= table->from_velocity * (1 - 1e-9) && velocity <= table->to_velocity * (1 + 1e-9)))
        return ash_velocity_outside;
    if (diameter < smallest) diameter = smallest;
    if (diameter > largest) diameter = largest;
    start = ash_start_velocity(table, diameter);
    if (table->captures && velocity < start) return ash_found;
    place = velocity > start ? asinh(sqrt(velocity / start - 1)) / table->step : 0.0;
    i = ash_interval(table, diameter, &s, &width);
    *restitution = ash_along_t(table, table->restitution, i, place);
    if (table->sizes > 1) *restitution += s * (ash_along_t(table, table->restitution, i + 1, place) - *restitution);
    if (table->attraction) {
        attraction = ash_along_t(table, table->attraction, i, place);
        if (table->sizes > 1) attraction += s * (ash_along_t(table, table->attraction, i + 1, place) - attraction);
    }
    *push = (1 + *restitution + attraction) * velocity;
    return ash_found;
}

/* Impulse of Coulomb friction over the mass of a rigid solid sphere [m/s]: the sphere slides throughout, or the slip of
 * its surface ends and it rolls. Against the slip; the spin changes by 5/2 of it over the radius. */
static double ash_friction(double friction, double push, double slip)
{
    const double rolls = 2.0 / 7.0 * slip;
    return friction * push < rolls ? friction * push : rolls;
}

#endif
