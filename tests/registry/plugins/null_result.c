#include <wrinkle/plugin.h>
WR_EXPORT const wr_plugin* wrinkle_plugin(void) {
    return 0;
}
