#pragma once
/// A flight in a window, in real time.

#include "host/signals/indications.h"
#include "host/signals/signal_store.h"
#include "tools/display/retro_display.h"
#include "tools/flight/flight.h"
#include "tools/fly/effects.h"
#include "tools/fly/recordings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::tools {

class Window;

struct FlyRequest {
    std::uint64_t updates = 0;          ///< until so many updates have been shown; 0: no limit
    std::string record = "linkdig.rec"; ///< file of the first recording (recordings.h)
    bool record_all = false; ///< from the first frame to the last, whatever the signal `record` says
    std::string state = "linkdig.state";          ///< file of the keys that save and load
    bool panel = false;                           ///< begin with the figures shown
    host::SignalStore* signals = nullptr;         ///< that others write as well; none: the keys alone
    host::IndicationStore* indications = nullptr; ///< for those who show them
};

struct FlyResult {
    std::uint64_t updates = 0;  ///< pictures shown
    std::uint64_t overruns = 0; ///< updates left out because the one before took too long
    std::vector<Recorded> recordings{};
};

/// Flies until somebody quits, or until enough updates have been shown. Simulated time goes with the clock: an update that comes
/// too late is left out and counted, and delays none after it. After its last second the flight hovers on. A frozen picture is
/// drawn anew only when a control has changed something. While the
/// signal `record` is on, each frame drawn is recorded, with the signals.
/// `display`: shows the pictures field by field, at the rate of fields; none: as they are.
FlyResult fly(Flight& flight, Window& window, const FlyRequest& request, RetroDisplay* display = nullptr);

} // namespace linkdig::tools
