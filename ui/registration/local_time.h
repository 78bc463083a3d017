#pragma once

#include <QDateTime>
#include <QString>

#include <string>

namespace carina
{

/// A time of a site file, ISO 8601, as people here read it; what is no time stays as it is.
inline QString localTime(const std::string& time)
{
    const auto at = QDateTime::fromString(QString::fromStdString(time), Qt::ISODate);
    return at.isValid() ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                        : QString::fromStdString(time);
}

} // namespace carina
