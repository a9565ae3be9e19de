#include "tools/flight/open_database.h"

#include "database/compiler/compile.h"
#include "database/format/read.h"
#include "database/format/write.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace linkdig::tools {
namespace {

/// A folder of its own, gone with its owner.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "linkdig-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error(fmt::format("{}: cannot be made: {}", pattern, std::strerror(errno)));
        path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const char* name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

OpenedDatabase read(const std::string& path) {
    database::ReadResult result = database::read_database(path);
    if (!result.database) throw BadInput("linkdig: error: " + result.error);
    return {std::move(*result.database), result.id};
}

} // namespace

OpenedDatabase open_database(const std::string& path, std::vector<std::string>* files) {
    if (files != nullptr) *files = {path};
    if (std::filesystem::path(path).extension() != ".toml") return read(path);
    const database::CompileResult compiled = database::compile_file(path);
    if (files != nullptr) *files = compiled.files;
    if (!compiled.database) throw BadInput(compiled.diagnostics.text());
    const TemporaryFolder folder;
    const std::string file = folder.file("compiled.igdb");
    database::write_database(*compiled.database, file);
    return read(file);
}

} // namespace linkdig::tools
