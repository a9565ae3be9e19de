#pragma once
/// How many reports of a panel count.

namespace linkdig::panel {

/// Reports a second that are taken at their word. A full-speed interrupt endpoint is asked at most once a millisecond (USB 2.0,
/// 5.7.4), so a sound panel never reaches it.
inline constexpr double most_reports_per_s = 1000.0;

/// A bucket that fills at that rate and holds a tenth of a second's worth.
class ReportLimit {
public:
    /// Does the report that came at this time count? Beyond the limit switches are still followed, but presses and notches are
    /// not counted: a flood ends with every switch where it stands, and moves nothing else by more than the limit lets it.
    bool take(double now_s);

private:
    static constexpr double most = most_reports_per_s / 10.0;
    double left_ = most;
    double at_s_ = 0.0;
    bool begun_ = false;
};

} // namespace linkdig::panel
