#include "editor/model/worker.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace wrinkle::editor {

void yield_to_interface() {
#ifdef __linux__
    constexpr int steps = 10;  // nice levels; `who` 0 is the calling thread
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps);
#endif
}

}  // namespace wrinkle::editor
