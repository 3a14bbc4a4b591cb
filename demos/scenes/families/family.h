// Families of scenes: a member is drawn at random within the ranges of its parameters and judged by properties, one
// of them what mechanics says of how it ends.
#pragma once

#include "demos/scenes/named/random.h"
#include "demos/scenes/parameters.h"
#include "demos/scenes/scene_description.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pushfactor::demos::families {

using scenes::Random;

// How a member ends.
//   stands   no body leaves its place
//   rests    everything comes to rest, somewhere
//   slides   some bodies leave their places without falling over
//   topples  some bodies fall over
enum class Ends { stands, rests, slides, topples };
std::string_view name_of(Ends ends);

enum class Draw { evenly, by_decades };

// `range.low` to `range.high` is what may be given, and what members are drawn from; small members, for tests, from
// the narrower one.
struct FamilyParameter {
    Parameter range;
    double small_low = 0.0, small_high = 0.0;
    Draw draw = Draw::evenly;
};

// What a member is, and what is expected of it.
struct Prospect {
    SceneDescription scene;
    Ends ends = Ends::stands;
    double rest_by = 3.0;                // s; the scene runs for another second
    std::vector<std::string> leaving{};  // bodies that slide or topple
    bool stirred = false;                // balls roll about for as long as they like, and into what rests
};

struct Family {
    std::string_view name;
    std::string_view sentence;  // what it is
    std::string_view why;       // how it ends, and why
    std::vector<FamilyParameter> parameters;
    Prospect (*describe)(const ParameterValues& values, Random& random);
};

std::span<const Family> families();

// Null when there is no family of that name.
const Family* find_family(std::string_view name);

// A value that is given as text for a parameter.
using GivenValues = std::vector<std::pair<std::string, std::string>>;

struct Choice {
    int seed = 1;
    GivenValues given{};  // names that the family has, values that are allowed
    bool small = false;
    std::optional<std::size_t> most_bodies{};  // drawn again until there are no more
};

struct Member {
    const Family* family = nullptr;
    int seed = 0;
    GivenValues values;  // of all parameters, in their order
    Prospect prospect;

    std::string command() const;  // that prints its scene
};

// The same choice gives the same member. A value that is given changes no other value. Throws std::invalid_argument
// for a value that the family does not allow.
Member draw_member(const Family& family, const Choice& choice);

}  // namespace pushfactor::demos::families
