#pragma once
/// What the figures found: pictures in a folder, checks with their bounds,
/// tables.

#include "ig/video/line.h"

#include <string>
#include <vector>

namespace linkdig::tools {

struct Check {
    std::string figure; ///< "4", or a name where the report has no figure
    std::string what;   ///< what is measured, with its unit
    double value = 0.0;
    std::string expected; ///< "at most 2"
    bool passed = false;
};

struct Table {
    std::string title;
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
};

class Findings {
public:
    /// The folder is made. Throws std::runtime_error, naming it, if it cannot be.
    /// `quick`: every check, from fewer pictures.
    explicit Findings(std::string folder, bool quick = false);
    bool quick() const { return quick_; }

    void at_most(const std::string& figure, const std::string& what, double value, double bound);
    void at_least(const std::string& figure, const std::string& what, double value, double bound);
    void between(const std::string& figure, const std::string& what, double value, double least,
                 double greatest);
    /// FOLDER/NAME.png.
    void picture(const std::string& name, const ig::VideoFrame& picture) const;
    void table(Table table) { tables_.push_back(std::move(table)); }

    const std::string& folder() const { return folder_; }
    const std::vector<Check>& checks() const { return checks_; }
    bool passed() const;
    /// As text: a line per check, then the tables. As JSON: {"checks": [...],
    /// "tables": [...]}.
    std::string text() const;
    std::string json() const;

private:
    std::string folder_;
    bool quick_ = false;
    std::vector<Check> checks_;
    std::vector<Table> tables_;
};

} // namespace linkdig::tools
