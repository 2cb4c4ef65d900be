"""A sheared mixture of two kinds of spheres, small enough to run in some milliseconds."""

MIXTURE = """\
[system]
dimension = 3
spheres = 90
restitution = 0.9
solids_volume_fraction = 0.3

[[species]]
name = "small"
diameter = 1
share = 0.6666666666666667

[[species]]
name = "large"
diameter = 1.4
share = 0.3333333333333333

[[contact]]
between = ["large", "large"]
restitution = 0.7

[start]
arrangement = "random"
granular_temperature = 1
seed = 7

[drive]
kind = "shear"
shear_rate = 1

[run]
collisions = 1000
"""
ROUGH = {"collision.tangential_restitution": 0.5, "collision.friction": 0.4}
SNAPSHOTS = {"output.snapshot_interval": 0.05}
