/* Stand-in for Fluent's udf.h: as much of it as ash_wall.c uses, to compile and exercise it without Fluent.
 * Not Ansys's header, and not to be used with Fluent. */
#ifndef UDF_H
#define UDF_H

#include <stdio.h>

typedef double real;
typedef int face_t;
typedef struct { int unused; } Thread;
typedef struct { real velocity[3], velocity_before[3], diameter, density; } Tracked_Particle;

enum { PATH_ABORT = -1, PATH_END = 0, PATH_ACTIVE = 1 };

#define TP_VEL(tp) ((tp)->velocity)
#define TP_VEL0(tp) ((tp)->velocity_before)
#define TP_DIAM(tp) ((tp)->diameter)
#define TP_RHO(tp) ((tp)->density)
#define Message printf
#define DEFINE_DPM_BC(name, tp, t, f, f_normal, dim) \
    int name(Tracked_Particle* tp, Thread* t, face_t f, real f_normal[], int dim)

#endif
