#define PUSHFACTOR_CATCH_MAIN
#include "tests/catch.h"
