// Damaged files: each is refused with a reason; if somebody made the hash fit, it is refused or harmless.

#include "database/compiler/compile.h"
#include "database/format/dump.h"
#include "database/format/file_header.h"
#include "database/format/read.h"
#include "database/format/validate.h"
#include "database/format/write.h"
#include "database/model/random.h"
#include "tests/database/format/sample_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace linkdig::database {

namespace {

using testing::HasSubstr;

using Bytes = std::vector<std::uint8_t>;

void expect_refused(std::span<const std::uint8_t> file, const std::string& what) {
    const ReadResult read = decode_database(file);
    EXPECT_FALSE(read.database) << what;
    EXPECT_FALSE(read.error.empty()) << what;
    EXPECT_EQ(read.id, 0U) << what;
}

TEST(Damage, EveryShorterFileIsRefused) {
    const Bytes file = encode_database(sample_database());
    for (std::size_t length = 0; length < file.size(); ++length) {
        const Bytes cut(file.begin(),
                        file.begin() + static_cast<std::ptrdiff_t>(length)); // so that reads past it show
        expect_refused(cut, std::to_string(length) + " bytes");
    }
    EXPECT_EQ(decode_database({}).error, "the file is empty");
    EXPECT_EQ(decode_database(std::span(file).first(31)).error,
              "cut short: 31 bytes, the header alone takes 32");
    EXPECT_THAT(decode_database(std::span(file).first(100)).error, HasSubstr("bytes, 68 are there"));
}

TEST(Damage, EveryFlippedBitIsRefused) {
    Bytes file = encode_database(sample_database());
    ASSERT_TRUE(decode_database(file).database);
    for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        file[bit / 8] ^= mask;
        expect_refused(file, "bit " + std::to_string(bit));
        file[bit / 8] ^= mask;
    }
    EXPECT_TRUE(decode_database(file).database);
}

TEST(Damage, BytesAfterTheEndAreRefused) {
    Bytes file = encode_database(sample_database());
    file.push_back(0);
    EXPECT_EQ(decode_database(file).error, "damaged: 1 bytes follow the end that the header gives");
}

TEST(Damage, AnotherVersionIsNamed) {
    Bytes file = encode_database(sample_database());
    file[8] = 9;
    EXPECT_EQ(decode_database(file).error, "format version 9; this program reads version " +
                                               std::to_string(format_version) + ": compile it anew");
}

TEST(Damage, IsTheSameOnDisk) {
    const TestFolder folder;
    Bytes file = encode_database(sample_database());
    file[file.size() / 2] ^= 0x10U;
    std::ofstream(folder.file("a.igdb"), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    EXPECT_THAT(read_database(folder.file("a.igdb")).error,
                HasSubstr("a.igdb: cannot be read as a visual database: "
                          "damaged: its contents hash to "));
}

/// Flips, overwrites, cuts or doubles some bytes of the payload.
void harm(Bytes& file, std::uint64_t seed) {
    std::uint64_t index = 0;
    const auto below = [&](std::uint64_t n) { return random_bits(seed, index++) % n; };
    const std::uint64_t wounds = 1 + below(4);
    for (std::uint64_t i = 0; i < wounds; ++i) {
        const std::size_t at = header_bytes + below(file.size() - header_bytes);
        switch (below(5)) {
        case 0:
            file[at] ^= static_cast<std::uint8_t>(1U << below(8));
            break;
        case 1:
            file[at] = static_cast<std::uint8_t>(below(256));
            break;
        case 2: // an extreme number, aligned as most are
            for (std::size_t k = at & ~std::size_t{3}, end = std::min(k + 4, file.size()); k < end; ++k)
                file[k] = seed % 2 == 0 ? 0xff : 0x7f;
            break;
        case 3: // another place's number
            for (std::size_t k = 0, from = header_bytes + below(file.size() - header_bytes);
                 k < 4 && at + k < file.size() && from + k < file.size(); ++k)
                file[at + k] = file[from + k];
            break;
        default:
            file.resize(std::max(header_bytes + 1, at));
        }
    }
}

TEST(Damage, WithTheHashRepairedIsRefusedOrHarmless) {
    const Bytes sound = encode_database(sample_database());
    int by_verifier = 0;
    int by_validation = 0;
    int read_anyway = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Bytes file = sound;
        harm(file, seed);
        seal_header(file);
        const ReadResult read = decode_database(file);
        if (read.database) {
            EXPECT_EQ(validate(*read.database), "") << seed;
            EXPECT_FALSE(dump_json(*read.database, read.id).empty() ||
                         dump_text(*read.database, read.id).empty());
            EXPECT_TRUE(decode_database(encode_database(*read.database)).database) << seed;
            ++read_anyway;
        } else {
            EXPECT_FALSE(read.error.empty()) << seed;
            by_verifier += read.error.find("verifier") != std::string::npos ? 1 : 0;
            by_validation += read.error.find("not sound") != std::string::npos ? 1 : 0;
        }
    }
    // All three ends are met, or the damage is too mild or too gross to tell anything.
    EXPECT_GT(by_verifier, 100);
    EXPECT_GT(by_validation, 100);
    EXPECT_GT(read_anyway, 100);
}

// Every single bit of the payload, with the hash repaired: whatever one wrong number can do.
TEST(Damage, EveryBitWithTheHashRepairedIsRefusedOrHarmless) {
    Bytes file = encode_database(sample_database());
    int refused = 0;
    for (std::size_t bit = 8 * header_bytes; bit < 8 * file.size(); ++bit) {
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        file[bit / 8] ^= mask;
        seal_header(file);
        const ReadResult read = decode_database(file);
        EXPECT_NE(read.database.has_value(), !read.error.empty()) << bit;
        refused += read.database ? 0 : 1;
        file[bit / 8] ^= mask;
    }
    EXPECT_GT(refused, 1000);
}

/// The same of a file that is shipped, lights, tile, planes and all: too many bits for each of them, so a seeded sample.
TEST(Damage, OfAShippedDatabaseToo) {
    const CompileResult compiled =
        compile_file(LINKDIG_SOURCE_DIR "/database/scenes/runway_lights/runway_lights.toml");
    ASSERT_TRUE(compiled.database);
    Bytes file = encode_database(*compiled.database);
    constexpr std::uint64_t sample = 2000, seed = 9;
    int refused = 0, read_anyway = 0;
    for (std::uint64_t i = 0; i < sample; ++i) {
        const std::size_t bit = random_bits(seed, i) % (8 * file.size());
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        file[bit / 8] ^= mask;
        expect_refused(file, "bit " + std::to_string(bit));
        if (bit / 8 >= header_bytes) { // the header's own words are checked one by one, above
            Bytes sealed = file;
            seal_header(sealed);
            const ReadResult read = decode_database(sealed);
            EXPECT_NE(read.database.has_value(), !read.error.empty()) << bit;
            ++(read.database ? read_anyway : refused);
        }
        file[bit / 8] ^= mask;
        const std::size_t length = random_bits(seed + 1, i) % file.size();
        expect_refused(std::span(file).first(length), std::to_string(length) + " bytes");
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(read_anyway, 100);
    EXPECT_TRUE(decode_database(file).database);
}

} // namespace

} // namespace linkdig::database
