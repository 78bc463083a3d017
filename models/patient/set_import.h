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

/// The interactive import of one anatomy set: it runs on its own thread, reports its progress,
/// waits for a person to confirm or correct what was read, and can be cancelled at any time.
class SetImport : public QObject
{
    Q_OBJECT

public:
    /// @param cacheFolder usually AnatomyCache::defaultFolder()
    SetImport(std::filesystem::path folder, std::filesystem::path cacheFolder,
              CacheUse use = CacheUse::Allowed);
    /// Cancels the import and waits for its thread.
    ~SetImport() override;

    void start();
    /// Ends the import as soon as possible; the result is then Cancelled.
    void cancel();
    /// Continues after reviewed(), with these corrections.
    void accept(const SetCorrections& corrections);

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    /// After finished(): the set, or the error.
    [[nodiscard]] const Result<LoadedSet>& result() const { return m_result; }
    [[nodiscard]] Result<LoadedSet> takeResult() { return std::move(m_result); }

Q_SIGNALS:
    void progressed(double share);
    /// The files were read, and the import waits for accept() or cancel(). Emitted from the
    /// import's thread; not emitted if the set is in the cache.
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
