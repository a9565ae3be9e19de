#include "tests/panel/mock_panel.h"

#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdarg>
#include <cstring>
#include <deque>
#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>

namespace linkdig::panel {

namespace {

void check(GError* error) {
    if (error == nullptr) return;
    const std::string message = error->message;
    g_error_free(error);
    throw std::runtime_error(message);
}

/// A transfer that the program has handed in. Of one that came over umockdev's socket `data` keeps the memory known.
struct Urb {
    usbdevfs_urb* urb = nullptr;
    UMockdevIoctlData* data = nullptr;
    gulong address = 0; ///< in the program
    usbdevfs_urb* operator->() const { return urb; }
};

/// HID, one interface, endpoint 0x81 of 64 bytes every 10 ms.
constexpr const char* usual_configuration =
    "09022200010100803209040000010300000009211101000122350007058103400"
    "00a";

} // namespace

struct MockBus::State {
    UMockdevTestbed* testbed = umockdev_testbed_new();
};

MockBus::MockBus() : state_(std::make_unique<State>()) {}
MockBus::~MockBus() { g_object_unref(state_->testbed); }
std::string MockBus::root() const {
    gchar* folder = umockdev_testbed_get_root_dir(state_->testbed);
    std::string result = folder;
    g_free(folder);
    return result;
}

struct MockPanel::State {
    mutable std::mutex mutex;
    std::condition_variable more; ///< reports
    UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
    std::deque<std::vector<std::uint8_t>> reports;
    std::uint64_t flood_left = 0;
    std::uint32_t flood_last = 0;
    std::deque<Urb> asked; ///< for reports, waiting
    std::deque<Urb> done;  ///< to be fetched
    std::uint32_t bits = 0;
    bool answers_state = true;
    bool gone = false;
    bool claimed = false;
    int report_error = 0;
    int report_errors_left = 0;
    int feature_error = 0;
    std::vector<std::vector<std::uint8_t>> features;
    std::uint64_t feature_attempts = 0;
    std::uint64_t reports_asked = 0;

    ~State() {
        forget();
        g_object_unref(handler);
    }
    void forget() {
        for (auto* all : {&asked, &done}) {
            for (const Urb& each : *all)
                if (each.data != nullptr) umockdev_ioctl_data_unref(each.data);
            all->clear();
        }
    }

    std::optional<std::vector<std::uint8_t>> next_report() {
        if (!reports.empty()) {
            std::vector<std::uint8_t> report = std::move(reports.front());
            reports.pop_front();
            return report;
        }
        if (flood_left == 0) return std::nullopt;
        const std::uint32_t now =
            --flood_left == 0 ? flood_last : static_cast<std::uint32_t>(flood_left & 3U);
        return std::vector<std::uint8_t>{static_cast<std::uint8_t>(now), static_cast<std::uint8_t>(now >> 8U),
                                         static_cast<std::uint8_t>(now >> 16U)};
    }
    /// Reports meet the transfers that wait for them.
    void feed() {
        while (!asked.empty()) {
            if (report_errors_left > 0) {
                --report_errors_left;
                finish(report_error, 0);
                continue;
            }
            const auto report = next_report();
            if (!report) return;
            const usbdevfs_urb& urb = *asked.front().urb;
            const auto room = static_cast<std::size_t>(urb.buffer_length);
            const std::size_t length = std::min(report->size(), room);
            if (length != 0) std::memcpy(urb.buffer, report->data(), length);
            finish(report->size() > room ? -EOVERFLOW : 0, static_cast<int>(length));
        }
    }
    void finish(int status, int length) {
        asked.front()->status = status;
        asked.front()->actual_length = length;
        done.push_back(asked.front());
        asked.pop_front();
    }

    /// Another transfer; the setup packet where it is a control transfer.
    void take(const Urb& urb, const std::uint8_t* setup) {
        if (urb->type == USBDEVFS_URB_TYPE_CONTROL) {
            answer_control(urb, setup);
            done.push_back(urb);
            return;
        }
        ++reports_asked;
        asked.push_back(urb);
        feed();
    }
    bool cancel(gulong address) {
        const auto found = std::ranges::find(asked, address, &Urb::address);
        if (found == asked.end()) return false;
        (*found)->status = -ENOENT;
        done.push_back(*found);
        asked.erase(found);
        return true;
    }
    void answer_control(const Urb& urb, const std::uint8_t* setup);

