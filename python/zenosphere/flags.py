"""Bits of the flags of a collision, in /collisions/flags and in the rows of `Run.advance`."""

HIT = 1  #: gap <= threshold
OVERLAP = 2  #: the overlap rule was used
ABSORBED = 4  #: no bit of a velocity changed
RECEDING = 8  #: receding by rounding, no impulse
CLOCK_STOOD = 16  #: the clock did not move forward
MADE_ELASTIC = 32  #: by the TC model
