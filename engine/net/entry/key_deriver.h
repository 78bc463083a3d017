#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"

#include <QObject>
#include <QThreadPool>

namespace carina
{

/// Derives keys one after another on a thread of its own, for derivation takes a second and 256
/// MiB.
class KeyDeriver : public QObject
{
public:
    using Done = std::function<void(const Result<AccessKey>&)>;

    explicit KeyDeriver(DeriveKey derive);
    /// Waits for the derivation under way.
    ~KeyDeriver() override;

    /// @param done called on the thread this lives on
    void derive(const JoinCode& code, const SessionKey& session, Done done);

private:
    DeriveKey m_derive;
    QThreadPool m_pool;
};

} // namespace carina
