/* SPDX-License-Identifier: Apache-2.0 */
#include "fw_normalise.h"

#include <math.h>
#include <stddef.h>

#include "fw_finite.h"
#include "fw_log.h"
#include "fw_strict_float.h"

/* Place of the largest value, in bins from the first, between bins by the parabola through it and
 * its neighbours. At either end of the profile there is no parabola: the bin itself. */
static float peak_place(const float values[], size_t n) {
    size_t top = 0;
    for (size_t k = 1; k < n; ++k) {
        if (values[k] > values[top]) top = k;
    }
    if (top == 0 || top + 1 == n) return (float)top;
    const float left = values[top - 1], right = values[top + 1];
    const float bend = left - 2.0f * values[top] + right; /* <= 0 at a maximum */
    const float offset = bend < 0.0f ? 0.5f * (left - right) / bend : 0.0f;
    return (float)top + offset;
}

static float value_at(const fw_bins* profile, int32_t index) {
    return index < 0 || index >= profile->n_bins ? 0.0f : profile->amplitude[index];
}

/* The profile at `place`, in bins from its first. A cubic may dip below 0, an amplitude may not. */
static float interpolate(const fw_bins* profile, float place) {
    if (place <= -2.0f || place >= (float)profile->n_bins + 1.0f) return 0.0f;
    const int32_t index = (int32_t)(place + 2.0f) - 2; /* towards minus infinity */
    const float t = place - (float)index;
    const float a = value_at(profile, index - 1), b = value_at(profile, index);
    const float c = value_at(profile, index + 1), d = value_at(profile, index + 2);
    const float slope = 0.5f * (c - a);
    const float square = a - 2.5f * b + 2.0f * c - 0.5f * d;
    const float cube = 0.5f * (d - a) + 1.5f * (b - c);
    const float value = b + t * (slope + t * (square + t * cube));
    return value < 0.0f ? 0.0f : value;
}

static bool positive(float value) {
    return value > 0.0f && value <= FLT_MAX;
}

float fw_peak_bin(const fw_bins* profile) {
    if (profile == NULL || profile->amplitude == NULL || profile->n_bins == 0) return 0.0f;
    return (float)profile->first_bin + peak_place(profile->amplitude, profile->n_bins);
}

bool fw_normalise_valid(const fw_normalise_config* config) {
    if (config == NULL) return false;
    const bool uses_target = config->align || config->compensate_range;
    return (!uses_target || positive(config->target_bin)) &&
           (!config->logarithm || positive(config->floor_lsb));
}

fw_status fw_normalise(const fw_bins* profile, const fw_normalise_config* config,
                       uint16_t first_out, uint16_t n_out, float out[]) {
    if (profile == NULL || config == NULL || out == NULL) return FW_ERR_NULL;
    if (profile->amplitude == NULL) return FW_ERR_NULL;
    const uint32_t last_out = (uint32_t)first_out + n_out;
    const uint32_t last_bin = (uint32_t)profile->first_bin + profile->n_bins;
    if (n_out == 0 || first_out < profile->first_bin || last_out > last_bin) return FW_ERR_SHAPE;
    if (!fw_normalise_valid(config)) return FW_ERR_CONFIG;
    if (!fw_all_finite(profile->amplitude, profile->n_bins)) return FW_ERR_NONFINITE;

    const float peak = fw_peak_bin(profile);
    const float shift = config->align ? peak - config->target_bin : 0.0f;
    const float gain = config->compensate_range ? peak / config->target_bin : 1.0f;
    const float limit = FLT_MAX / 16.0f / (gain > 1.0f ? gain : 1.0f); /* the cubic adds 4 terms */
    for (size_t k = 0; k < profile->n_bins; ++k) {
        if (!(profile->amplitude[k] <= limit)) return FW_ERR_NONFINITE;
    }
    for (size_t i = 0; i < n_out; ++i) {
        const float place = (float)(first_out - profile->first_bin + (int32_t)i) + shift;
        const float value = gain * interpolate(profile, place);
        const float floored = value > config->floor_lsb ? value : config->floor_lsb;
        out[i] = config->logarithm ? fw_log(floored) : value;
    }
    return FW_OK;
}
