#include "wrinkle/plugin.h"
#include "nodes/all.h"

const wr_plugin* wrinkle_plugin(void) {
    return wrinkle::built_in_nodes();
}
