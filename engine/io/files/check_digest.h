#pragma once

#include <QByteArray>
#include <QByteArrayView>

namespace carina
{

/// BLAKE2b-160 (RFC 7693) of what is stored beside it: 20 bytes that tell content which changed on
/// the disk by chance. It has no key, so it does not tell a change by somebody who also changes the
/// digest.
[[nodiscard]] QByteArray checkDigest(QByteArrayView content);

} // namespace carina
