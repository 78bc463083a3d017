#pragma once

#include "engine/core/progress.h"

#include <QObject>
#include <QThread>

#include <atomic>
#include <memory>

namespace carina
{

/// One long work after another, each on a thread of its own, with its progress; it can be
/// cancelled.
class BackgroundWork : public QObject
{
    Q_OBJECT

public:
    /// Asks now and then whether to go on. Uses nothing that this thread uses meanwhile.
    using Work = std::function<void(const Progress& goesOn)>;

    BackgroundWork() = default;
    /// Cancels the work and waits for its thread.
    ~BackgroundWork() override;

    /// @pre nothing is under way.
    void start(Work work);
    /// Ends it as soon as it asks; finished() follows.
    void cancel() { m_isCancelled = true; }
    /// Waits for its end, at the end of a program.
    void wait();
    /// Until finished().
    [[nodiscard]] bool isUnderWay() const { return m_thread != nullptr; }
    [[nodiscard]] int percent() const { return m_percent; }

Q_SIGNALS:
    void progressed();
    void finished();

private:
    std::atomic<bool> m_isCancelled = false;
    std::atomic<int> m_percent = 0;
    std::unique_ptr<QThread> m_thread;
};

} // namespace carina
