#pragma once

namespace carina::test
{

/// Makes calls of this program fail that send or receive over the network: sendmsg and recvmsg of
/// datagrams, or write and read of connections by TCP. They stand in its tests in place of the
/// system's.
namespace socket_faults
{

enum class Of { Datagrams, Connections };

struct Plan {
    Of of = Of::Datagrams; ///< whose calls count
    int first = 0;         ///< the call that fails first, counted from begin() on, from 1; 0: none
    int calls = 1;         ///< how many from there on fail
    int error = 0;         ///< errno of the failing calls
};

void begin(const Plan& plan);
/// Calls since begin().
[[nodiscard]] int calls();
/// Of these, how many failed.
[[nodiscard]] int struck();

} // namespace socket_faults

} // namespace carina::test
