#include "engine/io/files/confinement.h"

#include "engine/io/files/folder_rule.h"
#include "engine/io/files/system_calls.h"

#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace carina
{
namespace
{

constexpr rlim_t kMostOpenFiles = 16;
constexpr unsigned kFirstAfterStandard = 3;

Result<void> orFail(bool done, const char* what)
{
    return done ? Result<void>{} : fail(Errc::NotConfined, what);
}

template <class Resource> bool limit(Resource resource, rlim_t most, rlim_t hard)
{
    const rlimit limits{most, hard};
    return setrlimit(resource, &limits) == 0;
}

/// The signal comes when the parent ends; that it ended before is seen from who took its place.
bool endsWithParent(int parent)
{
    return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == parent;
}

/// A sanitizer needs address space without limit, files outside the folder and, to look for leaks,
/// a process of its own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

bool limitMemory(std::uint64_t most)
{
    return kIsSanitized || most == 0 || limit(RLIMIT_AS, most, most);
}

/// At the first limit comes SIGXCPU, which tells the parent why; a second later SIGKILL.
bool limitProcessorTime(std::chrono::seconds most)
{
    const auto seconds = static_cast<rlim_t>(most.count());
    return limit(RLIMIT_CPU, seconds, seconds + 1);
}

bool limitFiles()
{
    return syscall(SYS_close_range, kFirstAfterStandard, ~0U, 0U) == 0
           && limit(RLIMIT_NOFILE, kMostOpenFiles, kMostOpenFiles) && limit(RLIMIT_FSIZE, 0, 0)
           && limit(RLIMIT_CORE, 0, 0);
}

} // namespace

Result<void> confine(const Confinement& confinement)
{
    return orFail(endsWithParent(confinement.parent), "its parent has ended")
        .and_then(
            [] { return orFail(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "its privileges"); })
        .and_then([] { return orFail(limitFiles(), "its files"); })
        .and_then([&] { return orFail(limitMemory(confinement.mostMemory), "its memory"); })
        .and_then([&] {
            return orFail(limitProcessorTime(confinement.mostProcessorTime), "its processor time");
        })
        .and_then([&] {
            return orFail(kIsSanitized || !hasLandlock() || keepToFolder(confinement.folder),
                          "its folder");
        })
        .and_then([] { return orFail(kIsSanitized || allowReadingOnly(), "its system calls"); });
}

} // namespace carina
