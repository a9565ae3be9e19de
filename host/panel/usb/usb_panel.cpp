#include "host/panel/usb/usb_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace linkdig::panel {

namespace {

constexpr double try_again_after_s = 1.0;
constexpr double feature_pause_s =
    0.02;                              ///< between two feature reports: 50 a second are more than eyes follow
constexpr double first_pause_s = 0.01; ///< after a report that failed; twice as long after each that follows
constexpr double longest_pause_s = 1.0;
constexpr unsigned state_timeout_ms = 500;
constexpr unsigned feature_timeout_ms = 1000;

// HID 1.11, 7.2: class requests to an interface.
constexpr std::uint8_t to_interface = 0x21;
constexpr std::uint8_t from_interface = 0xa1;
constexpr std::uint8_t get_report = 0x01;
constexpr std::uint8_t set_report = 0x09;
constexpr std::uint16_t input_report_0 = 0x0100;
constexpr std::uint16_t feature_report_0 = 0x0300;

const char* words_of(libusb_transfer_status status) {
    switch (status) {
    case LIBUSB_TRANSFER_STALL:
        return "it stalls";
    case LIBUSB_TRANSFER_OVERFLOW:
        return "it sends more than its packet size";
    case LIBUSB_TRANSFER_TIMED_OUT:
        return "it does not answer in time";
    default:
        return "the transfer fails";
    }
}

} // namespace

UsbPanel::UsbPanel(libusb_device* device, PanelPlace place, Surroundings& around)
    : device_(libusb_ref_device(device)), place_(std::move(place)), around_(around) {}

UsbPanel::~UsbPanel() { libusb_unref_device(device_); }

void UsbPanel::trouble(const std::string& what) {
    if (std::ranges::find(told_, what) != told_.end()) return;
    told_.push_back(what);
    around_.tell(fmt::format("{}: {}", name_of(place_), what));
}

void UsbPanel::turn() {
    if (handle_ == nullptr) {
        if (!leaving_ && !refused_ && around_.now_s >= try_again_s_) open();
        return;
    }
    if (leaving_ || lost_) {
        cancel();
        if (!anything_in_flight()) close();
        return;
    }
    if (halted_ && !reports_[0].in_flight && !reports_[1].in_flight) {
        halted_ = false;
        libusb_clear_halt(handle_, endpoint_.address);
    }
    ask_for_reports();
    if (control_.in_flight || around_.now_s < control_.due_s) return;
    if (!asked_)
        ask_for_state();
    else
        light();
}

void UsbPanel::open() {
    try_again_s_ = around_.now_s + try_again_after_s;
    std::string why;
    const auto endpoint = find_endpoint(device_, why);
    if (!endpoint) {
        refused_ = true;
        return trouble(why);
    }
    endpoint_ = *endpoint;
    const int error = libusb_open(device_, &handle_);
    if (error != 0) {
        handle_ = nullptr;
        if (error != LIBUSB_ERROR_NO_DEVICE) trouble(words_of(error)); // it has gone: the bus will say so
        return;
    }
    if (!claim()) return;
    for (Transfer& each : reports_) {
        each.transfer.reset(libusb_alloc_transfer(0));
        each.bytes.resize(endpoint_.packet_bytes);
        each.due_s = 0.0;
    }
    control_.transfer.reset(libusb_alloc_transfer(0));
    control_.due_s = 0.0;
    asked_ = halted_ = lost_ = false;
    failures_ = 0;
    taken_.clear();
    around_.user.attached(place_);
    turn();
}

/// The kernel's own driver holds the interface until it is asked to let go, and takes it again afterwards.
bool UsbPanel::claim() {
    libusb_set_auto_detach_kernel_driver(handle_, 1); // where that is not supported nobody holds it
    const int error = libusb_claim_interface(handle_, endpoint_.interface);
    if (error == 0) return true;
    libusb_close(handle_);
    handle_ = nullptr;
    if (error != LIBUSB_ERROR_NO_DEVICE) trouble(words_of(error));
    return false;
}

void UsbPanel::close() {
    libusb_release_interface(handle_, endpoint_.interface);
    libusb_close(handle_);
    handle_ = nullptr;
    for (Transfer& each : reports_)
        each.transfer.reset();
    control_.transfer.reset();
    try_again_s_ = around_.now_s + try_again_after_s;
    if (!around_.closing) around_.user.detached(place_);
}

void UsbPanel::cancel() {
    for (Transfer& each : reports_)
        if (each.in_flight) libusb_cancel_transfer(each.transfer.get());
    if (control_.in_flight) libusb_cancel_transfer(control_.transfer.get());
}

bool UsbPanel::anything_in_flight() const {
    return control_.in_flight || std::ranges::any_of(reports_, &Transfer::in_flight);
}

void UsbPanel::submit(Transfer& transfer) {
    const int error = libusb_submit_transfer(transfer.transfer.get());
    transfer.in_flight = error == 0;
    if (error == LIBUSB_ERROR_NO_DEVICE) lost_ = true;
    if (error != 0) transfer.due_s = around_.now_s + try_again_after_s;
}

