#include "tests/peers/cases.h"
#include "tests/peers/piles.h"

#include <fmt/format.h>

namespace pushfactor::tests::peers {

namespace {

constexpr std::size_t second = 60;  // steps

const std::vector<Ours>& our_settings() {
    static const std::vector<Ours> settings{
        {"default", "", false},
        {"--scheme whole", "--scheme whole", false},
    };
    return settings;
}

Case pile(const std::string& name, const std::string& title, const std::string& arguments, std::size_t seconds) {
    Case result;
    result.name = name;
    result.title = title;
    result.arguments = arguments;
    result.steps = seconds * second;
    result.ours = our_settings();
    result.group = "piles";
    return result;
}

Case falls(const std::string& name, const std::string& title, const std::string& arguments, std::size_t seconds) {
    Case result = pile(name, title, arguments, seconds);
    result.measure = falling;
    result.cost = median_and_worst;
    result.ratios = {median_cost, typical_overlap};
    return result;
}

Case rests(const std::string& name, const std::string& title, const std::string& arguments) {
    Case result = pile(name, title + ", the last of 20 s", arguments, 20);
    result.measure = settled;
    result.cost = median_and_worst_at_end;
    result.ratios = {median_cost};
    return result;
}

Case stands(const std::string& name, const std::string& title, const std::string& arguments) {
    Case result = pile(name, title + ", 10 s", arguments, 10);
    result.measure = structure;
    result.cost = median_and_worst;
    result.ratios = {median_cost};
    return result;
}

Case pyramid(Case result, int rows) {
    result.pyramid = rows;
    return result;
}

Case of_family(Case result) {
    result.family = true;
    return result;
}

}  // namespace

std::vector<Case> pile_cases() {
    const std::string thousand = "cubes --count 1000 --layers 4 --friction 0.5";
    const std::string mixed = "mixed --count 2000 --layers 7 --friction 0.5";
    const std::string rough = " --friction 0.5";  // the catalogue's funnel has 0.3
    const auto tower = [](int planks, int rings) {
        return fmt::format("round-tower --planks {} --rings {} --friction 0.5", planks, rings);
    };
    const auto cards = [](int storeys) {
        return fmt::format("card-house --storeys {} --slenderness 50 --friction 0.7", storeys);
    };
    const std::string bricks = "wall --rows 20 --columns 20 --friction 0.5 --gap ";
    return {
        of_family(falls("cubes-1000", "1000 cubes fall, 2 s", thousand, 2)),
        of_family(falls("cubes-5000", "5000 cubes fall, 2 s", "cubes --count 5000 --layers 18 --friction 0.5", 2)),
        of_family(falls("mixed-2000", "2000 balls, boxes and cubes fall, 2 s", mixed, 2)),
        of_family(rests("cubes-1000-rest", "1000 cubes", thousand)),
        of_family(rests("mixed-2000-rest", "2000 balls, boxes and cubes", mixed)),
        falls("funnel-200", "200 balls fall into a funnel, friction 0.3, 3 s", "funnel --count 200", 3),
        falls("funnel-200-rough", "The same with friction 0.5, 3 s", "funnel --count 200" + rough, 3),
        falls("funnel-2000", "2000 balls fall into a funnel, friction 0.3, 3 s", "funnel --count 2000", 3),
        falls("funnel-2000-rough", "The same with friction 0.5, 3 s", "funnel --count 2000" + rough, 3),
        rests("funnel-200-rest", "200 balls in a funnel, friction 0.3", "funnel --count 200"),
        rests("funnel-2000-rest", "2000 balls in a funnel, friction 0.3", "funnel --count 2000"),
        rests("funnel-200-rough-rest", "The same with friction 0.5", "funnel --count 200" + rough),
        of_family(stands("kapla-100", "A round tower of 100 planks", tower(10, 10))),
        of_family(stands("kapla-400", "A round tower of 400 planks", tower(10, 40))),
        of_family(stands("kapla-600", "A round tower of 612 planks", tower(17, 36))),
        of_family(stands("wall", "A wall of 20 x 20 bricks", bricks + "0")),
        of_family(stands("wall-gap", "The same, neighbours 2 cm apart", bricks + "0.02")),
        pyramid(stands("pyramid-100", "A pyramid of 5050 cubes, a hundred wide", ""), 100),
        of_family(stands("cards-3", "A house of cards of three storeys", cards(3))),
        of_family(stands("cards-4", "Of four storeys", cards(4))),
        of_family(stands("cards-5", "Of five storeys", cards(5))),
    };
}

}  // namespace pushfactor::tests::peers
