// The link to the panels: the real libusb, and umockdev for the kernel behind it.

#include "tests/panel/bus_test.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <thread>
#include <unistd.h>

namespace linkdig::panel {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// Takes down what the link calls.
class Listener final : public PanelUser {
public:
    void attached(const PanelPlace& place) override { note("attached " + name_of(place)); }
    void detached(const PanelPlace& place) override { note("detached " + name_of(place)); }
    void report(const PanelPlace& place, std::span<const std::uint8_t> bytes, ReportSource source,
                double /*now_s*/) override {
        std::string text = source == ReportSource::asked ? "state" : "report";
        for (const std::uint8_t byte : bytes)
            text += fmt::format(" {:02x}", byte);
        note(text + " " + name_of(place));
    }
    void turn(double /*now_s*/) override {}
    std::vector<std::uint8_t> wanted(const PanelPlace& /*place*/) override {
        const std::lock_guard lock(mutex_);
        return wanted_;
    }

    void want(std::vector<std::uint8_t> bytes) {
        const std::lock_guard lock(mutex_);
        wanted_ = std::move(bytes);
    }
    Tell tell() { return told_.tell(); }
    std::vector<std::string> told() const { return told_.all(); }
    std::vector<std::string> heard() const { return heard_.all(); }
    bool has_heard(const std::string& text, std::ptrdiff_t times = 1) const {
        return std::ranges::count(heard(), text) >= times;
    }
    bool was_told(const std::string& part) const {
        return std::ranges::any_of(
            told(), [&](const std::string& each) { return each.find(part) != std::string::npos; });
    }

private:
    void note(std::string text) { heard_.add(std::move(text)); }
    Words heard_;
    Words told_;
    mutable std::mutex mutex_;
    std::vector<std::uint8_t> wanted_;
};

class Link : public testing::Test {
protected:
    MockBus bus_;
    Listener listener_;
};

std::string report_of(std::uint32_t bits, const std::string& place, const char* word = "report") {
    return fmt::format("{} {:02x} {:02x} {:02x} {}", word, bits & 0xffU, bits >> 8U & 0xffU, bits >> 16U,
                       place);
}

TEST_F(Link, EveryBitOfEveryPanelComesIn) {
    for (const PanelKind kind : {PanelKind::switches, PanelKind::multi, PanelKind::radio}) {
        MockPanel panel(bus_, {.kind = kind});
        Listener listener;
        const PanelLink link(listener, listener.tell());
        const std::string place = name_of({kind, "1-4"});
        ASSERT_TRUE(until([&] { return listener.has_heard("attached " + place); }));
        for (std::size_t bit = 0; bit < report_bits; ++bit)
            panel.send(1U << bit);
        for (std::size_t bit = 0; bit < report_bits; ++bit)
            EXPECT_TRUE(until([&] { return listener.has_heard(report_of(1U << bit, place)); }))
                << place << bit;
        EXPECT_EQ(link.counts().reports, report_bits);
    }
}

TEST_F(Link, TheStateIsAskedForWhenAPanelComes) {
    MockPanel panel(bus_, {});
    panel.stand(0x040083);
    const PanelLink link(listener_, listener_.tell());
    EXPECT_TRUE(
        until([&] { return listener_.has_heard(report_of(0x040083, "switch panel at 1-4", "state")); }));
}

TEST_F(Link, APanelThatDoesNotTellItsStateIsTakenAllTheSame) {
    MockPanel panel(bus_, {.answers_state = false});
    const PanelLink link(listener_, listener_.tell());
    listener_.want({0x07});
    ASSERT_TRUE(until([&] { return panel.features() == 1; }));
    panel.send(0x000001);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(1, "switch panel at 1-4")); }));
    EXPECT_THAT(listener_.told(), testing::IsEmpty());
}

TEST_F(Link, FeatureReportsGoOutWhenTheyChange) {
    MockPanel panel(bus_, {.kind = PanelKind::radio});
    {
        const PanelLink link(listener_, listener_.tell());
        std::vector<std::uint8_t> bytes(22, 0x0f);
        bytes[3] = 0xd4;
        listener_.want(bytes);
        ASSERT_TRUE(until([&] { return panel.feature() == bytes; }));
        std::this_thread::sleep_for(100ms);
        EXPECT_EQ(panel.features(), 1U) << "the same bytes are sent once";
        bytes[4] = 0x09;
        listener_.want(bytes);
        ASSERT_TRUE(until([&] { return panel.feature() == bytes; }));
        EXPECT_EQ(panel.features(), 2U);
    }
    const auto dark = layout_of(PanelKind::radio).dark;
    EXPECT_EQ(panel.feature(), std::vector<std::uint8_t>(dark.begin(), dark.end())) << "left dark";
    EXPECT_FALSE(panel.claimed());
}

