#pragma once

#include "engine/core/session_time.h"

#include <thread>

namespace carina::program
{

/// Gives blocks from 128 KiB on, such as the surfaces of a patient, pages of their own, which go
/// back to the system when they are freed. By default glibc begins so, and stops with the first
/// that is freed; what is left between them in the heap stays with the program.
void returnLargeBlocks();

/// Gives the pages that hold no block back to the system. glibc by itself gives back only those at
/// the end of a heap, and it has a heap for each few threads. Takes milliseconds, in which other
/// threads may wait for the heap.
void returnFreePages();

/// Calls returnFreePages now and then, on a thread of its own.
///
/// Blocks of all sizes come and go with each frame, fact and patient, and what lives on lies
/// between them. The holes would be found again only in part: a program would grow without holding
/// more.
class HeapPages
{
public:
    static constexpr Duration kInterval = std::chrono::seconds{20};

    explicit HeapPages(Duration interval = kInterval);

private:
    std::jthread m_thread;
};

} // namespace carina::program
