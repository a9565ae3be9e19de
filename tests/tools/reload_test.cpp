/// A flight whose database is saved anew while it flies: what a running window does with it.

#include "database/format/write.h"
#include "ig/sink/hash_sink.h"
#include "tests/tools/pictures.h"
#include "tools/flight/bad_input.h"
#include "tools/flight/flight.h"
#include "tools/watch/database_reload.h"

#include "database/compiler/compile.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace linkdig::tools {
namespace {

using testing::HasSubstr;

const std::string world = "[database]\nname = \"w\"\n[[sun]]\nname = \"world\"\n"
                          "[[moving_object]]\nname = \"boat\"\n[[slot]]\nname = \"flag\"\nalternatives = 1\n";

/// A boat of one box in this colour.
std::string boat(const std::string& rgb) {
    return "[[colour]]\nname = \"paint\"\nrgb = " + rgb +
           "\n[[cluster]]\nname = \"boat\"\npriority = 1\nmoving_object = \"boat\"\n"
           "[[object_list]]\nname = \"boat\"\ncluster = \"boat\"\nsun = \"world\"\n"
           "[[object]]\nname = \"hull\"\nlist = \"boat\"\ncolour = \"paint\"\nslot = \"flag\"\nalternative = "
           "0\n"
           "[[object.box]]\nfrom_m = [-10, -3, 0]\nto_m = [10, 3, 4]\n";
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

class Reload : public testing::Test {
protected:
    void SetUp() override {
        write(folder_.file("w.toml"), "include = [\"boat.toml\"]\n" + world);
        write(folder_.file("boat.toml"), boat("[200, 0, 0]"));
    }
    FlightRequest request(const std::string& database) const {
        write(folder_.file("flight.toml"),
              "[scenario]\nname = \"f\"\ndatabase = \"" + database +
                  "\"\nduration_s = 9.0\n[suns.world]\nazimuth_deg = 200.0\nelevation_deg = 40.0\n"
                  "[[ship]]\nmoving_object = \"boat\"\nheading_deg = 30.0\nspeed_kt = 8.0\n"
                  "[own_ship]\nkind = \"flown\"\nposition_m = [0, -60, 15]\nheading_deg = 0.0\n"
                  "[[sequence]]\nslot = \"flag\"\ndwell_s = 0.1\n"
                  "[[channel]]\nname = \"ahead\"\nhorizontal_field_deg = 56.0\n");
        FlightRequest request;
        request.scenario_path = folder_.file("flight.toml");
        request.configuration = ig::modern_profile();
        request.configuration.raster = {.width = 160, .height = 120};
        request.configuration.update_rate_hz = 30.0;
        return request;
    }
    /// Polls as the window does, until there is an outcome.
    static DatabaseReload::Outcome outcome_of(DatabaseReload& reload) {
        for (int i = 0; i < 3000; ++i) {
            if (auto outcome = reload.poll()) return std::move(*outcome);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        ADD_FAILURE() << "no outcome";
        return {};
    }
    static std::uint64_t picture(Flight& flight) { return ig::picture_hash(flight.machine().picture(0)); }
    TemporaryFolder folder_;
};

host::SignalValues by_hand() {
    host::SignalValues signals;
    signals.set(host::Signal::hands_on, 1.0);
    signals.set(host::Signal::stick_fore, 1.0);
    return signals;
}

TEST_F(Reload, TheFlightGoesOnOverWhatTheFilesSayNow) {
    Flight flight(request("w.toml"));
    for (std::uint64_t frame = 0; frame < 20; ++frame)
        flight.draw(frame, by_hand());
    Flight undisturbed(request("w.toml"));
    for (std::uint64_t frame = 0; frame < 20; ++frame)
        undisturbed.draw(frame, by_hand());

    DatabaseReload reload(flight.scenario().database_path, flight.database_files());
    EXPECT_FALSE(reload.poll());
    write(folder_.file("boat.toml"), boat("[0, 0, 210]"));
    DatabaseReload::Outcome outcome = outcome_of(reload);
    ASSERT_TRUE(outcome.database) << outcome.refused;
    const std::uint64_t before = flight.database_id();
    flight.replace_database(std::move(*outcome.database));
    EXPECT_NE(flight.database_id(), before);

    // The own ship, flown by hand, is where she would have been; what she sees has another colour.
    for (std::uint64_t frame = 20; frame < 23; ++frame) {
        flight.draw(frame, by_hand());
        undisturbed.draw(frame, by_hand());
        const ChannelView& here = flight.packet().channels[0];
        const ChannelView& there = undisturbed.packet().channels[0];
        EXPECT_EQ(here.eye_m, there.eye_m);
        EXPECT_EQ(here.attitude.pitch_rad, there.attitude.pitch_rad);
        EXPECT_NE(picture(flight), picture(undisturbed));
    }
    Flight from_the_first(request("w.toml"));
    for (std::uint64_t frame = 0; frame < 23; ++frame)
        from_the_first.draw(frame, by_hand());
    EXPECT_EQ(picture(flight), picture(from_the_first));
}

TEST_F(Reload, ACompiledDatabaseIsWatchedWhereItStands) {
    const std::string file = folder_.file("w.igdb");
    const auto compile = [&] {
        database::write_database(*database::compile_file(folder_.file("w.toml")).database, file);
    };
    compile();
    Flight flight(request("w.igdb"));
    flight.draw(0, {});
    DatabaseReload reload(flight.scenario().database_path, flight.database_files());
    write(folder_.file("boat.toml"), boat("[0, 0, 210]"));
    EXPECT_FALSE(reload.poll()); // nobody has compiled it yet
    compile();
    DatabaseReload::Outcome outcome = outcome_of(reload);
    ASSERT_TRUE(outcome.database) << outcome.refused;
    EXPECT_EQ(outcome.database->database.colours[0].blue, 210U);
    write(file, "no database");
    EXPECT_THAT(outcome_of(reload).refused, HasSubstr("cannot be read as a visual database"));
}

/// A mistake changes nothing; what mends it may be in a file that was included only then.
TEST_F(Reload, MistakesAreToldAndTheMendingIsSeen) {
    Flight flight(request("w.toml"));
    DatabaseReload reload(flight.scenario().database_path, flight.database_files());
    write(folder_.file("more.toml"), "[[colour]]\nname = \"more\"\nrgb = [1, 2]\n");
    write(folder_.file("w.toml"), "include = [\"boat.toml\", \"more.toml\"]\n" + world);
    const DatabaseReload::Outcome refused = outcome_of(reload);
    EXPECT_FALSE(refused.database);
    EXPECT_THAT(refused.refused, HasSubstr("more.toml:3:"));
    write(folder_.file("more.toml"), "[[colour]]\nname = \"more\"\nrgb = [1, 2, 3]\n");
    const DatabaseReload::Outcome mended = outcome_of(reload);
    ASSERT_TRUE(mended.database) << mended.refused;
    EXPECT_EQ(mended.database->database.colours.size(), 2U);
}

TEST_F(Reload, ADatabaseWithoutTheScenariosNamesIsRefused) {
    Flight flight(request("w.toml"));
    flight.draw(0, {});
    const std::uint64_t id = flight.database_id(), shown = picture(flight);
    std::string text = boat("[200, 0, 0]");
    text.replace(text.find("slot = \"flag\"\nalternative = 0\n"), 30, "");
    write(folder_.file("boat.toml"), text);
    std::string unnamed = world;
    unnamed.replace(unnamed.find("[[slot]]"), std::string::npos, "");
    write(folder_.file("w.toml"), "include = [\"boat.toml\"]\n" + unnamed);
    try {
        flight.replace_database(open_database(folder_.file("w.toml")));
        FAIL() << "not refused";
    } catch (const BadInput& refused) {
        EXPECT_THAT(refused.what(), HasSubstr("\"flag\""));
    }
    EXPECT_EQ(flight.database_id(), id);
    flight.draw(0, {});
    EXPECT_EQ(picture(flight), shown);
}

} // namespace
} // namespace linkdig::tools
