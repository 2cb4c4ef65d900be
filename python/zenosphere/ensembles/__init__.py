"""Figures and tables of the runs of a sweep."""
