"""The leg that hrp2p and biped12 share: six joints, thigh and shank of 0.30 m."""
from robot_writer import ball, box, mirrored, rod

LEG = ["HIP_Y", "HIP_R", "HIP_P", "KNEE", "ANKLE_P", "ANKLE_R"]


def leg(robot, prefix, side, width, thigh, shank, foot):
    """side: 1 left, -1 right; width: of the hip from the middle [m]; thigh: mass [kg] and y of its centre of mass,
    outwards [m]; shank, foot: mass [kg]."""
    def n(part):
        return f"{prefix}LEG_{part}"
    robot.link(n("HIP_Y"), 0.8, (0, 0, 0), (0.09, 0.08, 0.08), [rod(0.042, 0.07, "z", (0, 0, 0.02), "joint", "v")])
    robot.link(n("HIP_R"), 1.2, (0, 0, 0), (0.10, 0.09, 0.09), [rod(0.042, 0.100, "x", (0, 0, 0), "joint")])
    robot.link(n("HIP_P"), thigh[0], (0, thigh[1] * side, -0.13), (0.11, 0.11, 0.24),
               [rod(0.054, 0.185, "z", (0, 0, -0.155)), ball(0.052, (0, 0, 0), "accent", "v")])
    robot.link(n("KNEE"), shank, (0, 0, -0.12), (0.09, 0.09, 0.24),
               [rod(0.048, 0.10, "y", (0, 0, 0), "accent"), rod(0.042, 0.19, "z", (0, 0, -0.145))])
    robot.link(n("ANKLE_P"), 0.5, (0, 0, 0), (0.07, 0.07, 0.07), [ball(0.036, (0, 0, 0), "joint", "v")])
    robot.link(n("ANKLE_R"), foot, (0.02, 0, -0.075), (0.24, 0.138, 0.03),
               [box(0.24, 0.138, 0.02, (0.02, 0, -0.095), "sole"), box(0.13, 0.09, 0.035, (0.01, 0, -0.068), "shell", "v")])
    chain = [("HIP_Y", "WAIST", (0, width * side, 0), "z", mirrored(side, -0.52, 0.78), 120, 6),
             ("HIP_R", n("HIP_Y"), (0, 0, 0), "x", mirrored(side, -0.35, 0.61), 150, 6),
             ("HIP_P", n("HIP_R"), (0, 0, 0), "y", (-2.18, 0.73), 200, 8),
             ("KNEE", n("HIP_P"), (0, 0, -0.30), "y", (-0.03, 2.62), 200, 9),
             ("ANKLE_P", n("KNEE"), (0, 0, -0.30), "y", (-1.31, 0.73), 200, 8),
             ("ANKLE_R", n("ANKLE_P"), (0, 0, 0), "x", (-0.61, 0.61), 120, 8)]
    for part, parent, at, axis, (lower, upper), effort, velocity in chain:
        robot.joint(n(part), parent, n(part), at, axis, lower, upper, effort, velocity)
    robot.frame(f"{prefix}FOOT_SOLE", n("ANKLE_R"), (0, 0, -0.105))
    robot.frame(f"{prefix}FOOT_SENSOR", n("ANKLE_R"), (0, 0, -0.105))
