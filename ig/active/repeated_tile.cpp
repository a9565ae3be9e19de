#include "ig/active/repeated_tile.h"

#include "database/model/mathematics.h"
#include "database/model/tile_tables.h"
#include "ig/active/made_faces.h"

#include <algorithm>
#include <cmath>

namespace linkdig::ig {

namespace {

/// Squares along the side of a run: small enough to be culled by its bounding sphere, large enough to be few.
constexpr std::int64_t run_squares = 8;

/// Grid coordinates of a level: vertex (i, j) stands at (i, j) * side in the list's frame.
struct Index2 {
    std::int64_t i = 0;
    std::int64_t j = 0;
};

struct Level {
    int number = 0; ///< side = cell * 2^number
    double side_m = 0;
    Index2 centre{}; ///< of the ring, even in both coordinates
    std::uint32_t first_vertex = 0;
};

class TileMaker {
public:
    TileMaker(const VisualDatabase& database, const RepeatedTile& tile, const FramePacket& packet,
              const Configuration& configuration, const FaceBlock& block, ActiveDatabase& active)
        : tile_(tile), normals_(database.tile_normals.data() + tile.first_normal),
          face_normals_(database.tile_normals.data() + tile.first_face_normal), active_(active),
          half_width_(tile.half_width) {
        filtered_ = has_coarser_tables(tile);
        mean_ = Vec3f(0, 0, static_cast<float>(sine(static_cast<double>(tile.vertical_angle_rad))));
        if (filtered_) mean_ = normals_[tile_table_size(tile) - 1];
        take_updates(packet, block.list);
        look_from(packet, configuration, block);
    }

    void make() {
        Level inner;
        for (int number = -static_cast<int>(tile_.fine_levels); number <= static_cast<int>(tile_.rings);
             ++number) {
            Level level = level_around_eye(number);
            make_vertices(level, number > -static_cast<int>(tile_.fine_levels) ? &inner : nullptr);
            make_squares(level, number > -static_cast<int>(tile_.fine_levels) ? &inner : nullptr);
            inner = level;
            if (flat_beyond(level)) break; // the rest would only repeat the mean
        }
        make_far_faces(inner);
    }

    Vec3d origin_m() const { return {origin_.x, origin_.y, 0.0}; }

private:
    /// The report's first method (3.1.4): the host's own vertex normals in place of the modelled ones.
    void take_updates(const FramePacket& packet, std::uint32_t list) {
        for (const VertexNormalUpdate& update : packet.normal_updates) {
            if (update.list != list) continue;
            auto& updated = active_.updated_normals;
            filtered_ = false; // the stored coarser tables are those of the modelled normals
            if (normals_ != updated.data()) {
                updated.assign(normals_, normals_ + std::size_t{tile_.period} * tile_.period);
                normals_ = updated.data();
            }
            std::copy(update.normals.begin(), update.normals.end(), updated.begin() + update.first);
        }
    }

    void look_from(const FramePacket& packet, const Configuration& configuration, const FaceBlock& block) {
        lines_per_tangent_ = 1e9;
        bool first = true;
        for (const ChannelView& channel : packet.channels) {
            if (!channel.on) continue;
            const double lines = configuration.raster.height / (channel.top_tangent - channel.bottom_tangent);
            const double columns =
                configuration.raster.width / (channel.right_tangent - channel.left_tangent);
            lines_per_tangent_ = std::min({lines_per_tangent_, lines, columns});
            if (first) eye_ = glm::transpose(block.world_from_list) * (channel.eye_m - block.origin_m);
            first = false;
        }
        const double step = 2.0 * tile_.cell_m;
        origin_ = {std::floor(eye_.x / step + 0.5) * step, std::floor(eye_.y / step + 0.5) * step};
    }

