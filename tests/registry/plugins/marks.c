/* Reports the process that runs its code: a constructor writes to the file WRINKLE_TEST_MARK. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "small_node.h"
SMALL_PLUGIN("marks", "marked", WR_ABI)
__attribute__((constructor)) static void mark(void) {
    const char* name = getenv("WRINKLE_TEST_MARK");
    FILE* file = name ? fopen(name, "a") : NULL;
    if (!file) return;
    fprintf(file, "%ld\n", (long)getpid());
    fclose(file);
}
