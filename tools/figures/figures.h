#pragma once
/// The report's figures, each with a check.

#include "tools/figures/findings.h"

namespace linkdig::tools {

void static_seas(Findings& findings);   ///< Figures 1, 2, 3
void stepping(Findings& findings);      ///< 3.1.4: normals updated every 1, 2, 4, 8
                                        ///< frames; a sheet over size and repetition
void sea_states(Findings& findings);    ///< Figures 4, 5, 6
void ocean_sun(Findings& findings);     ///< Figure 7
void squares(Findings& findings);       ///< Figures 8 to 11
void directions(Findings& findings);    ///< swell and random pattern, 3.1.4
void bow_wakes(Findings& findings);     ///< Figures 12 and 13
void churned_water(Findings& findings); ///< Figure 14
void occulting(Findings& findings);     ///< Figure 15, and 3.3.1's methods against
                                        ///< a ray caster
void costs(Findings& findings);         ///< what each effect costs, 3.1.4 and 4.0
/// The film: FOLDER/report.mp4, `seconds` long. Nothing where the program
/// cannot write films.
void film(const Findings& findings, double seconds);

} // namespace linkdig::tools
