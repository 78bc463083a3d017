#include "engine/net/anatomy_transfer/set_fetch.h"

#include "engine/core/expects.h"
#include "engine/io/anatomy_set/set_hash.h"
#include "engine/net/anatomy_transfer/set_receiver.h"

namespace carina
{

SetFetch::SetFetch(HostDoor door, std::string contentHash, std::filesystem::path cacheFolder)
{
    CARINA_EXPECTS(isSetHash(contentHash));
    m_thread.setObjectName(QStringLiteral("carina-fetch"));
    m_receiver = std::make_unique<SetReceiver>(*this, std::move(door), std::move(contentHash),
                                               std::move(cacheFolder));
    m_receiver->moveToThread(&m_thread);
    m_thread.start();
    QMetaObject::invokeMethod(
        m_receiver.get(), [this] { m_receiver->connectToHost(); }, Qt::QueuedConnection);
}

SetFetch::~SetFetch()
{
    QMetaObject::invokeMethod(
        m_receiver.get(), [this] { m_receiver.reset(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

FetchStatus SetFetch::status() const
{
    const std::scoped_lock lock{m_mutex};
    return m_status;
}

void SetFetch::show(const FetchStatus& status)
{
    const std::scoped_lock lock{m_mutex};
    m_status = status;
}

} // namespace carina
