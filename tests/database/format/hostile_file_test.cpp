// Files made to do harm: their hash fits and the FlatBuffers verifier passes them.

#include "database/format/file_header.h"
#include "database/format/read.h"
#include "database/format/visual_database_generated.h"
#include "database/format/write.h"
#include "tests/database/format/sample_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace linkdig::database {

namespace {

using flatbuffers::Offset;
using flatbuffers::String;
using Builder = flatbuffers::FlatBufferBuilder;
using testing::HasSubstr;

std::vector<std::uint8_t> sealed(const Builder& builder) {
    std::vector<std::uint8_t> file(header_bytes + builder.GetSize());
    std::copy_n(builder.GetBufferPointer(), builder.GetSize(), file.begin() + header_bytes);
    seal_header(file);
    return file;
}

/// Offsets of an otherwise empty database, for a test to exchange some.
struct Parts {
    Offset<String> name;
    Offset<flatbuffers::Vector<Offset<String>>> strings;
    Offset<flatbuffers::Vector<const stored::ObjectList*>> lists;
    Offset<flatbuffers::Vector<Offset<String>>> list_names;
    Offset<flatbuffers::Vector<Offset<String>>> source_files;
};

std::vector<std::uint8_t> finished(Builder& builder, Parts parts) {
    const auto none_of = [&]<typename T>(T*) { return builder.CreateVectorOfStructs<T>(nullptr, 0); };
    const auto colours = none_of(static_cast<stored::Colour*>(nullptr));
    const auto details = none_of(static_cast<stored::Detail*>(nullptr));
    const auto levels = none_of(static_cast<stored::DetailLevel*>(nullptr));
    const auto groups = none_of(static_cast<stored::PriorityGroup*>(nullptr));
    const auto clusters = none_of(static_cast<stored::Cluster*>(nullptr));
    const auto objects = none_of(static_cast<stored::Object*>(nullptr));
    const auto planes = none_of(static_cast<stored::PlaneNode*>(nullptr));
    const auto leaves = none_of(static_cast<stored::RunLeaf*>(nullptr));
    const auto runs = none_of(static_cast<stored::FaceRun*>(nullptr));
    const auto faces = none_of(static_cast<stored::Face*>(nullptr));
    const auto vertices = none_of(static_cast<stored::Vertex*>(nullptr));
    const auto lights = none_of(static_cast<stored::LightPoint*>(nullptr));
    const auto tiles = none_of(static_cast<stored::RepeatedTile*>(nullptr));
    const auto normals = none_of(static_cast<stored::Vec3*>(nullptr));
    const auto numbers = builder.CreateVector(std::vector<std::uint32_t>{});
    const auto root = stored::CreateVisualDatabase(
        builder, parts.name, parts.source_files, colours, parts.strings, parts.strings, parts.strings,
        parts.strings, numbers, details, parts.strings, levels, groups, clusters, parts.strings, parts.lists,
        parts.list_names, objects, parts.strings, planes, leaves, runs, faces, numbers, colours, vertices,
        lights, tiles, normals);
    stored::FinishVisualDatabaseBuffer(builder, root);
    return sealed(builder);
}

Parts empty_parts(Builder& builder) {
    Parts parts;
    parts.name = builder.CreateString("hostile");
    parts.strings = builder.CreateVectorOfStrings(std::vector<std::string>{});
    parts.lists = builder.CreateVectorOfStructs<stored::ObjectList>(nullptr, 0);
    parts.list_names = parts.strings;
    parts.source_files = parts.strings;
    return parts;
}

TEST(HostileFile, TheEmptyOneIsRead) { // so that what the others are refused for is theirs alone
    Builder builder;
    const Parts parts = empty_parts(builder);
    const ReadResult read = decode_database(finished(builder, parts));
    ASSERT_TRUE(read.database) << read.error;
    EXPECT_EQ(read.database->name, "hostile");
}

// 4 MB that would unfold into 1 million copies of 100 kB: 100 GB.
TEST(HostileFile, NamesThatShareAStringDoNotUnfold) {
    Builder builder;
    Parts parts = empty_parts(builder);
    const Offset<String> shared = builder.CreateString(std::string(100'000, 'x'));
    parts.source_files = builder.CreateVector(std::vector<Offset<String>>(1'000'000, shared));
    EXPECT_EQ(decode_database(finished(builder, parts)).error,
              "damaged: source_files share their characters");
}

TEST(HostileFile, MissingNamesAreToldFrom) {
    Builder builder;
    Parts parts = empty_parts(builder);
    parts.lists = builder.CreateVectorOfStructs(std::vector<stored::ObjectList>(3));
    EXPECT_EQ(decode_database(finished(builder, parts)).error, "damaged: 3 lists, but 0 names for them");
}

// The verifier of FlatBuffers 2.0.8 aligns a vector's length only; a record with a double after it may stand
// askew.
TEST(HostileFile, RecordsAskewAreRefused) {
    int askew = 0;
    for (std::size_t padding = 0; padding < 2; ++padding) {
        Builder builder;
        Parts parts = empty_parts(builder);
        parts.list_names = builder.CreateVectorOfStrings(std::vector<std::string>{"list"});
        builder.CreateVectorOfStructs(
            std::vector<stored::Cluster>(1)); // makes the whole a multiple of 8 bytes
        builder.CreateVector(std::vector<std::uint32_t>(padding));
        std::vector<std::uint32_t> words(1 + sizeof(stored::ObjectList) / sizeof(std::uint32_t));
        const auto vector = builder.CreateVector(words);
        parts.lists = vector.o;
        std::vector<std::uint8_t> file = finished(builder, parts);
        // Its length counts words; as many lists would not fit. One does.
        const auto* root = stored::GetVisualDatabase(file.data() + header_bytes);
        const auto at =
            static_cast<std::size_t>(reinterpret_cast<const std::uint8_t*>(root->lists()) - file.data());
        file[at] = 1;
        seal_header(file);
        const ReadResult read = decode_database(file);
        EXPECT_FALSE(read.database);
        askew += read.error == "damaged: lists are not aligned" ? 1 : 0;
    }
    EXPECT_EQ(askew, 1); // of two neighbouring places one is aligned
}

TEST(HostileFile, AnotherFlatBufferIsRefused) {
    const std::vector<std::uint8_t> sound = encode_database(sample_database());
    std::vector<std::uint8_t> other = sound;
    other[header_bytes + 4] = 'X'; // of the file identifier
    seal_header(other);
    EXPECT_EQ(decode_database(other).error, "damaged: the FlatBuffers verifier refuses it");
    std::vector<std::uint8_t> nothing(header_bytes);
    seal_header(nothing);
    EXPECT_EQ(decode_database(nothing).error, "damaged: the FlatBuffers verifier refuses it");
}

} // namespace

} // namespace linkdig::database
