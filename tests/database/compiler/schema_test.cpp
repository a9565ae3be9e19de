/// The reference is what the readers ask for: complete, described, and the same as the committed page.

#include "database/compiler/schema.h"
#include "database/text/key_words.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace linkdig::database {
namespace {

using KeysOfTables = std::map<std::string, std::set<std::string>>;

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

KeysOfTables keys_of_schema() {
    KeysOfTables keys;
    for (const TableUse& table : schema())
        for (const KeyUse& use : table.keys)
            keys[table.table].insert(use.key);
    return keys;
}

TEST(Schema, TheCommittedReferenceIsWhatTheCompilerPrints) {
    EXPECT_EQ(bytes_of(LINKDIG_SOURCE_DIR "/docs/authoring-reference.md"), schema_markdown())
        << "linkdig compile --schema > docs/authoring-reference.md";
}

TEST(Schema, EveryKeyIsDescribed) {
    for (const TableUse& table : schema())
        for (const KeyUse& use : table.keys)
            EXPECT_NE(use.value, undescribed) << table.table << " " << use.key;
}

TEST(Schema, TheGuideNamesEveryTableAndKey) {
    const std::string guide = bytes_of(LINKDIG_SOURCE_DIR "/docs/authoring.md");
    for (const auto& [table, keys] : keys_of_schema()) {
        if (table.find(' ') == std::string::npos) {
            EXPECT_THAT(guide, testing::HasSubstr(table));
        }
        for (const std::string& key : keys)
            EXPECT_THAT(guide, testing::HasSubstr(key)) << table;
    }
}

/// Keys of `table`, and those of its tables, whose kind is `name` in brackets.
void collect(const toml::table& table, const std::string& name, KeysOfTables& keys) {
    for (auto&& [key, node] : table) {
        const std::string inner = name + "." + std::string(key.str());
        const toml::array* array = node.as_array();
        keys[name].insert(std::string(key.str()));
        if (array == nullptr || array->empty() || !array->is_array_of_tables()) continue;
        for (const toml::node& each : *array)
            collect(*each.as_table(), inner, keys);
    }
}

/// Whatever the shipped databases write stands in the reference.
TEST(Schema, WhatTheShippedDatabasesWriteIsListed) {
    const KeysOfTables listed = keys_of_schema();
    KeysOfTables written;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(LINKDIG_SOURCE_DIR "/database/scenes")) {
        const std::string text = entry.path().extension() == ".toml" ? bytes_of(entry.path().string()) : "";
        if (text.empty() || text.find("[scenario]") != std::string::npos ||
            text.find("[[exception]]") != std::string::npos || text.find("[[swimmer]]") != std::string::npos)
            continue;
        const toml::table root = toml::parse(text);
        for (auto&& [kind, node] : root)
            if (const toml::array* tables = node.as_array();
                tables != nullptr && tables->is_array_of_tables())
                for (const toml::node& each : *tables)
                    collect(*each.as_table(), std::string(kind.str()), written);
    }
    EXPECT_GT(written.size(), 20U);
    for (const auto& [table, keys] : written) {
        const auto found = listed.find("[[" + table + "]]");
        ASSERT_NE(found, listed.end()) << table;
        for (const std::string& key : keys) {
            const bool other_unit = is_other_unit(key, {found->second.begin(), found->second.end()});
            EXPECT_TRUE(found->second.contains(key) || other_unit) << table << " " << key;
        }
    }
}

} // namespace
} // namespace linkdig::database
