#pragma once
/// A packet in which every field differs from its default, for the database whose limits stand beside it.

#include "host/packet/check_packet.h"
#include "host/packet/frame_packet.h"

#include <string>

namespace linkdig {

FramePacket sample_packet();
PacketLimits sample_limits();

/// Equal to the bit, field by field (frame_packet.h has no comparison; bytes are compared by the encoder's
/// test).
std::string difference(const FramePacket& a, const FramePacket& b);

/// A path of the running test's own; whatever stands there is removed at the end.
class TestFile {
public:
    explicit TestFile(const std::string& name);
    ~TestFile();
    TestFile(const TestFile&) = delete;
    TestFile& operator=(const TestFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

} // namespace linkdig
