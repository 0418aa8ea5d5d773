#include <wrinkle/plugin.h>
WR_EXPORT int something_else(void);
WR_EXPORT int something_else(void) {
    return 1;
}
