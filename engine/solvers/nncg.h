// The nonsmooth nonlinear conjugate gradient method (Silcowitz-Hansen, Niebe & Erleben 2010): sweeps of paper
// section 7, each followed by an extrapolation along the previous ones. An iteration costs 1.6 times the
// multiply-adds of one of `pgs`, and far fewer are needed for high accuracy; not monotone.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

std::unique_ptr<Solver> make_nncg();

}  // namespace pushfactor::engine::solvers
