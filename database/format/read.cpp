#include "database/format/read.h"

#include "database/format/file_header.h"
#include "database/format/large_pages.h"
#include "database/format/stored_records.h"
#include "database/format/validate.h"

#include <fmt/format.h>

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

namespace linkdig::database {

namespace {

namespace fs = std::filesystem;

/// Largest alignment that a stored number asks for (double).
constexpr std::size_t alignment = 8;

ReadResult refused(std::string why) { return {.database = {}, .id = 0, .error = std::move(why)}; }

using StoredNames = flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>;

/// Copies out of a verified payload. Collects the first reason to refuse what the verifier lets pass.
class Copier {
public:
    explicit Copier(std::uint64_t payload_bytes) : name_bytes_left_(payload_bytes) {}

    template <typename Record, typename Stored>
    void records(const flatbuffers::Vector<const Stored*>& from, std::vector<Record>& to, const char* what) {
        // FlatBuffers 2.0.8 verifies that a vector's length is aligned, not that its elements are.
        if (from.size() != 0 && reinterpret_cast<std::uintptr_t>(from.Data()) % alignof(Stored) != 0)
            return refuse(fmt::format("damaged: {} are not aligned", what));
        to.reserve(from.size());
        prefer_large_pages(to.data(), from.size() * sizeof(Record));
        for (flatbuffers::uoffset_t i = 0; i < from.size(); ++i)
            to.push_back(from_stored(*from.Get(i)));
    }

    void numbers(const flatbuffers::Vector<std::uint32_t>& from, std::vector<std::uint32_t>& to) {
        to.reserve(from.size());
        prefer_large_pages(to.data(), from.size() * sizeof(std::uint32_t));
        to.assign(from.begin(), from.end());
    }

    void name(const flatbuffers::String& from, std::string& to, const char* what) {
        // Many names may point at one string: a small file must not unfold into more text than its own size.
        if (from.size() > name_bytes_left_)
            return refuse(fmt::format("damaged: {} share their characters", what));
        name_bytes_left_ -= from.size();
        to = from.str();
    }

    void names(const StoredNames& from, std::vector<std::string>& to, const char* what) {
        to.resize(from.size());
        for (flatbuffers::uoffset_t i = 0; i < from.size() && error_.empty(); ++i)
            name(*from.Get(i), to[i], what);
    }

    template <typename Record>
    void names_of(const StoredNames& from, std::vector<Record>& to, const char* what) {
        if (from.size() != to.size())
            return refuse(fmt::format("damaged: {} {}, but {} names for them", to.size(), what, from.size()));
        for (flatbuffers::uoffset_t i = 0; i < from.size() && error_.empty(); ++i)
            name(*from.Get(i), to[i].name, what);
    }

