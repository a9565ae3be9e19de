#pragma once
/// The author's mistakes: told with file, line and column, all of a file in one go.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace linkdig::database {

struct SourceLocation {
    std::string file;
    std::uint32_t line = 0; ///< from 1; 0: the file as a whole
    std::uint32_t column = 0;
};

struct Diagnostic {
    SourceLocation at;
    std::string message; ///< what is wrong; what was expected
};

class KeyLog;

class Diagnostics {
public:
    void error(SourceLocation at, std::string message);
    bool any() const { return !errors_.empty(); }
    const std::vector<Diagnostic>& all() const { return errors_; }
    /// One line per mistake, `file:line:column: error: message`, in the order of file, line and column.
    std::string text() const;

    /// Readers that tell their mistakes here note the keys that they ask for in this log; nothing: they note none.
    void note_keys(KeyLog* log) { keys_ = log; }
    KeyLog* keys() const { return keys_; }

private:
    KeyLog* keys_ = nullptr;
    std::vector<Diagnostic> errors_;
};

/// The candidate closest in spelling to `word`, quoted for a "did you mean" clause, or an empty string.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

} // namespace linkdig::database
