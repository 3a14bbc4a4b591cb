#include "demos/reports/stability/cases.h"

#include "demos/reports/stability/chapters.h"
#include "demos/reports/stability/refusals.h"

namespace pushfactor::demos::reports::stability {

std::vector<Chapter> chapters(bool quick) {
    std::vector<Chapter> all{
        heavy_on_light(), heights(),        steps(),   sizes_and_places(), overlaps(), thin(),
        structures(),     impacts(),        passing(), turning(),          bounces(),  slopes(),
        directions(),     slab(),           rolls(),   hovering(),         seams(),    chains(),
        ball_joints(),    redundant_bars(), little(),  refusals()};
    if (!quick) return all;
    for (Chapter& chapter : all) std::erase_if(chapter.cases, [](const Case& one) { return !one.quick; });
    std::erase_if(all, [](const Chapter& chapter) { return chapter.cases.empty(); });
    return all;
}

std::vector<std::string> chapter_names() {
    std::vector<std::string> names;
    for (const Chapter& chapter : chapters(false)) names.push_back(chapter.name);
    return names;
}

}  // namespace pushfactor::demos::reports::stability
