#include "host/signals/signal_store.h"

#include <cmath>

namespace linkdig::host {

SignalStore::SignalStore() { restore(); }

bool SignalStore::write(Signal signal, double value) {
    const auto written = admissible(signal, value);
    if (written) values_[static_cast<std::size_t>(signal)].store(*written);
    return written.has_value();
}

bool SignalStore::write(std::string_view name, double value) {
    const auto signal = find_signal(name);
    return signal && write(*signal, value);
}

bool SignalStore::add(Signal signal, double difference) {
    if (std::isnan(difference)) return false;
    std::atomic<double>& stored = values_[static_cast<std::size_t>(signal)];
    double before = stored.load();
    while (!stored.compare_exchange_weak(before, *admissible(signal, before + difference))) {
    }
    return true;
}

bool SignalStore::add_round(Signal signal, double difference) {
    if (std::isnan(difference)) return false;
    const SignalDefinition& defined = definition(signal);
    const auto sum = [&](double before) {
        const double asked = before + difference;
        const double round = asked > defined.maximum   ? defined.minimum
                             : asked < defined.minimum ? defined.maximum
                                                       : asked;
        return *admissible(signal, round);
    };
    std::atomic<double>& stored = values_[static_cast<std::size_t>(signal)];
    double before = stored.load();
    while (!stored.compare_exchange_weak(before, sum(before))) {
    }
    return true;
}

void SignalStore::change_over(Signal signal) {
    std::atomic<double>& stored = values_[static_cast<std::size_t>(signal)];
    double before = stored.load();
    while (!stored.compare_exchange_weak(before, before >= 0.5 ? 0.0 : 1.0)) {
    }
}

void SignalStore::restore() {
    for (const SignalDefinition& each : signal_directory())
        write(each.signal, each.initial);
    ++overwritten_;
}

void SignalStore::assign(const SignalValues& values) {
    for (const SignalDefinition& each : signal_directory())
        if (each.kind != SignalKind::pulse) write(each.signal, values[each.signal]);
    ++overwritten_;
}

double SignalStore::value(Signal signal) const { return values_[static_cast<std::size_t>(signal)].load(); }

SignalValues SignalStore::snapshot() {
    SignalValues values;
    for (const SignalDefinition& each : signal_directory()) {
        std::atomic<double>& stored = values_[static_cast<std::size_t>(each.signal)];
        values.set(each.signal, each.kind == SignalKind::pulse ? stored.exchange(0.0) : stored.load());
    }
    return values;
}

} // namespace linkdig::host
