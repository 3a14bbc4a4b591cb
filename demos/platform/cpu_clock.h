// CPU clock of a thread.
#pragma once

namespace pushfactor::demos {

// CPU time of this thread in us.
double thread_cpu_us();

}  // namespace pushfactor::demos
