#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"

#include <QObject>
#include <QThreadPool>

namespace carina
{

/// Derives keys one after another on its own thread, because a derivation takes a second and 256
/// MiB.
class KeyDeriver : public QObject
{
public:
    using Done = std::function<void(const Result<AccessKey>&)>;

    explicit KeyDeriver(DeriveKey derive);
    /// Waits for the derivation in progress.
    ~KeyDeriver() override;

    /// @param done called on the thread of this object
    void derive(const JoinCode& code, const SessionKey& session, Done done);

private:
    DeriveKey m_derive;
    QThreadPool m_pool;
};

} // namespace carina
