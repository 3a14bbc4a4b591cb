// Makes pieces on several threads.
#pragma once

#include "demos/reports/pieces/piece.h"

#include <functional>
#include <span>

namespace pushfactor::demos::reports {

// Makes the pieces on `jobs` threads, in order. `made` is called in the calling thread for each, in unspecified
// order, as soon as `keep` has been called for it in the thread that made it; `check` is called often. An exception
// of theirs or of a piece ends all: pieces in progress are dropped, and the exception is thrown.
void make_pieces(std::span<const Piece* const> pieces, int jobs,
                 const std::function<void(const Piece&, const Json& result)>& keep,
                 const std::function<void()>& made, const std::function<void()>& check);

}  // namespace pushfactor::demos::reports
