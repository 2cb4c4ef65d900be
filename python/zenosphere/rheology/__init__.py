"""Kinetic theory of sheared inelastic hard spheres, to compare measured averages with."""
