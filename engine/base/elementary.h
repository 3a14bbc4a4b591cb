// Elementary functions with the same bits on every machine. IEEE 754 fixes the arithmetic and the square root; what
// sin(x) rounds to each C library decides for itself, and after some hundred steps a run would be another one.
//
// At most 1 unit in the last place off (sin and cos for |x| <= 2^20; beyond, the error of an argument of that size,
// 2^-54 |x|, comes on top), special values as IEEE 754 says (9.2.1). Round to nearest and no contraction are
// assumed.
#pragma once

namespace pushfactor::engine::elementary {

struct SineCosine {
    double sine, cosine;
};

SineCosine sine_cosine(double x);
double sin(double x);
double cos(double x);
double atan2(double y, double x);
double hypot(double x, double y);
double cbrt(double x);
double exp(double x);
double log(double x);

}  // namespace pushfactor::engine::elementary
