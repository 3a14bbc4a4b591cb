// The table of figures.
#pragma once

#include "demos/pages/page.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pushfactor::demos::figures {

class FigureOutput;

struct Figure {
    std::string_view name;  // also the stem of its files
    std::string_view title;
    Plate (*make)(FigureOutput& output, const Figure& figure);
};

// In page order: the paper's by number, then ours.
std::span<const Figure> all_figures();

Plate push_error(FigureOutput& output, const Figure& figure);          // Figure 5
Plate stack_over_time(FigureOutput& output, const Figure& figure);     // Figure 6
Plate intersecting_stack(FigureOutput& output, const Figure& figure);  // Figure 7
Plate funnel(FigureOutput& output, const Figure& figure);              // Figure 8
Plate pendulum_grid(FigureOutput& output, const Figure& figure);       // Figure 9
Plate pendulum_wave(FigureOutput& output, const Figure& figure);       // Figure 10
Plate sphere_in_corner(FigureOutput& output, const Figure& figure);    // Figure 11
Plate push_against_beta(FigureOutput& output, const Figure& figure);
Plate push_pump(FigureOutput& output, const Figure& figure);
Plate intersecting_motion(FigureOutput& output, const Figure& figure);
Plate pendulum_energy(FigureOutput& output, const Figure& figure);
Plate arch_thickness(FigureOutput& output, const Figure& figure);
Plate domino_speed(FigureOutput& output, const Figure& figure);
Plate platonic_energy(FigureOutput& output, const Figure& figure);
Plate stack_forces(FigureOutput& output, const Figure& figure);

}  // namespace pushfactor::demos::figures
