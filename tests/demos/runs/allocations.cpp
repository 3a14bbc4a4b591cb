// Calls are forwarded to the next definition: the C library's, or that of a profiler that was loaded before it.
// Memory comes from there and goes back there, so free() is not replaced.
#include "tests/demos/runs/allocations.h"

#include <dlfcn.h>

#include <atomic>
#include <cstddef>

namespace pushfactor::tests {

namespace {

constinit thread_local Allocations so_far;

#ifdef PUSHFACTOR_COUNTS_ALLOCATIONS

// The next definition of that name after this program's own.
template <typename Function>
class Next {
  public:
    constexpr explicit Next(const char* name) : name_(name) {}

    // Several threads may look it up at the same time: they find the same one.
    Function* get() {
        Function* found = found_.load(std::memory_order_relaxed);
        if (!found) {
            found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name_));
            found_.store(found, std::memory_order_relaxed);
        }
        return found;
    }

  private:
    const char* name_;
    std::atomic<Function*> found_ = nullptr;
};

constinit Next<void*(std::size_t)> next_malloc("malloc");
constinit Next<void*(std::size_t, std::size_t)> next_calloc("calloc");
constinit Next<void*(void*, std::size_t)> next_realloc("realloc");
constinit Next<void*(std::size_t, std::size_t)> next_aligned_alloc("aligned_alloc");
constinit Next<int(void**, std::size_t, std::size_t)> next_posix_memalign("posix_memalign");

// Before main(): dlsym() within another dl function, which allocates too, would overwrite its error message.
[[maybe_unused]] const bool all_found = [] {
    next_malloc.get();
    next_calloc.get();
    next_realloc.get();
    next_aligned_alloc.get();
    next_posix_memalign.get();
    return true;
}();

void count(std::size_t bytes) {
    ++so_far.count;
    so_far.bytes += bytes;
}

#endif

}  // namespace

Allocations allocations() {
    return so_far;
}

bool allocations_are_counted() {
#ifdef PUSHFACTOR_COUNTS_ALLOCATIONS
    return true;
#else
    return false;
#endif
}

#ifdef PUSHFACTOR_COUNTS_ALLOCATIONS

extern "C" {

// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
void* malloc(std::size_t bytes) noexcept {
    count(bytes);
    return next_malloc.get()(bytes);
}

void* calloc(std::size_t number, std::size_t bytes) noexcept {
    count(number * bytes);
    return next_calloc.get()(number, bytes);
}

void* realloc(void* memory, std::size_t bytes) noexcept {
    count(bytes);
    return next_realloc.get()(memory, bytes);
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
    count(bytes);
    return next_aligned_alloc.get()(alignment, bytes);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) noexcept {
    count(bytes);
    return next_posix_memalign.get()(memory, alignment, bytes);
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)

}  // extern "C"

#endif

}  // namespace pushfactor::tests