    Level level_around_eye(int number) const {
        Level level{.number = number, .side_m = tile_.cell_m};
        for (int k = 0; k < number; ++k)
            level.side_m *= 2.0;
        for (int k = 0; k > number; --k)
            level.side_m *= 0.5;
        const double step = 2.0 * level.side_m;
        level.centre = {2 * static_cast<std::int64_t>(std::floor(eye_.x / step + 0.5)),
                        2 * static_cast<std::int64_t>(std::floor(eye_.y / step + 0.5))};
        return level;
    }

    // ---- normals
    // -------------------------------------------------------------------------------------------------

    std::size_t pattern_index(std::int64_t i, std::int64_t j) const {
        const auto mask = static_cast<std::int64_t>(tile_.period) - 1; // period is a power of two
        return static_cast<std::size_t>((j & mask) * static_cast<std::int64_t>(tile_.period) + (i & mask));
    }

    /// Entry of a level that is not finer than the pattern: of its own table, or every 2^number-th of the pattern's.
    std::size_t table_index(int number, std::int64_t i, std::int64_t j) const {
        if (!filtered_) return pattern_index(i << number, j << number);
        std::size_t first = 0;
        std::int64_t side = tile_.period;
        for (int k = 0; k < number && side > 1; ++k) {
            first += static_cast<std::size_t>(side * side);
            side /= 2;
        }
        return first + static_cast<std::size_t>((j & (side - 1)) * side + (i & (side - 1)));
    }

    /// The level's own normal: the pattern's, or, below the pattern's squares, what they interpolate.
    Vec3f own_normal(int number, std::int64_t i, std::int64_t j) const {
        if (number >= 0) return normals_[table_index(number, i, j)];
        return coarse_normal(number, i, j);
    }

    /// What the next coarser level interpolates at vertex (i, j) of this one. Its squares are cut along
    /// alternating diagonals, so a square's middle is the mean of that diagonal's two ends.
    Vec3f coarse_normal(int number, std::int64_t i, std::int64_t j) const {
        const std::int64_t ci = i >> 1;
        const std::int64_t cj = j >> 1;
        const bool odd_i = (i & 1) != 0;
        const bool odd_j = (j & 1) != 0;
        if (!odd_i && !odd_j) return own_normal(number + 1, ci, cj);
        std::int64_t ai = ci;
        std::int64_t bi = odd_i ? ci + 1 : ci;
        if (odd_i && odd_j && !rising_diagonal(ci, cj)) std::swap(ai, bi);
        const Vec3f a = own_normal(number + 1, ai, cj);
        const Vec3f b = own_normal(number + 1, bi, odd_j ? cj + 1 : cj);
        return 0.5F * (a + b);
    }

    /// The square at (i, j) is cut from (i, j) to (i+1, j+1) if true, else from (i+1, j) to (i, j+1).
    static bool rising_diagonal(std::int64_t i, std::int64_t j) { return ((i + j) & 1) == 0; }

    struct Detail {
        double towards_coarse = 0; ///< 0: the level's own normals, 1: the coarser level's
        double contrast = 1;
    };

    Detail detail_at(const Level& level, double x, double y) const {
        const double dx = x - eye_.x;
        const double dy = y - eye_.y;
        const double reach = std::max(std::fabs(dx), std::fabs(dy)) / level.side_m;
        const double from =
            0.5 * static_cast<double>(half_width_) + 1.0; // past the inner border, wherever it snapped
        const double to = static_cast<double>(half_width_) - 1.0; // before the outer one
        Detail detail;
        detail.towards_coarse = std::clamp((reach - from) / (to - from), 0.0, 1.0);
        const double side = level.number < 0 ? tile_.cell_m : level.side_m * (1.0 + detail.towards_coarse);
        const double height = std::fabs(eye_.z);
        const double range_squared = dx * dx + dy * dy + height * height;
        const double lines = lines_per_tangent_ * height * side / std::max(range_squared, 1e-6);
        detail.contrast = std::clamp((lines - faded_lines) / (full_contrast_lines - faded_lines), 0.0, 1.0);
        if (level.number == static_cast<int>(tile_.rings)) detail.contrast *= 1.0 - detail.towards_coarse;
        return detail;
    }

