#include "tools/watch/database_reload.h"

#include "tools/flight/bad_input.h"

#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

namespace linkdig::tools {
namespace {

/// An editor or a compiler may still be writing when its file is first seen to have changed.
constexpr std::chrono::milliseconds settling{50};

} // namespace

DatabaseReload::DatabaseReload(std::string path, const std::vector<std::string>& files)
    : path_(std::move(path)) {
    watch_.set(files);
}

std::optional<DatabaseReload::Outcome> DatabaseReload::poll() {
    if (!opening_.valid()) {
        if (!watch_.changed()) return std::nullopt;
        opening_ = std::async(std::launch::async, [this]() -> Outcome {
            std::this_thread::sleep_for(settling);
            try {
                return {.database = open_database(path_, &files_), .refused = {}};
            } catch (const std::runtime_error& error) { // BadInput among them
                return {.database = {}, .refused = error.what()};
            }
        });
        return std::nullopt;
    }
    if (opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    Outcome outcome = opening_.get();
    // Of a source with mistakes every file that was read counts: whichever is mended, it is opened again.
    if (!files_.empty()) watch_.set(files_);
    return outcome;
}

} // namespace linkdig::tools
