"""What every figure has: files, sizes, colours, and words."""
