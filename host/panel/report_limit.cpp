#include "host/panel/report_limit.h"

#include <algorithm>

namespace linkdig::panel {

bool ReportLimit::take(double now_s) {
    if (begun_) left_ = std::min(most, left_ + std::max(0.0, now_s - at_s_) * most_reports_per_s);
    begun_ = true;
    at_s_ = now_s;
    if (left_ < 1.0) return false;
    left_ -= 1.0;
    return true;
}

} // namespace linkdig::panel
