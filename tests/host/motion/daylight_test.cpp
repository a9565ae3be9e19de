#include "host/motion/daylight.h"

#include "database/model/mathematics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace linkdig::host {
namespace {

TEST(Daylight, TheSunRisesAtSixAndSetsAtEighteen) {
    EXPECT_NEAR(sun_elevation_deg(6.0), 0.0, 1e-9);
    EXPECT_NEAR(sun_elevation_deg(12.0), 60.0, 1e-9);
    EXPECT_NEAR(sun_elevation_deg(18.0), 0.0, 1e-9);
    EXPECT_NEAR(sun_elevation_deg(0.0), -60.0, 1e-9);
    for (double hour = 0.0; hour < 24.0; hour += 0.25)
        EXPECT_NEAR(sun_elevation_deg(hour), 60.0 * std::sin(2.0 * pi * (hour - 6.0) / 24.0), 1e-9);
}

TEST(Daylight, FullDayChangesNothing) {
    const Daylight day = daylight(12.0);
    EXPECT_TRUE(day.full_day);
    const Colour code{13, 200, 255, 0};
    EXPECT_EQ(tinted(day, code), code);
    for (const double height : {0.0, 0.3, 1.0})
        EXPECT_EQ(sky_colour(day, code, height), code);
    const ListLight light = under(day, 0.3F, 0.7F);
    EXPECT_EQ(light.ambient, 0.3F);
    EXPECT_EQ(light.diffuse, 0.7F);
}

double brightness(Colour code) { return code.red + code.green + code.blue; }

TEST(Daylight, DarkensSteadilyFromNoonToMidnightWithoutAStep) {
    const Colour grey{160, 160, 160, 0};
    const Colour blue{150, 180, 215, 0};
    for (double hour = 12.0; hour < 24.0; hour += 0.01) {
        const Daylight now = daylight(hour);
        const Daylight next = daylight(hour + 0.01);
        EXPECT_LE(brightness(tinted(next, grey)), brightness(tinted(now, grey)) + 1e-9) << hour;
        for (const double height : {0.0, 0.2, 0.4, 0.7, 1.0}) {
            const Colour a = sky_colour(now, blue, height);
            const Colour b = sky_colour(next, blue, height);
            EXPECT_NEAR(a.red, b.red, 4) << hour << " " << height;
            EXPECT_NEAR(a.blue, b.blue, 4) << hour << " " << height;
        }
        EXPECT_LE(next.direct, now.direct);
        EXPECT_GE(next.lamps, now.lamps);
    }
    EXPECT_GT(brightness(tinted(daylight(0.0), grey)), 15.0) << "shapes stay visible at night";
    EXPECT_EQ(daylight(0.0).lamps, 1.0);
}

TEST(Daylight, MorningIsAsEvening) {
    for (double hour = 0.0; hour <= 12.0; hour += 0.5) {
        const Colour code{90, 120, 30, 0};
        EXPECT_EQ(tinted(daylight(12.0 - hour), code), tinted(daylight(12.0 + hour), code)) << hour;
    }
}

TEST(Daylight, LowSunIsWarmAndTwilightCold) {
    const Colour grey{160, 160, 160, 0};
    const auto at = [&](double elevation_deg) {
        return tinted(daylight(18.0 - 24.0 / (2.0 * pi) * std::asin(elevation_deg / 60.0)), grey);
    };
    EXPECT_GT(at(2.0).red, at(2.0).blue);
    EXPECT_LT(at(-12.0).red, at(-12.0).blue);
}

} // namespace
} // namespace linkdig::host