    void submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
    void reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument);
    bool handle(UMockdevIoctlClient* client);
    int direct(unsigned long request, void* argument);
};

void MockPanel::State::submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
    UMockdevIoctlData* data = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
    const Urb urb{reinterpret_cast<usbdevfs_urb*>(data->data), data, data->client_addr};
    UMockdevIoctlData* buffer = umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer),
                                                            static_cast<gsize>(urb->buffer_length), nullptr);
    take(urb, buffer->data);
    umockdev_ioctl_data_unref(buffer);
    umockdev_ioctl_client_complete(client, 0, 0);
}

/// The setup packet and, behind it, the data.
void MockPanel::State::answer_control(const Urb& urb, const std::uint8_t* setup) {
    constexpr int setup_bytes = 8;
    const std::uint16_t value = static_cast<std::uint16_t>(setup[2] | setup[3] << 8U);
    urb->status = -EPIPE;
    urb->actual_length = 0;
    if (setup[0] == 0xa1 && setup[1] == 0x01 && value == 0x0100 && answers_state) {
        const std::array<std::uint8_t, 3> now{static_cast<std::uint8_t>(bits),
                                              static_cast<std::uint8_t>(bits >> 8U),
                                              static_cast<std::uint8_t>(bits >> 16U)};
        std::memcpy(static_cast<std::uint8_t*>(urb->buffer) + setup_bytes, now.data(), now.size());
        urb->status = 0;
        urb->actual_length = static_cast<int>(now.size());
    }
    if (setup[0] != 0x21 || setup[1] != 0x09 || value != 0x0300) return;
    ++feature_attempts;
    urb->status = feature_error;
    if (feature_error != 0) return;
    features.emplace_back(setup + setup_bytes, setup + urb->buffer_length);
    urb->actual_length = urb->buffer_length - setup_bytes;
}

void MockPanel::State::reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
    feed();
    if (done.empty()) {
        umockdev_ioctl_client_complete(client, -1, gone ? ENODEV : EAGAIN);
        return;
    }
    const Urb urb = done.front();
    done.pop_front();
    UMockdevIoctlData* place = umockdev_ioctl_data_resolve(argument, 0, sizeof(gpointer), nullptr);
    umockdev_ioctl_data_set_ptr(place, 0, urb.data);
    umockdev_ioctl_data_unref(place);
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(urb.data);
}

bool MockPanel::State::handle(UMockdevIoctlClient* client) {
    UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
    const std::lock_guard lock(mutex);
    switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_GET_CAPABILITIES: {
        UMockdevIoctlData* answer = umockdev_ioctl_data_resolve(argument, 0, sizeof(guint32), nullptr);
        *reinterpret_cast<guint32*>(answer->data) =
            USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM;
        umockdev_ioctl_data_unref(answer);
        umockdev_ioctl_client_complete(client, 0, 0);
        return true;
    }
    case USBDEVFS_GETDRIVER:
        umockdev_ioctl_client_complete(client, -1, ENODATA);
        return true;
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_DISCONNECT_CLAIM: // the kernel's driver lets go
    case USBDEVFS_RELEASEINTERFACE:
        claimed = umockdev_ioctl_client_get_request(client) != USBDEVFS_RELEASEINTERFACE;
        [[fallthrough]];
    case USBDEVFS_SETCONFIGURATION:
    case USBDEVFS_CLEAR_HALT:
    case USBDEVFS_RESET:
        umockdev_ioctl_client_complete(client, 0, 0);
        return true;
    case USBDEVFS_SUBMITURB:
        if (gone)
            umockdev_ioctl_client_complete(client, -1, ENODEV);
        else
            submit(client, argument);
        return true;
    case USBDEVFS_DISCARDURB:
        if (cancel(*reinterpret_cast<gulong*>(argument->data)))
            umockdev_ioctl_client_complete(client, 0, 0);
        else
            umockdev_ioctl_client_complete(client, -1, EINVAL);
        return true;
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
        reap(client, argument);
        return true;
    default:
        return false;
    }
}

