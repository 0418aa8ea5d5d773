#include "small_node.h"
extern int nobody_has_this(void);
SMALL_PLUGIN("missing", "small", WR_ABI)
WR_EXPORT int asks(void);
WR_EXPORT int asks(void) {
    return nobody_has_this();
}
