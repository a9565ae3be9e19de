#pragma once
/// Numbers on the command line: CLI11 2.1 itself takes -5 for an unsigned option as 2^64 - 5, a number beyond 64 bits as the
/// largest, 010 as eight, and its ranges let nan pass.

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>

namespace linkdig::tools {

/// For an option's transform(): decimal whole numbers from `least` to `most`, both included, without a sign.
CLI::Validator whole_number(std::uint64_t least = 0,
                            std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// For an option's check(): finite numbers from `least` to `most`, both included.
CLI::Validator finite_number(double least, double most);

} // namespace linkdig::tools
