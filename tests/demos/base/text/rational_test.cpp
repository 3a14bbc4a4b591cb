#include "demos/base/text/rational.h"

#include "tests/catch.h"

using namespace pushfactor::demos;

TEST_CASE("times are read exactly, as fractions and as decimals") {
    CHECK(parse_rational("1/60") == Rational{1, 60});
    CHECK(parse_rational("2/120") == Rational{1, 60});
    CHECK(parse_rational("0.02") == Rational{1, 50});
    CHECK(parse_rational("1e-3") == Rational{1, 1000});
    CHECK(parse_rational("2.5e+2") == Rational{250, 1});
    CHECK(parse_rational("-3") == Rational{-3, 1});
    CHECK(parse_rational("0") == Rational{0, 1});
}

TEST_CASE("what is no exact number is no rational") {
    for (const char* text :
         {"", "nan", "inf", "1/0", "1/-2", "1/", "/2", "0x10", "1.2.3", "1e99", "1 ", "12345678901234567890"}) {
        INFO(text);
        CHECK(!parse_rational(text));
    }
}

TEST_CASE("text and value of a rational are each other's inverse") {
    for (const char* text : {"1/60", "0.02", "3", "0.5", "31/60", "-0.125", "0"}) {
        CHECK(to_text(*parse_rational(text)) == text);
    }
}

TEST_CASE("60 steps of 1/60 s are exactly one second") {
    CHECK(Rational{1, 60} * Rational{60, 1} == Rational{1, 1});
    CHECK(Rational{1, 1} / (Rational{30, 1} * Rational{1, 60}) == Rational{2, 1});
}
