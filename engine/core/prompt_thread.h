#pragma once

#include <functional>

namespace carina
{

/// Threads that keep time, those of sessions and trackers (but for cameras, whose pictures cost as
/// much as drawing), have ten times the share of a processor that those have which draw and make
/// surfaces: where there is not enough for all, pictures come later rather than poses. Without
/// privileges a thread can lower its priority and not raise it, and hands it on to those that it
/// starts. So a program lowers its own at the beginning, and one thread keeps the first priority to
/// start these with.

/// Lowers the calling thread, and all that it starts from now on but by startPromptly(). To be
/// called first in a program, once.
void makeWayForPromptThreads();
/// Calls `start`, which must neither throw nor call this, and returns when it has returned. Threads
/// that it starts have the priority that the program began with.
void startPromptly(const std::function<void()>& start);
/// Lowers the calling thread as a program that makes way lowers its first; for work that a prompt
/// thread began and that is none itself. No effect in a program that does not make way.
void makeWay();

} // namespace carina
