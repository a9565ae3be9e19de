#pragma once
/// Authoring files made in a test, and what the compiler says of them.

#include "database/compiler/compile.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

namespace linkdig::database {

/// A folder that goes when the test ends.
class ScratchFolder {
public:
    ScratchFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ =
            std::filesystem::temp_directory_path() / (std::string("linkdig_") + test->test_suite_name() +
                                                      "_" + test->name() + "_" + std::to_string(::getpid()));
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file.string();
    }
    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

/// A database of one static cluster with one list, then `objects` from line 15 on.
inline std::string scene(std::string_view objects) {
    return "[database]\nname = \"t\"\n[[colour]]\nname = \"grey\"\nrgb = [128, 128, 128]\n[[sun]]\nname = "
           "\"sun\"\n"
           "[[cluster]]\nname = \"cluster\"\npriority = 1\n[[object_list]]\nname = \"list\"\ncluster = "
           "\"cluster\"\n"
           "sun = \"sun\"\n" +
           std::string(objects);
}
inline constexpr int scene_lines = 14; ///< before `objects`

inline CompileResult compile_text(std::string_view text) {
    const ScratchFolder folder;
    return compile_file(folder.write("root.toml", text));
}

/// What the compiler says, with the folder's path taken out: "root.toml:3:1: error: ...".
inline std::string messages(const CompileResult& result) {
    std::string text;
    for (const Diagnostic& each : result.diagnostics.all())
        text += std::filesystem::path(each.at.file).filename().string() + ":" + std::to_string(each.at.line) +
                ": " + each.message + "\n";
    return text;
}

} // namespace linkdig::database
