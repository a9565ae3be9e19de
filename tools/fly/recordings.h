#pragma once
/// The recordings of a flight that people switch on and off while it flies: each time it is switched on, a file of its own begins,
/// with the machine's history as it then is.

#include "host/packet/recording.h"
#include "tools/flight/flight.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::tools {

struct Recorded {
    std::string path;
    std::uint64_t packets = 0;
};

class Recordings {
public:
    /// The second file of "flight.rec" is "flight-2.rec", and so on.
    explicit Recordings(std::string first_path) : first_path_(std::move(first_path)) {}

    /// Begins a recording, or ends it. Call before the frame that is to be its first is drawn. Throws std::runtime_error if the file
    /// cannot be written; nothing is recorded then.
    void follow(bool on, const Flight& flight);
    bool active() const { return writer_.has_value(); }
    void write(const FramePacket& packet);
    /// Ends what is still being recorded. All of them, in order.
    const std::vector<Recorded>& finish();

private:
    std::string next_path() const;

    std::string first_path_;
    std::optional<RecordingWriter> writer_;
    std::vector<Recorded> recorded_; ///< while one is written it is the last
};

} // namespace linkdig::tools
