#include "tools/compare/compare.h"

#include "tools/compare/details.h"
#include "tools/compare/load_pair.h"
#include "tools/flight/progress.h"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

namespace linkdig::compare {
namespace {

/// Frames that differ, the greatest change first: by its energy, which a pixel off by a level has little of.
bool is_worse(const FrameResult& a, const FrameResult& b) {
    const auto energy = [](const Difference& d) {
        return std::isfinite(d.rms) ? d.rms : 1e9 + static_cast<double>(d.differing);
    };
    return energy(a.difference) > energy(b.difference);
}

/// What stands in files is read again when it is needed.
FrameResult without_pictures(FrameResult frame) {
    if (!frame.expected_path.empty()) {
        frame.expected.reset();
        frame.expected_ids.reset();
    }
    if (!frame.actual_path.empty()) {
        frame.actual.reset();
        frame.actual_ids.reset();
    }
    return frame;
}

void look_closely(const Loader& loader, const Case& which, const Settings& settings, CaseResult& result) {
    std::size_t place = 0;
    for (FrameResult& frame : result.worst) {
        loader.restore(frame);
        add_details(which, settings, place++ == 0, frame);
    }
    if (!result.first) return;
    if (result.first->name == result.worst.front().name) {
        result.first->details = result.worst.front().details;
    } else {
        loader.restore(*result.first);
        add_details(which, settings, true, *result.first);
    }
}

/// Gathers the frames' results, in order.
class Gathering {
public:
    Gathering(const Case& which, const Settings& settings) : settings_(settings), declared_(which.tolerance) {
        result_.name = which.name;
        result_.why = which.why;
        wants_better_ = which.declared;
    }

    void take(FrameResult&& frame) {
        ++result_.counts[static_cast<std::size_t>(frame.verdict)];
        switch (frame.verdict) {
        case Verdict::missing:
            return result_.missing.push_back(frame.name);
        case Verdict::extra:
            return result_.extra.push_back(frame.name);
        case Verdict::unreadable:
        case Verdict::shape:
            return result_.failures.push_back(frame.message);
        default:
            take_measured(std::move(frame));
        }
    }

    CaseResult finish(PacketComparison packets) {
        if (wants_better_) result_.better = declared_.better();
        result_.packets = std::move(packets);
        return std::move(result_);
    }

private:
    void take_measured(FrameResult&& frame) {
        const Difference& d = frame.difference;
        result_.ignored += d.ignored;
        for (std::size_t k = 0; k < d.histogram.size(); ++k)
            result_.histogram[k] += d.histogram[k];
        if (!d.buckets.empty()) declared_.take(d.buckets);
        if (frame.verdict != Verdict::differs) return;
        if (!result_.first) result_.first = without_pictures(frame);
        auto& worst = result_.worst;
        const auto place = std::ranges::upper_bound(worst, frame, is_worse);
        if (place == worst.end() && worst.size() >= settings_.worst) return;
        worst.insert(place, without_pictures(std::move(frame)));
        if (worst.size() > settings_.worst) worst.pop_back();
    }

    const Settings& settings_;
    Declared declared_;
    bool wants_better_ = false;
    CaseResult result_;
};

/// Two frames' pictures a thread: memory does not grow with the sequences' length.
std::size_t pairs_under_way() {
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 1;
}

} // namespace

const char* verdict_text(Verdict verdict) {
    constexpr const char* texts[verdicts] = {"same",  "tolerated", "differs",   "missing",
                                             "extra", "shape",     "unreadable"};
    return texts[static_cast<std::size_t>(verdict)];
}

std::uint64_t CaseResult::frames() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : counts)
        sum += n;
    return sum;
}

int heavier(int a, int b) {
    constexpr std::array order{0, 1, 3, 4, 2};
    return std::ranges::find(order, a) > std::ranges::find(order, b) ? a : b;
}

int CaseResult::exit_code() const {
    if (count(Verdict::unreadable) > 0) return 2;
    if (count(Verdict::shape) > 0) return 4;
    if (count(Verdict::missing) + count(Verdict::extra) > 0) return 3;
    return count(Verdict::differs) > 0 || !better.empty() ? 1 : 0;
}

CaseResult compare_case(const Case& which, const Settings& settings, const EachFrame& each) {
    Loader loader(which, settings);
    Gathering gathering(which, settings);
    tools::Progress progress(settings.progress, loader.pairs());
    tbb::task_arena arena(settings.threads == 0 ? tbb::task_arena::automatic
                                                : static_cast<int>(settings.threads));
    std::uint64_t done = 0;
    using FramePointer = std::shared_ptr<FrameResult>;
    const auto loaded = [&](tbb::flow_control& control) -> FramePointer {
        // Isolated: a machine that waits for its last band must not start on another frame's measuring.
        FramePointer frame = tbb::this_task_arena::isolate([&] { return loader.next(); });
        if (!frame) control.stop();
        return frame;
    };
    const auto measured = [&](const FramePointer& frame) {
        loader.measure(*frame);
        return frame;
    };
    const auto taken = [&](const FramePointer& frame) {
        each(*frame);
        gathering.take(std::move(*frame));
        progress.at(++done);
    };
    using tbb::filter_mode;
    arena.execute([&] {
        tbb::parallel_pipeline(
            pairs_under_way(),
            tbb::make_filter<void, FramePointer>(filter_mode::serial_in_order, loaded) &
                tbb::make_filter<FramePointer, FramePointer>(filter_mode::parallel, measured) &
                tbb::make_filter<FramePointer, void>(filter_mode::serial_in_order, taken));
    });
    progress.finish();
    CaseResult result = gathering.finish(loader.packets());
    look_closely(loader, which, settings, result);
    return result;
}

} // namespace linkdig::compare
