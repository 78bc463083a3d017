#include "engine/net/anatomy_transfer/set_server.h"

#include "engine/net/anatomy_transfer/set_listener.h"

namespace carina
{

Result<std::unique_ptr<SetServer>> SetServer::listen(std::uint16_t port, bool open,
                                                     const std::filesystem::path& anatomyCache,
                                                     const SetPatience& patience)
{
    std::unique_ptr<SetServer> server{new SetServer};
    server->m_thread.setObjectName(QStringLiteral("carina-sets"));
    server->m_listener = std::make_unique<SetListener>(anatomyCache, patience);
    server->m_listener->moveToThread(&server->m_thread);
    server->m_thread.start();
    Result<std::uint16_t> bound;
    server->runThere([&] { bound = server->m_listener->bind(port, open); });
    if (!bound)
        return tl::unexpected(bound.error());
    server->m_port = *bound;
    return server;
}

void SetServer::admit(const std::string& sessionId, HostTransport::KeyOf keyOf, IsNamed isNamed,
                      IsWelcome isWelcome)
{
    runThere([&] {
        m_listener->admit(sessionId, std::move(keyOf), std::move(isNamed), std::move(isWelcome));
    });
}

SetServer::~SetServer()
{
    runThere([this] { m_listener.reset(); });
    m_thread.quit();
    m_thread.wait();
}

void SetServer::runThere(const std::function<void()>& task)
{
    QMetaObject::invokeMethod(m_listener.get(), task, Qt::BlockingQueuedConnection);
}

} // namespace carina