    Vec3f shown_normal(const Level& level, std::int64_t i, std::int64_t j, const Detail& detail) const {
        Vec3f normal = own_normal(level.number, i, j);
        if (detail.towards_coarse > 0.0 && level.number >= 0) {
            const auto m = static_cast<float>(detail.towards_coarse);
            normal = (1.0F - m) * normal + m * coarse_normal(level.number, i, j);
        }
        return fade(normal, detail.contrast);
    }

    Vec3f fade(const Vec3f& normal, double contrast) const {
        if (contrast >= 1.0) return normal;
        if (contrast <= 0.0) return mean_;
        return mean_ + static_cast<float>(contrast) * (normal - mean_);
    }

    // ---- faces
    // ---------------------------------------------------------------------------------------------------

    std::uint32_t vertex_index(const Level& level, std::int64_t i, std::int64_t j) const {
        const std::int64_t row = j - level.centre.j + half_width_;
        const std::int64_t column = i - level.centre.i + half_width_;
        return level.first_vertex + static_cast<std::uint32_t>(row * (2 * half_width_ + 1) + column);
    }

    /// Is (i, j) of `level` strictly inside the hole that the finer level fills?
    bool in_hole(const Level* inner, std::int64_t i, std::int64_t j) const {
        return inner != nullptr && 2 * i > inner->centre.i - half_width_ &&
               2 * i < inner->centre.i + half_width_ && 2 * j > inner->centre.j - half_width_ &&
               2 * j < inner->centre.j + half_width_;
    }

    void make_vertices(Level& level, const Level* inner) {
        level.first_vertex = static_cast<std::uint32_t>(active_.made_vertices.size());
        for (std::int64_t row = -half_width_; row <= half_width_; ++row) {
            for (std::int64_t column = -half_width_; column <= half_width_; ++column) {
                const std::int64_t i = level.centre.i + column;
                const std::int64_t j = level.centre.j + row;
                Vertex vertex;
                if (!in_hole(inner, i, j)) {
                    const double x = static_cast<double>(i) * level.side_m;
                    const double y = static_cast<double>(j) * level.side_m;
                    vertex.position = {static_cast<float>(x - origin_.x), static_cast<float>(y - origin_.y),
                                       0.0F, 1.0F};
                    vertex.normal = shown_normal(level, i, j, detail_at(level, x, y));
                }
                active_.made_vertices.push_back(vertex);
            }
        }
    }

    void make_squares(const Level& level, const Level* inner) {
        for (std::int64_t row = -half_width_; row < half_width_; row += run_squares) {
            for (std::int64_t column = -half_width_; column < half_width_; column += run_squares) {
                make_run(level, inner, row, column);
            }
        }
    }

    void make_run(const Level& level, const Level* inner, std::int64_t row0, std::int64_t column0) {
        const auto first_face = static_cast<std::uint32_t>(active_.made_faces.size());
        const std::int64_t row1 = std::min(row0 + run_squares, half_width_);
        const std::int64_t column1 = std::min(column0 + run_squares, half_width_);
        for (std::int64_t row = row0; row < row1; ++row) {
            for (std::int64_t column = column0; column < column1; ++column) {
                const Index2 at{level.centre.i + column, level.centre.j + row};
                if (!filled_by(inner, at)) make_square(level, inner, at);
            }
        }
        const auto count = static_cast<std::uint32_t>(active_.made_faces.size()) - first_face;
        if (count == 0) return;
        FaceRun run{.first_face = first_face, .face_count = count};
        const double middle_i =
            static_cast<double>(level.centre.i) + 0.5 * static_cast<double>(column0 + column1);
        const double middle_j = static_cast<double>(level.centre.j) + 0.5 * static_cast<double>(row0 + row1);
        run.centre = {static_cast<float>(middle_i * level.side_m - origin_.x),
                      static_cast<float>(middle_j * level.side_m - origin_.y), 0.0F};
        run.radius =
            static_cast<float>(0.75 * static_cast<double>(run_squares) * level.side_m); // > half diagonal
        active_.made_runs.push_back(run);
    }

