#include "database/compiler/read_lights.h"

#include "database/model/mathematics.h"

#include <fmt/format.h>

#include <cmath>

namespace linkdig::database {

namespace {

class LightReader {
public:
    LightReader(const toml::table& table, const char* kind, const TableReader& object, std::uint16_t file,
                const Reading& reading, std::optional<std::uint16_t> inherited)
        : reading_(reading),
          reader_(table, object.file(), fmt::format("[[object.{}]] of {}", kind, object.what()),
                  *reading.diagnostics) {
        light_.at = place_of(table, file);
        light_.point.file = light_.at.file;
        light_.point.line = light_.at.line;
        read_colour(inherited);
        read_beam();
        read_strength();
        read_flash();
    }

    void read_one(ModelObject& object) {
        put(reader_.point_m("position"), object);
        reader_.finish();
    }

    void read_string(ModelObject& object) {
        const Vec3d from = reader_.point_m("from");
        const Vec3d to = reader_.point_m("to");
        const std::int64_t count = reader_.integer("count", 2, most_lights);
        const double phase_step = reader_.number("phase_step", 0.0, {-1.0, 1.0});
        reader_.finish();
        const double first_phase = light_.point.phase;
        for (std::int64_t i = 0; i < count; ++i) {
            const double phase = first_phase + static_cast<double>(i) * phase_step;
            light_.point.phase = static_cast<float>(phase - std::floor(phase));
            put(from + (to - from) * (static_cast<double>(i) / static_cast<double>(count - 1)), object);
        }
    }

private:
    void put(const Vec3d& position, ModelObject& object) {
        light_.point.position = Vec3f(rounded_to_float(position));
        object.lights.push_back(light_);
    }

    void read_colour(std::optional<std::uint16_t> inherited) {
        reader_.describe("colour", "name of a [[colour]]", "the object's");
        reader_.describe("back_colour", "name of a [[colour]]", "`colour`");
        const auto named_colour = named(reader_, "colour", reading_.registry->colour_names, false);
        if (!named_colour && !reader_.has("colour") && !inherited)
            reader_.error_at(
                "colour",
                fmt::format("{} has no colour; expected `colour` here or in the object", reader_.what()));
        light_.point.colour =
            named_colour ? static_cast<std::uint16_t>(*named_colour) : inherited.value_or(0);
        const auto back = named(reader_, "back_colour", reading_.registry->colour_names, false);
        light_.point.back_colour = back ? static_cast<std::uint16_t>(*back) : light_.point.colour;
    }

    void read_beam() {
        LightPoint& point = light_.point;
        point.beam = static_cast<LightBeam>(reader_.choice("beam", 0, {"all_round", "one_way", "two_way"}));
        const bool directed = point.beam != LightBeam::all_round;
        for (const char* key : {"direction", "half_angle_deg", "vertical_half_angle_deg"})
            if (!directed && reader_.has(key))
                reader_.error_at(key, fmt::format("\"{}\" stands in a light that shines all round; expected "
                                                  "beam = \"one_way\" or \"two_way\"",
                                                  key));
        if (point.beam != LightBeam::two_way && reader_.has("back_colour"))
            reader_.error_at("back_colour",
                             "\"back_colour\" stands in a light without a second beam; expected "
                             "beam = \"two_way\"");
        reader_.describe("direction", "[x, y, z]", "none; required in a beam");
        reader_.describe("vertical_half_angle_deg", "number, 0.5 to 85", "`half_angle_deg`");
        const std::optional<Vec3d> forward = directed ? std::nullopt : std::optional(Vec3d(1, 0, 0));
        aim(reader_.vector("direction", forward));
        const double across = reader_.angle_rad("half_angle", 60.0, half_angles);
        const double upward = reader_.angle_rad("vertical_half_angle", degrees(across), half_angles);
        point.across = steepness(across);
        point.upward = steepness(upward);
    }

    /// The side of a beam is level; that of one straight up or down is y.
    void aim(const Vec3d& direction) {
        if (glm::length(direction) < 1e-9) {
            if (reader_.has("direction"))
                reader_.error_at("direction", "the direction has no length; expected a vector");
            return;
        }
        const Vec3d forward = glm::normalize(direction);
        const Vec3d level(-forward.y, forward.x, 0.0);
        light_.point.direction = Vec3f(forward);
        light_.point.side = Vec3f(glm::length(level) < 1e-6 ? Vec3d(0, 1, 0) : glm::normalize(level));
    }

    static float steepness(double half_angle_rad) {
        const double slope = tangent(half_angle_rad);
        return static_cast<float>(1.0 / (slope * slope));
    }

    void read_strength() {
        LightPoint& point = light_.point;
        point.intensity = static_cast<float>(reader_.number("intensity", 2.0, {0.001, 1000.0}));
        point.size_m = static_cast<float>(reader_.length_m("size", 0.0, {0.0, 1000.0}));
        point.full_to_m = static_cast<float>(reader_.length_m("full_to", 1000.0, {1.0, 1e6}));
        point.fall_off = static_cast<FallOff>(reader_.choice("fall_off", 1, {"flat", "linear", "square"}));
    }

    void read_flash() {
        LightPoint& point = light_.point;
        point.flash_hz = static_cast<float>(reader_.number("flash_hz", 0.0, {0.0, 30.0}));
        point.duty = static_cast<float>(reader_.number("duty", 0.5, {0.0, 1.0}));
        point.phase = static_cast<float>(reader_.number("phase", 0.0, {0.0, 1.0}));
    }

    static constexpr Range half_angles{0.5, 85.0};
    const Reading& reading_;
    TableReader reader_;
    ModelLight light_;
};

} // namespace

void read_lights(TableReader& object_reader, std::uint16_t file, const Reading& reading,
                 std::optional<std::uint16_t> inherited, ModelObject& object) {
    for (const toml::table* table : object_reader.tables("light"))
        LightReader(*table, "light", object_reader, file, reading, inherited).read_one(object);
    for (const toml::table* table : object_reader.tables("light_string"))
        LightReader(*table, "light_string", object_reader, file, reading, inherited).read_string(object);
}

} // namespace linkdig::database
