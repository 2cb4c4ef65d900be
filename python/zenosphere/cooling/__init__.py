"""The granular temperature of a cooling gas, with Haff's law."""
