#include "tests/support/socket_faults.h"

#include <atomic>
#include <cerrno>
#include <dlfcn.h>
#include <sys/socket.h>

namespace carina::test::socket_faults
{
namespace
{

std::atomic<int> s_first{0};
std::atomic<int> s_last{0};
std::atomic<int> s_error{0};
std::atomic<int> s_calls{0};
std::atomic<int> s_struck{0};

bool isDatagram(int socket)
{
    int type = 0;
    socklen_t length = sizeof type;
    return getsockopt(socket, SOL_SOCKET, SO_TYPE, &type, &length) == 0 && type == SOCK_DGRAM;
}

bool strikes(int socket)
{
    if (!isDatagram(socket))
        return false;
    const int number = ++s_calls;
    if (number < s_first || number > s_last)
        return false;
    ++s_struck;
    errno = s_error;
    return true;
}

template <class Function> Function* next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

void begin(const Plan& plan)
{
    s_first = plan.first == 0 ? 1 : plan.first;
    s_last = plan.first == 0 ? 0 : plan.first + plan.calls - 1;
    s_error = plan.error;
    s_calls = 0;
    s_struck = 0;
}

int calls() { return s_calls; }
int struck() { return s_struck; }

} // namespace carina::test::socket_faults

extern "C" {

ssize_t sendmsg(int socket, const msghdr* message, int flags)
{
    static const auto call =
        carina::test::socket_faults::next<ssize_t(int, const msghdr*, int)>("sendmsg");
    return carina::test::socket_faults::strikes(socket) ? -1 : call(socket, message, flags);
}

ssize_t recvmsg(int socket, msghdr* message, int flags)
{
    static const auto call =
        carina::test::socket_faults::next<ssize_t(int, msghdr*, int)>("recvmsg");
    return carina::test::socket_faults::strikes(socket) ? -1 : call(socket, message, flags);
}
}
