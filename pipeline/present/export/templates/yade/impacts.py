# Impacts of ash @other_body@ in YADE; rows for compare.py go to log.impacts.
#   yade -n -x impacts.py          (or sh run.sh, which compares too)
# YADE's wall counts as a mirror sphere: R* = R/2. Young's modulus 2 sqrt(2) E* with nu = 0 makes up for it, so that the
# repulsion is (4/3) E* sqrt(R) overlap^(3/2). Two spheres have R* = r1 r2/(r1 + r2), and 2 E* is right.
import json
import math

@softening_comment@CONTACT_MODULUS, DENSITY, WORK_OF_ADHESION = @contact_modulus@, @density@, @work_of_adhesion@
LAW, DAMPING_LAW = "@law@", "@damping_law@"
COHESION_ENERGY_DENSITY = @cohesion_energy_density@    # of law sjkr
REFERENCE_DIAMETER, EXPONENT = @diameter@, @exponent@
NODES = @nodes@    # (t, damping) with t = asinh(sqrt(v/v_c - 1))^2 of the velocity of approach; linear between
THRESHOLD = @threshold@    # ln v_c = sum c_k x^k, x = (ln d - middle)/half width; None: one damping for every velocity
MEMORY = {}    # velocity of approach of each sphere, or of each pair by the number of its ash
ADHESION_DAMPING_RATIO = @adhesion_damping_ratio@    # zeta_A/zeta_H of brach-dunn-damping, where zeta_A goes with zeta_H
ADHESION_DAMPING = @adhesion_damping@    # zeta_A, where it is the same for every size
PARTNER = @partner@    # radius and mass of the sphere that the ash meets; None: the wall z = 0
DAMPING_RATIO = @damping_ratio@    # YADE's own `betan`; None: the damping is that of ash_force()
FRICTION = @friction@    # Coulomb's coefficient, on the wall
TANGENTIAL_RATIO = @tangential_ratio@    # stiffness along the wall over that normal to it, with friction
YOUNG_MODULUS = (2 * math.sqrt(2) if PARTNER is None else 2) * CONTACT_MODULUS
RESOLUTIONS = (2000, 3000, 4500, 6750, 10000)    # steps a contact


def effective(radius, mass):
    """R* and m* of a sphere of ash and what it meets."""
    if PARTNER is None:
        return radius, mass
    return radius * PARTNER[0] / (radius + PARTNER[0]), mass * PARTNER[1] / (mass + PARTNER[1])


def attraction(radius, overlap):
    """[N], negative; radius is R*"""
    if LAW == "dmt":
        return -2 * math.pi * WORK_OF_ADHESION * radius
    if LAW == "brach-dunn":
        tension = (6 * WORK_OF_ADHESION ** 2 * radius * CONTACT_MODULUS / math.pi) ** (1 / 3)
        return -2 * math.pi * tension * math.sqrt(radius * overlap)
    if LAW == "sjkr":
        return -math.pi * COHESION_ENERGY_DENSITY * radius * overlap
    return 0.0


def coefficient(diameter, velocity):
    """of the damping at a velocity of approach"""
    if THRESHOLD is None:
        return NODES[0][1]
    middle, half, powers = THRESHOLD
    x = (math.log(diameter) - middle) / half
    critical = math.exp(sum(c * x ** k for k, c in enumerate(powers)))
    t = math.asinh(math.sqrt(max(0.0, velocity / critical - 1))) ** 2
    for (t0, c0), (t1, c1) in zip(NODES, NODES[1:]):
        if t <= t1:
            return c0 + (t - t0) / (t1 - t0) * (c1 - c0)
    return NODES[-1][1]


def damping(ash, overlap):
    """eta [kg/s]"""
    radius, mass = effective(ash.shape.radius, ash.state.mass)
    diameter = 2 * ash.shape.radius
    eta = coefficient(diameter, MEMORY.get(ash.id, 0.0)) * (diameter / REFERENCE_DIAMETER) ** EXPONENT
    if DAMPING_LAW == "contact-radius":
        return eta * math.sqrt(radius * overlap)
    if DAMPING_LAW in ("hunt-crossley", "brach-dunn-damping"):
        repulsion = 4 / 3 * CONTACT_MODULUS * math.sqrt(radius * overlap) * overlap
        return eta * repulsion - (eta * ADHESION_DAMPING_RATIO + ADHESION_DAMPING) * attraction(radius, overlap)
    if DAMPING_LAW == "tsuji":
        return eta * math.sqrt(mass * 4 / 3 * CONTACT_MODULUS * math.sqrt(radius)) * overlap ** 0.25
    return eta


def ash_force(ash, overlap, speed):
    """What YADE does not have of the law: attraction and damping of a contact whose bodies part with that speed.

    YADE knows the velocity of half a step ago, with which the damping would be that of a mass m* - eta dt/2. Dividing the
    forces of the contact, YADE's repulsion among them, by 1 + eta dt/(2 m*) takes that error out."""
    if overlap < 0:
        MEMORY[ash.id] = -speed
    if overlap < 0 or DAMPING_RATIO is not None:
        return 0.0
    MEMORY.setdefault(ash.id, -speed)
    radius, mass = effective(ash.shape.radius, ash.state.mass)
    eta = damping(ash, overlap)
    repulsion = 4 / 3 * CONTACT_MODULUS * math.sqrt(radius * overlap) * overlap
    force = repulsion + attraction(radius, overlap) - eta * speed
    return force / (1 + eta * O.dt / (2 * mass)) - repulsion


