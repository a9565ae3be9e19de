#pragma once
/// A panel that is not there: umockdev answers for it wherever libusb asks the kernel, so that the real libusb and the real link
/// are what is tested.

#include "host/panel/layout.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::panel {

/// One testbed, while it lives. Needs libumockdev-preload.so.0 in LD_PRELOAD.
class MockBus {
public:
    MockBus();
    ~MockBus();
    MockBus(const MockBus&) = delete;
    MockBus& operator=(const MockBus&) = delete;

    struct State;
    State& state() { return *state_; }
    std::string root() const; ///< the testbed's folder

private:
    std::unique_ptr<State> state_;
};

struct MockDescription {
    PanelKind kind = PanelKind::switches;
    unsigned bus = 1;
    unsigned device = 4;
    std::string port = "4"; ///< behind the bus number: "4", or "1.4" behind a hub
    /// After the device descriptor, in hex; empty: one interface with endpoint 0x81 of 64 bytes.
    std::string configuration{};
    /// Answered within this process, where umockdev's sockets are too slow: on a busy machine they carry some hundred reports a second.
    bool direct = false;
    bool answers_state = true; ///< to HID's GET_REPORT; else it stalls
};

class MockPanel {
public:
    /// Plugged in.
    MockPanel(MockBus& bus, MockDescription description);
    ~MockPanel();
    MockPanel(const MockPanel&) = delete;
    MockPanel& operator=(const MockPanel&) = delete;

    void unplug();
    void plug();

    /// Bits as in a report; sent at once, as a panel does, and from then on how it stands.
    void send(std::uint32_t bits);
    void send_bytes(const std::vector<std::uint8_t>& bytes);
    /// So many reports, each other bits than the one before, and at last these.
    void flood(std::uint64_t reports, std::uint32_t last_bits);
    /// The next transfers for reports end with this negative errno instead of a report.
    void fail_reports(int error, int times);
    /// Feature reports end with this negative errno; 0: they are taken again.
    void fail_features(int error);

    /// How the panel stands, for GET_REPORT, without sending it.
    void stand(std::uint32_t bits);

    std::vector<std::uint8_t> feature() const;                   ///< last one taken; empty: none
    std::vector<std::vector<std::uint8_t>> all_features() const; ///< that were taken, in order
    std::uint64_t features() const;
    std::uint64_t feature_attempts() const;
    std::uint64_t waiting() const;       ///< reports not yet fetched
    std::uint64_t reports_asked() const; ///< transfers for reports so far
    bool claimed() const;
    std::string node() const; ///< the device's file

    struct State;

private:
    MockBus& bus_;
    MockDescription description_;
    std::shared_ptr<State> state_;
    bool plugged_ = false;
};

} // namespace linkdig::panel
