#include "tests/bench/world_faces.h"

#include "ig/active/activate.h"
#include "ig/priority/prioritise.h"

#include <map>

namespace linkdig::bench {

namespace {

class Gatherer {
public:
    Gatherer(const FramePacket& packet, std::size_t channel, const VisualDatabase& database)
        : packet_(packet), database_(database) {
        out_.eye_m = packet.channels[channel].eye_m;
        ig::History history;
        ig::activate(database, packet, {}, history, active_);
        ig::PriorityScratch scratch;
        ig::prioritise(active_, packet.channels[channel], scratch, order_);
    }

    WorldFaces run() {
        for (auto ranked = order_.runs.rbegin(); ranked != order_.runs.rend(); ++ranked) {
            block_ = &active_.blocks[ranked->block];
            block_index_ = ranked->block;
            const FaceRun& run = block_->runs[ranked->run];
            for (std::uint32_t k = run.face_count; k > 0; --k)
                put(block_->faces[run.first_face + k - 1]);
        }
        return std::move(out_);
    }

private:
    WorldVertex vertex(const Face& face, std::uint32_t index, bool smooth) const {
        const Vertex& made = block_->vertices[index];
        const auto w = static_cast<double>(made.position.w);
        const Vec3d origin = block_->at_eye ? Vec3d(0) : block_->origin_m - out_.eye_m;
        const Vec3d at = block_->world_from_list * Vec3d(made.position) + w * origin;
        const Vec3d normal = block_->world_from_list * Vec3d(smooth ? made.normal : face.normal);
        const Colour colour = database_.colours[face.colour];
        const float sun =
            face.shading == Shading::unshaded ? -1.0F : static_cast<float>(database_.lists[block_->list].sun);
        return {
            {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z), made.position.w},
            {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)},
            {colour.red, colour.green, colour.blue, 255},
            {block_->ambient, block_->diffuse, sun}};
    }

    std::uint32_t place(const Face& face, std::uint32_t index) {
        const bool smooth = face.shading == Shading::vertex && block_->smooth;
        const auto key = std::pair{std::pair{block_index_, face.colour}, index};
        if (smooth) {
            if (const auto found = shared_.find(key); found != shared_.end()) return found->second;
            shared_[key] = static_cast<std::uint32_t>(out_.vertices.size());
        }
        out_.vertices.push_back(vertex(face, index, smooth));
        return static_cast<std::uint32_t>(out_.vertices.size() - 1);
    }

    void put(const Face& face) {
        const std::uint32_t* corners = block_->corners.data() + face.first_corner;
        corners_.clear();
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            corners_.push_back(place(face, corners[k]));
        for (std::size_t k = 1; k + 1 < corners_.size(); ++k) {
            out_.indices.insert(out_.indices.end(), {corners_[0], corners_[k], corners_[k + 1]});
            if (face.two_sided != 0)
                out_.indices.insert(out_.indices.end(), {corners_[0], corners_[k + 1], corners_[k]});
        }
    }

    const FramePacket& packet_;
    const VisualDatabase& database_;
    ig::ActiveDatabase active_;
    ig::PriorityOrder order_;
    const ig::FaceBlock* block_ = nullptr;
    std::uint32_t block_index_ = 0;
    std::map<std::pair<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t>, std::uint32_t> shared_;
    std::vector<std::uint32_t> corners_;
    WorldFaces out_;
};

} // namespace

WorldFaces world_faces(const VisualDatabase& database, const FramePacket& packet, std::size_t channel) {
    return Gatherer(packet, channel, database).run();
}

} // namespace linkdig::bench
