# SPDX-License-Identifier: Apache-2.0
"""Writes fw_golden.c:  python3 firmware/generate_golden.py > firmware/fw_golden.c

The library's arithmetic said a second time, in Python: doubles rounded to float32 after every
operation are what a float unit gives (a double has more than twice the digits, so rounding twice
does not differ for + - * / and square root). Each result is also held against plain double
precision, so that the two statements cannot share a mistake.
"""

import cmath
import math
import struct

N, FIRST, BINS = 128, 6, 12
SEARCH_FIRST, SEARCH, AROUND, TARGET, FLOOR = 4, 20, 12, 11.5, 0.01
HIDDEN, OUT, SHIFT, LEVELS = 6, 5, 40, 16.0


def f32(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def bits(x):
    return struct.unpack("<I", struct.pack("<f", x))[0]


def chirp():
    state, codes = 12345, []
    for i in range(N):
        state = (1103515245 * state + 12345) % 2**31
        noise = (state >> 16) % 5 - 2
        tones = 300 * math.cos(0.71 * i + 0.4) + 40 * math.cos(0.55 * i)
        codes.append(round(tones) + noise)
    return codes


def window(i):
    s = math.sin(math.pi * i / (N - 1)) ** 2
    return f32(s * (0.36 + 0.64 * s))


def twiddle(turn):  # of 1024
    return f32(math.cos(2 * math.pi * turn / 1024)), f32(-math.sin(2 * math.pi * turn / 1024))


def fft_float(z):  # of pairs
    n = len(z)
    if n == 1:
        return z
    even, odd, out = fft_float(z[0::2]), fft_float(z[1::2]), [None] * n
    for k in range(n // 2):
        (wr, wi), (br, bi), (ar, ai) = twiddle(k * 1024 // n), odd[k], even[k]
        re = f32(f32(wr * br) - f32(wi * bi))
        im = f32(f32(wr * bi) + f32(wi * br))
        out[k] = (f32(ar + re), f32(ai + im))
        out[k + n // 2] = (f32(ar - re), f32(ai - im))
    return out


def spectrum(codes, bins):
    """(re, im) of bins below n/4: the first half of each split."""
    x = [f32(window(min(i, N - 1 - i)) * codes[i]) for i in range(N)]
    z = fft_float(list(zip(x[0::2], x[1::2])))
    values = []
    for k in bins:
        (a0, a1), (b0, b1), (wr, wi) = z[k], z[N // 2 - k], twiddle(k * 1024 // N)
        even_re, even_im = f32(0.5 * f32(a0 + b0)), f32(0.5 * f32(a1 - b1))
        odd_re, odd_im = f32(0.5 * f32(a1 + b1)), f32(0.5 * f32(b0 - a0))
        re = f32(even_re + f32(f32(wr * odd_re) - f32(wi * odd_im)))
        im = f32(even_im + f32(f32(wr * odd_im) + f32(wi * odd_re)))
        values.append((re, im))
    return values


def exact_bin(codes, k):
    return sum(window(min(i, N - 1 - i)) * codes[i] * cmath.exp(-2j * math.pi * i * k / N) for i in range(N))


def magnitude(re, im):
    return f32(math.sqrt(f32(f32(re * re) + f32(im * im))))


def window_sum():
    return f32(math.fsum(math.sin(math.pi * i / (N - 1)) ** 2 * (0.36 + 0.64 * math.sin(math.pi * i / (N - 1)) ** 2) for i in range(N)))


def profile(codes):
    scale, out = f32(2.0 / window_sum()), []
    bins = range(FIRST, FIRST + BINS)
    for k, (re, im) in zip(bins, spectrum(codes, bins)):
        out.append(f32(magnitude(re, im) * scale))
        exact = abs(exact_bin(codes, k)) * 2 / window_sum()
        assert abs(out[-1] - exact) < 2e-4, (k, out[-1], exact)
    return out


def cubic(a, b, c, d, t):
    slope = f32(0.5 * f32(c - a))
    square = f32(f32(f32(a - f32(2.5 * b)) + f32(2.0 * c)) - f32(0.5 * d))
    cube = f32(f32(0.5 * f32(d - a)) + f32(1.5 * f32(b - c)))
    return f32(b + f32(t * f32(slope + f32(t * f32(square + f32(t * cube))))))


def logarithm(x):
    sqrt_half = 0x3F3504F3
    shifted = bits(x) + (0x3F800000 - sqrt_half)
    f = f32(struct.unpack("<f", struct.pack("<I", (shifted & 0x7FFFFF) + sqrt_half))[0] - 1.0)
    s = f32(f / f32(2.0 + f))
    s2, tail = f32(s * s), f32(2.0 / 9.0)
    for term in (7.0, 5.0, 3.0):
        tail = f32(f32(tail * s2) + f32(2.0 / term))
    near = f32(f - f32(s * f32(f - f32(s2 * tail))))
    exponent = (shifted >> 23) - 127
    result = f32(f32(exponent * 0.693359375) + f32(f32(exponent * f32(-2.12194440e-4)) + near))
    assert abs(result - math.log(x)) <= 2e-7 * max(1.0, abs(math.log(x)))
    return result


def shape(codes):
    """Bins around the strongest, over it, and its level: one row."""
    held = range(1, N // 4)
    bin_at = {k: (-re, -im) if k % 2 else (re, im) for k, (re, im) in zip(held, spectrum(codes, held))}
    sizes = {k: magnitude(*bin_at[k]) for k in held}
    top = max(range(SEARCH_FIRST, SEARCH_FIRST + SEARCH), key=lambda k: sizes[k])
    bend = f32(f32(sizes[top - 1] - f32(2.0 * sizes[top])) + sizes[top + 1])
    peak = f32(top + f32(f32(0.5 * f32(sizes[top - 1] - sizes[top + 1])) / bend))

    def value_at(place):
        index, t = int(place), f32(place - int(place))
        four = [bin_at[index + k] for k in (-1, 0, 1, 2)]
        return tuple(cubic(*(value[part] for value in four), t) for part in (0, 1))

    def exact_at(place):  # the same interpolation of the exact transform, in double
        index, t = int(place), place - int(place)
        a, b, c, d = ((-1) ** (index + k) * exact_bin(codes, index + k) for k in (-1, 0, 1, 2))
        return b + t * (0.5 * (c - a) + t * (a - 2.5 * b + 2 * c - 0.5 * d + t * (0.5 * (d - a) + 1.5 * (b - c))))

    (re, im), out = value_at(peak), []
    square = f32(f32(re * re) + f32(im * im))
    for k in range(AROUND):
        place = f32(f32(peak - AROUND // 2) + k)
        a, b = value_at(place)
        out.append(f32(f32(f32(a * re) + f32(b * im)) / square))
        out.append(f32(f32(f32(b * re) - f32(a * im)) / square))
        assert abs(complex(*out[-2:]) - exact_at(place) / exact_at(peak)) < 2e-5, k
    level = f32(f32(f32(math.sqrt(square)) * peak) / TARGET)
    return out + [logarithm(max(FLOOR, f32(level * f32(2.0 / window_sum()))))]


def to_even(numerator, shift):
    down, rest = numerator >> shift, numerator & ((1 << shift) - 1)
    half = 1 << (shift - 1)
    return down + (1 if rest > half or (rest == half and down & 1) else 0)


def fixed(x, places):
    return int(math.floor(abs(x) * 2**places + 0.5)) * (1 if x >= 0 else -1)


def fft_hwa(z):
    n = len(z)
    if n == 1:
        return z
    even, odd, out = fft_hwa(z[0::2]), fft_hwa(z[1::2]), [None] * n
    for k in range(n // 2):
        wr, wi = (fixed(w, 20) for w in twiddle(k * 1024 // n))
        (br, bi), (ar, ai) = odd[k], even[k]
        re, im = to_even(wr * br - wi * bi, 20), to_even(wr * bi + wi * br, 20)
        out[k], out[k + n // 2] = (ar + re, ai + im), (ar - re, ai - im)
    return out


def hwa_like(codes):
    x = [(to_even(codes[i] * fixed(window(min(i, N - 1 - i)), 17), 17), 0) for i in range(N)]
    spectrum = fft_hwa(x)
    out = []
    for k in range(FIRST, FIRST + BINS):
        exact = sum(window(min(i, N - 1 - i)) * codes[i] * cmath.exp(-2j * math.pi * i * k / N) for i in range(N)) / 4
        re, im = (to_even(part, 2) for part in spectrum[k])
        assert abs(complex(re, im) - exact) < 4, (k, re, im, exact)
        out += [im, re]
    return out


def numbers(seed, n, most):
    state, out = seed, []
    for _ in range(n):
        state = (1103515245 * state + 12345) % 2**31
        out.append((state >> 12) % (2 * most + 1) - most)
    return out


W0, W1 = numbers(1, HIDDEN * BINS, 127), numbers(2, OUT * HIDDEN, 127)
B0, B1 = numbers(3, HIDDEN, 900), numbers(4, OUT, 900)
MULTIPLIER = 1431655765  # about 2^40 / 768


def layer(weights, biases, values):
    n = len(values)
    out = []
    for o, bias in enumerate(biases):
        total = f32(bias / 512)
        for i, value in enumerate(values):
            total = f32(total + f32(f32(weights[o * n + i] / 512) * value))
        exact = bias / 512 + sum(weights[o * n + i] / 512 * v for i, v in enumerate(values))
        assert abs(total - exact) < 1e-4 * (1 + sum(abs(w) for w in weights))
        out.append(total)
    return out


def standardised(features):
    return [f32(f32(x - 4.0) * 0.0625) for x in features]


def logits_float(features):
    hidden = [max(0.0, x) for x in layer(W0, B0, standardised(features))]
    return layer(W1, B1, hidden)


def logits_int(features, largest):
    q = []
    for x in standardised(features):
        level = f32(x * LEVELS)
        level = f32(level + (-0.5 if level < 0 else 0.5))
        q.append(int(max(-largest, min(largest, level))))
    sums = [b + sum(W0[o * BINS + i] * q[i] for i in range(BINS)) for o, b in enumerate(B0)]
    hidden = [min(largest, (s * MULTIPLIER + 2 ** (SHIFT - 1)) >> SHIFT) if s > 0 else 0 for s in sums]
    sums = [b + sum(W1[o * HIDDEN + i] * hidden[i] for i in range(HIDDEN)) for o, b in enumerate(B1)]
    return [f32(2.0**-10 * f32(s)) for s in sums]


def exponential(x):
    turns = f32(x * f32(1.44269504))
    n = int(f32(turns + (-0.5 if turns < 0 else 0.5)))
    r = f32(f32(x - f32(n * 0.693359375)) - f32(n * f32(-2.12194440e-4)))
    tail = f32(f32(1.0) / f32(5040.0))
    for term in (720.0, 120.0, 24.0, 6.0):
        tail = f32(f32(tail * r) + f32(1.0 / term))
    tail = f32(f32(tail * r) + 0.5)
    near = f32(1.0 + f32(r + f32(f32(r * r) * tail)))
    half = int(n / 2)
    result = f32(f32(near * 2.0**half) * 2.0 ** (n - half))
    assert abs(result - math.exp(x)) <= 2e-7 * math.exp(x)
    return result


def softmax(logits):
    top, total, out = max(logits), 0.0, []
    for logit in logits:
        out.append(exponential(f32(logit - top)))
        total = f32(total + out[-1])
    return [f32(value / total) for value in out]


def subnormal():
    """Inputs, weights (out, in) and sums; each product is rounded before it is added."""
    smallest_normal = 2.0**-126
    inputs = [f32(1.3 * 2.0**-100), f32(1.7 * 2.0**20)]
    weights = [f32(1.1 * 2.0**-32), 0.0, 0.0, f32(1.9 * 2.0**-140)]
    products = [f32(weights[0] * inputs[0]), f32(weights[3] * inputs[1])]
    assert 0 < products[0] < smallest_normal <= min(abs(x) for x in inputs + weights[:1])
    assert 0 < weights[3] < smallest_normal < products[1]
    return inputs, weights, products


def emit(declaration, values, per_line=12):
    print(f"\n{declaration} = {{")
    for start in range(0, len(values), per_line):
        print("    " + ", ".join(str(v) for v in values[start : start + per_line]) + ",")
    print("};")


def emit_floats(name, values):
    emit(f"const uint32_t {name}[{len(values)}]", [f"0x{bits(v):08x}u" for v in values], 6)


def main():
    codes = chirp()
    features = profile(codes)
    logits = logits_float(features)
    print("/* SPDX-License-Identifier: Apache-2.0 */")
    print("/* GENERATED by generate_golden.py: edit that. */")
    print('#include "fw_golden.h"')
    print("/* clang-format off */")
    emit(f"const int16_t fw_golden_chirp[{N}]", codes)
    emit_floats("fw_golden_profile", features)
    emit_floats("fw_golden_shape", shape(codes))
    emit(f"const int16_t fw_golden_im_re[{2 * BINS}]", hwa_like(codes))
    emit(f"const int8_t fw_golden_weight[{len(W0 + W1)}]", W0 + W1)
    emit(f"const int32_t fw_golden_bias[{HIDDEN + OUT}]", B0 + B1)
    emit(f"const int32_t fw_golden_multiplier[{HIDDEN}]", [MULTIPLIER] * HIDDEN)
    emit_floats("fw_golden_logits", logits)
    emit_floats("fw_golden_logits_int16", logits_int(features, 32767))
    emit_floats("fw_golden_logits_int8", logits_int(features, 127))
    emit_floats("fw_golden_probabilities", softmax(logits))
    for name, values in zip(("in", "weight", "logits"), subnormal()):
        emit_floats("fw_golden_subnormal_" + name, values)


main()