TEST_F(Link, AFailingFeatureReportIsToldOnceAndTriedAgain) {
    MockPanel panel(bus_, {});
    panel.fail_features(-EPIPE);
    const PanelLink link(listener_, listener_.tell());
    listener_.want({0x01});
    ASSERT_TRUE(until([&] { return link.counts().failed_features >= 2; }));
    EXPECT_THAT(listener_.told(), ElementsAre(HasSubstr("its lamps and displays cannot be set: it stalls")));
    panel.send(0x000002);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(2, "switch panel at 1-4")); }))
        << "reports come in all the while";
    panel.fail_features(0);
    EXPECT_TRUE(until([&] { return panel.feature() == std::vector<std::uint8_t>{0x01}; }));
    EXPECT_EQ(listener_.told().size(), 1U);
}

TEST_F(Link, UnpluggedAndPluggedInAgain) {
    MockPanel panel(bus_, {});
    const PanelLink link(listener_, listener_.tell());
    listener_.want({0x2a});
    ASSERT_TRUE(until([&] { return panel.features() == 1; }));
    for (int round = 1; round <= 3; ++round) {
        panel.unplug();
        ASSERT_TRUE(until([&] { return listener_.has_heard("detached switch panel at 1-4", round); }))
            << round;
        panel.stand(1U << round);
        panel.plug();
        ASSERT_TRUE(until([&] { return listener_.has_heard("attached switch panel at 1-4", round + 1); }))
            << round;
        EXPECT_TRUE(until(
            [&] { return listener_.has_heard(report_of(1U << round, "switch panel at 1-4", "state")); }));
        EXPECT_TRUE(until([&] { return panel.features() == static_cast<std::uint64_t>(round) + 1; }))
            << "lit again as it was";
        panel.send(0x000100);
        EXPECT_TRUE(
            until([&] { return listener_.has_heard(report_of(0x100, "switch panel at 1-4"), round); }));
    }
    EXPECT_THAT(listener_.told(), testing::IsEmpty());
}

TEST_F(Link, PluggedInWhileTheLinkRuns) {
    const PanelLink link(listener_, listener_.tell());
    std::this_thread::sleep_for(20ms);
    MockPanel panel(bus_, {.kind = PanelKind::multi, .device = 9});
    ASSERT_TRUE(until([&] { return listener_.has_heard("attached multi panel at 1-4"); }));
    panel.send(0x000020);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(0x20, "multi panel at 1-4")); }));
}

TEST_F(Link, TwoOfAKindAreToldApartByTheirPorts) {
    MockPanel left(bus_, {.device = 4, .port = "4"});
    MockPanel right(bus_, {.device = 5, .port = "1"});
    const PanelLink link(listener_, listener_.tell());
    ASSERT_TRUE(until([&] {
        return listener_.has_heard("attached switch panel at 1-4") &&
               listener_.has_heard("attached switch panel at 1-1");
    }));
    left.send(0x000001);
    right.send(0x000002);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(1, "switch panel at 1-4")); }));
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(2, "switch panel at 1-1")); }));
    left.unplug();
    ASSERT_TRUE(until([&] { return listener_.has_heard("detached switch panel at 1-4"); }));
    right.send(0x000008);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(8, "switch panel at 1-1")); }));
    const std::vector<FoundPanel> found = find_panels();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(name_of(found[0].place), "switch panel at 1-1");
    EXPECT_EQ(found[0].trouble, "");
}

TEST_F(Link, WrongDescriptorsAreLeftAlone) {
    struct Case {
        const char* configuration;
        const char* says;
    };
    const Case cases[] = {
        // no endpoint at all; an endpoint away from us; a bulk one; packets of two bytes
        {"09021200010100803209040000000300000009211101000122", "name no interrupt endpoint"},
        {"090222000101008032090400000103000000092111010001223500070501034000"
         "0a",
         "name no interrupt endpoint"},
        {"090222000101008032090400000103000000092111010001223500070581024000"
         "0a",
         "name no interrupt endpoint"},
        {"090222000101008032090400000103000000092111010001223500070581030200"
         "0a",
         "its packets hold 2 bytes"},
        // another configuration than the one that the kernel has chosen
        {"090222000102008032090400000103000000092111010001223500070581034000"
         "0a",
         "its descriptors cannot be read"},
    };
    for (const Case& each : cases) {
        MockPanel panel(bus_, {.configuration = each.configuration});
        Listener listener;
        const PanelLink link(listener, listener.tell());
        MockPanel sound(bus_, {.device = 7, .port = "2"});
        ASSERT_TRUE(until([&] { return listener.has_heard("attached switch panel at 1-2"); }));
        ASSERT_TRUE(until([&] { return listener.was_told(each.says); })) << each.says;
        EXPECT_FALSE(panel.claimed());
        EXPECT_EQ(listener.told().size(), 1U);
        const std::vector<FoundPanel> found = find_panels();
        ASSERT_EQ(found.size(), 2U);
        EXPECT_THAT(found[1].trouble, HasSubstr(each.says));
    }
}

