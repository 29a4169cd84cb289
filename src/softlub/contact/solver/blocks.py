"""Rows of points to rows of blocks and back; the last block takes what is left."""

# mypy: disable-error-code="no-untyped-def"

from __future__ import annotations

from softlub.contact.solver.compiled import compiled


@compiled
def collect(values, block, sums):
    """Sum the values over blocks; the last block takes what is left."""
    sums[:] = 0
    whole = values.size // block
    for offset in range(block):
        for k in range(whole):
            sums[k] += values[k * block + offset]
    for j in range(whole * block, values.size):
        sums[whole] += values[j]


@compiled
def spread(blocks, block, values):
    """Give every point the value of its block."""
    whole = values.size // block
    for k in range(whole):
        value = blocks[k]
        for j in range(k * block, (k + 1) * block):
            values[j] = value
    for j in range(whole * block, values.size):
        values[j] = blocks[whole]
