#include "database/compiler/tile_pattern.h"

#include "database/compiler/primitives.h"
#include "database/model/mathematics.h"
#include "database/water/sea_pattern.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

namespace linkdig::database {

namespace {

enum class Pattern : std::uint8_t { random, sine, mirrored_sine, two_waves, levels };

constexpr std::int64_t most_table_entries = 65536;

class PatternReader {
public:
    PatternReader(TableReader& reader, RepeatedTile& tile, bool face_shaded)
        : reader_(reader), tile_(tile), side_m_(tile.period * tile.cell_m), filtered_(face_shaded) {}

    TilePattern read() {
        const auto pattern = static_cast<Pattern>(
            reader_.choice("pattern", 0, {"random", "sine", "mirrored_sine", "two_waves", "levels"}));
        filtered_ = filtered_ || pattern != Pattern::random;
        if (pattern == Pattern::levels) return read_levels();
        vertical_angle_rad_ = reader_.angle_rad("vertical_angle", {}, {0, 90});
        tile_.vertical_angle_rad = static_cast<float>(vertical_angle_rad_);
        if (pattern == Pattern::random) return read_random();
        return pattern == Pattern::two_waves ? read_two_waves()
                                             : read_sine(pattern == Pattern::mirrored_sine);
    }

private:
    template <typename Normals>
    TilePattern tables(Normals normals) const {
        TilePattern result;
        for (const NormalStream stream : {NormalStream::vertices, NormalStream::faces}) {
            auto& table = stream == NormalStream::vertices ? result.vertices : result.faces;
            table = normals(stream);
            if (filtered_) table = with_coarser_tables(std::move(table), tile_.period, stream);
        }
        return result;
    }

    TilePattern read_random() {
        const auto seed =
            static_cast<std::uint64_t>(reader_.integer("seed", 0, std::numeric_limits<std::int64_t>::max()));
        const std::size_t count = std::size_t{tile_.period} * tile_.period;
        return tables(
            [&](NormalStream stream) { return random_normals(seed, stream, count, vertical_angle_rad_); });
    }

    TilePattern read_sine(bool mirrored) {
        const WholeWaves wave = read_wave("wavelength", 0.0);
        if (!usable()) return {};
        return tables([&](NormalStream stream) {
            return sine_normals(tile_.period, static_cast<std::uint32_t>(wave.along_x), mirrored, stream,
                                vertical_angle_rad_);
        });
    }

    TilePattern read_two_waves() {
        const WholeWaves first = read_wave("first_wavelength", 0.0);
        const double between_rad = reader_.angle_rad("between", {}, {-180, 180});
        const WholeWaves second = read_wave("second_wavelength", between_rad);
        const auto entries =
            static_cast<std::uint32_t>(reader_.integer("table_size", normal_azimuths, 2, most_table_entries));
        if (!usable()) return {};
        return tables([&](NormalStream stream) {
            return two_wave_normals(tile_.period, first, second, entries, stream, vertical_angle_rad_);
        });
    }

    /// The wave of this length that repeats over the pattern; an error if none is near.
    WholeWaves read_wave(const std::string& stem, double angle_rad) {
        const Mistakes before{reader_};
        const double length_m = reader_.length_m(stem, {}, {0.01, 1e6});
        const std::string key = stem + (reader_.has(stem + "_ft") ? "_ft" : "_m");
        if (before.any()) return {1, 0};
        if (length_m < least_squares_of_wave * tile_.cell_m) {
            reader_.error_at(
                key, fmt::format("\"{}\" is {:.6g} m, {:.3g} squares; expected at least {:.0f} squares", key,
                                 length_m, length_m / tile_.cell_m, least_squares_of_wave));
            return {1, 0};
        }
        const WholeWaves wave = nearest_whole_waves(side_m_ / length_m, angle_rad);
        const double turns = std::sqrt(static_cast<double>(wave.along_x) * wave.along_x +
                                       static_cast<double>(wave.along_y) * wave.along_y);
        const double nearest_m = turns > 0.0 ? side_m_ / turns : side_m_;
        const double nearest_rad = turns > 0.0 ? arc_tangent(wave.along_y, wave.along_x) : angle_rad;
        const double off_rad = modulo(nearest_rad - angle_rad + pi, two_pi) - pi;
        if (turns > 0.0 && std::fabs(nearest_m / length_m - 1.0) <= most_wave_misfit &&
            std::fabs(degrees(off_rad)) <= most_angle_misfit_deg)
            return wave;
        reader_.error_at(
            key, fmt::format(
                     "a wave of {:.6g} m at {:.4g} degrees does not repeat over the pattern's {:.6g} m; the "
                     "nearest that does has {:.6g} m at {:.4g} degrees",
                     length_m, degrees(angle_rad), side_m_, nearest_m, degrees(nearest_rad)));
        return {1, 0};
    }

    TilePattern read_levels() {
        reader_.describe("levels", "n rows of n numbers, 0 to 1", {});
        const toml::node* node = reader_.node("levels");
        const toml::array* rows = node == nullptr ? nullptr : node->as_array();
        std::vector<float> levels;
        bool square = rows != nullptr && !rows->empty() && tile_.period % rows->size() == 0;
        for (std::size_t row = 0; square && row < rows->size(); ++row) {
            const toml::array* of_row =
                rows->get(rows->size() - 1 - row)->as_array(); // the first is the northern one
            square = of_row != nullptr && of_row->size() == rows->size();
            for (std::size_t i = 0; square && i < of_row->size(); ++i) {
                const auto level = of_row->get(i)->value<double>();
                square = level && *level >= 0.0 && *level <= 1.0;
                levels.push_back(static_cast<float>(level.value_or(0.0)));
            }
        }
        if (!square) {
            reader_.error_at(
                "levels", fmt::format("\"levels\" is no pattern of levels; expected n rows of n numbers, 0 "
                                      "to 1, with n a power of two, at most \"period\" {}",
                                      tile_.period));
            return {};
        }
        if (!usable()) return {};
        return tables([&](NormalStream stream) { return level_normals(tile_.period, levels, stream); });
    }

    /// Could a table be made? What follows from a mistake of the period or of a wave is no second one.
    bool usable() const {
        return !mistakes_.any() && (tile_.period & (tile_.period - 1)) == 0 && tile_.period > 1;
    }

    TableReader& reader_;
    RepeatedTile& tile_;
    Mistakes mistakes_{reader_};
    double side_m_;
    bool filtered_; ///< coarser tables follow
    double vertical_angle_rad_ = 0.0;
};

} // namespace

TilePattern read_pattern(TableReader& reader, RepeatedTile& tile, bool face_shaded) {
    return PatternReader(reader, tile, face_shaded).read();
}

} // namespace linkdig::database
