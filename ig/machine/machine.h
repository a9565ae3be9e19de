#pragma once
/// The image generator as one block: a packet in, pictures and a report out.

#include "host/packet/link.h"
#include "ig/active/history.h"
#include "ig/configuration.h"
#include "ig/machine/explain.h"
#include "ig/machine/stage_times.h"
#include "ig/video/line.h"

#include <memory>
#include <optional>

namespace linkdig::ig {

class Machine final : public Link {
public:
    /// The database must outlive the machine. Throws std::invalid_argument if the configuration is out of
    /// bounds.
    Machine(const VisualDatabase& database, const Configuration& configuration);
    ~Machine() override;
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    /// Draws every channel of the packet. A packet that cannot be drawn (not finite, tables of the wrong
    /// length, indices out of range) is refused: the report's `errors` say why, and the pictures stay as they
    /// were.
    const FrameReport& frame(const FramePacket& packet) override;

    /// A frame that is not drawn: the water goes on as it would, all else stays as it was. For pictures from the middle of a flight.
    const FrameReport& follow(const FramePacket& packet);

    /// The picture of a channel of the last frame; valid until the next call of frame(). An empty frame if
    /// the channel is off or was never drawn.
    const VideoFrame& picture(std::size_t channel) const;

    /// What the machine remembers of the frames before. Put back, maybe into another machine on the same database, it
    /// makes the same packets give the same pictures. A refused packet leaves it alone.
    const History& history() const;
    void restore(History history);

    /// Draw these planes beside the colour from the next frame on.
    void draw_planes(bool intensity, bool rank);

    /// Measure the stages from the next frame on; stage_times() has what the last frame took.
    void measure_stages(bool on);
    const StageTimes& stage_times() const;

    /// List, object and face of a rank on a channel of the last frame.
    struct Source {
        std::uint32_t list = 0;
        std::uint32_t object = 0;
        const Face* face = nullptr;
        std::uint16_t colour = 0;        ///< its colour code, of the packet if that sends one
        std::int32_t flat_intensity = 0; ///< by the face's own normal, whatever its shading; 1.0 = 2^22
    };
    Source source(std::size_t channel, std::int32_t rank) const;

    /// What a pixel of a channel of the last frame is made of, and every face over it (column and row as the viewer sees them).
    /// Nothing beyond the picture, or if the channel was never drawn.
    std::optional<PixelReasons> explain(std::size_t channel, std::uint32_t column, std::uint32_t row) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace linkdig::ig
