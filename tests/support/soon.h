#pragma once

#include "tests/support/patience.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QTimer>

#include <chrono>

namespace carina::test
{

/// Processes this thread's events until a condition holds; false if it does not within `patience`.
/// The condition is evaluated after every event and each millisecond, for changes by other threads.
/// The waiting macros of QTest sleep 10 ms between events and test every 50 ms, so that a test of
/// many exchanges mostly sleeps.
template <class Holds>
[[nodiscard]] bool
soon(const Holds& holds,
     std::chrono::milliseconds patience = std::chrono::milliseconds{kPatience_ms})
{
    const QDeadlineTimer end{patience};
    QTimer looking;
    looking.setTimerType(Qt::PreciseTimer);
    looking.start(std::chrono::milliseconds{1});
    while (!holds()) {
        if (end.hasExpired())
            return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    return true;
}

} // namespace carina::test
