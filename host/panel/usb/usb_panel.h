#pragma once
/// One panel on the bus: opened, asked, lit and closed again, all on the link's thread and by asynchronous transfers.

#include "host/panel/panel_link.h"

#include <libusb.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace linkdig::panel {

/// Where a device sends its reports.
struct ReportEndpoint {
    std::uint8_t interface = 0;
    std::uint8_t address = 0;
    std::size_t packet_bytes = 0; ///< the most that one transfer brings
};

/// The first interrupt endpoint towards us whose packets hold a report; nothing, and why, where there is none.
std::optional<ReportEndpoint> find_endpoint(libusb_device* device, std::string& trouble);

/// The panel's place, if the device is one.
std::optional<PanelPlace> place_of(libusb_device* device);

/// What libusb's error means for somebody who wants to use the panel.
std::string words_of(int error);

/// Of all panels; read by any thread.
struct Counters {
    std::atomic<std::uint64_t> reports{0};
    std::atomic<std::uint64_t> failed_reports{0};
    std::atomic<std::uint64_t> features{0};
    std::atomic<std::uint64_t> failed_features{0};
};

/// What panels share; outlives them.
struct Surroundings {
    PanelUser& user;
    Tell& tell;
    Counters& counters;
    double now_s = 0.0;   ///< of the last event or turn
    bool closing = false; ///< the link is at its end: what is closed now has not gone
};

class UsbPanel {
public:
    /// Keeps a reference to the device.
    UsbPanel(libusb_device* device, PanelPlace place, Surroundings& around);
    /// Only while idle.
    ~UsbPanel();
    UsbPanel(const UsbPanel&) = delete;
    UsbPanel& operator=(const UsbPanel&) = delete;

    /// Opens the panel if it is time to try, sends again what failed, lights what is to be lit, closes one that has gone.
    void turn();
    /// The bus says that it has gone, or nobody wants it any more: it closes in the turns that follow.
    void leave() { leaving_ = true; }
    /// Asks for everything dark; true once the panel has taken that, or will not.
    bool darken();
    bool is(const libusb_device* device) const { return device == device_; }
    bool idle() const { return handle_ == nullptr; }
    bool left() const { return leaving_ && idle(); }

private:
    static constexpr std::size_t reports_in_flight = 2; ///< so that one waits while the other is read

    struct Freed {
        void operator()(libusb_transfer* transfer) const { libusb_free_transfer(transfer); }
    };
    struct Transfer {
        std::unique_ptr<libusb_transfer, Freed> transfer;
        std::vector<std::uint8_t> bytes;
        bool in_flight = false;
        double due_s = 0.0; ///< not to be sent before
    };
    enum class Question : std::uint8_t { state, feature };

    void open();
    bool claim();
    void close();
    void cancel();
    bool anything_in_flight() const;
    void trouble(const std::string& what);

    static void LIBUSB_CALL report_done(libusb_transfer* transfer);
    static void LIBUSB_CALL control_done(libusb_transfer* transfer);
    void take_report(Transfer& report);
    void take_answer();
    void fail_report(Transfer& report, libusb_transfer_status status);
    void fail_feature(const std::string& why);
    void ask_for_reports();
    void ask_for_state();
    void light();
    void send_feature(const std::vector<std::uint8_t>& bytes);
    void submit(Transfer& transfer);

    libusb_device* device_;
    PanelPlace place_;
    Surroundings& around_;
    ReportEndpoint endpoint_;
    libusb_device_handle* handle_ = nullptr;
    std::array<Transfer, reports_in_flight> reports_;
    Transfer control_;
    Question question_ = Question::state;
    bool asked_ = false;  ///< how its switches stand
    bool halted_ = false; ///< the endpoint, until it is cleared
    bool lost_ = false;   ///< it no longer answers
    bool leaving_ = false;
    bool refused_ = false;       ///< for good: it is not what it says
    std::uint32_t failures_ = 0; ///< reports that failed one after the other
    double try_again_s_ = 0.0;
    std::vector<std::uint8_t> sent_;  ///< the feature report under way
    std::vector<std::uint8_t> taken_; ///< the one that the panel has
    std::vector<std::string> told_;
};

} // namespace linkdig::panel
