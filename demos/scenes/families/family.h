// Families of scenes: members are drawn at random within the ranges of the parameters and judged by properties,
// among them the end that mechanics predicts.
#pragma once

#include "demos/scenes/parameters.h"
#include "demos/scenes/random.h"
#include "demos/scenes/scene_description.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pushfactor::demos::families {

using scenes::Random;

// The end that mechanics predicts for a member.
//   stands   no body leaves its place
//   rests    everything comes to rest, somewhere
//   slides   some bodies leave their places without falling over
//   topples  some bodies fall over
enum class Ends { stands, rests, slides, topples };

enum class Draw { evenly, by_decades };

// A parameter: allowed and drawn values are `range.low` to `range.high`.
struct FamilyParameter {
    Parameter range;
    Draw draw = Draw::evenly;
};

// The scene of a member and its expected end.
struct Prospect {
    SceneDescription scene;
    Ends ends = Ends::stands;
    double rest_by = 3.0;                // s; the scene runs for another second
    std::vector<std::string> leaving{};  // bodies that slide or topple
    bool stirred = false;                // rolling balls may go on for ever and hit resting bodies
};

struct Family {
    std::string_view name;
    std::string_view sentence;  // description
    std::string_view why;       // expected end, and why
    std::vector<FamilyParameter> parameters;
    Prospect (*describe)(const ParameterValues& values, Random& random);
};

std::span<const Family> families();

// Null if there is no family of that name.
const Family* find_family(std::string_view name);

// Parameter values as texts, by name.
using GivenValues = std::vector<std::pair<std::string, std::string>>;

struct Choice {
    int seed = 1;
    GivenValues given{};  // names of the family's parameters, allowed values
};

struct Member {
    const Family* family = nullptr;
    int seed = 0;
    GivenValues values;  // of all parameters, in their order
    Prospect prospect;

    std::string command() const;  // prints its scene
};

// The value that a seed draws for a parameter, as text; another attempt draws another one.
std::string drawn_value(const Family& family, const FamilyParameter& parameter, int seed, int attempt = 0);

// Draws a member, the same for equal choices. Given values do not change the others. Throws std::invalid_argument
// for a value that the family does not allow.
Member draw_member(const Family& family, const Choice& choice);

}  // namespace pushfactor::demos::families
