"""Snapshots one after another."""
