"""make_recording.py FILE.npz: 24 frames of random codes in 6 sessions of 2 classes."""

import sys

import numpy as np

random = np.random.default_rng(1)
np.savez(sys.argv[1],
         frames=random.integers(-2048, 2048, (24, 1, 3, 64), dtype=np.int16),
         material=np.repeat(["iron", "wood"], 12),
         run=np.repeat(np.arange(6), 4))
