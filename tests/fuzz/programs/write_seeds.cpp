// write_seeds FOLDER: the seeds as files, a folder per fuzzer.
#include "tests/fuzz/seeds.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

bool write(const std::filesystem::path& folder, const std::vector<linkdig::fuzz::Bytes>& seeds) {
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        std::ofstream file(folder / std::to_string(i), std::ios::binary);
        file.write(reinterpret_cast<const char*>(seeds[i].data()),
                   static_cast<std::streamsize>(seeds[i].size()));
        if (!file) return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: write_seeds FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const bool written = write(folder / "packet_bytes", linkdig::fuzz::packet_bytes_seeds()) &&
                         write(folder / "packet_json", linkdig::fuzz::packet_json_seeds()) &&
                         write(folder / "database_file", linkdig::fuzz::database_seeds());
    return written ? 0 : 3;
}
