/* SPDX-License-Identifier: Apache-2.0 */
/* A fuzzer where libFuzzer is not: fw_fuzz_driver SECONDS SEED_FILE... changes the seeds at random,
 * the same way every time, until the time is over. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MAX_BYTES 16384

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t n_bytes);

static uint64_t state = 88172645463325252u;

static uint32_t next(void) { /* G. Marsaglia, Xorshift RNGs, 2003, with triple 13, 7, 17 */
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 32);
}

static size_t mutate(uint8_t bytes[], size_t n) {
    static const uint8_t telling[] = {0, 1, 2, 4, 127, 128, 254, 255};
    for (uint32_t left = next() % 8 + 1; left > 0 && n > 0; --left) {
        uint8_t* const place = bytes + next() % n;
        switch (next() % 5) {
            case 0:
                *place ^= (uint8_t)(1u << next() % 8);
                break;
            case 1:
                *place = telling[next() % sizeof telling];
                break;
            case 2:
                *place = (uint8_t)next();
                break;
            case 3:
                n -= next() % (n < 16 ? n : 16);
                break;
            default:
                *place = bytes[next() % n];
        }
    }
    return n;
}

int main(int argc, char* argv[]) {
    static uint8_t seed[MAX_BYTES], bytes[MAX_BYTES];
    if (argc < 3) return 2;
    const time_t end = time(NULL) + atoi(argv[1]);
    unsigned long runs = 0;
    for (int i = 2; i < argc; ++i) {
        FILE* const file = fopen(argv[i], "rb");
        if (file == NULL) return 2;
        const size_t n_seed = fread(seed, 1, sizeof seed, file);
        fclose(file);
        const time_t until = end - (argc - 1 - i) * ((end - time(NULL)) / (argc - i));
        do {
            for (int burst = 0; burst < 200; ++burst, ++runs) {
                memcpy(bytes, seed, n_seed);
                LLVMFuzzerTestOneInput(bytes, mutate(bytes, n_seed));
            }
        } while (time(NULL) < until);
    }
    printf("%lu inputs\n", runs);
    return 0;
}
