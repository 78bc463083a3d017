#pragma once

#include <functional>

namespace carina
{

/// Threads that keep time, those of sessions and trackers, go before those that draw and make
/// surfaces: where there are more of them than processors, pictures come later, and no pose does.
/// Without privileges a thread can lower its priority and not raise it, and hands it on to those
/// that it starts. So a program lowers its own at the beginning, and one thread keeps the first
/// priority to start these with.

/// Lowers the calling thread, and all that it starts from now on but by startPromptly(). To be
/// called first in a program, once.
void makeWayForPromptThreads();
/// Calls `start`, which must not throw, and returns when it has returned. Threads that it starts
/// have the priority that the program began with.
void startPromptly(const std::function<void()>& start);

} // namespace carina