def ash_forces(pairs=()):
    """Call it before each O.step(): for every sphere on the wall, or for these pairs (ash, partner) of bodies."""
    spheres = [body for body in O.bodies if isinstance(body.shape, Sphere)]
    forces = {body.id: Vector3(0, 0, 0) for body in spheres}
    if PARTNER is None:
        for ash in spheres:
            force = ash_force(ash, ash.shape.radius - ash.state.pos[2], ash.state.vel[2])
            forces[ash.id] += Vector3(0, 0, force)
    for ash, partner in pairs:
        between = ash.state.pos - partner.state.pos
        away = between / between.norm()
        overlap = ash.shape.radius + partner.shape.radius - between.norm()
        force = ash_force(ash, overlap, (ash.state.vel - partner.state.vel).dot(away)) * away
        forces[ash.id] += force
        forces[partner.id] -= force
    for number, force in forces.items():
        O.forces.setPermF(number, force)
    if FRICTION > 0:
        for contact in O.interactions:
            contact.phys.kso = TANGENTIAL_RATIO * 1.5 * contact.phys.kno


def ash_material(density=DENSITY):
    return FrictMat(young=YOUNG_MODULUS, poisson=0, density=density, frictionAngle=math.atan(FRICTION))


def ash_engines():
    properties = {} if DAMPING_RATIO is None else {"betan": DAMPING_RATIO, "betas": DAMPING_RATIO}
    return [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
            InteractionLoop([Ig2_Wall_Sphere_ScGeom(), Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(**properties)],
                            [Law2_ScGeom_MindlinPhys_Mindlin()]),
            NewtonIntegrator(damping=0, gravity=(0, 0, 0))]


def other_body():
    """The wall, or the partner with its pole where the wall would be."""
    if PARTNER is None:
        return wall(0, axis=2)
    radius, mass = PARTNER
    O.materials.append(ash_material(mass / (4 / 3 * math.pi * radius ** 3)))
    return sphere((0, 0, -radius), radius)


def hertz_time(diameter, velocity):
    """Contact time without damping and adhesion [s]"""
    radius, mass = effective(diameter / 2, DENSITY * math.pi / 6 * diameter ** 3)
    stiffness = 4 / 3 * CONTACT_MODULUS * math.sqrt(radius)
    return 3.21806546 * (mass ** 2 / (stiffness ** 2 * velocity)) ** 0.2


def impact(log, number, diameter, velocity, sideways, contact_time, captured):
    for resolution in RESOLUTIONS[::4] if captured else RESOLUTIONS:    # a capture is not extrapolated
        O.reset()
        O.materials.append(ash_material())
        O.bodies.append(sphere((0, 0, diameter / 2), diameter / 2))
        O.bodies.append(other_body())
        O.engines = ash_engines()
        O.dt = contact_time / (resolution - 0.5)
        ash, other = O.bodies[0], O.bodies[1]
        pairs = [] if PARTNER is None else [(ash, other)]
        MEMORY[ash.id] = velocity
        first = 0.0         # force at first touch
        if DAMPING_RATIO is None:
            first = attraction(effective(diameter / 2, ash.state.mass)[0], 0) + damping(ash, 0) * velocity
        # YADE's velocities are those of half a step ago.
        ash.state.vel = Vector3(sideways, 0, -velocity - first / ash.state.mass * O.dt / 2)
        if pairs:
            other.state.vel = Vector3(0, 0, first / other.state.mass * O.dt / 2)
        touching = ash.state.pos[2] - other.state.pos[2]
        log.write("impact %d %d %.17g\n" % (number, resolution, O.dt))
        for step in range((8 if captured else 4) * resolution + 1):
            height = ash.state.pos[2] - other.state.pos[2] - touching
            before = ash.state.vel[2] - other.state.vel[2]
            ash_forces(pairs)
            O.step()
            if not captured or step % 50 == 0:
                log.write("%d %.17g %.17g %.17g %.17g\n" % (step, height, 0.5 * (before + ash.state.vel[2] - other.state.vel[2]),
                                                       ash.state.vel[0], -ash.state.angVel[1]))
            if before > 0 and height > 0 and not captured:
                break       # it has left


with open("expected.json") as file:
    expected = json.load(file)
with open("log.impacts", "w") as log:
    for number, one in enumerate(expected["impacts"], 1):
        captured = one["outcome"] == "capture"
        diameter, velocity = one["diameter"]["value"], one["velocity"]["value"]
        contact_time = one["contact_time"]["value"] if not captured else hertz_time(diameter, velocity)
        sideways = one.get("tangential_velocity", {"value": 0.0})["value"]
        impact(log, number, diameter, velocity, sideways, contact_time, captured)
