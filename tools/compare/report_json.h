#pragma once
/// What a comparison says to programs: JSON, and JUnit's XML.

#include "tools/compare/compare.h"

#include <string>
#include <vector>

namespace linkdig::compare {

/// One object, indented: exit code, closing line, and each case with its counts, names, worst frames and
/// packets' fields. Numbers without bound are null.
std::string json_of_results(const std::vector<CaseResult>& results, ig::Scan scan);

/// Builds a JUnit file: a test suite per case, a test case per frame.
class JunitFile {
public:
    void begin(const std::string& name);
    void take(const FrameResult& frame, ig::Scan scan);
    void end(const CaseResult& result);
    std::string text() const;

private:
    std::string suites_;
    std::string frames_;
    std::string name_;
    std::uint64_t tests_ = 0;
    std::uint64_t failures_ = 0;
};

} // namespace linkdig::compare
