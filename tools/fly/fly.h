#pragma once
/// A flight in a window, in real time.

#include "tools/display/retro_display.h"
#include "tools/flight/flight.h"

#include <cstdint>
#include <string>

namespace linkdig::tools {

class Window;

struct FlyResult {
    std::uint64_t updates = 0;  ///< pictures shown
    std::uint64_t overruns = 0; ///< updates left out because the one before took too long
};

/// Flies until somebody quits, or until `updates` updates have been shown (0: no limit). After its last
/// second the flight hovers on. A frozen picture is drawn anew only when a key has changed something.
/// `display`: shows the pictures field by field, at the rate of fields; none: as they are.
FlyResult fly(Flight& flight, Window& window, std::uint64_t updates, RetroDisplay* display = nullptr);

} // namespace linkdig::tools
