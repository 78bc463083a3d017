#include "engine/net/entry/key_deriver.h"

#include "engine/core/prompt_thread.h"

namespace carina
{

KeyDeriver::KeyDeriver(DeriveKey derive) : m_derive{std::move(derive)}
{
    m_pool.setMaxThreadCount(1);
}

KeyDeriver::~KeyDeriver()
{
    m_pool.clear();
    m_pool.waitForDone();
}

void KeyDeriver::derive(const JoinCode& code, const SessionKey& session, Done done)
{
    m_pool.start([this, code, session, done = std::move(done)] {
        makeWay(); // it takes a second, and the thread of the session began it
        QMetaObject::invokeMethod(
            this, [done, key = m_derive(code, session)] { done(key); }, Qt::QueuedConnection);
    });
}

} // namespace carina
