#pragma once

namespace carina
{

/// Leaves the process the system calls with which a program reads files and takes memory, for good
/// (seccomp). A call for a socket, a process, a program or another process's memory ends it with
/// SIGSYS; any other call fails with EPERM.
/// @pre the process can gain no privileges
/// @returns false where the kernel has no seccomp.
[[nodiscard]] bool allowReadingOnly();

} // namespace carina