void UsbPanel::ask_for_reports() {
    for (Transfer& each : reports_) {
        if (each.in_flight || halted_ || around_.now_s < each.due_s) continue;
        libusb_fill_interrupt_transfer(each.transfer.get(), handle_, endpoint_.address, each.bytes.data(),
                                       static_cast<int>(each.bytes.size()), report_done, this, 0);
        submit(each);
    }
}

void UsbPanel::report_done(libusb_transfer* transfer) {
    auto& panel = *static_cast<UsbPanel*>(transfer->user_data);
    for (Transfer& each : panel.reports_)
        if (each.transfer.get() == transfer) panel.take_report(each);
}

void UsbPanel::take_report(Transfer& report) {
    report.in_flight = false;
    const libusb_transfer& done = *report.transfer;
    if (done.status == LIBUSB_TRANSFER_NO_DEVICE) lost_ = true;
    if (leaving_ || lost_ || done.status == LIBUSB_TRANSFER_CANCELLED) return;
    if (done.status != LIBUSB_TRANSFER_COMPLETED) return fail_report(report, done.status);
    failures_ = 0;
    ++around_.counters.reports;
    around_.user.report(place_, std::span(report.bytes).first(static_cast<std::size_t>(done.actual_length)),
                        ReportSource::sent, around_.now_s);
    ask_for_reports();
}

/// What fails again and again is asked ever less often.
void UsbPanel::fail_report(Transfer& report, libusb_transfer_status status) {
    ++around_.counters.failed_reports;
    trouble(fmt::format("a report failed: {}; it is asked again", words_of(status)));
    halted_ = halted_ || status == LIBUSB_TRANSFER_STALL;
    const double doubled = first_pause_s * static_cast<double>(1U << std::min(failures_, 10U));
    report.due_s = around_.now_s + std::min(longest_pause_s, doubled);
    ++failures_;
}

/// HID 1.11, 7.2.1: how the switches stand now. A panel that does not answer tells it with its first report.
void UsbPanel::ask_for_state() {
    asked_ = true;
    question_ = Question::state;
    control_.bytes.assign(LIBUSB_CONTROL_SETUP_SIZE + report_bytes, 0);
    libusb_fill_control_setup(control_.bytes.data(), from_interface, get_report, input_report_0,
                              endpoint_.interface, report_bytes);
    libusb_fill_control_transfer(control_.transfer.get(), handle_, control_.bytes.data(), control_done, this,
                                 state_timeout_ms);
    submit(control_);
}

void UsbPanel::light() {
    const std::vector<std::uint8_t> bytes = around_.user.wanted(place_);
    if (!bytes.empty() && bytes != taken_) send_feature(bytes);
}

void UsbPanel::send_feature(const std::vector<std::uint8_t>& bytes) {
    question_ = Question::feature;
    sent_ = bytes;
    control_.bytes.resize(LIBUSB_CONTROL_SETUP_SIZE);
    libusb_fill_control_setup(control_.bytes.data(), to_interface, set_report, feature_report_0,
                              endpoint_.interface, static_cast<std::uint16_t>(bytes.size()));
    control_.bytes.insert(control_.bytes.end(), bytes.begin(), bytes.end());
    libusb_fill_control_transfer(control_.transfer.get(), handle_, control_.bytes.data(), control_done, this,
                                 feature_timeout_ms);
    submit(control_);
}

void UsbPanel::control_done(libusb_transfer* transfer) {
    static_cast<UsbPanel*>(transfer->user_data)->take_answer();
}

void UsbPanel::take_answer() {
    control_.in_flight = false;
    const libusb_transfer& done = *control_.transfer;
    if (done.status == LIBUSB_TRANSFER_NO_DEVICE) lost_ = true;
    if (lost_ || done.status == LIBUSB_TRANSFER_CANCELLED) return;
    const bool taken = done.status == LIBUSB_TRANSFER_COMPLETED;
    control_.due_s = around_.now_s + feature_pause_s;
    if (question_ == Question::state) {
        if (!taken) return;
        const auto answer = std::span(control_.bytes).subspan(LIBUSB_CONTROL_SETUP_SIZE);
        const auto length = std::min(answer.size(), static_cast<std::size_t>(done.actual_length));
        if (length == report_bytes)
            around_.user.report(place_, answer.first(length), ReportSource::asked, around_.now_s);
        return;
    }
    if (!taken) return fail_feature(words_of(done.status));
    ++around_.counters.features;
    taken_ = sent_;
}

void UsbPanel::fail_feature(const std::string& why) {
    ++around_.counters.failed_features;
    control_.due_s = around_.now_s + try_again_after_s;
    trouble(fmt::format("its lamps and displays cannot be set: {}; it is tried again and again", why));
}

bool UsbPanel::darken() {
    if (handle_ == nullptr || leaving_ || lost_ || taken_.empty()) return true;
    const auto dark = layout_of(place_.kind).dark;
    const std::vector<std::uint8_t> bytes(dark.begin(), dark.end());
    if (control_.in_flight) return false;
    if (bytes == taken_ || around_.now_s < control_.due_s - feature_pause_s) return true;
    send_feature(bytes);
    return !control_.in_flight;
}

} // namespace linkdig::panel
