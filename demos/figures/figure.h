// A figure: what it is called, and what makes it.
#pragma once

#include "demos/pages/page.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::figures {

class Workshop;

struct Figure {
    std::string_view name;  // also of its files
    std::string_view title;
    Plate (*make)(Workshop& workshop, const Figure& figure);
};

// In the order of the page: those of the paper by number, then ours.
std::span<const Figure> all_figures();

Plate push_error(Workshop& workshop, const Figure& figure);          // Figure 5
Plate stack_over_time(Workshop& workshop, const Figure& figure);     // Figure 6
Plate intersecting_stack(Workshop& workshop, const Figure& figure);  // Figure 7
Plate funnel(Workshop& workshop, const Figure& figure);              // Figure 8
Plate pendulum_grid(Workshop& workshop, const Figure& figure);       // Figure 9
Plate pendulum_wave(Workshop& workshop, const Figure& figure);       // Figure 10
Plate sphere_in_corner(Workshop& workshop, const Figure& figure);    // Figure 11
Plate push_against_beta(Workshop& workshop, const Figure& figure);
Plate push_pump(Workshop& workshop, const Figure& figure);
Plate intersecting_motion(Workshop& workshop, const Figure& figure);
Plate pendulum_energy(Workshop& workshop, const Figure& figure);
Plate stack_forces(Workshop& workshop, const Figure& figure);

}  // namespace pushfactor::demos::figures
