#pragma once

#include "engine/session/facts/fact_store.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace carina
{

/// What is to be stored next. After it FactStore::keepWhole is asked.
struct StoreJob {
    std::vector<FactRecord> facts; ///< one transaction
    std::vector<EventCpo> actions; ///< another
    /// Writes what lies beside the store; before the facts, which may depend on it.
    std::function<Result<void>()> beside{};
};

/// What became of a job.
struct StoreReport {
    Result<void> facts; ///< StoreFailed, too, where what lies beside the store was not written
    Result<void> actions;
    Result<std::optional<std::filesystem::path>> moved; ///< the answer of FactStore::keepWhole
};

/// Writes into a store on a thread of its own, so that a slow disk delays nothing but what waits
/// for it. It takes one job at a time: what is decided meanwhile is the owner's to collect, and
/// becomes one transaction.
///
/// All functions are called on one thread, the owner's.
class StoreWriter
{
public:
    explicit StoreWriter(std::unique_ptr<FactStore> store);
    /// Waits for the job under way.
    ~StoreWriter();
    StoreWriter(const StoreWriter&) = delete;
    StoreWriter& operator=(const StoreWriter&) = delete;

    /// Calls back from the writer's thread, after each job, when its report can be taken.
    void onReport(std::function<void()> callback);

    /// Whether a job was handed over and its report not taken.
    [[nodiscard]] bool isBusy() const { return m_isBusy; }
    /// Hands over a job. @pre !isBusy()
    void write(StoreJob job);
    /// The report on the job; nothing while it is being done, and where there is none.
    [[nodiscard]] std::optional<StoreReport> take();
    /// Waits for the report. @pre isBusy()
    [[nodiscard]] StoreReport wait();

private:
    void run(const std::stop_token& stopping);
    [[nodiscard]] StoreReport done(const StoreJob& job);

    std::unique_ptr<FactStore> m_store; // of the writer's thread
    bool m_isBusy = false;              // of the owner's thread

    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::optional<StoreJob> m_job;
    std::optional<StoreReport> m_report;
    std::function<void()> m_onReport;

    std::jthread m_thread; // last: it uses all of the above
};

} // namespace carina
