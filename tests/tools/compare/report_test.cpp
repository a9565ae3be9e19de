// The report in a browser: what it shows, and that its keys work. Chromium is asked if it is there.

#include "tests/tools/compare/frames.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace linkdig::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A report of two frames that differ, with names that would begin a script.
class CompareReport : public testing::Test {
protected:
    void SetUp() override {
        const std::string a = folder.file("expected");
        const std::string b = folder.file("actual");
        write_sequence(a, "f<script>&_", 3);
        write_sequence(b, "f<script>&_", 3);
        Frame off = test_frame(40, 30, 2);
        off.at(10, 10, 1) ^= 64U;
        write_frame(b + "/f<script>&_0002.png", off);
        off = test_frame(40, 30, 3);
        off.at(30, 20, 2) ^= 1U;
        write_frame(b + "/f<script>&_0003.png", off);
    }
    std::string report() const {
        const std::string page = folder.file("report.html");
        const Outcome outcome = run("compare " + in_quotes(folder.file("expected")) + " " +
                                    in_quotes(folder.file("actual")) + " --report " + in_quotes(page));
        EXPECT_EQ(outcome.exit_code, 1) << outcome.errors;
        return bytes_of(page);
    }
    /// The document after its script has run, with more script at its end.
    std::string browsed(const std::string& page, const std::string& more) const {
        const std::string file = folder.file("browsed.html");
        std::ofstream(file) << page << "<script>" << more << "</script>";
        const std::string command =
            "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
            "--disable-background-networking --disable-component-update --disable-sync --user-data-dir='" +
            folder.file("profile") + "' --virtual-time-budget=3000 --dump-dom 'file://" + file +
            "' 2>/dev/null";
        std::string document;
        FILE* pipe = popen(command.c_str(), "r");
        std::array<char, 4096> buffer{};
        while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
            document += buffer.data();
        if (pipe != nullptr) pclose(pipe);
        return document;
    }
    TemporaryFolder folder;
};

TEST_F(CompareReport, StandsAlone) {
    const std::string page = report();
    for (const char* outside : {"http:", "https:", "src=\"/", "@import", "<link"})
        EXPECT_THAT(page, Not(HasSubstr(outside)));
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,iVBORw0KGgo"));
}

TEST_F(CompareReport, WorksInABrowser) {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "no chromium";
    const std::string page = report();
    const std::string still = browsed(page, "");
    EXPECT_THAT(still, HasSubstr("differs: 3 frames; 2 differ"));
    EXPECT_THAT(still, testing::ContainsRegex("<tr class=\"chosen\"><td>[^<]*0002.png</td><td>1</td>"));
    EXPECT_THAT(still, HasSubstr("data-picture=\"expected\""));
    EXPECT_THAT(still, HasSubstr("data-picture=\"difference\""));
    EXPECT_THAT(still, HasSubstr("line 10, element 10, channel 1"));
    const std::string pressed = browsed(
        page, "for (const key of ['ArrowDown', 's', '+', '+', '-', 'ArrowRight'])"
              " dispatchEvent(new KeyboardEvent('keydown', { key }));"
              "const wide = [...document.images].map(i => i.naturalWidth + 'x' + i.style.width).join();"
              "document.title = 'pictures ' + wide;");
    EXPECT_THAT(pressed,
                testing::ContainsRegex("<body[^>]* data-frame=\"1\" data-view=\"slider\" data-zoom=\"2\""));
    EXPECT_THAT(pressed, testing::ContainsRegex("<tr class=\"chosen\"><td>[^<]*0003.png</td>"));
    EXPECT_THAT(pressed, HasSubstr("clip-path: inset(0px 0px 0px 52%)"));
    const std::string flicker = browsed(page, "dispatchEvent(new KeyboardEvent('keydown', { key: 'f' }));"
                                              "const seen = new Set(); setInterval(() => { "
                                              "seen.add(document.querySelector('.over').style.visibility);"
                                              "document.title = 'seen ' + [...seen].sort().join(); }, 100);");
    EXPECT_THAT(flicker, HasSubstr("seen hidden,visible"));
}

} // namespace
} // namespace linkdig::tools
