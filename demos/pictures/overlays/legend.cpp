#include "demos/pictures/overlays/legend.h"

namespace pushfactor::demos::pictures {

std::vector<LegendEntry> entries_of(OverlayKind kind) {
    const auto colour = [](std::string_view name) { return *find_colour(name); };
    switch (kind) {
        case OverlayKind::contacts:
            return {{"contact point", colour("vermilion"), ""}, {"within the margin", colour("ivory"), ""}};
        case OverlayKind::forces:
            return {{"contact force", colour("violet"), "N"},
                    {"bar force", colour("green"), "N"},
                    {"joint force", colour("orange"), "N"},
                    {"force from outside", colour("blue"), "N"}};
        case OverlayKind::torques:
            return {{"torque from outside", colour("blue"), "N m"},
                    {"torque of a motor", colour("vermilion"), "N m"}};
        case OverlayKind::push:
            return {{"push for this frame only", colour("orange"), "m/s"},
                    {"push that lasts", colour("vermilion"), "m/s"}};
        case OverlayKind::islands:
            return {{"one colour per island", colour("vermilion"), ""},
                    {"in no island", colour(colour_of_none), ""}};
        case OverlayKind::rest:
            return {{"at rest", colour("green"), ""},
                    {"still, but held by what is not", colour(colour_of_none), ""},
                    {"moves, or did a moment ago", colour("vermilion"), ""}};
        case OverlayKind::thrust:
            return {{"line of thrust, through the centres of pressure", colour("violet"), ""}};
        case OverlayKind::no_contacts:
            return {{"do not touch each other", colour("vermilion"), ""},
                    {"one group, whose bodies do not touch", colour("blue"), ""}};
        case OverlayKind::trails:
            return {{"path of a centre, in its colour", colour(colour_of_none), ""}};
        case OverlayKind::velocities:
            break;
    }
    return {{"velocity", colour("blue"), "m/s"}, {"of a moved body", colour("orange"), "m/s"}};
}

}  // namespace pushfactor::demos::pictures
