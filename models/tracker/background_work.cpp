#include "models/tracker/background_work.h"

#include "engine/core/expects.h"

#include <utility>

namespace carina
{

BackgroundWork::~BackgroundWork()
{
    cancel();
    wait();
}

void BackgroundWork::start(Work work)
{
    CARINA_EXPECTS(!isUnderWay());
    m_isCancelled = false;
    m_percent = 0;
    m_thread.reset(QThread::create([this, work = std::move(work)] {
        work([this](double share) {
            const int percent = int(100.0 * share);
            if (m_percent.exchange(percent) != percent)
                Q_EMIT progressed();
            return !m_isCancelled;
        });
    }));
    connect(m_thread.get(), &QThread::finished, this, [this] {
        m_thread->wait();
        m_thread.release()->deleteLater();
        Q_EMIT finished();
    });
    m_thread->start();
}

void BackgroundWork::wait()
{
    if (m_thread)
        m_thread->wait();
}

} // namespace carina
