#pragma once
/// Committed hashes: what every compiler, build type and thread count must reproduce.
///
/// tests/determinism/hashes.txt holds one line per hash: a name without blanks, a blank, 16 hexadecimal
/// digits (XXH64, seed 0). Lines that begin with # and empty lines are passed over. After a change that is
/// meant to change pictures:
///
///   LINKDIG_UPDATE_HASHES=1 build/release/tests/determinism_test
///
/// writes the lines that differ, and the commit says why they did.

#include "ig/video/line.h"

#include <xxhash.h>

#include <cstdint>
#include <string>
#include <type_traits>

namespace linkdig::determinism {

/// Hashes values one after another, as little-endian bytes.
class Hasher {
public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;

    void bytes(const void* data, std::size_t size);
    template <typename T>
    void value(const T& number) {
        static_assert(std::is_arithmetic_v<T>);
        bytes(&number, sizeof number); // the machines in question are little-endian
    }
    std::uint64_t hash() const;

private:
    XXH64_state_t* state_;
};

/// Hash of a picture: width, height and pixels.
std::uint64_t picture_hash(const ig::VideoFrame& picture);

/// Expects the committed hash of this name (a gtest expectation), or writes it if LINKDIG_UPDATE_HASHES is
/// set.
void expect_hash(const std::string& name, std::uint64_t hash);

} // namespace linkdig::determinism
