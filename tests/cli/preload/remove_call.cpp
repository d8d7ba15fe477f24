// A library that is loaded before those of glibra. It makes the kernel one that has no Landlock
// (GLIBRA_REMOVE_CALL=landlock) or no seccomp filters (GLIBRA_REMOVE_CALL=seccomp).

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace {

[[gnu::constructor]] void removeCall() {
    const char* name = std::getenv("GLIBRA_REMOVE_CALL");
    if (name == nullptr) return;
    const unsigned call = std::strcmp(name, "landlock") == 0 ? SYS_landlock_create_ruleset : SYS_seccomp;
    sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog program{std::size(code), code};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        std::abort();
}

}  // namespace
