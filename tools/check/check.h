#pragma once
/// The check of a database: seeded views, each drawn by the machine and cast by Embree, and what differed.

#include "ig/configuration.h"
#include "ig/video/line.h"
#include "tools/check/exceptions.h"
#include "tools/check/views.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace linkdig::tools {

struct CheckRequest {
    std::uint64_t seed = 1;
    std::uint64_t first_view = 0;
    std::uint64_t views = 60;
    ig::Raster raster{512, 512, ig::Scan::horizontal};
    std::vector<DesignException> exceptions;
};

/// Where a face comes from, as its author knows it. Empty: the background.
struct FacePlace {
    std::string list;
    std::string object;
    std::string file;
    std::uint32_t line = 0;
    auto operator<=>(const FacePlace&) const = default;
};

/// One face that is seen where another should be, over all views.
struct Finding {
    FacePlace shown;
    FacePlace nearest;
    std::uint64_t pixels = 0;
    double nearer_by_m = 0; ///< the most; endless_m if the ray does not meet the shown face
    bool gone = false;      ///< the shown face is not present in this frame at all
    std::uint64_t view = 0; ///< the first
    std::uint32_t column = 0;
    std::uint32_t row = 0;
};

struct CheckResult {
    std::uint64_t views = 0;
    std::uint64_t interior = 0;
    std::uint64_t as_near = 0;
    std::uint64_t wrong = 0;
    std::uint64_t ambiguous = 0;         ///< pairs of clusters that no plane decided, over all views
    std::vector<std::uint64_t> excepted; ///< pixels, parallel to the request's exceptions
    std::vector<Finding> findings;       ///< most pixels first
    double wrong_share() const {
        return interior == 0 ? 0.0 : static_cast<double>(wrong) / static_cast<double>(interior);
    }
};

/// What one view showed, for whoever wants to look: the picture with its wrong pixels painted over.
struct CheckedView {
    const CheckView& view;
    const ig::VideoFrame& picture;
    std::uint64_t wrong = 0;
};

/// Checks the views; calls `each`, if given, after every one. Deterministic in database and request. Throws
/// std::logic_error if the machine refuses a packet, and BadInput if there was no pixel to check in any view.
CheckResult check_database(const VisualDatabase& database, const CheckRequest& request,
                           const std::function<void(const CheckedView&)>& each = {});

/// The same for one packet with one channel, in place of a seeded view.
void check_packet_view(const VisualDatabase& database, const CheckRequest& request, const CheckView& view,
                       CheckResult& result, const std::function<void(const CheckedView&)>& each = {});

} // namespace linkdig::tools
