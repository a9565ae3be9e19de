#include "tests/fuzz/seeds.h"

#include "database/format/write.h"
#include "host/packet/packet_json.h"
#include "tests/database/format/sample_database.h"
#include "tests/host/packet/sample_packet.h"

namespace linkdig::fuzz {
namespace {

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

} // namespace

std::vector<Bytes> packet_bytes_seeds() { return {encode_packet(sample_packet()), encode_packet({})}; }

std::vector<Bytes> packet_json_seeds() {
    return {bytes_of(to_json(sample_packet())), bytes_of(to_json({})), bytes_of("{\"frame\": 1}")};
}

std::vector<Bytes> database_seeds() {
    return {database::encode_database(database::sample_database()), database::encode_database({})};
}

} // namespace linkdig::fuzz
