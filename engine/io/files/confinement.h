#pragma once

#include "engine/core/result.h"

#include <chrono>
#include <cstdint>
#include <filesystem>

namespace carina
{

/// What a process may use that reads foreign files.
struct Confinement {
    int parent = 0;               ///< process that started this one
    std::filesystem::path folder; ///< the only one whose files it may read
    std::uint64_t mostMemory = 0; ///< bytes of address space; 0 leaves it unlimited
    std::chrono::seconds mostProcessorTime{0};
};

/// Confines the calling process, which has one thread, for the rest of its life:
///
/// - It ends when the thread that started it does.
/// - It gains no privileges, has no descriptors but the standard three, opens at most a few files,
///   writes none and leaves no core dump.
/// - It ends when it asks for a socket, a process, a program or another process's memory (seccomp).
///   Of the other system calls it has those with which a program reads files and takes memory; the
///   rest fail with EPERM.
/// - It reads files of one folder and of those below it only, where the kernel has Landlock. Where
///   it has not, this process must compare paths itself (pathWithin).
///
/// Memory, files and system calls are not limited in a build with the address or thread sanitizer,
/// whose own code needs more than this leaves.
///
/// @returns NotConfined where something of it could not be done, other than Landlock. The process
///          must then read nothing.
[[nodiscard]] Result<void> confine(const Confinement& confinement);

/// Whether the kernel can keep a process to a folder.
[[nodiscard]] bool hasLandlock();

} // namespace carina