    void refuse(std::string why) {
        if (error_.empty()) error_ = std::move(why);
    }
    const std::string& error() const { return error_; }

private:
    std::uint64_t name_bytes_left_;
    std::string error_;
};

void copy_named(const stored::VisualDatabase& from, VisualDatabase& to, Copier& copier) {
    copier.name(*from.name(), to.name, "name");
    copier.names(*from.source_files(), to.source_files, "source_files");
    copier.names(*from.colour_names(), to.colour_names, "colour_names");
    copier.names(*from.suns(), to.suns, "suns");
    copier.names(*from.moving_objects(), to.moving_objects, "moving_objects");
    for (const std::uint32_t alternatives : *from.slot_alternatives())
        to.slots.push_back({.name = {}, .alternatives = alternatives});
    copier.names_of(*from.slot_names(), to.slots, "slots");
    copier.records(*from.details(), to.details, "details");
    copier.names_of(*from.detail_names(), to.details, "details");
    copier.records(*from.clusters(), to.clusters, "clusters");
    copier.names_of(*from.cluster_names(), to.clusters, "clusters");
    copier.records(*from.lists(), to.lists, "lists");
    copier.names_of(*from.list_names(), to.lists, "lists");
    copier.records(*from.objects(), to.objects, "objects");
    copier.names_of(*from.object_names(), to.objects, "objects");
}

/// The numerous ones, side by side: most of the time goes into pages that are touched for the first time.
void copy_numerous(const stored::VisualDatabase& from, VisualDatabase& to, Copier& copier) {
    std::array<Copier, 6> copiers{Copier(0), Copier(0), Copier(0),
                                  Copier(0), Copier(0), Copier(0)}; // no names
    tbb::parallel_invoke([&] { copiers[0].records(*from.faces(), to.faces, "faces"); },
                         [&] { copiers[1].records(*from.vertices(), to.vertices, "vertices"); },
                         [&] { copiers[2].records(*from.planes(), to.planes, "planes"); },
                         [&] { copiers[3].records(*from.runs(), to.runs, "runs"); },
                         [&] { copiers[4].records(*from.run_leaves(), to.run_leaves, "run_leaves"); },
                         [&] { copiers[5].numbers(*from.corners(), to.corners); });
    for (const Copier& each : copiers)
        if (!each.error().empty()) copier.refuse(each.error());
}

void copy_unnamed(const stored::VisualDatabase& from, VisualDatabase& to, Copier& copier) {
    copier.records(*from.colours(), to.colours, "colours");
    copier.records(*from.detail_levels(), to.detail_levels, "detail_levels");
    copier.records(*from.groups(), to.groups, "groups");
    copy_numerous(from, to, copier);
    copier.records(*from.corner_colours(), to.corner_colours, "corner_colours");
    copier.records(*from.lights(), to.lights, "lights");
    copier.records(*from.tiles(), to.tiles, "tiles");
    copier.records(*from.tile_normals(), to.tile_normals, "tile_normals");
}

/// `payload` is aligned.
ReadResult decode_payload(std::span<const std::uint8_t> payload) {
    if (payload.size() > max_payload_bytes)
        return refused(fmt::format("too large: {} bytes", payload.size()));
    flatbuffers::Verifier verifier(payload.data(), payload.size());
    if (payload.size() < 2 * sizeof(flatbuffers::uoffset_t) || !stored::VerifyVisualDatabaseBuffer(verifier))
        return refused("damaged: the FlatBuffers verifier refuses it");
    const stored::VisualDatabase& root = *stored::GetVisualDatabase(payload.data());
    ReadResult result{.database = VisualDatabase{}, .id = 0, .error = {}};
    Copier copier(payload.size());
    copy_named(root, *result.database, copier);
    copy_unnamed(root, *result.database, copier);
    if (!copier.error().empty()) return refused(copier.error());
    if (std::string unsound = validate(*result.database); !unsound.empty())
        return refused("not sound: " + unsound);
    return result;
}

/// A whole file in memory that nobody has filled with zeros first.
struct FileBytes {
    LargeBytes data;
    std::size_t size = 0;
};

/// An open file, closed with its owner.
struct OpenFile {
    int descriptor;
    explicit OpenFile(const std::string& path) : descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~OpenFile() {
        if (descriptor >= 0) close(descriptor);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
};

/// From `begin` on, all `bytes`; false if the file ends before, or cannot be read.
bool read_part(int descriptor, std::uint8_t* to, std::size_t begin, std::size_t bytes) {
    while (bytes != 0) {
        const ssize_t got = pread(descriptor, to + begin, bytes, static_cast<off_t>(begin));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        begin += static_cast<std::size_t>(got);
        bytes -= static_cast<std::size_t>(got);
    }
    return true;
}

/// In parts, side by side.
bool read_all(int descriptor, const FileBytes& bytes) {
    constexpr std::size_t part = std::size_t{4} << 20U;
    std::atomic<bool> whole = true;
    tbb::parallel_for(std::size_t{0}, (bytes.size + part - 1) / part, [&](std::size_t i) {
        if (!read_part(descriptor, bytes.data.get(), i * part, std::min(part, bytes.size - i * part)))
            whole = false;
    });
    return whole;
}

/// Empty and `error` set if the file cannot be read.
FileBytes read_file(const std::string& path, std::string& error) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found) {
        error = "there is no such file";
    } else if (code) {
        error = code.message();
    } else if (status.type() == fs::file_type::directory) {
        error = "it is a directory";
    } else if (status.type() != fs::file_type::regular) {
        error = "it is not a regular file"; // opening a pipe would wait for ever
    }
    if (!error.empty()) return {};
    const OpenFile file(path);
    if (file.descriptor < 0) {
        error = std::generic_category().message(errno);
        return {};
    }
    const std::uint64_t size = fs::file_size(path, code);
    if (code || size > header_bytes + max_payload_bytes) {
        error = code ? code.message() : fmt::format("too large: {} bytes", size);
        return {};
    }
    FileBytes bytes{large_bytes(size), size};
    if (!read_all(file.descriptor, bytes)) error = "it became shorter while it was read";
    return bytes;
}

} // namespace

ReadResult decode_database(std::span<const std::uint8_t> file) {
    if (std::string reason = check_header(file); !reason.empty()) return refused(std::move(reason));
    const std::span<const std::uint8_t> payload = file.subspan(header_bytes);
    std::vector<std::uint8_t> aligned;
    if (reinterpret_cast<std::uintptr_t>(payload.data()) % alignment != 0)
        aligned.assign(payload.begin(), payload.end());
    // Hashed while it is decoded, which takes any bytes; but whatever that finds, a wrong hash is what is told.
    std::uint64_t id = 0;
    std::string damaged;
    ReadResult result;
    tbb::parallel_invoke([&] { damaged = check_hash(file, id); },
                         [&] { result = decode_payload(aligned.empty() ? payload : aligned); });
    if (!damaged.empty()) return refused(std::move(damaged));
    result.id = result.database ? id : 0;
    return result;
}

ReadResult read_database(const std::string& path) {
    std::string error;
    const FileBytes file = read_file(path, error);
    ReadResult result =
        error.empty() ? decode_database(std::span(file.data.get(), file.size)) : refused(error);
    if (!result.error.empty())
        result.error = fmt::format("{}: cannot be read as a visual database: {}", path, result.error);
    return result;
}

} // namespace linkdig::database
