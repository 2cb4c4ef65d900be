"""What collapses: its spheres, contacts, and how it closes."""
