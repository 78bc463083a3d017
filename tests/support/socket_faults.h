#pragma once

namespace carina::test
{

/// Makes calls of this program fail that send or receive a datagram: sendmsg and recvmsg, which
/// stand in its tests in place of the system's.
namespace socket_faults
{

struct Plan {
    int first = 0; ///< the call that fails first, counted from begin() on, from 1; 0: none
    int calls = 1; ///< how many from there on fail
    int error = 0; ///< errno of the failing calls
};

void begin(const Plan& plan);
/// Calls since begin().
[[nodiscard]] int calls();
/// Of these, how many failed.
[[nodiscard]] int struck();

} // namespace socket_faults

} // namespace carina::test