/// The same as handle(), for a program in this process; a negative errno is an error.
int MockPanel::State::direct(unsigned long request, void* argument) {
    std::unique_lock lock(mutex);
    switch (request) {
    case USBDEVFS_GET_CAPABILITIES:
        *static_cast<std::uint32_t*>(argument) =
            USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM;
        return 0;
    case USBDEVFS_GETDRIVER:
        return -ENODATA;
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_DISCONNECT_CLAIM:
    case USBDEVFS_RELEASEINTERFACE:
        claimed = request != USBDEVFS_RELEASEINTERFACE;
        return 0;
    case USBDEVFS_SUBMITURB: {
        auto* urb = static_cast<usbdevfs_urb*>(argument);
        take({urb, nullptr, reinterpret_cast<gulong>(argument)}, static_cast<std::uint8_t*>(urb->buffer));
        return 0;
    }
    case USBDEVFS_DISCARDURB:
        return cancel(reinterpret_cast<gulong>(argument)) ? 0 : -EINVAL;
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
        feed();
        // The file that stands for the device is ready at any time: what poll() would wait for is waited for here.
        if (done.empty()) more.wait_for(lock, std::chrono::milliseconds(1));
        feed();
        if (done.empty()) return -EAGAIN;
        *static_cast<usbdevfs_urb**>(argument) = done.front().urb;
        done.pop_front();
        return 0;
    default:
        return -ENOTTY;
    }
}

namespace {

/// Panels that answer within this process, by the end of their files' names.
struct DirectPanels {
    std::mutex mutex;
    std::vector<std::pair<std::string, MockPanel::State*>> all;

    MockPanel::State* behind(int file) {
        const std::lock_guard lock(mutex);
        if (all.empty()) return nullptr;
        std::error_code ignored;
        const std::string name =
            std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", file), ignored).string();
        for (const auto& [node, state] : all)
            if (name.ends_with(node)) return state;
        return nullptr;
    }
};
DirectPanels& direct_panels() {
    static DirectPanels panels;
    return panels;
}

gboolean on_ioctl(UMockdevIoctlBase* /*handler*/, UMockdevIoctlClient* client, gpointer state) {
    return static_cast<MockPanel::State*>(state)->handle(client) ? TRUE : FALSE;
}

std::string device_path(const MockDescription& panel) {
    return fmt::format("/devices/pci0000:00/usb{0}/{0}-{1}", panel.bus, panel.port);
}

} // namespace

MockPanel::MockPanel(MockBus& bus, MockDescription description)
    : bus_(bus), description_(std::move(description)), state_(std::make_shared<State>()) {
    state_->answers_state = description_.answers_state;
    g_signal_connect(state_->handler, "handle-ioctl", G_CALLBACK(on_ioctl), state_.get());
    if (description_.direct) {
        const std::lock_guard lock(direct_panels().mutex);
        direct_panels().all.emplace_back(node(), state_.get());
    }
    plug();
}

MockPanel::~MockPanel() {
    if (plugged_) unplug();
    const std::lock_guard lock(direct_panels().mutex);
    std::erase_if(direct_panels().all, [this](const auto& each) { return each.second == state_.get(); });
}

std::string MockPanel::node() const {
    return fmt::format("/dev/bus/usb/{:03}/{:03}", description_.bus, description_.device);
}

void MockPanel::plug() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->gone = false;
        state_->reports.clear();
        state_->flood_left = 0;
    }
    const std::uint16_t product = layout_of(description_.kind).product_id;
    const std::string device_descriptor =
        fmt::format("1201000200000008a306{:02x}{:02x}000101020001", product & 0xffU, product >> 8U);
    const std::string text =
        fmt::format("P: {}\nN: {}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: BUSNUM={:03}\nE: "
                    "DEVNUM={:03}\nE: DEVNAME={}\n"
                    "E: PRODUCT=6a3/{:x}/100\nA: busnum={}\\n\nA: devnum={}\\n\nA: "
                    "bConfigurationValue=1\\n\nA: speed=12\\n\n"
                    "A: idVendor=06a3\\n\nA: idProduct={:04x}\\n\nH: descriptors={}{}\n",
                    device_path(description_), node().substr(5), description_.bus, description_.device,
                    node(), product, description_.bus, description_.device, product, device_descriptor,
                    description_.configuration.empty() ? usual_configuration : description_.configuration);
    GError* error = nullptr;
    umockdev_testbed_attach_ioctl(bus_.state().testbed, node().c_str(), state_->handler, &error);
    check(error);
    umockdev_testbed_add_from_string(bus_.state().testbed, text.c_str(), &error);
    check(error);
    umockdev_testbed_uevent(bus_.state().testbed, ("/sys" + device_path(description_)).c_str(), "add");
    plugged_ = true;
}

