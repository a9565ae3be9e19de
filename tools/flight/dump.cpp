#include "tools/flight/dump.h"

#include "ig/sink/png_sink.h"
#include "tools/film/film.h"
#include "tools/flight/progress.h"
#include "tools/sheet/contact_sheet.h"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

namespace linkdig::tools {
namespace {

/// A frame on its way through the pipeline.
struct Dumped {
    std::uint64_t frame = 0;
    ig::VideoFrame picture;
};
using DumpedPointer = std::shared_ptr<Dumped>;

/// Pictures under way at a time: enough to keep a machine busy, few enough to bound memory (4 MiB each at
/// 1024 x 1024).
std::size_t pictures_under_way() {
    return 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 2;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder, error.message()));
}

/// What needs the frames in order: the film, the sheet and the progress line.
class Ordered {
public:
    explicit Ordered(const DumpRequest& request)
        : request_(request), chosen_(sheet_frames(request.frames)),
          sheet_(request.heading, request.width, request.height),
          progress_(request.progress, request.frames) {
        if (!request.film_name.empty())
            film_.emplace(fmt::format("{}/{}.mp4", request.folder, request.film_name), request.width,
                          request.height, request.frames_per_second);
    }

    void take(const Dumped& dumped) {
        if (film_) film_->add(dumped.picture);
        for (std::uint32_t place = 0; place < sheet_pictures; ++place)
            if (request_.first + chosen_[place] == dumped.frame)
                sheet_.place(place, dumped.picture, title(dumped.frame));
        progress_.at(dumped.frame - request_.first + 1);
    }

    void finish() {
        if (film_) film_->finish();
        sheet_.write(request_.folder + "/contact.png");
        progress_.finish();
    }

private:
    std::string title(std::uint64_t frame) const {
        const double seconds = static_cast<double>(frame) / request_.frames_per_second;
        return fmt::format("{:.1f} s   frame {}", seconds, frame);
    }

    const DumpRequest& request_;
    std::array<std::uint64_t, sheet_pictures> chosen_;
    ContactSheet sheet_;
    Progress progress_;
    std::optional<Film> film_;
};

} // namespace

void dump_flight(const DumpRequest& request, const DrawFrame& draw) {
    make_folder(request.folder);
    ig::PngSink files(request.folder);
    Ordered ordered(request);
    std::uint64_t next = request.first;
    const auto drawn = [&](tbb::flow_control& control) -> DumpedPointer {
        if (next == request.first + request.frames) {
            control.stop();
            return nullptr;
        }
        const std::uint64_t frame = next++;
        // Isolated: while the machine waits for its last band, its thread must not start on a neighbour's
        // file.
        return tbb::this_task_arena::isolate([&] {
            return std::make_shared<Dumped>(Dumped{frame, draw(frame)});
        });
    };
    const auto written = [&](DumpedPointer dumped) {
        files.put(dumped->frame, dumped->picture);
        return dumped;
    };
    const auto taken = [&](const DumpedPointer& dumped) { ordered.take(*dumped); };
    using tbb::filter_mode;
    tbb::parallel_pipeline(
        pictures_under_way(),
        tbb::make_filter<void, DumpedPointer>(filter_mode::serial_in_order, drawn) &
            tbb::make_filter<DumpedPointer, DumpedPointer>(filter_mode::parallel, written) &
            tbb::make_filter<DumpedPointer, void>(filter_mode::serial_in_order, taken));
    ordered.finish();
}

} // namespace linkdig::tools
