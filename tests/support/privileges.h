// Takes root's right to read and write all files from this process and those that it starts, so
// that file permissions apply. The user stays root: another one might not reach a program below
// /root.
#pragma once

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace wrinkle::test {

// Returns true if the process has no capabilities, as every user but root.
inline bool drop_capabilities() {
    if (geteuid() != 0) return true;
    for (int capability = 0; prctl(PR_CAPBSET_READ, capability) >= 0; ++capability)
        if (prctl(PR_CAPBSET_DROP, capability) != 0) return false;
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const __user_cap_data_struct none[2]{};
    return syscall(SYS_capset, &header, none) == 0;
}

}  // namespace wrinkle::test
