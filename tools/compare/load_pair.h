#pragma once
/// The two pictures of a frame, and what came of them.

#include "tools/compare/compare.h"

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace linkdig::compare {

class Loader {
public:
    /// Opens both sides. Throws tools::BadInput. Case and settings must outlive it.
    Loader(const Case& which, const Settings& settings);

    std::size_t pairs() const { return pairs_.size(); }
    /// The next pair; frames of recordings are drawn here, one after the other. Null after the last.
    std::shared_ptr<FrameResult> next();
    /// Reads what is a file, and measures. May run for several frames at a time.
    void measure(FrameResult& frame) const;
    /// The pictures and planes of a frame that was measured, read again if they were let go.
    void restore(FrameResult& frame) const;
    const PacketComparison& packets() const { return packets_; }

private:
    /// Where a plane stands: plane, prefix of the series, number.
    using PlaneKey = std::tuple<std::string, std::string, std::uint64_t>;
    using PlaneFiles = std::map<PlaneKey, std::string>;

    void draw(const Pair& pair, FrameResult& frame);
    void compare_packets(FrameResult& frame);
    bool read_files(FrameResult& frame) const;
    bool is_comparable(FrameResult& frame) const;
    void add_ids(FrameResult& frame) const;
    static PlaneFiles plane_files(const Side& side);
    static std::shared_ptr<const Ids> ids_beside(const Entry& entry, const PlaneFiles& files,
                                                 const Picture& picture);

    const Case& which_;
    const Settings& settings_;
    Side expected_, actual_;
    std::vector<Pair> pairs_;
    std::size_t next_ = 0;
    PlaneFiles expected_planes_, actual_planes_;
    PacketComparison packets_;
    std::optional<std::uint64_t> last_differing_;
};

} // namespace linkdig::compare