TEST_F(Link, CutDescriptorsHoldUpNoOtherPanel) {
    for (const char* cut : {"09", "0902ff", "0902220001010080320904000001", "090209000101008032"}) {
        MockPanel panel(bus_, {.configuration = cut});
        MockPanel sound(bus_, {.device = 7, .port = "2"});
        Listener listener;
        const PanelLink link(listener, listener.tell());
        EXPECT_TRUE(until([&] { return listener.has_heard("attached switch panel at 1-2"); })) << cut;
        EXPECT_FALSE(panel.claimed()) << cut;
    }
}

TEST_F(Link, OtherEndpointsAndPacketSizesAreReadFromTheDevice) {
    // interface 1, endpoint 0x83 of 8 bytes
    MockPanel panel(
        bus_, {.configuration = "0902220001010080320904010001030000000921110100012235000705830308000a"});
    const PanelLink link(listener_, listener_.tell());
    ASSERT_TRUE(until([&] { return listener_.has_heard("attached switch panel at 1-4"); }));
    panel.send(0x000004);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(4, "switch panel at 1-4")); }));
    panel.send_bytes(std::vector<std::uint8_t>(9, 0xff));
    EXPECT_TRUE(until([&] { return listener_.was_told("it sends more than its packet size"); }));
    panel.send(0x000010);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(0x10, "switch panel at 1-4")); }));
}

/// Nobody in particular, while it lives; root could open everything.
class AsNobody {
public:
    AsNobody() : root_(geteuid() == 0) {
        if (root_) changed_ = seteuid(65534) == 0;
    }
    ~AsNobody() {
        if (changed_) changed_ = seteuid(0) != 0;
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;
    bool powerless() const { return !root_ || changed_; }

private:
    bool root_;
    bool changed_ = false;
};

TEST_F(Link, WithoutPermissionTheMessageNamesTheRule) {
    namespace fs = std::filesystem;
    MockPanel panel(bus_, {});
    const std::string file = bus_.root() + panel.node();
    fs::permissions(bus_.root(), fs::perms::all); // umockdev's own sockets are open to all
    fs::permissions(bus_.root() + "/ioctl" + panel.node(), fs::perms::all);
    fs::permissions(file, fs::perms::none);
    {
        const AsNobody nobody;
        if (!nobody.powerless()) GTEST_SKIP() << "this user may open everything";
        const std::vector<FoundPanel> found = find_panels();
        ASSERT_EQ(found.size(), 1U);
        EXPECT_THAT(found[0].trouble,
                    HasSubstr("no permission to open it; tools/panel_permission.sh installs"));
        EXPECT_THAT(found[0].trouble, HasSubstr(permission_rule));
        const PanelLink link(listener_, listener_.tell());
        ASSERT_TRUE(until([&] { return !listener_.told().empty(); }));
        std::this_thread::sleep_for(1200ms); // it tries again, and says nothing new
        EXPECT_THAT(listener_.told(), ElementsAre(HasSubstr("switch panel at 1-4: no permission")));
        EXPECT_THAT(listener_.heard(), testing::IsEmpty());
    }
    const PanelLink link(listener_, listener_.tell());
    fs::permissions(file, fs::perms::owner_all);
    EXPECT_TRUE(until([&] { return listener_.has_heard("attached switch panel at 1-4"); }))
        << "once it is given";
}

TEST_F(Link, FailingReportsAreToldOnceAndAskedAgain) {
    MockPanel panel(bus_, {});
    panel.fail_reports(-EPIPE, 6);
    const PanelLink link(listener_, listener_.tell());
    ASSERT_TRUE(until([&] { return link.counts().failed_reports == 6; }));
    panel.send(0x000040);
    EXPECT_TRUE(until([&] { return listener_.has_heard(report_of(0x40, "switch panel at 1-4")); }));
    EXPECT_THAT(listener_.told(), ElementsAre(HasSubstr("a report failed: it stalls")));
}

} // namespace
} // namespace linkdig::panel
