#include "engine/io/files/system_calls.h"

#include <cerrno>
#include <fcntl.h>
#include <initializer_list>
#include <memory>
#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

namespace carina
{
namespace
{

/// Rules that are being collected; false stays false.
class Rules
{
public:
    Rules() : m_filter{seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release}
    {
        m_good = m_filter != nullptr
                 && seccomp_attr_set(m_filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS)
                        == 0;
    }

    void allow(std::initializer_list<int> calls) { add(SCMP_ACT_ALLOW, calls); }
    void endAt(std::initializer_list<int> calls) { add(SCMP_ACT_KILL_PROCESS, calls); }
    void allow(int call, scmp_arg_cmp argument)
    {
        m_good = m_good
                 && seccomp_rule_add_array(m_filter.get(), SCMP_ACT_ALLOW, call, 1, &argument) == 0;
    }
    [[nodiscard]] bool load() { return m_good && seccomp_load(m_filter.get()) == 0; }

private:
    void add(std::uint32_t action, std::initializer_list<int> calls)
    {
        for (const int call : calls)
            m_good =
                m_good && seccomp_rule_add_array(m_filter.get(), action, call, 0, nullptr) == 0;
    }

    std::unique_ptr<void, decltype(&seccomp_release)> m_filter;
    bool m_good;
};

/// An argument that has none of these bits.
scmp_arg_cmp without(unsigned argument, int bits)
{
    return {argument, SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(bits), 0};
}

scmp_arg_cmp equalTo(unsigned argument, int value)
{
    return {argument, SCMP_CMP_EQ, static_cast<scmp_datum_t>(value), 0};
}

void allowFiles(Rules& rules)
{
    constexpr int kChanging = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC | O_APPEND;
    rules.allow(SCMP_SYS(open), without(1, kChanging));
    rules.allow(SCMP_SYS(openat), without(2, kChanging));
    rules.allow({SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(lseek),
                 SCMP_SYS(close), SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(fstat),
                 SCMP_SYS(newfstatat), SCMP_SYS(statx), SCMP_SYS(access), SCMP_SYS(faccessat),
                 SCMP_SYS(faccessat2), SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd)});
    // To the standard descriptors only: no other can be written to.
    rules.allow({SCMP_SYS(write), SCMP_SYS(writev)});
}

void allowMemory(Rules& rules)
{
    rules.allow(SCMP_SYS(mmap), without(2, PROT_EXEC));
    rules.allow(SCMP_SYS(mprotect), without(2, PROT_EXEC));
    rules.allow({SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(madvise), SCMP_SYS(brk)});
}

/// What the C library asks of any program, and ending.
void allowRunning(Rules& rules)
{
    rules.allow({SCMP_SYS(futex), SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday),
                 SCMP_SYS(getrandom), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(sched_yield),
                 SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(restart_syscall),
                 SCMP_SYS(exit), SCMP_SYS(exit_group)});
    rules.allow(SCMP_SYS(tgkill), equalTo(0, getpid())); // std::abort
}

void endAtAttacks(Rules& rules)
{
    rules.endAt({SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(connect), SCMP_SYS(bind),
                 SCMP_SYS(listen), SCMP_SYS(accept), SCMP_SYS(accept4), SCMP_SYS(sendto),
                 SCMP_SYS(sendmsg), SCMP_SYS(sendmmsg), SCMP_SYS(recvfrom), SCMP_SYS(recvmsg),
                 SCMP_SYS(io_uring_setup)});
    rules.endAt({SCMP_SYS(fork), SCMP_SYS(vfork), SCMP_SYS(clone), SCMP_SYS(clone3),
                 SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(kill), SCMP_SYS(tkill)});
    rules.endAt({SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev),
                 SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd), SCMP_SYS(unshare),
                 SCMP_SYS(setns), SCMP_SYS(mount), SCMP_SYS(keyctl), SCMP_SYS(add_key)});
}

} // namespace

bool allowReadingOnly()
{
    Rules rules;
    allowFiles(rules);
    allowMemory(rules);
    allowRunning(rules);
    endAtAttacks(rules);
    return rules.load();
}

} // namespace carina
