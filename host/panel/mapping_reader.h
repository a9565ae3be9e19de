#pragma once
/// Reads the tables of one mapping file: names are looked up in the panel's layout and among the signals, and every mistake is told.

#include "database/text/table_reader.h"
#include "host/panel/mapping.h"
#include "host/panel/signal_unit.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace linkdig::panel {

class MappingReader {
public:
    MappingReader(const database::Document& document, database::Diagnostics& diagnostics);
    /// Worth something only if there is no diagnostic.
    Mapping read();

private:
    using TableReader = database::TableReader;
    using Signal = host::Signal;

    const PanelLayout& layout() const { return layout_of(mapping_.kind); }
    bool read_head();
    void each_table(const char* key, const std::function<void(TableReader&)>& read_one);

    void read_switch(TableReader& table);
    void read_selector(TableReader& table);
    void read_button(TableReader& table);
    void read_encoder(TableReader& table);
    void read_lamp(TableReader& table);
    void read_display(TableReader& table);
    Step read_step(TableReader& table, Signal written);
    std::optional<Shown> shows(TableReader& table);

    /// One of the panel's lamps or displays, if it has the one that is named.
    struct Place {
        std::optional<std::size_t> index;
        std::string name;
    };
    using FindPlace = std::optional<std::size_t> (*)(const PanelLayout&, std::string_view);
    template <typename All>
    Place shown_on(TableReader& table, const std::string& key, const All& all, FindPlace find) const;

    /// The named control, if it is there and of one of these kinds.
    std::optional<std::uint8_t> control(TableReader& table, std::initializer_list<ControlKind> kinds);
    /// `state`: the signal is to take a state that stays, which a pulse has none of.
    std::optional<Signal> signal(TableReader& table, bool state);
    /// A value of the signal under `key`, in the unit that ends the key.
    static std::optional<double> value(TableReader& table, const std::string& key, Signal signal);
    static std::optional<double> step(TableReader& table, Signal signal);
    /// "selector.alt": a selector of this panel and one of its positions.
    std::optional<Stand> when(TableReader& table);
    std::string stands() const;
    std::optional<std::uint8_t> position(TableReader& table, const char* key, std::size_t control,
                                         const std::string& name);
    /// Is this the first of its kind in the file? If not, says where that is.
    void once(TableReader& table, const char* key, const std::string& what);
    std::string stand_text(const std::optional<Stand>& stand) const;
    /// Keys whose meaning hangs on a name that is wrong: one mistake, told once.
    static void pass_over(TableReader& table, std::initializer_list<const char*> stems);

    TableReader root_;
    Mapping mapping_;
    std::map<std::string, std::uint32_t> seen_;
};

} // namespace linkdig::panel