    /// Is the square at `at` covered by the finer level? Borders coincide with its grid lines, so it is all
    /// or none.
    bool filled_by(const Level* inner, Index2 at) const {
        return inner != nullptr && 2 * at.i >= inner->centre.i - half_width_ &&
               2 * at.i < inner->centre.i + half_width_ && 2 * at.j >= inner->centre.j - half_width_ &&
               2 * at.j < inner->centre.j + half_width_;
    }

    void make_square(const Level& level, const Level* inner, Index2 at) {
        const std::uint32_t corner[4] = {vertex_index(level, at.i, at.j), vertex_index(level, at.i + 1, at.j),
                                         vertex_index(level, at.i + 1, at.j + 1),
                                         vertex_index(level, at.i, at.j + 1)};
        auto& corners = active_.made_corners;
        const auto first_corner = static_cast<std::uint32_t>(corners.size());
        // The fan starts at an end of the diagonal; beside a finer ring at the one that does not touch the
        // border, so that the mid-edge vertex cuts a triangle in two and leaves the square's own surface as
        // it is.
        const int side = inner == nullptr ? -1 : side_on_hole(*inner, at);
        int start = rising_diagonal(at.i, at.j) ? 0 : 1;
        if (side == start || side == ((start + 3) & 3)) start = (start + 2) & 3;
        for (int k = 0; k < 4; ++k) {
            const int at_corner = (start + k) & 3;
            corners.push_back(corner[at_corner]);
            if (at_corner == side) corners.push_back(mid_edge_vertex(*inner, at, side));
        }
        Face face;
        face.first_corner = first_corner;
        face.corner_count = static_cast<std::uint16_t>(corners.size() - first_corner);
        face.colour = tile_.colour;
        face.shading = is_face_shaded(tile_) ? Shading::face : Shading::vertex;
        face.file = tile_.file;
        face.line = tile_.line;
        face.normal = square_normal(level, at);
        active_.made_faces.push_back(face);
    }

    /// Normal of a square that is face-shaded (report, Figures 2, 8 and 9).
    Vec3f square_normal(const Level& level, Index2 at) const {
        const double x = (static_cast<double>(at.i) + 0.5) * level.side_m;
        const double y = (static_cast<double>(at.j) + 0.5) * level.side_m;
        const std::size_t index = level.number >= 0
                                      ? table_index(level.number, at.i, at.j)
                                      : pattern_index(at.i >> -level.number, at.j >> -level.number);
        return fade(face_normals_[index], detail_at(level, x, y).contrast);
    }

    /// Side of the square that lies on the finer level's border: 0 south, 1 east, 2 north, 3 west; -1 if none
    /// does.
    int side_on_hole(const Level& inner, Index2 at) const {
        const std::int64_t west = inner.centre.i - half_width_;
        const std::int64_t east = inner.centre.i + half_width_;
        const std::int64_t south = inner.centre.j - half_width_;
        const std::int64_t north = inner.centre.j + half_width_;
        const bool in_columns = 2 * at.i >= west && 2 * at.i < east;
        const bool in_rows = 2 * at.j >= south && 2 * at.j < north;
        if (in_columns && 2 * at.j == north) return 0;
        if (in_rows && 2 * (at.i + 1) == west) return 1;
        if (in_columns && 2 * (at.j + 1) == south) return 2;
        if (in_rows && 2 * at.i == east) return 3;
        return -1;
    }

    std::uint32_t mid_edge_vertex(const Level& inner, Index2 at, int side) const {
        const Index2 middle[4] = {{2 * at.i + 1, 2 * at.j},
                                  {2 * at.i + 2, 2 * at.j + 1},
                                  {2 * at.i + 1, 2 * at.j + 2},
                                  {2 * at.i, 2 * at.j + 1}};
        return vertex_index(inner, middle[side].i, middle[side].j);
    }

