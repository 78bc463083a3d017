#include "engine/io/files/check_digest.h"

#include <QCryptographicHash>

namespace carina
{

QByteArray checkDigest(QByteArrayView content)
{
    return QCryptographicHash::hash(content, QCryptographicHash::Blake2b_160);
}

} // namespace carina
