"""A dataset of Specula for h5py and, where it is installed, PyTorch."""

import os

import h5py
import numpy as np


class SpeculaDataset:
    """Map-style: item i is (values, label); every worker process opens the file for itself.

    table  "adc" (chirp, rx, sample), "profile" (rx, bin) or "features" (feature)
    rows   indices of the frames to see, or a mask over all of them; default all
    """

    def __init__(self, path, table="adc", rows=None):
        self.path, self.table, self._file = os.path.abspath(path), table, None
        with h5py.File(path, "r") as file:
            self.labels = file["label"][:].astype(np.int64)
            self.groups = {name: ids[:] for name, ids in file["group"].items()}
            self.class_names = [n.decode() if isinstance(n, bytes) else n
                                for n in file.attrs["class_names"]]
        every = np.arange(len(self.labels))
        self.rows = every if rows is None else every[rows if hasattr(rows, "dtype") else list(rows)]

    def __getstate__(self):  # an open file goes through neither fork nor pickle
        return {**self.__dict__, "_file": None}

    def __len__(self):
        return len(self.rows)

    def __getitem__(self, i):
        if self._file is None or self._pid != os.getpid():
            self._file, self._pid = h5py.File(self.path, "r"), os.getpid()
        row = self.rows[i]
        return self._file[self.table][row].astype(np.float32), self.labels[row]

    def split(self, share=0.2, by="session", seed=0):
        """(training, held back): no session (or sample, world) is on both sides."""
        ids = np.unique(self.groups[by][self.rows])
        if len(ids) < 2 or not 0 < share < 1:
            raise ValueError(f"{self.path}: {len(ids)} {by}(s) cannot be split at {share}; take a "
                             "finer group, such as by='session', or a share between 0 and 1")
        n_held = min(max(1, round(share * len(ids))), len(ids) - 1)
        held = np.random.default_rng(seed).permutation(ids)[:n_held]
        out = np.isin(self.groups[by][self.rows], held)
        return (SpeculaDataset(self.path, self.table, self.rows[~out]),
                SpeculaDataset(self.path, self.table, self.rows[out]))