    // ---- the horizon
    // ---------------------------------------------------------------------------------------------

    /// Does everything at and beyond the level's outer border show the mean?
    bool flat_beyond(const Level& level) const {
        if (level.number < 0) return false;
        const double nearest = (static_cast<double>(half_width_) - 1.0) * level.side_m;
        const double height = std::fabs(eye_.z);
        // Side grows in proportion to the range, so lines fall with the range: the next ring's are the most
        // there are.
        const double lines = lines_per_tangent_ * height * 2.0 * level.side_m /
                             std::max(nearest * nearest + height * height, 1e-6);
        return lines <= faded_lines;
    }

    void make_far_faces(const Level& last) {
        static constexpr int step_i[4] = {1, 0, -1, 0}; // along each side of the border, counter-clockwise
        static constexpr int step_j[4] = {0, 1, 0, -1};
        static constexpr int corner_i[4] = {-1, 1, 1, -1}; // where each side begins
        static constexpr int corner_j[4] = {-1, -1, 1, 1};
        const auto first_infinite = static_cast<std::uint32_t>(active_.made_vertices.size());
        for (int k = 0; k < 4; ++k) {
            const Vec4f position(static_cast<float>(corner_i[k]), static_cast<float>(corner_j[k]), 0.0F,
                                 0.0F);
            active_.made_vertices.push_back({.position = position, .normal = mean_});
        }
        for (int side = 0; side < 4; ++side) {
            auto& corners = active_.made_corners;
            Face face;
            face.first_corner = static_cast<std::uint32_t>(corners.size());
            for (std::int64_t k = 2 * half_width_; k >= 0; --k) { // backwards: the face lies outside
                corners.push_back(
                    vertex_index(last, last.centre.i + corner_i[side] * half_width_ + step_i[side] * k,
                                 last.centre.j + corner_j[side] * half_width_ + step_j[side] * k));
            }
            corners.push_back(first_infinite + static_cast<std::uint32_t>(side));
            corners.push_back(first_infinite + static_cast<std::uint32_t>((side + 1) & 3));
            face.corner_count = static_cast<std::uint16_t>(corners.size() - face.first_corner);
            face.colour = tile_.colour;
            face.shading = Shading::face;
            face.normal = mean_;
            face.file = tile_.file;
            face.line = tile_.line;
            active_.made_runs.push_back({.first_face = static_cast<std::uint32_t>(active_.made_faces.size()),
                                         .face_count = 1,
                                         .radius = -1.0F});
            active_.made_faces.push_back(face);
        }
    }

    const RepeatedTile& tile_;
    const Vec3f* normals_;
    const Vec3f* face_normals_;
    ActiveDatabase& active_;
    std::int64_t half_width_;
    bool filtered_ = false; ///< coarser levels have tables of their own
    Vec3d eye_{0};          ///< in the list's frame
    Vec2d origin_{0};       ///< of the made vertices, in the list's frame: near the eye, on the grid
    double lines_per_tangent_ = 0;
    Vec3f mean_{0};
};

} // namespace

void make_tile_faces(const VisualDatabase& database, const RepeatedTile& tile, const FramePacket& packet,
                     const Configuration& configuration, ActiveDatabase& active, FaceBlock& block) {
    const auto first_run = static_cast<std::uint32_t>(active.made_runs.size());
    const auto first_face = active.made_faces.size();
    TileMaker maker(database, tile, packet, configuration, block, active);
    maker.make();
    give_to_list(block.list, first_face, active);
    active.made_leaves.push_back(
        {.first_run = first_run,
         .run_count = static_cast<std::uint32_t>(active.made_runs.size()) - first_run});
    block.origin_m += block.world_from_list * maker.origin_m();
    block.root = leaf_reference(static_cast<std::uint32_t>(active.made_leaves.size() - 1));
    active.made_faces_of.push_back(static_cast<std::uint32_t>(active.blocks.size()));
}

} // namespace linkdig::ig
