#include "models/patient/set_import.h"

#include "engine/core/expects.h"

#include <utility>

namespace carina
{

SetImport::SetImport(std::filesystem::path folder, std::filesystem::path cacheFolder, CacheUse use)
    : m_folder{std::move(folder)}, m_cacheFolder{std::move(cacheFolder)}, m_use{use}
{
}

SetImport::~SetImport()
{
    cancel();
    if (m_thread)
        m_thread->wait();
}

void SetImport::start()
{
    CARINA_EXPECTS(m_thread == nullptr);
    m_thread.reset(QThread::create([this] {
        const auto goesOn = [this](double share) {
            Q_EMIT progressed(share);
            return !m_cancelled;
        };
        m_result = loadAnatomySet(m_folder, m_cacheFolder, goesOn, m_use,
                                  [this](const SetDraft& draft) { return ask(draft); });
    }));
    connect(m_thread.get(), &QThread::finished, this, &SetImport::finished);
    m_thread->start();
}

void SetImport::cancel()
{
    const QMutexLocker locked{&m_mutex};
    m_cancelled = true;
    m_answered.wakeAll();
}

void SetImport::accept(const SetCorrections& corrections)
{
    const QMutexLocker locked{&m_mutex};
    m_answer = corrections;
    m_answered.wakeAll();
}

/// On the thread of the import.
std::optional<SetCorrections> SetImport::ask(const SetDraft& draft)
{
    Q_EMIT reviewed(draft);
    QMutexLocker locked{&m_mutex};
    while (!m_answer && !m_cancelled)
        m_answered.wait(&m_mutex);
    return m_cancelled ? std::nullopt : std::exchange(m_answer, std::nullopt);
}

} // namespace carina
