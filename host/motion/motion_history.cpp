#include "host/motion/motion_history.h"

#include <algorithm>

namespace linkdig::host {

MotionHistory::Values MotionHistory::at(double time) const {
    if (values.empty()) return {};
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time_s, time) - time_s.begin());
    if (after == 0) return values.front();
    if (after == values.size()) return values.back();
    const double fraction = (time - time_s[after - 1]) / (time_s[after] - time_s[after - 1]);
    Values between{};
    for (std::size_t axis = 0; axis < axes; ++axis)
        between[axis] = values[after - 1][axis] + (values[after][axis] - values[after - 1][axis]) * fraction;
    return between;
}

} // namespace linkdig::host
