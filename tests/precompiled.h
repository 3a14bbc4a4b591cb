// Precompiled for all tests: what costs most to compile. Sources include what they use themselves.
#pragma once

#include "engine/constraints/contact_constraints.h"
#include "engine/constraints/distance_constraints.h"
#include "engine/world.h"
#include "tests/catch.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
