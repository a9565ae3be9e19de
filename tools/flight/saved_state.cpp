#include "tools/flight/saved_state.h"

#include "host/packet/recording.h"
#include "tools/flight/bad_input.h"

#include <fmt/format.h>

namespace linkdig::tools {

void save_state(const std::string& path, const Flight& flight, const std::vector<std::uint8_t>& history) {
    RecordingWriter file(path, flight.recording_header(), history);
    file.write(flight.packet());
    file.close();
}

SavedState load_state(const std::string& path, std::uint64_t database_id) {
    SavedState state;
    try {
        RecordingReader file(path);
        if (!file.next(state.packet))
            throw BadInput(fmt::format("linkdig: error: {}: holds no packet; expected a saved state", path));
        state.history = file.history();
    } catch (const BadInput&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw BadInput(std::string("linkdig: error: ") + error.what());
    }
    if (state.packet.database_id != database_id)
        throw BadInput(
            fmt::format("linkdig: error: {}: was saved with database {:016x}; the scenario's is {:016x}",
                        path, state.packet.database_id, database_id));
    return state;
}

} // namespace linkdig::tools
