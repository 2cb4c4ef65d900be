"""Structure, velocities, profiles and transport, from the snapshots of an output file.

Each measurement is an object to which the snapshots are added one by one, and which gives its
result at the end; so no more than three of them are in memory. `results.analyse` goes through
them all, and docs/measurements.md defines them.
"""
