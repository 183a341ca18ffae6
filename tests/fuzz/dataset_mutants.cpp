// dataset_mutants SEED.h5 FOLDER COUNT: reads COUNT damaged versions of a dataset, as every command
// does that takes one, and says what became of them. Built with address and undefined-behaviour
// sanitizers, which end it at the first fault; a version that is read although its content changed
// ends it too. Each kind of damage is drawn by its number, so that a finding comes back.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "sim/core/error.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/hdf5_file.hpp"

namespace specula {
namespace {

using Bytes = std::vector<char>;

/// Numbers that are the same with every standard library.
struct Draws {
    std::mt19937_64 engine;
    std::uint32_t bits() { return static_cast<std::uint32_t>(engine() >> 32); }
    std::uint32_t below(std::uint32_t n) { return n == 0 ? 0 : bits() % n; }
};

Bytes read_bytes(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A place in the file: the first kilobytes, where the structure is dense, as often as all others.
std::size_t place(const Bytes& bytes, Draws& draws) {
    constexpr std::uint32_t dense = 4096;
    const auto size = static_cast<std::uint32_t>(bytes.size());
    return draws.below(draws.bits() & 1 ? std::min(dense, size) : size);
}

struct Mutant {
    const char* kind;
    Bytes bytes;
};

Mutant mutant_of(const Bytes& whole, std::uint32_t number) {
    Draws draws{std::mt19937_64(number)};
    Bytes bytes = whole;
    const auto some = [&](std::uint32_t most) {
        return std::min<std::size_t>(1 + draws.below(most), bytes.size());
    };
    switch (number % 8) {
        case 0: {
            char& byte = bytes[place(bytes, draws)];
            byte = static_cast<char>(byte ^ (1 << draws.below(8)));
            return {"one bit", bytes};
        }
        case 1:
            for (std::size_t i = some(8); i-- > 0;)
                bytes[place(bytes, draws)] = static_cast<char>(draws.bits());
            return {"some bytes", bytes};
        case 2:
            bytes.resize(draws.below(static_cast<std::uint32_t>(bytes.size())));
            return {"cut short", bytes};
        case 3: {
            const std::size_t at = place(bytes, draws), n = some(512);
            std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      bytes.begin() + static_cast<std::ptrdiff_t>(std::min(bytes.size(), at + n)),
                      draws.bits() & 1 ? '\0' : '\xff');
            return {"a run of one value", bytes};
        }
        case 4: {
            const std::size_t from = place(bytes, draws), to = place(bytes, draws);
            const std::size_t n = std::min({some(256), bytes.size() - from, bytes.size() - to});
            std::copy_n(whole.begin() + static_cast<std::ptrdiff_t>(from), n,
                        bytes.begin() + static_cast<std::ptrdiff_t>(to));
            return {"a piece elsewhere", bytes};
        }
        case 5: {
            const std::size_t at = place(bytes, draws);
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
            return {"a byte missing", bytes};
        }
        case 6: {
            for (std::size_t i = 0; i < 8; ++i) {
                const std::size_t at = place(bytes, draws) / 8 * 8 + i;
                if (at < bytes.size()) bytes[at] = '\xff';
            }
            return {"huge numbers", bytes};
        }
        default:
            bytes.insert(bytes.end(), whole.begin(),
                         whole.begin() + static_cast<std::ptrdiff_t>(some(4096)));
            return {"something appended", bytes};
    }
}

/// As show, diff, train and augment read it: whole, by rows, and every table and attribute.
std::string content_of(const std::string& file) {
    const DatasetReader reader(file);
    const Dataset dataset = reader.read({0, reader.n_frames()});
    const Hdf5File in = Hdf5File::open(file);
    std::string content = fingerprint(dataset);
    for (const std::string& table : in.tables()) {
        content += table + in.number_type(table);
        for (const std::string& name : in.attributes(table))
            content += name + in.attribute_text(table, name);
    }
    for (const std::string& name : in.attributes("/")) content += in.attribute_text("/", name);
    for (const Truth& truth : dataset.truth)
        for (const TruthColumn& column : truth_columns)
            content += std::to_string(truth.*column.member);
    return content;
}

int run(const std::string& seed, const std::string& folder, std::uint32_t count) {
    const Bytes whole = read_bytes(seed);
    const std::string right = content_of(seed), file = folder + "/mutant.h5";
    std::map<std::string, std::map<std::string, int>> outcomes;
    for (std::uint32_t number = 0; number < count; ++number) {
        const Mutant mutant = mutant_of(whole, number);
        std::ofstream(file, std::ios::binary | std::ios::trunc)
            .write(mutant.bytes.data(), static_cast<std::streamsize>(mutant.bytes.size()));
        try {
            if (const std::string content = content_of(file); content != right) {
                const auto apart =
                    std::mismatch(content.begin(), content.end(), right.begin(), right.end());
                const auto at = static_cast<std::size_t>(apart.first - content.begin());
                std::printf("mutant %u (%s): read, with another content: %.60s against %.60s\n",
                            number, mutant.kind, content.substr(at > 20 ? at - 20 : 0).c_str(),
                            right.substr(at > 20 ? at - 20 : 0).c_str());
                return 1;
            }
            ++outcomes[mutant.kind]["unharmed"];
        } catch (const InputError& error) {
            const std::string message = error.what();
            if (message.rfind(file + ": ", 0) != 0 || message.find('\n') != std::string::npos) {
                std::printf("mutant %u (%s): refused without its name: %s\n", number, mutant.kind,
                            message.c_str());
                return 1;
            }
            ++outcomes[mutant.kind]["refused"];
        }
    }
    for (const auto& [kind, of] : outcomes)
        for (const auto& [outcome, n] : of)
            std::printf("%-20s %-10s %6d\n", kind.c_str(), outcome.c_str(), n);
    return 0;
}

}  // namespace
}  // namespace specula

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    return specula::run(argv[1], argv[2], static_cast<std::uint32_t>(std::atoi(argv[3])));
}
