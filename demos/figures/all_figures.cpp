#include "demos/figures/figure_output.h"

#include <array>

namespace pushfactor::demos::figures {

std::span<const Figure> all_figures() {
    static constexpr std::array figures{
        Figure{"figure_05", "Figure 5: error caused by the push factor", push_error},
        Figure{"figure_06", "Figure 6: stack test", stack_over_time},
        Figure{"figure_07", "Figure 7: intersecting stack test", intersecting_stack},
        Figure{"figure_08", "Figure 8: funnel stack", funnel},
        Figure{"figure_09", "Figure 9: pendulum grid", pendulum_grid},
        Figure{"figure_10", "Figure 10: pendulum wave", pendulum_wave},
        Figure{"figure_11", "Figure 11: sphere resting in a V shaped corner", sphere_in_corner},
        Figure{"push_against_beta", "The push factor against beta", push_against_beta},
        Figure{"push_pump", "Energy from a push that is not solved", push_pump},
        Figure{"intersecting_motion", "Height and speed of the intersecting stack", intersecting_motion},
        Figure{"pendulum_energy", "Energy of a pendulum", pendulum_energy},
        Figure{"stack_forces", "Contact forces of the stack", stack_forces},
        Figure{"arch_thickness", "How thin an arch may be", arch_thickness},
        Figure{"domino_speed", "The wave along dominoes", domino_speed},
        Figure{"platonic_energy", "Regular solids come to rest", platonic_energy},
    };
    return figures;
}

}  // namespace pushfactor::demos::figures
