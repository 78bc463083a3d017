#pragma once

#include "engine/core/session_time.h"

#include <thread>

namespace carina::program
{

/// One heap for all threads: by default glibc has one for each few, and what a thread leaves free
/// in its own the others do not use. Blocks from 128 KiB on, such as the surfaces of a patient, get
/// pages of their own, which go back to the system when they are freed; by default that stops with
/// the first that is freed. To be called before the first thread starts.
void useOneHeap();

/// Gives the pages that hold no block back to the system. glibc by itself gives back only those at
/// the end of the heap. Takes milliseconds, in which other threads may wait for the heap.
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
