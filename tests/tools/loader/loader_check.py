"""loader_check.py LOADER_FOLDER DATASET: what the loader gives is what the file holds."""

import multiprocessing
import os
import pickle
import sys

import h5py
import numpy as np

sys.path.insert(0, sys.argv[1])
from specula_dataset import SpeculaDataset  # noqa: E402


def sums(dataset, rows):
    return [float(dataset[i][0].sum()) for i in rows]


def in_workers(method, dataset):
    """The same sums computed by two processes that share an opened dataset."""
    parts = [range(0, len(dataset), 2), range(1, len(dataset), 2)]
    with multiprocessing.get_context(method).Pool(2) as pool:
        even, odd = pool.starmap(sums, [(dataset, part) for part in parts])
    together = [0.0] * len(dataset)
    together[0::2], together[1::2] = even, odd
    return together


def main():
    path = sys.argv[2]
    here = os.getcwd()
    dataset = SpeculaDataset(path)
    with h5py.File(path) as file:
        adc, label = file["adc"][:], file["label"][:]
        session = file["group/session"][:]
    assert len(dataset) == len(label)
    for i in (0, len(dataset) // 2, len(dataset) - 1):
        values, number = dataset[i]
        assert values.dtype == np.float32 and np.array_equal(values, adc[i]), i
        assert number == label[i] and 0 <= number < len(dataset.class_names)
    assert pickle.loads(pickle.dumps(dataset))[1][0].shape == adc.shape[1:]

    mask = np.arange(len(dataset)) % 3 == 0
    for rows in (mask, list(mask), np.flatnonzero(mask), tuple(np.flatnonzero(mask))):
        assert SpeculaDataset(path, rows=rows).rows.tolist() == np.flatnonzero(mask).tolist()
    assert len(SpeculaDataset(path, rows=[])) == 0
    for rows in (mask[1:], [len(dataset)]):
        try:
            SpeculaDataset(path, rows=rows)
        except IndexError:
            continue
        raise AssertionError("rows that the file does not have")
    os.chdir("/")  # as a worker may be elsewhere
    assert np.array_equal(dataset[0][0], adc[0])
    os.chdir(here)

    training, held = dataset.split(share=0.5)
    assert len(training) + len(held) == len(dataset) and len(held) > 0 and len(training) > 0
    assert not set(session[training.rows]) & set(session[held.rows])
    again, _ = dataset.split(share=0.5)
    assert np.array_equal(again.rows, training.rows)

    for by, share in (("world", 0.2), ("session", 0.0), ("session", 1.0)):  # one world in the file
        try:
            dataset.split(share=share, by=by)
        except ValueError as error:
            assert path in str(error) and by in str(error), error
        else:
            raise AssertionError(f"a split by {by} at {share} of what cannot be split")
    assert all(len(part) > 0 for part in dataset.split(share=0.99))  # never all of them

    expected = [float(frame.astype(np.float32).sum()) for frame in adc]
    assert sums(dataset, range(len(dataset))) == expected  # the file is open from here on
    for method in ("fork", "spawn"):
        assert in_workers(method, dataset) == expected, method
    try:
        import torch.utils.data
    except ImportError:
        print("h5py: right; torch is not installed (Debian: python3-torch), so not tried with it")
        return
    loader = torch.utils.data.DataLoader(dataset, batch_size=4, num_workers=2)
    batches = [(x.sum(dim=(1, 2, 3)).tolist(), y.tolist()) for x, y in loader]
    assert np.allclose([s for x, _ in batches for s in x], expected)
    assert [n for _, y in batches for n in y] == label.tolist()
    print("h5py and torch: right")


if __name__ == "__main__":
    main()
