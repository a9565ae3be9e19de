#include "host/panel/panel_link.h"

#include "host/panel/usb/usb_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace linkdig::panel {

namespace {

constexpr long turn_us = 5000; ///< events wake the thread at once; between them it looks for lamps to light
constexpr double look_around_s =
    1.0;                           ///< how often the bus is listed where it does not tell of changes itself
constexpr double patience_s = 2.0; ///< with a bus that does not end what was cancelled
constexpr double darkening_s = 0.3;

struct Context {
    Context() {
        if (const int error = libusb_init(&context); error != 0)
            throw std::runtime_error(fmt::format("USB cannot be reached ({})", libusb_error_name(error)));
    }
    ~Context() { libusb_exit(context); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    libusb_context* context = nullptr;
};

/// Calls for each device on the bus.
template <typename Call>
void each_device(libusb_context* context, const Call& call) {
    libusb_device** devices = nullptr;
    const auto count = libusb_get_device_list(context, &devices);
    for (std::ptrdiff_t i = 0; i < count; ++i)
        call(devices[i]);
    if (count >= 0) libusb_free_device_list(devices, 1);
}

std::string trouble_with(libusb_device* device) {
    std::string trouble;
    if (!find_endpoint(device, trouble)) return trouble;
    libusb_device_handle* handle = nullptr;
    if (const int error = libusb_open(device, &handle); error != 0) return words_of(error);
    libusb_close(handle);
    return {};
}

} // namespace

std::string no_panels_because() { return {}; }

std::vector<FoundPanel> find_panels() {
    const Context usb;
    std::vector<FoundPanel> found;
    each_device(usb.context, [&](libusb_device* device) {
        if (const auto place = place_of(device)) found.push_back({*place, trouble_with(device)});
    });
    std::ranges::sort(found, {}, [](const FoundPanel& each) { return each.place.port; });
    return found;
}

struct PanelLink::State {
    State(PanelUser& panel_user, Tell words)
        : user(panel_user), tell(std::move(words)), around{user, tell, counters} {}

    void run();
    void watch();
    void look_around();
    void arrived(libusb_device* device);
    void gone(const libusb_device* device);
    void turn();
    void finish();
    void handle_events();
    void tick();
    static int LIBUSB_CALL changed(libusb_context* context, libusb_device* device, libusb_hotplug_event event,
                                   void* state);

    Context usb;
    PanelUser& user;
    Tell tell;
    Counters counters;
    Surroundings around;
    std::vector<std::unique_ptr<UsbPanel>> panels;
    bool told_by_bus = false;
    double look_again_s = 0.0;
    const std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
    std::atomic<bool> stop{false};
    std::thread thread;
};

void PanelLink::State::tick() {
    around.now_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// The bus calls in the middle of events: what has come is opened, and what has gone is closed, in the turn that follows.
int PanelLink::State::changed(libusb_context* /*context*/, libusb_device* device, libusb_hotplug_event event,
                              void* state) {
    if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED)
        static_cast<State*>(state)->arrived(device);
    else
        static_cast<State*>(state)->gone(device);
    return 0;
}

void PanelLink::State::arrived(libusb_device* device) {
    const bool known = std::ranges::any_of(panels, [&](const auto& each) { return each->is(device); });
    if (known) return;
    if (const auto place = place_of(device))
        panels.push_back(std::make_unique<UsbPanel>(device, *place, around));
}

void PanelLink::State::gone(const libusb_device* device) {
    for (const auto& each : panels)
        if (each->is(device)) each->leave();
}

void PanelLink::State::watch() {
    constexpr auto arrive_and_leave = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
    told_by_bus = libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0 &&
                  libusb_hotplug_register_callback(usb.context, arrive_and_leave, LIBUSB_HOTPLUG_ENUMERATE,
                                                   vendor_id, LIBUSB_HOTPLUG_MATCH_ANY,
                                                   LIBUSB_HOTPLUG_MATCH_ANY, changed, this, nullptr) == 0;
}

void PanelLink::State::look_around() {
    if (told_by_bus || around.now_s < look_again_s) return;
    look_again_s = around.now_s + look_around_s;
    std::vector<const libusb_device*> there;
    each_device(usb.context, [&](libusb_device* device) {
        there.push_back(device);
        arrived(device);
    });
    for (const auto& each : panels)
        if (std::ranges::none_of(there, [&](const libusb_device* device) { return each->is(device); }))
            each->leave();
}

void PanelLink::State::handle_events() {
    timeval timeout{0, turn_us};
    libusb_handle_events_timeout_completed(usb.context, &timeout, nullptr);
    tick();
}

void PanelLink::State::turn() {
    look_around();
    user.turn(around.now_s);
    for (const auto& each : panels)
        each->turn();
    std::erase_if(panels, [](const auto& each) { return each->left(); });
}

void PanelLink::State::run() {
    watch();
    while (!stop) {
        turn();
        handle_events();
    }
    finish();
}

/// Dark, then closed. A device that does not even end its cancelled transfers is left to the end of the program.
void PanelLink::State::finish() {
    const double dark_by_s = around.now_s + darkening_s;
    bool dark = false;
    while (!dark && around.now_s < dark_by_s) {
        dark = true;
        for (const auto& each : panels)
            dark = each->darken() && dark;
        handle_events();
    }
    around.closing = true;
    for (const auto& each : panels)
        each->leave();
    const double closed_by_s = around.now_s + patience_s;
    while (!panels.empty() && around.now_s < closed_by_s) {
        turn();
        if (!panels.empty()) handle_events();
    }
    for (auto& each : panels)
        static_cast<void>(each.release());
    panels.clear();
}

PanelLink::PanelLink(PanelUser& user, Tell tell) : state_(std::make_unique<State>(user, std::move(tell))) {
    state_->thread = std::thread([state = state_.get()] { state->run(); });
}

PanelLink::~PanelLink() {
    state_->stop = true;
    state_->thread.join();
}

LinkCounts PanelLink::counts() const {
    const Counters& now = state_->counters;
    return {now.reports, now.failed_reports, now.features, now.failed_features};
}

} // namespace linkdig::panel
