# Impacts of ash on a wall in YADE; rows for compare.py go to log.impacts.
#   yade -n -x impacts.py          (or sh run.sh, which compares too)
# YADE's wall counts as a mirror sphere: R* = R/2. Young's modulus 2 sqrt(2) E* with nu = 0 makes up for it, so that the
# repulsion is (4/3) E* sqrt(R) overlap^(3/2).
import json
import math

CONTACT_MODULUS, DENSITY, WORK_OF_ADHESION = @contact_modulus@, @density@, @work_of_adhesion@
LAW, DAMPING_LAW = "@law@", "@damping_law@"
COHESION_ENERGY_DENSITY = @cohesion_energy_density@    # of law sjkr
COEFFICIENT, REFERENCE_DIAMETER, EXPONENT = @coefficient@, @diameter@, @exponent@
DAMPING_RATIO = @damping_ratio@    # YADE's own `betan`; None: the damping is that of ash_force()
RESOLUTIONS = (2000, 3000, 4500, 6750, 10000)    # steps a contact


def attraction(radius, overlap):
    """[N], negative"""
    if LAW == "dmt":
        return -2 * math.pi * WORK_OF_ADHESION * radius
    if LAW == "brach-dunn":
        tension = (6 * WORK_OF_ADHESION ** 2 * radius * CONTACT_MODULUS / math.pi) ** (1 / 3)
        return -2 * math.pi * tension * math.sqrt(radius * overlap)
    if LAW == "sjkr":
        return -math.pi * COHESION_ENERGY_DENSITY * radius * overlap
    return 0.0


def damping(radius, overlap, mass):
    """eta [kg/s]"""
    eta = COEFFICIENT * (2 * radius / REFERENCE_DIAMETER) ** EXPONENT
    if DAMPING_LAW == "contact-radius":
        return eta * math.sqrt(radius * overlap)
    if DAMPING_LAW == "tsuji":
        return eta * math.sqrt(mass * 4 / 3 * CONTACT_MODULUS * math.sqrt(radius)) * overlap ** 0.25
    return eta


def ash_force(body):
    """What YADE does not have of the law: attraction and damping of a sphere in contact with the wall z = 0.

    YADE knows the velocity of half a step ago, with which the damping would be that of a mass m - eta dt/2. Dividing the
    forces of the contact, YADE's repulsion among them, by 1 + eta dt/(2 m) takes that error out."""
    radius = body.shape.radius
    overlap = radius - body.state.pos[2]
    if overlap < 0 or DAMPING_RATIO is not None:
        O.forces.setPermF(body.id, Vector3(0, 0, 0))
        return
    eta = damping(radius, overlap, body.state.mass)
    share = eta * O.dt / (2 * body.state.mass)
    repulsion = 4 / 3 * CONTACT_MODULUS * math.sqrt(radius * overlap) * overlap
    force = repulsion + attraction(radius, overlap) - eta * body.state.vel[2]
    O.forces.setPermF(body.id, Vector3(0, 0, force / (1 + share) - repulsion))


def ash_forces():
    """For every sphere: call it before each O.step()."""
    for body in O.bodies:
        if isinstance(body.shape, Sphere):
            ash_force(body)


def ash_material():
    return FrictMat(young=2 * math.sqrt(2) * CONTACT_MODULUS, poisson=0, density=DENSITY, frictionAngle=0)


def ash_engines():
    properties = {} if DAMPING_RATIO is None else {"betan": DAMPING_RATIO, "betas": DAMPING_RATIO}
    return [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
            InteractionLoop([Ig2_Wall_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(**properties)],
                            [Law2_ScGeom_MindlinPhys_Mindlin()]),
            NewtonIntegrator(damping=0, gravity=(0, 0, 0))]


def impact(log, number, diameter, velocity, contact_time, captured):
    for resolution in RESOLUTIONS:
        O.reset()
        O.materials.append(ash_material())
        O.bodies.append(wall(0, axis=2))
        O.bodies.append(sphere((0, 0, diameter / 2), diameter / 2))
        O.engines = ash_engines()
        O.dt = contact_time / (resolution - 0.5)
        state = O.bodies[1].state
        first = 0.0         # force at first touch
        if DAMPING_RATIO is None:
            first = attraction(diameter / 2, 0) + damping(diameter / 2, 0, state.mass) * velocity
        state.vel = Vector3(0, 0, -velocity - first / state.mass * O.dt / 2)    # YADE's is that of half a step ago
        log.write("impact %d %d %.17g\n" % (number, resolution, O.dt))
        for step in range((8 if captured else 4) * resolution + 1):
            height, before = state.pos[2] - diameter / 2, state.vel[2]
            ash_forces()
            O.step()
            if not captured or step % 50 == 0:
                log.write("%d %.17g %.17g\n" % (step, height, 0.5 * (before + state.vel[2])))
            if before > 0 and height > 0 and not captured:
                break       # it has left


with open("expected.json") as file:
    expected = json.load(file)
with open("log.impacts", "w") as log:
    for number, one in enumerate(expected["impacts"], 1):
        captured = one["outcome"] == "capture"
        diameter, velocity = one["diameter"]["value"], one["velocity"]["value"]
        mass = DENSITY * math.pi / 6 * diameter ** 3
        stiffness = 4 / 3 * CONTACT_MODULUS * math.sqrt(diameter / 2)
        hertz = 3.21806546 * (mass ** 2 / (stiffness ** 2 * velocity)) ** 0.2
        impact(log, number, diameter, velocity, hertz if captured else one["contact_time"]["value"], captured)
