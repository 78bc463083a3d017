#pragma once

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QTimer>

#include <chrono>

namespace carina::test
{

/// Runs this thread's events until it holds; false if it does not within the patience. Looks after
/// every event and each millisecond, for what other threads do. The waiting macros of QTest sleep
/// 10 ms between the events and look every 50 ms, so that a test of many exchanges mostly sleeps.
template <class Holds>
[[nodiscard]] bool soon(const Holds& holds,
                        std::chrono::milliseconds patience = std::chrono::seconds{5})
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
