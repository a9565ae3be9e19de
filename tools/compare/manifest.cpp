#include "tools/compare/manifest.h"

#include "database/text/table_reader.h"
#include "tools/compare/read_picture.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <stdexcept>

namespace linkdig::compare {
namespace {

namespace fs = std::filesystem;
using database::TableReader;

/// Four whole numbers, the last two above 0.
std::optional<Rectangle> rectangle_of(const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 4) return std::nullopt;
    std::uint32_t numbers[4] = {};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto number = array->get(k)->value_exact<std::int64_t>();
        if (!number || *number < (k < 2 ? 0 : 1) || *number > 1'000'000) return std::nullopt;
        numbers[k] = static_cast<std::uint32_t>(*number);
    }
    return Rectangle{numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<Rectangle> rectangles(TableReader& reader, const char* key) {
    std::vector<Rectangle> found;
    const toml::node* node = reader.node(key);
    if (node == nullptr) return found;
    const toml::array* array = node->as_array();
    bool right = array != nullptr;
    for (std::size_t k = 0; right && k < array->size(); ++k) {
        const auto rectangle = rectangle_of(*array->get(k));
        right = rectangle.has_value();
        if (right) found.push_back(*rectangle);
    }
    if (!right)
        reader.error_at(
            key,
            fmt::format("{} is no list of rectangles; expected [[x, y, width, height], ...] in pixels", key));
    return found;
}

void read_background(TableReader& reader, Case& result) {
    const toml::node* node = reader.node("background");
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    std::array<double, 3> rgb{};
    bool right = array != nullptr && array->size() == 3;
    for (std::size_t k = 0; right && k < 3; ++k) {
        const auto level = array->get(k)->value<double>();
        right = level && *level >= 0.0 && *level <= 255.0;
        rgb[k] = level.value_or(0.0);
    }
    if (right)
        result.background = rgb;
    else
        reader.error_at("background", "background is no colour; expected [red, green, blue], 0 to 255 each");
}

/// Values that have a text form of their own on the command line.
template <class Parse>
void parse_at(TableReader& reader, const char* key, const Parse& parse) {
    try {
        parse();
    } catch (const std::invalid_argument& mistake) {
        reader.error_at(key, mistake.what());
    }
}

Case read_case(TableReader& reader, const fs::path& folder, const std::optional<Roots>& roots) {
    Case result;
    result.declared = true;
    result.name = reader.text("name");
    result.why = reader.text("why", "");
    const fs::path expected_root = roots ? fs::path(roots->expected) : folder;
    const fs::path actual_root = roots ? fs::path(roots->actual) : folder;
    result.expected = (expected_root / reader.text("expected", result.name)).string();
    result.actual = (actual_root / reader.text("actual", result.name)).string();
    if (result.expected == result.actual)
        reader.error_at(
            "actual",
            "expected and actual are the same; expected two paths, or two folders on the command line");
    parse_at(reader, "tolerance", [&] { result.tolerance = parse_tolerance(reader.texts("tolerance")); });
    parse_at(reader, "frames", [&] {
        if (const std::string frames = reader.text("frames", ""); !frames.empty())
            result.frames = tools::parse_frames(frames);
    });
    result.regions.include = rectangles(reader, "include");
    result.regions.ignore = rectangles(reader, "ignore");
    if (const std::string mask = reader.text("mask", ""); !mask.empty()) {
        ReadPicture read = read_picture((folder / mask).string());
        if (read.picture)
            result.regions.mask = std::move(read.picture);
        else
            reader.error_at("mask", read.error);
    }
    read_background(reader, result);
    reader.finish();
    return result;
}

} // namespace

std::vector<Case> read_manifest(const std::string& path, const std::optional<Roots>& roots) {
    database::Diagnostics diagnostics;
    std::vector<Case> cases;
    std::set<std::string> names;
    if (const auto document = database::parse_file(path, diagnostics)) {
        TableReader reader(document->root, path, "the manifest", diagnostics);
        const auto tables = reader.tables("case");
        if (tables.empty())
            diagnostics.error(reader.here(), "there is no case; expected at least one [[case]]");
        for (const toml::table* table : tables) {
            TableReader of_case(*table, path, "[[case]]", diagnostics);
            cases.push_back(read_case(of_case, fs::path(path).parent_path(), roots));
            if (!names.insert(cases.back().name).second)
                of_case.error_at("name", fmt::format("there are two cases '{}'; expected names of their own",
                                                     cases.back().name));
        }
        reader.finish();
    }
    if (diagnostics.any()) throw tools::BadInput(diagnostics.text());
    return cases;
}

} // namespace linkdig::compare
