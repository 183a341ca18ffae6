#!/bin/sh
# How much of a dataset depends on the generation of the processor: the same recipe with the C library's
# code for processors without AVX2, FMA and AVX-512, compared code by code.
#
#   other_processor_test.sh PROGRAM SOURCE_TREE
#
# Skipped (77) without h5py (Debian: python3-h5py).
set -u
program=$(readlink -f "$1")
export SPECULA_HOME="$2"
/usr/bin/python3 -c 'import h5py' 2>/dev/null || { echo "skipped: python3-h5py is missing"; exit 77; }
folder=$(mktemp -d /tmp/specula-processor.XXXXXX)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
worlds=${SPECULA_PROCESSOR_WORLDS:-1}
generate() { "$program" generate tilt_and_height --worlds "$worlds" -o "$1" >log 2>&1 || { cat log; exit 1; }; }

generate own/data.h5
(GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F
 export GLIBC_TUNABLES
 generate old/data.h5)
/usr/bin/python3 - <<'END'
import h5py, numpy, sys
a, b = h5py.File("own/data.h5"), h5py.File("old/data.h5")
codes = a["adc"][:].astype(int) - b["adc"][:]
differing = numpy.count_nonzero(codes)
most = int(abs(codes).max())
labels = numpy.count_nonzero(a["label"][:] != b["label"][:])
features = abs(a["features"][:] / b["features"][:] - 1).max()
print(f"{codes.shape[0]} frames: {differing} of {codes.size} codes differ ({differing / codes.size:.1e}), "
      f"by at most {most} LSB; labels that differ: {labels}; features by at most {features:.1e}")
# docs/datasets.md promises: at most 1e-5 of the codes, each by one LSB; labels equal.
sys.exit(0 if differing <= 1e-5 * codes.size and most <= 1 and labels == 0 else 1)
END
