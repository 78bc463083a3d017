#include "resources/resources.h"

#include "engine/core/expects.h"

#include <QFile>

namespace carina
{

QByteArray resource(const char* name)
{
    QFile file(QStringLiteral(":/carina/") + QString::fromUtf8(name));
    CARINA_EXPECTS(file.open(QIODevice::ReadOnly));
    return file.readAll();
}

} // namespace carina
