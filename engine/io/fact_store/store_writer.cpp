#include "engine/io/fact_store/store_writer.h"

#include "engine/core/expects.h"

#include <utility>

namespace carina
{

StoreWriter::StoreWriter(std::unique_ptr<FactStore> store)
    : m_store{std::move(store)}, m_thread{[this](const std::stop_token& stopping) {
          run(stopping);
      }}
{
}

StoreWriter::~StoreWriter()
{
    m_thread.request_stop();
    m_thread.join();
}

void StoreWriter::onReport(std::function<void()> callback)
{
    const std::scoped_lock lock{m_mutex};
    m_onReport = std::move(callback);
}

void StoreWriter::write(StoreJob job)
{
    CARINA_EXPECTS(!m_isBusy);
    m_isBusy = true;
    const std::scoped_lock lock{m_mutex};
    m_job = std::move(job);
    m_changed.notify_all();
}

std::optional<StoreReport> StoreWriter::take()
{
    const std::scoped_lock lock{m_mutex};
    if (m_report)
        m_isBusy = false;
    return std::exchange(m_report, std::nullopt);
}

StoreReport StoreWriter::wait()
{
    CARINA_EXPECTS(m_isBusy);
    m_isBusy = false;
    std::unique_lock lock{m_mutex};
    m_changed.wait(lock, [this] { return m_report.has_value(); });
    return *std::exchange(m_report, std::nullopt);
}

void StoreWriter::run(const std::stop_token& stopping)
{
    std::unique_lock lock{m_mutex};
    while (m_changed.wait(lock, stopping, [this] { return m_job.has_value(); })) {
        const StoreJob job = *std::exchange(m_job, std::nullopt);
        lock.unlock();
        StoreReport report = done(job);
        lock.lock();
        m_report = std::move(report);
        m_changed.notify_all();
        const std::function<void()> callback = m_onReport;
        lock.unlock();
        if (callback)
            callback();
        lock.lock();
    }
    m_store.reset(); // its connection is this thread's
}

StoreReport StoreWriter::done(const StoreJob& job)
{
    StoreReport report;
    if (const auto beside = job.beside ? job.beside() : Result<void>{}; !beside)
        report.facts = fail(Errc::StoreFailed, beside.error().detail);
    else if (!job.facts.empty())
        report.facts = m_store->append(job.facts);
    if (!job.actions.empty())
        report.actions = m_store->keepActions(job.actions);
    report.moved = m_store->keepWhole();
    return report;
}

} // namespace carina