/// What waits ends as the kernel ends it, the bus tells of it, and the file is no longer there.
void MockPanel::unplug() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->gone = true;
        while (!state_->asked.empty())
            state_->finish(-ESHUTDOWN, 0);
    }
    umockdev_testbed_uevent(bus_.state().testbed, ("/sys" + device_path(description_)).c_str(), "remove");
    GError* error = nullptr;
    umockdev_testbed_detach_ioctl(bus_.state().testbed, node().c_str(), &error);
    check(error);
    umockdev_testbed_remove_device(bus_.state().testbed, ("/sys" + device_path(description_)).c_str());
    plugged_ = false;
}

void MockPanel::send(std::uint32_t bits) {
    stand(bits);
    send_bytes({static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                static_cast<std::uint8_t>(bits >> 16U)});
}

void MockPanel::send_bytes(const std::vector<std::uint8_t>& bytes) {
    const std::lock_guard lock(state_->mutex);
    state_->reports.push_back(bytes);
    state_->more.notify_all();
}

void MockPanel::flood(std::uint64_t reports, std::uint32_t last_bits) {
    const std::lock_guard lock(state_->mutex);
    state_->flood_left += reports;
    state_->flood_last = last_bits;
    state_->bits = last_bits;
    state_->more.notify_all();
}

void MockPanel::fail_reports(int error, int times) {
    const std::lock_guard lock(state_->mutex);
    state_->report_error = error;
    state_->report_errors_left = times;
}

void MockPanel::fail_features(int error) {
    const std::lock_guard lock(state_->mutex);
    state_->feature_error = error;
}

void MockPanel::stand(std::uint32_t bits) {
    const std::lock_guard lock(state_->mutex);
    state_->bits = bits;
}

std::vector<std::uint8_t> MockPanel::feature() const {
    const std::lock_guard lock(state_->mutex);
    return state_->features.empty() ? std::vector<std::uint8_t>() : state_->features.back();
}

std::vector<std::vector<std::uint8_t>> MockPanel::all_features() const {
    const std::lock_guard lock(state_->mutex);
    return state_->features;
}

std::uint64_t MockPanel::features() const {
    const std::lock_guard lock(state_->mutex);
    return state_->features.size();
}

std::uint64_t MockPanel::feature_attempts() const {
    const std::lock_guard lock(state_->mutex);
    return state_->feature_attempts;
}

std::uint64_t MockPanel::waiting() const {
    const std::lock_guard lock(state_->mutex);
    return state_->reports.size() + state_->flood_left;
}

std::uint64_t MockPanel::reports_asked() const {
    const std::lock_guard lock(state_->mutex);
    return state_->reports_asked;
}

bool MockPanel::claimed() const {
    const std::lock_guard lock(state_->mutex);
    return state_->claimed;
}

} // namespace linkdig::panel

/// What libusb calls, before umockdev's own: programs come before libraries in the search for a name.
extern "C" int ioctl(int file, unsigned long request, ...) noexcept {
    using Ioctl = int (*)(int, unsigned long, void*);
    std::va_list rest;
    va_start(rest, request);
    void* argument = va_arg(rest, void*);
    va_end(rest);
    constexpr unsigned long usbdevfs = 'U';
    if (_IOC_TYPE(request) == usbdevfs)
        if (auto* panel = linkdig::panel::direct_panels().behind(file)) {
            const int result = panel->direct(request, argument);
            if (result >= 0) return result;
            errno = -result;
            return -1;
        }
    static const auto next = reinterpret_cast<Ioctl>(dlsym(RTLD_NEXT, "ioctl"));
    return next(file, request, argument);
}
