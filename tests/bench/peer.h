#pragma once
/// The peer: OpenGL as Mesa's software renderer llvmpipe draws it, off screen.

#include "tests/bench/world_faces.h"

#include <memory>
#include <string>
#include <vector>

namespace linkdig::bench {

/// One context. Threads are those of the environment variable LP_NUM_THREADS when the first context is made.
class Peer {
public:
    /// Throws std::runtime_error, saying what was tried, if there is no such renderer here.
    Peer(std::uint32_t width, std::uint32_t height, bool depth_test);
    ~Peer();
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    std::string renderer() const;

    /// Puts a channel's faces into static buffers; they are drawn by later calls of draw() with its number.
    void add(const WorldFaces& faces);

    /// Draws a channel, waits until it is done and reads it back: rows from the bottom.
    const std::vector<std::uint32_t>& draw(const FramePacket& packet, std::size_t channel);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace linkdig::bench
