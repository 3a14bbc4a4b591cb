// Compiled by ctest, not by the build: a newton plus an ADDEND, which compiles for a newton and for nothing else.
#include "tests/engine/paper/units.h"

using namespace pushfactor::tests::units;

constexpr Newton sum = Newton{1.0} + ADDEND{1.0};
static_assert(sum.value == 2.0);
