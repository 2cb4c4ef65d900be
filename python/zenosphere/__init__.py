"""Reads Zenosphere's output files and draws the paper's figures and reports from them."""
