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
    SectionContent (*make)(FigureOutput& output, const Figure& figure);
};

// In page order: the paper's by number, then ours.
std::span<const Figure> all_figures();

SectionContent push_error(FigureOutput& output, const Figure& figure);          // Figure 5
SectionContent stack_over_time(FigureOutput& output, const Figure& figure);     // Figure 6
SectionContent intersecting_stack(FigureOutput& output, const Figure& figure);  // Figure 7
SectionContent funnel(FigureOutput& output, const Figure& figure);              // Figure 8
SectionContent pendulum_grid(FigureOutput& output, const Figure& figure);       // Figure 9
SectionContent pendulum_wave(FigureOutput& output, const Figure& figure);       // Figure 10
SectionContent sphere_in_corner(FigureOutput& output, const Figure& figure);    // Figure 11
SectionContent push_against_beta(FigureOutput& output, const Figure& figure);
SectionContent push_pump(FigureOutput& output, const Figure& figure);
SectionContent intersecting_motion(FigureOutput& output, const Figure& figure);
SectionContent pendulum_energy(FigureOutput& output, const Figure& figure);
SectionContent arch_thickness(FigureOutput& output, const Figure& figure);
SectionContent domino_speed(FigureOutput& output, const Figure& figure);
SectionContent platonic_energy(FigureOutput& output, const Figure& figure);
SectionContent stack_forces(FigureOutput& output, const Figure& figure);

}  // namespace pushfactor::demos::figures
