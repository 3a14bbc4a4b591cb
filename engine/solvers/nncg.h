// The nonsmooth nonlinear conjugate gradient method (Silcowitz-Hansen, Niebe & Erleben 2010): the sweep of paper
// section 7, and after it a step on in the direction of the sweeps before. An iteration costs 1.6 times the
// multiply-adds of one of `pgs`, and far fewer are needed where accuracy is wanted; it is not monotone.
#pragma once

#include "engine/solvers/solver.h"

#include <memory>

namespace pushfactor::engine::solvers {

std::unique_ptr<Solver> make_nncg();

}  // namespace pushfactor::engine::solvers
