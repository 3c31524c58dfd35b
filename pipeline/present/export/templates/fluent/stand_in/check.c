/* Sends particles at ash_wall: reads "diameter velocity tangential_velocity density" a line, writes "diameter velocity
 * restitution tangential_velocity", with a restitution of -1 for a particle that the function gave up. The wall stands
 * aslant. */
#include "udf.h"

int ash_wall(Tracked_Particle* tp, Thread* t, face_t f, real f_normal[], int dim);

int main(void)
{
    real normal[3] = {0.6, 0.0, 0.8}, along[3] = {0.8, 0.0, -0.6};
    double diameter, velocity, sideways, density;
    while (scanf("%lf %lf %lf %lf", &diameter, &velocity, &sideways, &density) == 4) {
        Tracked_Particle particle;
        Thread thread = {0};
        double away = 0.0, slid = 0.0, e;
        int i, fate;
        particle.diameter = diameter;
        particle.density = density;
        for (i = 0; i < 3; ++i)
            particle.velocity[i] = particle.velocity_before[i] = velocity * normal[i] + sideways * along[i];
        fate = ash_wall(&particle, &thread, 0, normal, 3);
        for (i = 0; i < 3; ++i) {
            away -= particle.velocity_before[i] * normal[i];
            slid += particle.velocity_before[i] * along[i];
        }
        e = fate == PATH_END ? 0.0 : away / velocity;
        printf("%.17g %.17g %.17g %.17g\n", diameter, velocity, fate == PATH_ABORT ? -1.0 : e, slid);
    }
    return 0;
}
