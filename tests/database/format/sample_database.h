#pragma once
/// A small sound database in which every kind of record, reference and optional thing occurs.

#include "database/model/visual_database.h"

#include <filesystem>
#include <string>
#include <vector>

namespace linkdig::database {

VisualDatabase sample_database();

/// An empty folder of the running test's own; removed when it goes out of scope.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    const std::filesystem::path& path() const { return path_; }
    std::vector<std::string> names() const; ///< of what is in it, sorted

private:
    std::filesystem::path path_;
};

} // namespace linkdig::database
