/// What can be known of a device before it is opened.

#include "host/panel/usb/usb_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace linkdig::panel {

namespace {

constexpr std::size_t deepest_port = 7; // USB 2.0, 4.1.1: tiers of a bus

struct FreedDescriptor {
    void operator()(libusb_config_descriptor* descriptor) const { libusb_free_config_descriptor(descriptor); }
};

bool is_report_endpoint(const libusb_endpoint_descriptor& endpoint) {
    return (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_IN &&
           (endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) == LIBUSB_TRANSFER_TYPE_INTERRUPT;
}

/// Bits 11 and 12 of wMaxPacketSize say how many packets a microframe may hold (USB 2.0, 9.6.6).
std::size_t packet_bytes_of(const libusb_endpoint_descriptor& endpoint) {
    return endpoint.wMaxPacketSize & 0x7ffU;
}

} // namespace

std::optional<ReportEndpoint> find_endpoint(libusb_device* device, std::string& trouble) {
    libusb_config_descriptor* read = nullptr;
    if (libusb_get_active_config_descriptor(device, &read) != 0) {
        trouble = "its descriptors cannot be read; it is left alone";
        return std::nullopt;
    }
    const std::unique_ptr<libusb_config_descriptor, FreedDescriptor> configuration(read);
    std::size_t largest = 0;
    for (const libusb_interface& interface :
         std::span(configuration->interface, configuration->bNumInterfaces)) {
        if (interface.num_altsetting < 1) continue;
        const libusb_interface_descriptor& setting = interface.altsetting[0];
        for (const libusb_endpoint_descriptor& endpoint :
             std::span(setting.endpoint, setting.bNumEndpoints)) {
            if (!is_report_endpoint(endpoint)) continue;
            const std::size_t bytes = packet_bytes_of(endpoint);
            if (bytes >= report_bytes)
                return ReportEndpoint{setting.bInterfaceNumber, endpoint.bEndpointAddress, bytes};
            largest = std::max(largest, bytes);
        }
    }
    trouble = largest > 0
                  ? fmt::format("its packets hold {} bytes, and a report has {}; it is left alone", largest,
                                report_bytes)
                  : "its descriptors name no interrupt endpoint that could send reports; it is left alone";
    return std::nullopt;
}

std::optional<PanelPlace> place_of(libusb_device* device) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(device, &descriptor) != 0 || descriptor.idVendor != vendor_id)
        return std::nullopt;
    const auto kind = kind_of_product(descriptor.idProduct);
    if (!kind) return std::nullopt;
    std::array<std::uint8_t, deepest_port> ports{};
    const int depth = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
    std::string port = fmt::format("{}", libusb_get_bus_number(device));
    for (int i = 0; i < depth; ++i)
        port += fmt::format("{}{}", i == 0 ? '-' : '.', ports[static_cast<std::size_t>(i)]);
    return PanelPlace{*kind, port};
}

std::string words_of(int error) {
    switch (error) {
    case LIBUSB_ERROR_ACCESS:
        return fmt::format("no permission to open it; tools/panel_permission.sh installs the udev rule {} "
                           "(docs/panel.md)",
                           permission_rule);
    case LIBUSB_ERROR_BUSY:
        return "another program holds it";
    default:
        return fmt::format("it cannot be opened ({})", libusb_error_name(error));
    }
}

} // namespace linkdig::panel
