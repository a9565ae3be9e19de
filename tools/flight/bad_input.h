#pragma once
/// The author's or the caller's mistake: the program ends with exit code 2 and this text.

#include <stdexcept>

namespace linkdig::tools {

/// The text is complete: one or more lines `file:line:column: error: ...`, or a sentence about the command
/// line.
class BadInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace linkdig::tools
