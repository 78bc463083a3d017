#pragma once

#include "engine/io/anatomy_set/anatomy_set.h"

#include <QMutex>
#include <QObject>
#include <QThread>
#include <QWaitCondition>

#include <atomic>
#include <memory>

namespace carina
{

/// The import of one anatomy set while a person looks on: it runs on a thread of its own, says how
/// far it is, waits for the person's word on what was read, and can be stopped at any time.
class SetImport : public QObject
{
    Q_OBJECT

public:
    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    SetImport(std::filesystem::path folder, std::filesystem::path cacheFolder,
              CacheUse use = CacheUse::Allowed);
    /// Stops it and waits.
    ~SetImport() override;

    void start();
    /// Ends as soon as it can, with Cancelled.
    void cancel();
    /// Goes on after reviewed(), with these corrections.
    void accept(const SetCorrections& corrections);

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    /// After finished(): the set, or why there is none.
    [[nodiscard]] const Result<LoadedSet>& result() const { return m_result; }
    [[nodiscard]] Result<LoadedSet> takeResult() { return std::move(m_result); }

Q_SIGNALS:
    void progressed(double share);
    /// Something was read, and waits for accept() or cancel(). Not where the set is in the cache.
    void reviewed(const carina::SetDraft& draft);
    void finished();

private:
    [[nodiscard]] std::optional<SetCorrections> ask(const SetDraft& draft);

    std::filesystem::path m_folder;
    std::filesystem::path m_cacheFolder;
    CacheUse m_use;
    std::unique_ptr<QThread> m_thread;
    std::atomic<bool> m_cancelled{false};
    QMutex m_mutex; ///< of m_answer
    QWaitCondition m_answered;
    std::optional<SetCorrections> m_answer;
    Result<LoadedSet> m_result = fail(Errc::Cancelled, "it was not started");
};

} // namespace carina
